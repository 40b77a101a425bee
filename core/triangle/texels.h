/*
 * texels.h - private: where a texture's coordinates lie, and its texels there.
 */
#ifndef SHEEN_TEXELS_H
#define SHEEN_TEXELS_H

#include "triangle.h"

/* What rounding takes off a coordinate that lies on a border must not show the texel on its other side. */
#define BORDER_BIAS 64 /* 1/1024 texel */

/* Of an attribute, in the order of the gradients. */
struct at_corners {
    int32_t f[3];
};

/* Of u (i = 0) or v, which the corners have as their normals, texels, Q15.16: what repeats is brought near 0. */
void sheen_texels_of(struct at_corners *at, const struct draw *d, const struct sheen_texture *t,
                     const struct corners *c, int i);

/*
 * Corners that lie on a border between texels are moved by `by` to the triangle's inside, for by so much what is made
 * of them at pixels may be off: a triangle that ends where a texel does must not show the next one, which may be that
 * of the picture's other side. Coordinates are those of sheen_texels_of.
 */
void sheen_keep_within(struct at_corners at[2], int32_t by);

/* Channels in 1/32 level, of a 565 value or a sum of several by shares of 32: green at bit 21, red at 11, blue at 0. */
#define SPREAD 0x07e0f81fu

SPECIALISED uint32_t spread(uint32_t texel)
{
    return (texel | texel << 16) & SPREAD;
}

/* From a texel's edge to its middle, and half a share. */
#define TO_MIDDLE (0x400u - 0x8000u)

/* 0..mask: held there, or what is left of a division. */
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

/* The four texels about (u, v) by their shares; those that are transparent count as `nearest`. */
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
