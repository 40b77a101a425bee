/*
 * slerp_parts.c - rows cut into parts of equal width on the screen; values at their ends come from the arcs' series.
 *
 * With one light, L.N and N.V follow the normals' arcs along edges and rows, and L.N and 1 - R.V are quadratic over a
 * part. Otherwise the normals follow the arcs; they are linear over a part and normalised at each pixel. Parts depend
 * on the row and the triangle alone, so pixels are the same in whichever band they are drawn.
 */
#include "../triangle/normal.h"
#include "slerp.h"

#define MOST_PARTS_LOG2 4  /* the logarithm of the most parts, before perspective adds up to 2 */
#define LEAST_PART 3       /* px: if parts would be narrower, each pixel is computed by itself */
#define WIDEST_NORMALS 159 /* sin^2(p/2), UQ0.15, of the widest part: with normals 8 degrees; */
#define WIDEST_16 487      /* with one light 14, 11, 7 degrees for shininess up to 16, 32, 128; */
#define WIDEST_32 301
#define WIDEST_128 122
#define WIDEST_DULL 802 /* 18 degrees outside highlights, if the whole row has less than 40 (DULL_ROW) */
#define DULL_ROW 3833

/* v t / 2^15, |v| < 2^22 and t < 2^17, or |v| < 2^23 and t <= 2^15 */
static inline int32_t times15(int32_t v, int32_t t)
{
    return asr32(asr32(v, 8) * t, 7) + asr32((v & 255) * t, 15);
}

/* v r / 2^8, |v| < 2^23, r at most 2^16 */
static inline int32_t times8(int32_t v, int32_t r)
{
    return asr32(v, 8) * r + asr32((v & 255) * r, 8);
}

/* How far in space t, UQ0.15, of the way on the screen is, from 1/m = a to 1/m = b; *weight: 1/m there. */
static inline int32_t in_space(int32_t t, uint32_t a, uint32_t b, uint32_t *weight)
{
    uint32_t part = (uint32_t)t * b, all = part + (uint32_t)(32768 - t) * a; /* 2^15 to below 2^31 */

    *weight = all >> 15;
    do { /* rarely more than twice: the largest weight of a triangle has 16 bits */
        part <<= 1;
        all <<= 1;
    } while (all < 1u << 31);
    return (int32_t)((part >> 16) * reciprocal_seed(all) >> 16);
}

/* ---- one light: L.N and N.V ---- */

#define HIGHEST_ARGUMENT 0xd0000000u /* 3.25 times the power table's range: no part with a highlight comes near */

/* The values at t of the way along the row, as in struct arc_row's `lit`. */
HOT static APART void lit_place(const struct arc_row *r, int32_t t, int32_t lit[2])
{
    const int32_t *end = r->end[t >> 15];
    int32_t ln = end[0], nv = end[1];
    int32_t share[2];
    uint32_t weight;

    if ((t & 0x7fff) != 0) {
        if (!r->at->even)
            t = in_space(t, r->weight[0], r->weight[1], &weight);
        arc_shares(&r->series, t, share);
        ln = blended(share, r->end[0][0], r->end[1][0]);
        nv = blended(share, r->end[0][1], r->end[1][1]);
    }
    OPAQUE_BOTH(r, ln); /* what follows is loaded here, when there are registers for it */
    const struct draw *d = r->s->draw;
    const unsigned up = d->power.up;
    const int32_t u = d->light.lv1[0] - ln * nv;
    lit[0] = ln;
    lit[1] = (int32_t)((((uint32_t)min32(max32(u, 0), (int32_t)(HIGHEST_ARGUMENT >> up)) << up) + POWER_GUARD) >> 15);
}

/* A value, its step per pixel, and bend, the change of that step at each pixel. */
struct bent_run {
    uint32_t value, step, bend;
};

