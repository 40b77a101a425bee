/*
 * normal_rows.h - private: the loop of normal_rows.c, for light with and without a ramp.
 */
#ifndef SHEEN_NORMAL_ROWS_H
#define SHEEN_NORMAL_ROWS_H

#include "normal.h"

/*
 * A pixel's normal, Q0.15, scaled to a length in [1/2, 1], and 1/|N|: a root seed, UQ1.15, and the share of itself,
 * Q.28, by which it is too small. That correction is for magnified triangles: there thousands of pixels have the seed's
 * error, and a highlight multiplies it by n. The angle by which rounding turns N does not show.
 */
struct pixel_normal {
    int32_t n[3];
    uint32_t root;
    int32_t lacks;
};

/* (1 - D root^2) / 2, Q.28, below 2^15; D: UQ1.31. */
static int32_t root_lacks(uint32_t d, uint32_t root)
{
    const uint32_t square = root * root, high = d >> 16, low = d & 0xffffu; /* UQ2.30 */
    uint32_t product =
        high * (square >> 16) + (high * (square & 0xffffu) >> 16) + (low * (square >> 16) >> 16); /* UQ.29 */

    return asr32((int32_t)((1u << 29) - product), 2);
}

/* Returns 0 if N is too short to have a direction. */
SPLIT int pixel_normal(const uint32_t plane[3], struct pixel_normal *p)
{
    int32_t *n = p->n;
    uint32_t square = 0; /* UQ2.30 */

    for (int i = 0; i < 3; i++) {
        n[i] = asr32((int32_t)(plane[i] + HALF), 15); /* |n| <= 2^16 whatever the planes */
        n[i] = min32(max32(n[i], -32768), 32768);
        square += (uint32_t)(n[i] * n[i]); /* three terms <= 2^30 */
    }
    if (square < 1u << 6) /* |n| < 8, half of what LEAST_WEIGHT leaves a corner */
        return 0;
    if (square >= 1u << 30) /* a unit normal, rounded outwards */
        square = 1u << 30;
    while (square < ROOT_LOWEST >> 1) {
        square <<= 2;
        for (int i = 0; i < 3; i++)
            n[i] *= 2;
    }
    p->root = root_seed(square << 1);
    p->lacks = root_lacks(square << 1, p->root);
    return 1;
}

/* v.N / |N|, clamped to +-1.0: Q2.29. Range: |dot| < 2^31, so root times its high half stays below 2^31. */
SPECIALISED int32_t unit_dot_at(const struct pixel_normal *p, const int32_t v[3])
{
    int32_t dot = 2 * dot32_q29(p->n, v);
    int32_t x = (int32_t)p->root * asr32(dot, 16) + (int32_t)(p->root * ((uint32_t)dot & 0xffffu) >> 16);

    x += asr32(asr32(x, 15) * p->lacks, 13);
    return min32(max32(x, -(1 << 29)), 1 << 29);
}

/* Q2.29 to Q0.15 */
SPECIALISED int32_t rounded_cosine(int32_t ln)
{
    return asr32(ln + (1 << 13), 14);
}

/* The highlight of light i, UQ1.15, for L.N = ln > 0 and V.N = facing, both Q2.29. */
SPLIT uint32_t pixel_highlight(const struct draw *d, unsigned i, int32_t ln, int32_t facing)
{
    const int32_t product = mul_16_32(asr32(ln, 14), facing) + asr32((ln & 0x3fff) * asr32(facing, 15), 15); /* Q.28 */

    return highlight_at(d->power, (int32_t)((uint32_t)d->light.lv1[i] - 4u * (uint32_t)product),
                        (uint32_t)rounded_cosine(ln));
}

/* Sums up the lights, each with its weight. */
SPLIT void light_pixel(const struct draw *d, const struct pixel_normal *p, struct lit *lit, int by_ramp)
{
    const struct lighting *l = &d->light;
    const int32_t facing = unit_dot_at(p, l->view);
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0 */

    for (unsigned i = 0; i < l->count; i++) {
        const int32_t ln = unit_dot_at(p, l->to[i]), rounded = rounded_cosine(ln);
        if (by_ramp)
            diffuse += l->diffuse_weight[i] * response_at(l->ramp, rounded);
        if (ln <= 0)
            continue;
        if (!by_ramp)
            diffuse += l->diffuse_weight[i] * (uint32_t)rounded;
        specular += l->specular_weight[i] * pixel_highlight(d, i, ln, facing);
    }
    lit->diffuse = (diffuse + HALF) >> 15;
    lit->specular = (specular + HALF) >> 15;
}

SPLIT void normal_loop(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                       const struct normal_run *run, int by_ramp, int is_fogged)
{
    struct rounding rounding = rounding_of(t, &d->colour, y);
    uint32_t at = tile_offset(t, x, y), z = run->z, n0 = run->n[0], n1 = run->n[1], n2 = run->n[2];

    for (; x < x1; x++, at++, z += run->dz) {
        if (nearer(t, t->depth + at, z)) {
            const uint32_t normal[3] = {n0, n1, n2};
            struct lit lit = {0, 0};
            struct pixel_normal p;
            if (pixel_normal(normal, &p))
                light_pixel(d, &p, &lit, by_ramp);
            if (is_fogged)
                put_fogged_lit(t, d, rounding, at, x, z, &lit);
            else
                put_lit(t, d, rounding, at, x, lit);
        }
        n0 += run->dn[0];
        n1 += run->dn[1];
        n2 += run->dn[2];
    }
}

#endif
