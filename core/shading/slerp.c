/*
 * slerp.c - a row's two normals on great arcs, and the arc between them, made
 * ready for recurrences (lecture, "Spherical Linear Interpolation").
 *
 * Along an arc L.N is a sinusoid, and so is R.V less its mean, at twice the
 * angle; both obey x'' = -4 sin^2(step/2) x, so a pixel needs no root, no sine
 * and no product of L.N with N.V.
 */
#include "slerp.h"
#include "../math/angle.h"
#include "../math/arc.h"
#include "../triangle/reflection.h"

SETUP_FITS(struct slerp_setup);

/* Even steps of the angle are good enough over a row where they are off by less than this, about 1e-4 rad; */
#define TOLERANCE (1u << 16)
#define BLOCK_TOLERANCES 4 /* over a part of it where by less than so much */
#define LONGEST_BLOCK 64
/* Recurrences hold while a step stays under 1/16 turn: then 4 sin^2(step) < 0.6. */
#define STEEPEST_STEP (1u << 28)

/* t from t*: t* w2 / ((1 - t*) w1 + t* w2); weights UQ0.32. */
static uint32_t in_space(uint32_t t, uint32_t w1, uint32_t w2, uint32_t *weight)
{
    uint32_t part = mul_high(t, w2), rest = mul_high(~t, w1);

    *weight = rest + part;
    return w1 == w2 ? t : sheen_ratio(part, *weight > part ? *weight : part + 1);
}

/* ---- the ends of a row ---- */

/* Where row y crosses the edge from corner a down to corner b: x, weight and normal there. */
static void cross_edge(const struct tile *t, const struct slerp_setup *s, unsigned a, unsigned b, uint32_t angle,
                       int32_t y, int32_t *x, uint32_t *weight, int32_t normal[3])
{
    int32_t ya = s->y[a] + t->centre_y, height = s->y[b] - s->y[a];
    int32_t xa = s->x[a] + t->centre_x, across = s->x[b] - s->x[a];
    uint32_t part = sheen_ratio((uint32_t)(y * SUBPIXEL_ONE + SUBPIXEL_HALF - ya), (uint32_t)height);
    uint32_t wa = (uint32_t)s->weight[a] << 16, wb = (uint32_t)s->weight[b] << 16;

    *x = xa * 1024 + (int32_t)asr64((int64_t)across * part, 22); /* Q15.16 px */
    sheen_arc_normal(s->normal[a], s->normal[b], angle, in_space(part, wa, wb, weight), normal);
}

/* ---- lights along the arc ---- */

/* What an end's normal gives with v: at the left end, and by how much more at the right end. Q1.30. */
struct ends {
    int64_t left, more;
};

static struct ends dots(const int32_t left[3], const int32_t right[3], const int32_t v[3])
{
    struct ends e = {0, 0};

    for (int i = 0; i < 3; i++) {
        e.left += (int64_t)left[i] * v[i];
        e.more += ((int64_t)right[i] - left[i]) * v[i];
    }
    e.left = round_shift64(e.left, 30);
    e.more = round_shift64(e.more, 30);
    return e;
}

/* The factor of sin w: (v.Nr - cos v.Nl) / sin = (more + (1 - cos) v.Nl) / sin, held at +-1.0. Q1.30. */
static int32_t sine_factor(struct ends e, const struct arc *arc)
{
    int64_t over = e.more + round_shift64(e.left * arc->versine, 29);

    if (over >= arc->sine || over <= -(int64_t)arc->sine)
        return over > 0 ? 1 << 30 : -(1 << 30);
    unsigned zeros = clz32((uint32_t)arc->sine);
    int64_t scale = sheen_reciprocal((uint32_t)arc->sine << zeros); /* |over| < sine, so the product is below 2^62 */

    return (int32_t)round_shift64(over * scale, 33 - zeros);
}

/* At most +-1.0, though normals may be rounded outwards. */
static int32_t held(int64_t x)
{
    const int64_t one = 1 << 30;

    return (int32_t)(x > one ? one : x < -one ? -one : x);
}

static void light_row(const struct slerp_setup *s, const int32_t left[3], const int32_t right[3], const struct arc *arc,
                      struct slerp_row *row)
{
    const struct lighting *l = &s->s.draw->light;
    int flat = arc->angle < TINY_ANGLE >> 6 || row->opposite; /* the left end's normal throughout */
    struct ends v = dots(left, right, l->view);
    int32_t c = held(v.left), d = flat ? 0 : sine_factor(v, arc);