/* The quadratic through lit[0..2][k], a part's start, middle and end, from its first pixel on: Q.30. */
HOT static APART struct bent_run bent_through(const struct arc_row *r, const struct part *p, unsigned k)
{
    const int32_t f0 = r->lit[0][k], f1 = r->lit[2][k], up = (int32_t)p->up, n = p->n;
    const int32_t bent = 2 * (f0 + f1) - 4 * r->lit[1][k], m = f1 - f0 - bent;
    const int32_t px = (int32_t)r->inverse, px2 = (int32_t)((r->inverse * (r->inverse >> 1) - 1u) >> 15); /* 16 bits */
    const uint32_t rise = (uint32_t)times8(m + times15(bent, 2 * p->t + asr32(px, 16 - p->up)), px),
                   curve = (uint32_t)times8(bent, px2);
    struct bent_run run;

    run.step = up >= 8 ? rise << (up - 8) : (uint32_t)asr32((int32_t)rise, (unsigned)(8 - up));
    run.bend = up >= 11 ? curve << (2 * up - 22) : (uint32_t)asr32((int32_t)curve, (unsigned)(22 - 2 * up));
    run.value = ((uint32_t)f0 << 15) + (uint32_t)(m + times15(bent, p->t)) * (uint32_t)p->t + (uint32_t)n * run.step +
                pairs(n) * run.bend;
    run.step += (uint32_t)n * run.bend;
    return run;
}

/* 1 if some pixel may have a highlight. */
static int is_shiny(const struct arc_row *r)
{
    const int32_t *const lit[3] = {r->lit[0], r->lit[1], r->lit[2]};
    const int32_t a = lit[0][1], m = lit[1][1], b = lit[2][1], below = asr32(max32(a + b - 2 * m, 0), 2);

    return min32(min32(a, m), b) - below < (int32_t)(r->s->draw->loop.power_end >> 15) &&
           (lit[0][0] > 0 || lit[1][0] > 0 || lit[2][0] > 0);
}

HOT static void draw_lit(const struct tile *t, struct arc_row *r, const struct part *p)
{
    const struct setup *s = r->s;
    struct shaded_run run = {plane_at(&s->depth, p->x, r->y), s->depth.dx, 0, 0, 0, 0, 0, 0};

    if (p->fresh) {
        lit_place(r, p->at, r->lit[0]);
    } else {
        r->lit[0][0] = r->lit[2][0];
        r->lit[0][1] = r->lit[2][1];
    }
    SHEEN_TAP(ARC_PART, p->length > 0);
    SHEEN_TAP(ARC_ALONE, p->length == 0);
    SHEEN_TAP(SKEWED_PART, !r->at->even);
    enum second second;
    if (p->length > 0) {
        lit_place(r, p->at + asr32(p->length, 1), r->lit[1]);
        lit_place(r, p->at + p->length, r->lit[2]);
        struct bent_run along = bent_through(r, p, 0);
        second = is_shiny(r) ? SECOND_POWER : SECOND_NONE;
        run.f = along.value + (1u << 14);
        run.df = along.step;
        run.ddf = along.bend;
        if (second == SECOND_POWER) {
            along = bent_through(r, p, 1);
            run.u = along.value;
            run.du = along.step;
            run.ddu = along.bend;
        }
    } else {
        second =
            r->lit[0][0] > 0 && r->lit[0][1] < (int32_t)(s->draw->loop.power_end >> 15) ? SECOND_POWER : SECOND_NONE;
        run.f = ((uint32_t)r->lit[0][0] << 15) + (1u << 14);
        run.u = (uint32_t)r->lit[0][1] << 15;
    }
    SHEEN_TAP(ARC_POWER, second == SECOND_POWER ? p->x1 - p->x : 0);
    sheen_shaded_run(t, s->draw, p->x, p->x1, r->y, &run, second);
}

