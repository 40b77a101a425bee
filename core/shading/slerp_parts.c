/*
 * slerp_parts.c - rows cut into parts, even on the screen, with what lies at their ends by the arcs' series.
 *
 * One light: of normals only L.N and N.V are carried along edges and rows, and L.N and 1 - R.V are quadratic over a
 * part. Else normals are, linear over a part and brought to length 1 a pixel. What a part is hangs on the row and the
 * triangle alone, so any band gives the same pixels.
 */
#include "../triangle/normal.h"
#include "../triangle/reflection.h"
#include "slerp_row.h"

/* sin^2(p/2), UQ0.15, of the widest parts: 14, 11, 7 degrees for shininess to 16, 32, 128; */
#define WIDEST_16 487
#define WIDEST_32 301
#define WIDEST_128 122
#define WIDEST_DULL 802 /* 18 degrees outside highlights, where the row has less than 40 */
#define DULL_ROW 3833

/* ---- one light: L.N and N.V ---- */

#define HIGHEST_ARGUMENT 0xd0000000u /* 3.25 ranges of the power table: no part with a highlight comes near */

static APART void lit_place(const struct arc_row *r, int32_t t, struct place *p)
{
    const struct draw *d = r->s->draw;
    const unsigned up = d->power.up;
    const int16_t *left = r->cosine[0], *right = r->cosine[1];
    int32_t ln = left[0], nv = left[1];
    uint32_t weight;

    if (t > 0) {
        if (!r->at->even)
            t = in_space(t, r->weight[0], r->weight[1], &weight);
        const int32_t a = arc_share(&r->arc.series, 32768 - t), b = arc_share(&r->arc.series, t);
        ln = round15(a * left[0] + b * right[0]);
        nv = round15(a * left[1] + b * right[1]);
    }
    const int32_t u = min32(max32(d->light.lv1[0] - ln * nv, 0), (int32_t)(HIGHEST_ARGUMENT >> up));
    p->part[0] = ln;
    p->part[1] = (int32_t)((((uint32_t)u << up) + POWER_GUARD) >> 15);
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
static void draw_lit(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                     const struct place *b)
{
    const struct setup *s = r->s;
    struct shaded_run run = {plane_at(&s->depth, p->x, r->y), s->depth.dx, 0, 0, 0, 0, 0, 0};
    struct place m = *a;

    if (p->length > 0)
        lit_place(r, p->at + p->length / 2, &m);
    const enum second second = is_shiny(s->draw, a, &m, b) ? SECOND_POWER : SECOND_NONE;
    SHEEN_TAP(ARC_PART, 1);
    SHEEN_TAP(SKEWED_PART, !r->at->even);
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
    const struct draw *d = r->s->draw;
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

static void draw_normals(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    const struct setup *s = r->s;
    struct normal_run run = {.z = plane_at(&s->depth, p->x, r->y), .dz = s->depth.dx};

    normals_between(r, p, a, b, run.n, run.dn);
    draw_normal_run(t, s->draw, p->x, p->x1, r->y, &run);
}

/* ---- rows ---- */

void sheen_slerp_begin_row(const struct tile *t, struct arc_row *r, const struct arc arc[2], unsigned other,
                           int32_t centre)
{
    const unsigned right = r->at->long_right; /* of edge 02 */
    struct crossing at[2];
    int16_t normal[2][3];

    for (unsigned j = 0; j < 2; j++) {
        const unsigned side = j ^ right;
        int32_t n[3];
        sheen_slerp_cross(r->at, j * other, centre, &at[side]);
        r->weight[side] = at[side].weight;
        sheen_arc_at(&arc[j], at[side].t, n);
        for (int i = 0; i < 3; i++)
            normal[side][i] = (int16_t)min32(max32(round15(n[i]), -32767), 32767);
    }
    sheen_arc_begin(&r->arc, normal[0], normal[1]);
    for (int side = 0; r->s->way == SHEEN_WAY_SLERP && side < 2; side++) {
        uint16_t kept[2];
        sheen_keep_cosines(r->s->draw, normal[side], kept);
        r->cosine[side][0] = (int16_t)kept[0];
        r->cosine[side][1] = (int16_t)kept[1];
    }
    r->from = at[0].x + t->centre_x * 1024;
    r->width = max32(at[1].x - at[0].x, 1);
    r->up = clz32((uint32_t)r->width);
    r->inverse = reciprocal_seed((uint32_t)r->width << r->up);
}

static unsigned parts_of(const struct arc_row *r)
{
    return r->s->way == SHEEN_WAY_SLERP ? lit_parts(r) : normal_parts(r);
}

static void find_place(const struct arc_row *r, int32_t t, struct place *p)
{
    if (r->s->way == SHEEN_WAY_SLERP)
        lit_place(r, t, p);
    else
        normal_place(r, t, p);
}

static void draw_between(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    if (r->s->way == SHEEN_WAY_SLERP)
        draw_lit(t, r, p, a, b);
    else
        draw_normals(t, r, p, a, b);
}

static const struct arc_way plain_arcs = {parts_of, find_place, draw_between};

static APART void draw_plain_row(const struct tile *t, struct arc_row *r, const struct span *span)
{
    arc_row(t, r, span, plain_arcs);
}

void sheen_slerp_rows(const struct tile *t, const struct setup *s)
{
    struct arc_row r;

    r.s = s;
    r.at = &((const struct slerp_setup *)s)->at;
    arc_rows(t, &r, draw_plain_row);
}
