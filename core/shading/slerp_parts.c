/*
 * slerp_parts.c - rows cut into parts, even on the screen, with what lies at their ends by the arcs' series.
 *
 * One light: of normals only L.N and N.V are carried along edges and rows, and L.N and 1 - R.V are quadratic over a
 * part. Else normals are, linear over a part and brought to length 1 a pixel. What a part is hangs on the row and the
 * triangle alone, so any band gives the same pixels.
 */
#include "../triangle/normal.h"
#include "../triangle/reflection.h"
#include "slerp.h"

/* sin^2(p/2), UQ0.15, of the widest parts: 14, 11, 7 degrees for shininess to 16, 32, 128; */
#define WIDEST_16 487
#define WIDEST_32 301
#define WIDEST_128 122
#define WIDEST_DULL 802 /* 18 degrees outside highlights, where the row has less than 40; */
#define DULL_ROW 3833
#define WIDEST_NORMALS 159 /* 8 degrees where normals are linear */
#define MOST_PARTS 4       /* the logarithm of their number, before perspective adds up to 2 */
#define LEAST_PART 3       /* px: of less, each pixel for itself */

/* A row on its way from crossing to crossing. */
struct arc_row {
    const struct slerp_setup *s;
    int32_t y, from, width; /* from: the left crossing, px on the target, Q15.16; width > 0 */
    uint32_t inverse;       /* 1 / width = inverse 2^(up - 31), 1/px; 16 bits */
    unsigned up;
    uint32_t weight[2];   /* at the crossings, UQ0.16 */
    int16_t cosine[2][2]; /* there, L.N and N.V, Q0.15 */
    struct arc arc;       /* of normals; else its series alone */
};

/* What lies somewhere on a row: L.N, Q0.15, and the power table's argument / 2^15; or the normal, Q1.30, and 1/m. */
struct place {
    int32_t part[3];
    uint32_t weight; /* UQ0.16 */
};

/* Columns x to before x1 of a part: how much of the row lies before it and how much it is, UQ0.15. */
struct part {
    int32_t at, length;   /* length 0: one pixel */
    int32_t x, x1, first; /* first: the first column after its left end */
    int32_t t;            /* that column's centre in it, UQ0.15 */
    unsigned up;          /* a pixel is the row's inverse 2^(up - 31) of it; at most 15 */
};

/* d, Q15.16 px, of the row's width: UQ0.15, 0..1.0 */
static int32_t share_of_row(const struct arc_row *r, int32_t d)
{
    if (d <= 0 || d >= r->width)
        return d <= 0 ? 0 : 32768;
    return min32((int32_t)((((uint32_t)d << r->up) >> 16) * r->inverse >> 16), 32768);
}

/* ---- one light: L.N and N.V ---- */

#define HIGHEST_ARGUMENT 0xd0000000u /* 3.25 ranges of the power table: no part with a highlight comes near */

static APART void lit_place(const struct arc_row *r, int32_t t, struct place *p)
{
    const struct draw *d = r->s->s.draw;
    const unsigned up = d->power.up;
    const int16_t *left = r->cosine[0], *right = r->cosine[1];
    int32_t ln = left[0], nv = left[1];
    uint32_t weight;

    if (t > 0) {
        if (!(r->s->s.detail & SLERP_EVEN))
            t = in_space(t, r->weight[0], r->weight[1], &weight);
        const int32_t a = arc_share(&r->arc.series, 32768 - t), b = arc_share(&r->arc.series, t);
        ln = round15(a * left[0] + b * right[0]);
        nv = round15(a * left[1] + b * right[1]);
    }
    const int32_t u = min32(max32(d->light.lv1[0] - ln * nv, 0), (int32_t)(HIGHEST_ARGUMENT >> up));
    p->part[0] = ln;
    p->part[1] = (int32_t)((((uint32_t)u << up) + POWER_GUARD) >> 15);
}

