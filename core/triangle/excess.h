/*
 * excess.h - private: what light has more at the middles of a triangle's edges than the mean of their ends, of one of a
 * draw's lights; see reflection.c.
 */
#ifndef SHEEN_EXCESS_H
#define SHEEN_EXCESS_H

#include "reflection.h"

#define REFLECTION_LEAN 32768 /* 1/m at an edge's ends in the ratio of 1 1/8 at most */
#define MAGNIFIED 12          /* gradients' bits: 16 bits of L.N and N.V at corners 64 px apart show in highlights */
#define MOST_ARGUMENT 0xe0000000u /* 3.5 times the power table's range: what a quadric makes of it does not wrap */

static inline int32_t least3(const int32_t x[3])
{
    return min32(x[0], min32(x[1], x[2]));
}

static inline int32_t most3(const int32_t x[3])
{
    return max32(x[0], max32(x[1], x[2]));
}

/* As sheen_cosine_excess, of 1 - R.V, Q.15; u: at the corners, Q2.29. */
static inline int32_t reflected_excess(const struct facing *f, const int32_t u[3], int i, int j, int32_t h,
                                       int32_t lean)
{
    int32_t e = h + asr32(h * h, 18);
    int32_t difference = asr32((f->ln[i] - f->ln[j]) * (f->nv[i] - f->nv[j]), 14);
    int32_t sum = asr32(asr32(f->ln[i] + f->ln[j], 1) * asr32(f->nv[i] + f->nv[j], 1), 15); /* a quarter of it */

    return difference - asr32(sum * e, 15) + asr32(asr32(u[i] - u[j], 14) * lean, 18);
}

/* Of edges 01, 02, 12, whatever the light: as sheen_cosine_excess takes them. */
struct edge_terms {
    int32_t h[3], lean[3]; /* Q0.18 */
};

/* A triangle's quadrics before they are brought to pixels. */
struct excesses {
    struct edge_terms edges;
    int32_t light[3];        /* Q.16 */
    int32_t u[3], second[3]; /* 1 - R.V at the corners, Q2.29; its excess, Q.15 */
    int32_t most;            /* the largest u of all corners */
};

static inline void angle_excesses(struct excesses *e, const struct facing *f)
{
    for (int k = 0; k < 3; k++)
        e->edges.h[k] = (int32_t)(f->h[k] >> 14);
}

/* With angle_excesses, of a light's L.N in *f. */
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
 * 1 where some pixel may have a highlight: a rough bound first, then e->second's, a product of coordinates is 1/4.
 * Dithered, one is left out as well that is faint throughout and beyond power.limit at two corners: over the triangle
 * it is about as little as what is left out everywhere.
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

/* How far apart normals may be where the draw has highlights: see too_sharp. */
static inline uint32_t widest_with_highlight(const struct draw *d)
{
    /* 20 degrees for n <= 32, else 14; 13 and 9 for one above 1/2: what it is off by grows with both */
    static const uint32_t widest_highlight[2][2] = {{129509111u, 63789442u}, {55039867u, 26439087u}};

    return widest_highlight[d->strong][d->power.shininess > 32];
}

/* 1 where a highlight is too sharp for the angle, or its argument may wrap. */
static inline int too_sharp(const struct excesses *e, const struct facing *f, const struct draw *d)
{
    return f->apart > widest_with_highlight(d) || e->most >= (int32_t)(MOST_ARGUMENT >> d->power.up);
}

/* Of light_excesses: Q1.30 and half a step of UQ1.15. */
static inline void light_quadric(struct quadric *q, const struct quadric_steps *steps, const struct facing *f,
                                 const struct excesses *e)
{
    sheen_corner_quadric(q, steps, ((uint32_t)f->ln[0] << 15) + (1u << 14), (f->ln[1] - f->ln[0]) * 2,
                         (f->ln[2] - f->ln[0]) * 2, e->light);
}

/* Of reflected_excesses: the power table's argument. */
static inline void second_quadric(struct quadric *q, const struct quadric_steps *steps, const struct excesses *e,
                                  unsigned up)
{
    const int32_t to = 1 << up;
    const int32_t k[3] = {e->second[0] * to, e->second[1] * to, e->second[2] * to};

    sheen_corner_quadric(q, steps, ((uint32_t)e->u[0] << up) + POWER_GUARD, asr32(e->u[1] - e->u[0], 14 - up),
                         asr32(e->u[2] - e->u[0], 14 - up), k);
}

#endif