/* The logarithm of the number of parts. */
HOT static unsigned lit_parts(const struct arc_row *r)
{
    const int32_t h = r->h;
    const struct draw *d = r->s->draw;
    const unsigned n = d->power.shininess;
    const uint32_t w0 = r->weight[0], w1 = r->weight[1], light = w0 < w1 ? w0 : w1, more = w0 + w1 - 2 * light;
    int32_t widest = n > 32 ? WIDEST_128 : n > 16 ? WIDEST_32 : WIDEST_16;
    unsigned parts = 0;

    if (h > widest && h < DULL_ROW) {
        const int32_t(*end)[2] = r->end;
        const int32_t u0 = d->light.lv1[0] - end[0][0] * end[0][1], u1 = d->light.lv1[0] - end[1][0] * end[1][1];
        const int32_t least = min32(u0, u1), spread = max32(u0, u1) - least;
        if (least - h * (13 << 14) - asr32(spread, 3) > (int32_t)d->power.limit)
            widest = WIDEST_DULL;
    }
    while (parts < MOST_PARTS_LOG2 && h > widest << 2 * parts)
        parts++;
    if (more > light >> (n > 32 ? 4 : 3))
        parts += more > light >> 1 ? 2 : 1;
    return parts;
}

/* ---- otherwise: normals ---- */

static void normal_place(const struct arc_row *r, int32_t t, struct place *p)
{
    struct arc_blend blend;

    p->weight = r->weight[0];
    if (!r->at->even)
        t = in_space(t, r->weight[0], r->weight[1], &p->weight);
    arc_blend_at(&r->arc, t, &blend);
    for (int i = 0; i < 3; i++)
        p->part[i] = blended_part(&blend, i);
}

/* Normals that are linear in space are linear on the screen once they are multiplied by weights. */
COLD void sheen_slerp_normals(struct arc_row *r, const struct part *p, uint32_t n[3], uint32_t dn[3])
{
    struct place end;

    SHEEN_TAP(NORMAL_PART, 1);
    SHEEN_TAP(SKEWED_PART, !r->at->even);
    if (p->fresh)
        normal_place(r, p->at, &r->left);
    normal_place(r, p->at + p->length, &end);
    const unsigned up = clz32(r->left.weight | end.weight) - 16;
    const int32_t w0 = (int32_t)(r->left.weight << up >> 1), w1 = (int32_t)(end.weight << up >> 1);
    for (int i = 0; i < 3; i++) {
        const int32_t from = r->left.part[i] * w0, more = asr32(end.part[i] * w1 - from, 8);
        dn[i] = p->length == 0 ? 0 : (uint32_t)asr32(times8(more, (int32_t)r->inverse), 15 - p->up);
        n[i] = (uint32_t)from + (uint32_t)times15(more, p->t) * 256u + (uint32_t)p->n * dn[i];
        r->left.part[i] = end.part[i];
    }
    r->left.weight = end.weight;
}

unsigned sheen_slerp_normal_parts(const struct arc_row *r)
{
    unsigned parts = r->arc.parts == 2;

    if (r->arc.parts == 0)
        return 15;
    while (parts < MOST_PARTS_LOG2 + 2 && r->arc.h > WIDEST_NORMALS << 2 * (parts - (r->arc.parts - 1u)))
        parts++;
    return parts;
}

static void draw_normals(const struct tile *t, struct arc_row *r, const struct part *p)
{
    const struct setup *s = r->s;
    struct normal_run run;

    run.z = plane_at(&s->depth, p->x, r->y);
    run.dz = s->depth.dx;
    sheen_slerp_normals(r, p, run.n, run.dn);
    draw_normal_run(t, s->draw, p->x, p->x1, r->y, &run);
}

/* ---- rows ---- */

/*
 * Where a row crosses an edge: the weight there, and *t, how far from the upper end that is in space, UQ0.15. centre:
 * as for begin_row. Returns the column, px from the viewport's centre, Q15.16.
 */