    for (unsigned i = 0; i < l->count; i++) {
        struct arc_light *at = &row->light[i];
        struct ends e = dots(left, right, l->to[i]);
        at->a = held(e.left);
        at->b = flat ? 0 : sine_factor(e, arc);
        /* 2 (a cos + b sin)(c cos + d sin) = ac + bd + (ac - bd) cos 2w + (ad + bc) sin 2w; Q2.29 */
        int32_t ac = mul_round(at->a, c, 31), bd = mul_round(at->b, d, 31);
        at->mean = ac + bd - (l->lv1[i] - (1 << 29));
        at->p = ac - bd;
        at->q = mul_round(at->a, d, 31) + mul_round(at->b, c, 31);
    }
}

/* ---- rows and blocks ---- */

/*
 * How many pixels the angle may grow evenly for. Over the whole row that is off by angle (q - 1) / 4, q the ratio of
 * the weights: under the tolerance the row is even, as without perspective. Over a part it is off by that times the
 * part's square. Range: excess < 2^47, tolerance < 2^34, width at most 1023 px.
 */
static void choose_block(struct slerp_row *row)
{
    uint32_t low = row->weight[0] < row->weight[1] ? row->weight[0] : row->weight[1];
    uint32_t high = row->weight[0] < row->weight[1] ? row->weight[1] : row->weight[0];
    uint64_t excess = (uint64_t)row->angle * (high - low) >> 16, tolerance = (uint64_t)low * (4 * TOLERANCE) >> 16;
    uint32_t width = ((uint32_t)row->width >> 16) + 1;
    uint32_t block = LONGEST_BLOCK;

    row->even = excess <= tolerance;
    while (!row->even && block > 1 && excess * (block * block) > BLOCK_TOLERANCES * tolerance * (width * width))
        block /= 2;
    row->block = (uint8_t)(row->opposite ? 1 : block);
}

/*
 * The scan line of pixel row y: which two edges it crosses (a horizontal one
 * never), what is there, and the arc between. Returns 0 where it crosses none.
 */
static int begin_row(const struct tile *t, const struct slerp_setup *s, int32_t y, struct slerp_row *row)
{
    int32_t centre = y * SUBPIXEL_ONE + SUBPIXEL_HALF - t->centre_y, x[2], normal[2][3];
    uint32_t weight[2];
    unsigned found = 0;

    for (unsigned k = 0; k < 3 && found < 2; k++) {
        unsigned a = k, b = k == 2 ? 0 : k + 1;
        if (s->y[b] < s->y[a]) {
            a = b;
            b = k;
        }
        if (s->y[a] <= centre && centre < s->y[b]) {
            cross_edge(t, s, a, b, s->angle[k], y, &x[found], &weight[found], normal[found]);
            found++;
        }
    }
    if (found < 2)
        return 0;
    unsigned left = x[0] <= x[1] ? 0 : 1, right = 1 - left;
    struct arc arc = sheen_arc_between(normal[left], normal[right]);

    row->x0 = x[left];
    row->width = x[right] - x[left];
    row->weight[0] = weight[left];
    row->weight[1] = weight[right];
    row->angle = arc.angle;
    row->opposite = arc.angle > HALF_TURN - TINY_ANGLE;
    choose_block(row);
    light_row(s, normal[left], normal[right], &arc, row);
    return 1;
}

/* The angle from the left end at pixel x, turns. */
static uint32_t angle_at(const struct slerp_row *row, int32_t x)
{
    int32_t from = x * 65536 + 32768 - row->x0;
    uint32_t weight, t;

    if (from <= 0 || row->width <= 0)
        return 0;
    t = from >= row->width ? UINT32_MAX : sheen_ratio((uint32_t)from, (uint32_t)row->width);
    if (!row->even)
        t = in_space(t, row->weight[0], row->weight[1], &weight);
    if (row->opposite)
        return t < HALF_TURN ? 0 : HALF_TURN;
    return mul_high(row->angle, t);
}

/* 15 bits of e = 4 sin^2(angle), angle at most STEEPEST_STEP: value / 2^(15 + shift), shift 1..31. */
static uint32_t law(uint32_t angle, unsigned *shift)
{
    int32_t sine = sheen_sin(angle);
    uint64_t square = (uint64_t)((int64_t)sine * sine); /* sin^2, UQ4.60; below 2^58 */
    unsigned zeros = clz64(square | 1u);

    if (zeros > 37) { /* steps below 2e-5 rad: straight over a block */
        *shift = 1;
        return 0;
    }
    *shift = zeros - 6; /* e = square / 2^58 = law / 2^(zeros + 9) */
    return (uint32_t)((square << zeros) >> 49);
}

