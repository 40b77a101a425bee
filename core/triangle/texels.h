/*
 * texels.h - private: texel coordinates of a triangle's corners, and a texture's texels at coordinates.
 */
#ifndef SHEEN_TEXELS_H
#define SHEEN_TEXELS_H

#include "triangle.h"

/* Added to coordinates so that rounding cannot take one that lies on a border to the texel on its other side. */
#define BORDER_BIAS 64 /* 1/1024 texel */

/* An attribute at the corners, in the order of the gradients. */
struct at_corners {
    int32_t f[3];
};

/*
 * The texel coordinates U (i = 0) or V (i = 1), Q15.16, from the u and v that corners have in place of normals, in
 * steps of the mesh divided by 2^finer; brought near 0 if the texture repeats.
 */
void sheen_texels_of(struct at_corners *at, const struct draw *d, const struct sheen_texture *t,
                     const struct corners *c, int i, unsigned finer);

/*
 * Moves corners that lie on a border between texels towards the triangle's inside by `by`, which is how far coordinates
 * at pixels may be off: a triangle that ends where a texel ends must not show the next texel, which may be the one at
 * the picture's other side. at: of sheen_texels_of.
 */
void sheen_inset_corners(struct at_corners at[2], int32_t by);

/*
 * A 565 value spread out: green at bit 21, red at 11, blue at 0. Sums of such values by shares of 32 fit, too; their
 * channels are in 1/32 level.
 */
#define SPREAD 0x07e0f81fu

SPECIALISED uint32_t spread(uint32_t texel)
{
    return (texel | texel << 16) & SPREAD;
}

/* Added to coordinates for bilinear: minus half a texel, to count from texels' middles, plus half a share to round. */
#define TO_MIDDLE (0x400u - 0x8000u)

/* i brought into 0..size - 1: clamped, or modulo the size. */
SPECIALISED uint32_t address(int32_t i, unsigned size_log2, unsigned clamp)
{
    const int32_t most = (1 << size_log2) - 1;

    return (uint32_t)(clamp ? max32(0, min32(i, most)) : i & most);
}

/* Texel number n, 565. */
SPECIALISED uint32_t texel_number(const struct sheen_texture *t, uint32_t n)
{
    if (t->bits == 8)
        return t->palette[((const uint8_t *)t->texels)[n]];
    if (t->bits == 4)
        return t->palette[(uint32_t)((const uint8_t *)t->texels)[n >> 1] >> (4 * (n & 1u)) & 15u];
    return ((const uint16_t *)t->texels)[n];
}

/* The texel that holds (i, j). */
SPECIALISED uint32_t texel_value(const struct sheen_texture *t, int32_t i, int32_t j)
{
    return texel_number(t, address(j, t->height_log2, t->clamp_v) << t->width_log2 |
                               address(i, t->width_log2, t->clamp_u));
}

/* The sum of the four texels around (u, v), spread, by their shares; transparent ones count as `nearest`. */
SPECIALISED uint32_t any_mixed(const struct sheen_texture *t, uint32_t u, uint32_t v, uint32_t nearest)
{
    const int32_t i = asr32((int32_t)u, 16), j = asr32((int32_t)v, 16);
    const uint32_t a = u >> 11 & 31u, b = v >> 11 & 31u, both = (a * b + 16) >> 5;
    const uint32_t share[4] = {32 - a - b + both, a - both, b - both, both};
    uint32_t sum = 0;

    for (int k = 0; k < 4; k++) {
        uint32_t texel = texel_value(t, i + (k & 1), j + (k >> 1));
        sum += spread(t->keyed && texel == t->key ? nearest : texel) * share[k];
    }
    return sum;
}

#endif