/* v t / 2^15, |v| < 2^22, t < 2^17 */
static int32_t times15(int32_t v, int32_t t)
{
    return asr32(asr32(v, 8) * t, 7) + asr32((v & 255) * t, 15);
}

/* v r / 2^8, |v| < 2^22, r at most 2^16 */
static int32_t times8(int32_t v, int32_t r)
{
    return asr32(v, 8) * r + asr32((v & 255) * r, 8);
}

/* A value, what the next pixel has more, and what that has more each time. */
struct bent_run {
    uint32_t value, step, bend;
};

/* Through f0, fm, f1 at a part's ends and middle, units of 2^-15, at column x: Q.30. */
static APART struct bent_run bent_through(const struct part *p, uint32_t inverse, int32_t f0, int32_t fm, int32_t f1)
{
    const int32_t px = (int32_t)inverse, px2 = (int32_t)((inverse * (inverse >> 1) - 1u) >> 15); /* 16 bits */
    const int32_t k = 2 * (f0 + f1) - 4 * fm, m = f1 - f0 - k, up = (int32_t)p->up, n = p->x - p->first;
    const uint32_t rise = (uint32_t)times8(m + times15(k, 2 * p->t + asr32(px, 16 - p->up)), px),
                   curve = (uint32_t)times8(k, px2);
    struct bent_run run;

    run.value = ((uint32_t)f0 << 15) + (uint32_t)(m + times15(k, p->t)) * (uint32_t)p->t;
    run.step = up >= 8 ? rise << (up - 8) : (uint32_t)asr32((int32_t)rise, (unsigned)(8 - up));
    run.bend = up >= 11 ? curve << (2 * up - 22) : (uint32_t)asr32((int32_t)curve, (unsigned)(22 - 2 * up));
    run.value += (uint32_t)n * run.step + pairs(n) * run.bend;
    run.step += (uint32_t)n * run.bend;
    return run;
}

/* 1 where some pixel may have a highlight. */
static int is_shiny(const struct draw *d, const struct place *a, const struct place *m, const struct place *b)
{
    const int32_t below = asr32(max32(a->part[1] + b->part[1] - 2 * m->part[1], 0), 2);

    return min32(min32(a->part[1], m->part[1]), b->part[1]) - below < (int32_t)(d->loop.power_end >> 15) &&
           (a->part[0] > 0 || m->part[0] > 0 || b->part[0] > 0);
}

/* a, b: what lies at its ends. */
static void draw_lit(const struct tile *t, const struct arc_row *r, const struct part *p, const struct place *a,
                     const struct place *b)
{
    const struct setup *s = &r->s->s;
    struct shaded_run run = {plane_at(&s->depth, p->x, r->y), s->depth.dx, 0, 0, 0, 0, 0, 0};
    struct place m = *a;

    if (p->length > 0)
        lit_place(r, p->at + p->length / 2, &m);
    const enum second second = is_shiny(s->draw, a, &m, b) ? SECOND_POWER : SECOND_NONE;
    SHEEN_TAP(ARC_PART, 1);
    SHEEN_TAP(SKEWED_PART, (s->detail & SLERP_EVEN) == 0);
    SHEEN_TAP(ARC_POWER, second == SECOND_POWER ? p->x1 - p->x : 0);
    struct bent_run along = bent_through(p, r->inverse, a->part[0], m.part[0], b->part[0]);
    run.f = along.value + (1u << 14);
    run.df = along.step;
    run.ddf = along.bend;
    if (second == SECOND_POWER) {
        along = bent_through(p, r->inverse, a->part[1], m.part[1], b->part[1]);
        run.u = along.value;
        run.du = along.step;
        run.ddu = along.bend;
    }
    sheen_shaded_run(t, s->draw, p->x, p->x1, r->y, &run, second);
}

