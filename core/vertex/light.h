/*
 * light.h - private: what a light gives at a unit normal, with a ramp and without.
 */
#ifndef SHEEN_LIGHT_H
#define SHEEN_LIGHT_H

#include "vertex.h"

/* L.N or N.V, Q1.30, held at +-1.0. */
static inline int32_t unit_cosine(const int16_t normal[3], int32_t lacks, const sheen_q30_t v[3])
{
    int32_t value = unit_dot_q29(normal, lacks, v);

    return 2 * min32(max32(value, -(1 << 29)), 1 << 29);
}

/* Of L.N > 0: UQ1.15. */
static inline uint32_t rounded_cosine(int32_t ln)
{
    return ((uint32_t)ln + (1u << 14)) >> 15;
}

/* The highlight of light i at L.N > 0 and N.V, UQ1.15. */
static inline uint32_t reflected_light(const struct lighting *l, unsigned i, struct power power, int32_t ln, int32_t nv)
{
    /* 1 - R.V = (1 + L.V) - 2 (L.N)(N.V), Q2.29; not of rounded cosines, for n makes much of what is lost */
    int32_t u = (int32_t)((uint32_t)l->lv1[i] - (uint32_t)mul_round(ln, nv, 30));

    return highlight_at(power, u, rounded_cosine(ln));
}

#endif