static inline int32_t cross_edge(const struct slerp_corners *at, unsigned edge, int32_t centre, uint32_t *weight,
                                 int32_t *t)
{
    const struct slerp_corner *a = upper_end(at, edge), *b = lower_end(at, edge);
    const int32_t across = b->x - a->x;                                               /* below 2^16 */
    const uint32_t down = (uint32_t)(centre - a->y) * at->inverse[edge];              /* UQ.31, at most 1.0 + 2^-16 */
    const int32_t high = (int32_t)(down >> 16), low = (int32_t)(down >> 1 & 0x7fffu); /* 65408 * 2^15 < 2^31 */

    *t = min32((int32_t)((down + (1u << 15)) >> 16), 32768);
    *weight = a->weight;
    if (!at->even)
        *t = in_space(*t, a->weight, b->weight, weight);
    return a->x * 1024 + asr32(across * high, 5) + asr32(across * low, 20);
}

/* Begins the arc of normals between the crossings; t: how far down edge 02 and the other edge the crossings are. */
static void begin_normals(struct arc_row *r, const struct arc arc[2], const int32_t t[2])
{
    int16_t normal[2][3];

    for (unsigned j = 0; j < 2; j++) {
        struct arc_blend blend;
        arc_blend_at(&arc[j], t[j], &blend);
        for (int i = 0; i < 3; i++)
            normal[j ^ r->at->long_right][i] = (int16_t)max32(min32(blended_part(&blend, i), 32767), -32767);
    }
    sheen_arc_begin(&r->arc, normal[0], normal[1]);
}

/* L.N and N.V at a crossing, t of the way down the edge from a to b. */
static inline void lit_crossing(const struct slerp_corner *a, const struct slerp_corner *b,
                                const struct arc_series *series, int32_t t, int32_t share[2], int32_t end[2])
{
    arc_shares(series, t, share);
    end[0] = blended(share, a->lit[0], b->lit[0]);
    end[1] = blended(share, a->lit[1], b->lit[1]);
}

/*
 * As begin_normals, with one light. The crossings' normals differ by the sum of ci Ni over the corners' unit normals
 * Ni; ci is by how much Ni's share is larger at one crossing than at the other, |ci| <= 1.0. |sum|^2 =
 * (c0 + c1 + c2)^2 - c0 c1 |N0 - N1|^2 - ... is computed in quarters, as h is: Q0.15.
 */
HOT static void begin_lit(struct arc_row *r, const struct arc arc[2], unsigned other, const int32_t t[2])
{
    const struct slerp_corners *at = r->at;
    const struct slerp_corner *corner = at->corner;
    int32_t(*end)[2] = r->end, share[2];

    lit_crossing(&corner[0], &corner[2], &arc[0].series, t[0], share, end[at->long_right]);
    int32_t c0 = share[0], c1, c2 = share[1];
    corner += other >> 1;
    lit_crossing(&corner[0], &corner[1], &arc[1].series, t[1], share, end[at->long_right ^ 1]);
    if (other == 1) {
        c0 -= share[0];
        c1 = -share[1];
    } else {
        c1 = -share[0];
        c2 -= share[1];
    }
    const int32_t sum = c0 + c1 + c2;
    const int32_t h = asr32(sum * sum, 17) - round15(round15(c0 * c2) * at->h[0]) -
                      round15(round15(c0 * c1) * at->h[1]) - round15(round15(c1 * c2) * at->h[2]);
    r->h = min32(max32(h, 0), RIGHT_ANGLE);
    sheen_arc_series(&r->series, r->h);
}