/* The logarithm of the number of parts. */
static unsigned lit_parts(const struct arc_row *r)
{
    const int32_t h = r->arc.h;
    const struct draw *d = r->s->s.draw;
    const unsigned n = d->power.shininess;
    const int32_t u0 = d->light.lv1[0] - r->cosine[0][0] * r->cosine[0][1];
    const int32_t u1 = d->light.lv1[0] - r->cosine[1][0] * r->cosine[1][1];
    const int32_t least = min32(u0, u1), spread = max32(u0, u1) - least;
    const uint32_t w0 = r->weight[0], w1 = r->weight[1], light = w0 < w1 ? w0 : w1, more = w0 + w1 - 2 * light;
    int32_t widest = n > 32 ? WIDEST_128 : n > 16 ? WIDEST_32 : WIDEST_16;
    unsigned parts = 0;

    if (h < DULL_ROW && least - h * (13 << 14) - asr32(spread, 3) > (int32_t)d->power.limit)
        widest = WIDEST_DULL;
    while (parts < MOST_PARTS && h > widest << 2 * parts)
        parts++;
    if (more > light >> (n > 32 ? 4 : 3))
        parts += more > light >> 1 ? 2 : 1;
    return parts;
}

/* ---- else: normals ---- */

static APART void normal_place(const struct arc_row *r, int32_t t, struct place *p)
{
    p->weight = r->weight[0];
    if (!(r->s->s.detail & SLERP_EVEN))
        t = in_space(t, r->weight[0], r->weight[1], &p->weight);
    sheen_arc_at(&r->arc, t, p->part);
}

/* Times weights the normals are linear on the screen, as they are in space without. */
static void draw_normals(const struct tile *t, const struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    const struct setup *s = &r->s->s;
    const unsigned up = clz32(a->weight | b->weight) - 16;
    const int32_t w0 = (int32_t)(a->weight << up >> 1), w1 = (int32_t)(b->weight << up >> 1), n = p->x - p->first;
    struct normal_run run = {plane_at(&s->depth, p->x, r->y), s->depth.dx, {0, 0, 0}, {0, 0, 0}};

    SHEEN_TAP(NORMAL_PART, 1);
    SHEEN_TAP(SKEWED_PART, (s->detail & SLERP_EVEN) == 0);
    for (int i = 0; i < 3; i++) {
        const int32_t from = round15(a->part[i]) * w0, more = asr32(round15(b->part[i]) * w1 - from, 8);
        run.dn[i] = p->length == 0 ? 0 : (uint32_t)asr32(times8(more, (int32_t)r->inverse), 15 - p->up);
        run.n[i] = (uint32_t)from + (uint32_t)times15(more, p->t) * 256u + (uint32_t)n * run.dn[i];
    }
    draw_normal_run(t, s->draw, p->x, p->x1, r->y, &run);
}

static unsigned normal_parts(const struct arc_row *r)
{
    unsigned parts = r->arc.parts == 2;

    if (r->arc.parts == 0)
        return 15;
    while (parts < MOST_PARTS + 2 && r->arc.h > WIDEST_NORMALS << 2 * (parts - (r->arc.parts - 1u)))
        parts++;
    return parts;
}

/* ---- rows ---- */

static void find_place(const struct arc_row *r, int32_t t, struct place *p)
{
    if (r->s->s.way == SHEEN_WAY_SLERP)
        lit_place(r, t, p);
    else
        normal_place(r, t, p);
}

static void draw_between(const struct tile *t, const struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    if (r->s->s.way == SHEEN_WAY_SLERP)
        draw_lit(t, r, p, a, b);
    else
        draw_normals(t, r, p, a, b);
}