/* x at w and its difference to w + step, for a cos w + b sin w. */
static void sinusoid(int32_t a, int32_t b, uint32_t w, uint32_t step, int32_t *x, int32_t *difference)
{
    int32_t next = mul_round(a, sheen_cos(w + step), 30) + mul_round(b, sheen_sin(w + step), 30);

    *x = mul_round(a, sheen_cos(w), 30) + mul_round(b, sheen_sin(w), 30);
    *difference = next - *x;
}

/* Start the recurrences at pixel x for at most count pixels; returns for how many they hold. */
static unsigned begin_block(const struct slerp_row *row, unsigned lights, int32_t x, int32_t count,
                            struct arc_block *block)
{
    uint32_t length = (uint32_t)min32(count, row->block);
    uint32_t w = angle_at(row, x), step = 0;

    if (length > 1) {
        uint32_t end = angle_at(row, x + (int32_t)length - 1), n = length - 1;
        step = mul_high(end - w, sheen_reciprocal(n << clz32(n))) >> (31 - clz32(n)); /* over n */
    }
    if (step > STEEPEST_STEP) {
        step = 0;
        length = 1;
    }
    block->light_law = law(step / 2, &block->light_law_shift);
    block->reflected_law = law(step, &block->reflected_law_shift);
    for (unsigned i = 0; i < lights; i++) {
        const struct arc_light *l = &row->light[i];
        struct arc_state *at = &block->state[i];
        sinusoid(l->a, l->b, w, step, &at->light, &at->light_step);
        sinusoid(l->p, l->q, 2 * w, 2 * step, &at->reflected, &at->reflected_step);
    }
    return length;
}

static void slerp_rows(const struct tile *t, const struct setup *setup)
{
    const struct slerp_setup *s = (const struct slerp_setup *)setup;

    for (unsigned i = 0; i < t->rows; i++) {
        struct slerp_row row;
        int32_t x = t->spans[i].x0, x1 = t->spans[i].x1, y = t->first_row + (int32_t)i;
        if (x >= x1 || !begin_row(t, s, y, &row))
            continue;
        while (x < x1) {
            struct arc_block block;
            unsigned length = begin_block(&row, s->s.draw->light.count, x, x1 - x, &block);
            SHEEN_TAP(ARC_BLOCK, 1);
            SHEEN_TAP(SKEWED_BLOCK, !row.even);
            SHEEN_TAP(BLOCK_LIGHT, s->s.draw->light.count);
            SHEEN_TAP(ARC_LIGHT, length * s->s.draw->light.count);
            sheen_slerp_block(t, s, &row, &block, x, y, length);
            x += (int32_t)length;
        }
    }
}

/* ---- set-up ---- */

/* One light and normals so close that great arcs do not show: as Phong. 0 where they are not. */
static int close_arcs(struct setup *s, const struct surface_corners *c, const struct gradients *g)
{
    struct facing f;

    if (s->draw->light.count != 1 || (c->at.v[0]->flags & LIT_AS_SEEN) != 0)
        return 0; /* pieces keep no cosines */
    sheen_face(&f, c);
    return f.apart <= CLOSE_ARCS && sheen_setup_reflection(s, c, g, &f);
}

static void slerp_setup(struct setup *setup, struct surface_corners *c, const struct gradients *g)
{
    struct slerp_setup *s = (struct slerp_setup *)setup;
    int32_t unit[3][3]; /* by corner and component, Q1.30 */

    if (g == NULL || setup->draw->light.count == 0) {
        sheen_setup_mean_normal(setup, c);
        return;
    }
    if (close_arcs(setup, c, g))
        return;
    sheen_weigh(c);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) {
            int32_t component = max32(c->at.normal[k][i], -32767);
            s->normal[k][i] = (int16_t)(c->back ? -component : component);
            unit[k][i] = s->normal[k][i] * 32769; /* 32767 * 32769 = 2^30 - 1 */
        }
        s->weight[k] = (uint16_t)(c->flat_weight ? 0xffff : c->weight[k] >> 16);
        s->x[k] = c->at.v[k]->x;
        s->y[k] = c->at.v[k]->y;
    }
    setup->way = SHEEN_WAY_SLERP;
    setup->fast = 0;
    setup->rows = slerp_rows;
    for (int k = 0; k < 3; k++)
        s->angle[k] = sheen_arc_between(unit[k], unit[k == 2 ? 0 : k + 1]).angle;
}

const struct sheen_shader sheen_slerp = {
    .light = sheen_keep_cosines, .setup = slerp_setup, .needs_normals = 1, .unit_normals = 1};
