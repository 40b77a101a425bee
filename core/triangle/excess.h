/*
 * excess.h - private: the excess, 4 (middle - mean of the ends), of L.N and 1 - R.V on a triangle's edges, for one of a
 * draw's lights; see reflection.c.
 */
#ifndef SHEEN_EXCESS_H
#define SHEEN_EXCESS_H

#include "reflection.h"

#define REFLECTION_LEAN 32768 /* the largest lean: 1/m changes along an edge by 1/8 of its mean */
#define MOST_HIGHLIGHT_BITS                                                                                            \
    12 /* most bits of gradients with a highlight: from 64 px on L.N's and N.V's 16 bits show in it */
#define MOST_ARGUMENT 0xe0000000u /* 3.5 times the power table's range: up to there no value of a quadric wraps */

static inline int32_t least3(const int32_t x[3])
{
    return min32(x[0], min32(x[1], x[2]));
}

static inline int32_t most3(const int32_t x[3])
{
    return max32(x[0], max32(x[1], x[2]));
}

/* The excess of 1 - R.V on the edge from i to j, Q.15; see sheen_cosine_excess. u: 1 - R.V at the corners, Q2.29. */
static inline int32_t reflected_excess(const struct facing *f, const int32_t u[3], int i, int j, int32_t h,
                                       int32_t lean)
{
    int32_t e = h + asr32(h * h, 18);
    int32_t difference = asr32((f->ln[i] - f->ln[j]) * (f->nv[i] - f->nv[j]), 14);
    int32_t sum = asr32(asr32(f->ln[i] + f->ln[j], 1) * asr32(f->nv[i] + f->nv[j], 1), 15); /* product / 4 */

    return difference - asr32(sum * e, 15) + asr32(asr32(u[i] - u[j], 14) * lean, 18);
}

/* What sheen_cosine_excess needs to know about edges 01, 02, 12, whatever the light. */
struct edge_terms {
    int32_t h[3], lean[3]; /* Q0.18 */
};

/* What a triangle's quadrics for one light are made from; excesses are those of edges 01, 02, 12. */
struct excesses {
    struct edge_terms edges;
    int32_t light[3];        /* excess of L.N, Q.16 */
    int32_t u[3], second[3]; /* 1 - R.V at the corners, Q2.29; its excess, Q.15 */
    int32_t most;            /* the largest u of all corners */
};

static inline void angle_excesses(struct excesses *e, const struct facing *f)
{
    for (int k = 0; k < 3; k++)
        e->edges.h[k] = (int32_t)(f->h[k] >> 14);
}

/* After angle_excesses: the excesses of L.N of the light that is in *f. */
static inline void light_excesses(struct excesses *e, const struct facing *f)
{
    e->light[0] = sheen_cosine_excess(f->ln[0], f->ln[1], e->edges.h[0], e->edges.lean[0]);
    e->light[1] = sheen_cosine_excess(f->ln[0], f->ln[2], e->edges.h[1], e->edges.lean[1]);
    e->light[2] = sheen_cosine_excess(f->ln[1], f->ln[2], e->edges.h[2], e->edges.lean[2]);
}

static inline void reflected_corners(struct excesses *e, const struct facing *f, int32_t lv1)
{
    UNROLLED
    for (int k = 0; k < 3; k++)
        e->u[k] = lv1 - f->ln[k] * f->nv[k];
}

static inline void reflected_excesses(struct excesses *e, const struct facing *f)
{
    e->second[0] = reflected_excess(f, e->u, 0, 1, e->edges.h[0], e->edges.lean[0]);
    e->second[1] = reflected_excess(f, e->u, 0, 2, e->edges.h[1], e->edges.lean[1]);
    e->second[2] = reflected_excess(f, e->u, 1, 2, e->edges.h[2], e->edges.lean[2]);
}

/*
 * 1 if some pixel may have a highlight: by a rough bound first, then by the excesses in e->second, which count 1/4
 * because a product of two barycentric coordinates is at most that. If the draw is dithered, a highlight is also left
 * out if it is faint throughout and two corners are beyond power.limit: over the triangle it adds about as little as
 * those that are left out everywhere.
 */
static inline int has_highlight(struct excesses *e, const struct facing *f, const struct draw *d, unsigned light)
{
    const int32_t lv1 = d->light.lv1[light], limit = (int32_t)d->power.limit;

    reflected_corners(e, f, lv1);
    if (limit == 0)
        return 0;
    int32_t least = least3(e->u);
    e->most = most3(e->u);
    if (f->kept != NULL) {
        const int32_t across = lv1 - (int16_t)f->kept[0] * (int16_t)f->kept[1];
        least = min32(least, across);
        e->most = max32(e->most, across);
    }
    const int32_t spread = e->most - least;
    if (least - (int32_t)(f->apart + (f->apart >> 1) + (f->apart >> 4)) - asr32(spread, 3) >= limit)
        return 0;
    reflected_excesses(e, f);
    least += (min32(e->second[0], 0) + min32(e->second[1], 0) + min32(e->second[2], 0)) * (1 << 12);
    if (least >= limit)
        return 0;
    return least < d->power.faint << 16 || (e->u[0] < limit) + (e->u[1] < limit) + (e->u[2] < limit) > 1;
}

/* How far apart normals may be on triangles with a highlight; see too_sharp. */
static inline uint32_t widest_with_highlight(const struct draw *d)
{
    /* 20 degrees for n <= 32, else 14; 13 and 9 if the highlight is strong: the error grows with both */
    static const uint32_t widest_highlight[2][2] = {{129509111u, 63789442u}, {55039867u, 26439087u}};

    return widest_highlight[d->strong][d->power.shininess > 32];
}

/* 1 if a highlight is too sharp for how far apart the normals are, or the power table's argument may wrap. */
static inline int too_sharp(const struct excesses *e, const struct facing *f, const struct draw *d)
{
    return f->apart > widest_with_highlight(d) || e->most >= (int32_t)(MOST_ARGUMENT >> d->power.up);
}

/* The quadric of L.N, from light_excesses: Q1.30 plus half a step of UQ1.15. */
static inline void light_quadric(struct quadric *q, const struct quadric_steps *steps, const struct facing *f,
                                 const struct excesses *e)
{
    sheen_corner_quadric(q, steps, ((uint32_t)f->ln[0] << 15) + (1u << 14), (f->ln[1] - f->ln[0]) * 2,
                         (f->ln[2] - f->ln[0]) * 2, e->light);
}

/* The quadric of 1 - R.V, from reflected_excesses, as the power table's argument. */
static inline void second_quadric(struct quadric *q, const struct quadric_steps *steps, const struct excesses *e,
                                  unsigned up)
{
    const int32_t to = 1 << up;
    const int32_t k[3] = {e->second[0] * to, e->second[1] * to, e->second[2] * to};

    sheen_corner_quadric(q, steps, ((uint32_t)e->u[0] << up) + POWER_GUARD, asr32(e->u[1] - e->u[0], 14 - up),
                         asr32(e->u[2] - e->u[0], 14 - up), k);
}

#endif
