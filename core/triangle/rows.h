/*
 * rows.h - private: what the rows of every shading share.
 */
#ifndef SHEEN_ROWS_H
#define SHEEN_ROWS_H

#include "../frame/frame.h"
#include "../math/newton.h"

/* Loops are written once and specialised by constant arguments. */
#if FAST_LOOPS
#define SPECIALISED static inline __attribute__((always_inline))
#else
#define SPECIALISED static inline
#endif

/* Pixels that pass the depth test, in builds that count them. */
#if SHEEN_STATS
#define COUNT_SHADED(t) (++*(t)->shaded)
#else
#define COUNT_SHADED(t) ((void)0)
#endif

/* Where a span's first pixel stands in the tile. */
SPECIALISED uint32_t tile_offset(const struct tile *t, int32_t x, int32_t y)
{
    return (uint32_t)(y - t->rect.y0) * t->pitch + (uint32_t)(x - t->rect.x0);
}

/* A quadric along the rows of a triangle: value in column 0, first difference there in x and to the next row. */
struct quadric_row {
    uint32_t value, dx, dy, dxx, dxy, dyy;
};

SPECIALISED struct quadric_row quadric_row_at(const struct quadric *q, int32_t y)
{
    struct quadric_row r = {q->base + (uint32_t)y * q->dy + pairs(y) * q->dyy,
                            q->dx + (uint32_t)y * q->dxy,
                            q->dy + (uint32_t)y * q->dyy,
                            q->dxx,
                            q->dxy,
                            q->dyy};

    return r;
}

SPECIALISED void quadric_row_next(struct quadric_row *r)
{
    r->value += r->dy;
    r->dy += r->dyy;
    r->dx += r->dxy;
}

/* Where the run of pixels from column x begins: value and first difference. */
SPECIALISED void quadric_run(const struct quadric_row *r, int32_t x, uint32_t *value, uint32_t *difference)
{
    *value = r->value + (uint32_t)x * r->dx + pairs(x) * r->dxx;
    *difference = r->dx + (uint32_t)x * r->dxx;
}

/* Nearer than what is there? Then it is there. z: UQ16.16 of z16; on a tie the first drawn stays. */
SPECIALISED int nearer(const struct tile *t, uint16_t *depth, uint32_t z)
{
    uint32_t z16 = z >> 16;

    (void)t;
    if (z16 <= *depth)
        return 0;
    *depth = (uint16_t)z16;
    COUNT_SHADED(t);
    return 1;
}

/* A row's thresholds, and what they are shifted by to the draw's fraction. */
struct rounding {
    const uint8_t *threshold;
    unsigned shift;
};

SPECIALISED struct rounding rounding_of(const struct tile *t, const struct colour_terms *terms, int32_t y)
{
    struct rounding r = {threshold_row(t->dither, y), terms->fraction - 7u};

    return r;
}

/* What the dithering test compares with: a test build defines it and sees each pixel's unrounded channels. */
#ifndef SHEEN_TEST_TAP
#define SHEEN_TEST_TAP(tile, at, r, g, b, fraction) ((void)0)
#endif

SPECIALISED uint32_t clamped(uint32_t x, uint32_t top)
{
    return x > top ? top : x;
}

/* The one rounding: floor(channel + threshold), each channel at most 1.0. */
SPECIALISED void put_general(const struct tile *t, const struct colour_terms *terms, struct rounding rounding,
                             uint32_t at, int32_t x, uint32_t r, uint32_t g, uint32_t b)
{
    uint32_t threshold = (uint32_t)rounding.threshold[(uint32_t)x & 7u] << rounding.shift;
    unsigned fraction = terms->fraction;

    SHEEN_TEST_TAP(t, at, r, g, b, fraction);
    r = clamped(r, terms->top[0]) + threshold;
    g = clamped(g, terms->top[1]);
    b = clamped(b, terms->top[2]);
    if (t->format->grey) {
        ((uint8_t *)t->pixels)[at] = (uint8_t)((r + g + b) >> fraction);
        return;
    }
    uint32_t value = (r >> fraction) << 11 | ((g + threshold) >> fraction) << 5 | (b + threshold) >> fraction;
    ((uint16_t *)t->pixels)[at] = pixel_order(value, t->format->swap);
}

/* floor of channels that rounding was added to and that no corner takes above the highest level. */
SPECIALISED uint16_t fast_pixel(uint32_t r, uint32_t g, uint32_t b, unsigned fraction, unsigned swap)
{
    return pixel_order((r >> fraction) << 11 | (g >> fraction) << 5 | b >> fraction, swap);
}

/* max(0, x) for a sum that rounding may have taken below 0. */
SPECIALISED uint32_t not_negative(uint32_t x)
{
    return (int32_t)x < 0 ? 0 : x;
}

/* D inside the root table: UQ1.31 from 1/4 to 1 + 1/512. */
#define ROOT_LOWEST (1u << 29)
#define ROOT_RANGE ((3u << 29) + (1u << 22))

#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* A dot product with N over |N|: Q1.30 times UQ1.15 to Q0.15; modulo 2^32, should a sliver's rounding part the two. */
SPECIALISED int32_t normalised(int32_t dot, uint32_t root)
{
    return asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)dot + HALF), 15) * root + HALF), 15);
}

#endif