/* Begins the row at centre, 1/64 px from the viewport's, between edge 02 and edge `other`; arc: those edges' arcs. */
HOT static APART void begin_row(const struct tile *t, struct arc_row *r, const struct arc arc[2], unsigned other,
                                int32_t centre)
{
    const unsigned side = r->at->long_right; /* of edge 02 */
    int32_t x[2], down[2];

    x[side] = cross_edge(r->at, 0, centre, &r->weight[side], &down[0]);
    x[side ^ 1] = cross_edge(r->at, other, centre, &r->weight[side ^ 1], &down[1]);
    if (r->s->way == SHEEN_WAY_SLERP)
        begin_lit(r, arc, other, down);
    else
        begin_normals(r, arc, down);
    r->from = x[0] + t->centre_x * 1024;
    r->width = max32(x[1] - x[0], 1);
    r->up = clz32((uint32_t)r->width);
    r->inverse = reciprocal_seed((uint32_t)r->width << r->up);
}

/* The share, UQ0.15, that d, Q15.16 px, has of 2^(31 - up) / inverse px. */
static inline int32_t row_share(const struct arc_row *r, int32_t d, unsigned up)
{
    return (int32_t)((((uint32_t)d << up) >> 16) * r->inverse >> 16);
}

/* If parts would have less than LEAST_PART px, each pixel is computed by itself. */
static void draw_row(const struct tile *t, struct arc_row *r, const struct span *span)
{
    const unsigned parts = r->parts(r);
    const int32_t width = asr32(r->width, parts);
    int32_t begin = r->from;
    struct part p;

    p.x = span->x0;
    p.at = p.length = p.n = p.t = 0;
    p.up = 0;
    p.fresh = 1;
    if (width < LEAST_PART << 16) {
        for (; p.x < span->x1; p.x++) {
            const int32_t d = p.x * 65536 + 32768 - begin;
            p.at = d <= 0 ? 0 : d >= r->width ? 32768 : min32(row_share(r, d, r->up), 32768);
            p.x1 = p.x + 1;
            r->draw(t, r, &p);
        }
        return;
    }
    p.length = 32768 >> parts;
    p.up = r->up + parts;
    for (; p.x < span->x1; p.at += p.length, begin += width) {
        const int32_t first = asr32(begin + 32767, 16), end = asr32(begin + width + 32767, 16);
        p.x1 = p.at + p.length >= 32768 ? span->x1 : min32(span->x1, end);
        if (p.x >= p.x1)
            continue;
        p.n = p.x - first;
        p.t = row_share(r, first * 65536 + 32768 - begin, p.up);
        r->draw(t, r, &p);
        p.fresh = 0;
        p.x = p.x1;
    }
}

HOT static APART void begin_edge(struct arc *arc, const struct arc_row *r, unsigned edge)
{
    if (r->s->way == SHEEN_WAY_SLERP)
        sheen_arc_series(&arc->series, r->at->h[edge]);
    else
        sheen_arc_begin(arc, upper_end(r->at, edge)->normal, lower_end(r->at, edge)->normal);
}

HOT void sheen_slerp_draw(const struct tile *t, struct arc_row *r)
{
    unsigned edge = 0; /* the one that arc[1] is of; 0: none yet */
    struct arc arc[2];

    begin_edge(&arc[0], r, 0);
    r->y = t->first_row;
    for (const struct span *span = t->spans, *end = span + t->rows; span < end; span++, r->y++) {
        const int32_t centre = r->y * SUBPIXEL_ONE + SUBPIXEL_HALF - t->centre_y;
        const unsigned other = centre < r->at->corner[1].y ? 1 : 2;
        if (span->x0 >= span->x1)
            continue;
        if (edge != other)
            begin_edge(&arc[1], r, other);
        edge = other;
        begin_row(t, r, arc, other, centre);
        draw_row(t, r, span);
    }
}

void sheen_slerp_rows(const struct tile *t, const struct setup *s)
{
    const int lit = s->way == SHEEN_WAY_SLERP;
    struct arc_row r;

    r.s = s;
    r.at = &((const struct slerp_setup *)s)->at;
    r.parts = lit ? lit_parts : sheen_slerp_normal_parts;
    r.draw = lit ? draw_lit : draw_normals;
    sheen_slerp_draw(t, &r);
}
