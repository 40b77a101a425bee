/*
 * shade.h - private: what the rows of every shading share.
 */
#ifndef SHEEN_SHADE_H
#define SHEEN_SHADE_H

#include "stages.h"

/* Loops are written once and specialised by constant arguments. */
#define SPECIALISED static inline __attribute__((always_inline))

/* Where a span's first pixel stands in the tile. */
SPECIALISED uint32_t tile_offset(const struct tile *t, int32_t x, int32_t y)
{
    return (uint32_t)(y - t->rect.y0) * t->pitch + (uint32_t)(x - t->rect.x0);
}

/* Nearer than what is there? Then it is there. z: UQ16.16 of z16; on a tie the first drawn stays. */
SPECIALISED int depth_test(uint16_t *depth, uint32_t z)
{
    uint32_t z16 = z >> 16;

    if (z16 <= *depth)
        return 0;
    *depth = (uint16_t)z16;
    return 1;
}

/* floor of a channel in levels, at most `top` where some corner may exceed it. */
SPECIALISED uint32_t level_of(uint32_t channel, unsigned fraction, uint32_t top, int clamp)
{
    uint32_t level = channel >> fraction;

    return clamp && level > top ? top : level;
}

SPECIALISED uint16_t pixel_of(uint32_t r, uint32_t g, uint32_t b, unsigned fraction, int clamp, unsigned swap)
{
    return pixel_order(level_of(r, fraction, 31, clamp) << 11 | level_of(g, fraction, 63, clamp) << 5 |
                           level_of(b, fraction, 31, clamp),
                       swap);
}

/* max(0, x) for a sum that rounding may have taken below 0. */
SPECIALISED uint32_t not_negative(uint32_t x)
{
    return (int32_t)x < 0 ? 0 : x;
}

#if SHEEN_STATS
#define COUNT_SHADED(t) (++*(t)->shaded)
#else
#define COUNT_SHADED(t) ((void)0)
#endif

#endif