/* Parts that would have less than LEAST_PART px: each pixel for itself. */
static APART void draw_row(const struct tile *t, const struct arc_row *r, const struct span *span, unsigned parts)
{
    const int32_t width = asr32(r->width, parts), pixels = width < LEAST_PART << 16;
    int32_t begin = r->from;
    struct part p;
    struct place place[2];

    p.at = 0;
    p.length = pixels ? 0 : 1 << (15 - parts);
    p.x = span->x0;
    p.up = pixels ? 0 : r->up + parts;
    p.t = 0;
    while (!pixels && p.at + p.length < 32768 && begin + width <= p.x * 65536 + 32768) {
        p.at += p.length;
        begin += width;
    }
    if (!pixels)
        find_place(r, p.at, &place[0]);
    for (; p.x < span->x1; p.at += p.length, begin += width) {
        if (pixels) {
            p.first = p.x;
            p.x1 = p.x + 1;
            find_place(r, share_of_row(r, p.x * 65536 + 32768 - r->from), &place[0]);
            place[1] = place[0];
        } else {
            const int last = p.at + p.length >= 32768;
            p.x1 = last ? span->x1 : min32(span->x1, asr32(begin + width + 32767, 16));
            p.first = asr32(begin + 32767, 16);
            p.t = (int32_t)((((uint32_t)(p.first * 65536 + 32768 - begin) << p.up) >> 16) * r->inverse >> 16);
            find_place(r, p.at + p.length, &place[1]);
        }
        if (p.x < p.x1) {
            draw_between(t, r, &p, &place[0], &place[1]);
            p.x = p.x1;
        }
        place[0] = place[1];
    }
}

/* The row at centre, 1/64 px from the viewport's, between edge 02 and `other`, of which `arc` are the arcs. */
static APART void begin_row(const struct tile *t, struct arc_row *r, const struct arc arc[2], unsigned other,
                            int32_t centre)
{
    const struct slerp_setup *s = r->s;
    const unsigned right = (s->s.detail & SLERP_LONG_RIGHT) != 0; /* of edge 02 */
    struct crossing at[2];
    int16_t normal[2][3];

    for (unsigned j = 0; j < 2; j++) {
        const unsigned side = j ^ right;
        int32_t n[3];
        sheen_slerp_cross(s, j * other, centre, &at[side]);
        r->weight[side] = at[side].weight;
        sheen_arc_at(&arc[j], at[side].t, n);
        for (int i = 0; i < 3; i++)
            normal[side][i] = (int16_t)min32(max32(round15(n[i]), -32767), 32767);
    }
    sheen_arc_begin(&r->arc, normal[0], normal[1]);
    for (int side = 0; s->s.way == SHEEN_WAY_SLERP && side < 2; side++) {
        uint16_t kept[2];
        sheen_keep_cosines(s->s.draw, normal[side], kept);
        r->cosine[side][0] = (int16_t)kept[0];
        r->cosine[side][1] = (int16_t)kept[1];
    }
    r->from = at[0].x + t->centre_x * 1024;
    r->width = max32(at[1].x - at[0].x, 1);
    r->up = clz32((uint32_t)r->width);
    r->inverse = reciprocal_seed((uint32_t)r->width << r->up);
}

static void begin_edge(struct arc *arc, const struct slerp_setup *s, unsigned edge)
{
    sheen_arc_begin(arc, s->normal[sheen_slerp_end[edge][0]], s->normal[sheen_slerp_end[edge][1]]);
}

void sheen_slerp_rows(const struct tile *t, const struct setup *setup)
{
    const struct slerp_setup *s = (const struct slerp_setup *)setup;
    unsigned edge = 0; /* that arc[1] is of */
    struct arc arc[2];
    struct arc_row r;

    r.s = s;
    begin_edge(&arc[0], s, 0);
    for (unsigned i = 0; i < t->rows; i++) {
        r.y = t->first_row + (int32_t)i;
        const int32_t centre = r.y * SUBPIXEL_ONE + SUBPIXEL_HALF - t->centre_y;
        const unsigned other = centre < s->y[1] ? 1 : 2;
        if (t->spans[i].x0 >= t->spans[i].x1)
            continue;
        if (edge != other)
            begin_edge(&arc[1], s, other);
        edge = other;
        begin_row(t, &r, arc, other, centre);
        unsigned parts = s->s.way == SHEEN_WAY_SLERP ? lit_parts(&r) : normal_parts(&r);
        draw_row(t, &r, t->spans + i, parts);
    }
}
