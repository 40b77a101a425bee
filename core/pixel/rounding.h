/*
 * rounding.h - private: the one rounding: channels to the pixel of a tile.
 */
#ifndef SHEEN_ROUNDING_H
#define SHEEN_ROUNDING_H

#include "shades.h"
#include "tile.h"

/* A 565 value in the target's byte order. */
static inline uint16_t pixel_order(uint32_t value, unsigned swap)
{
#ifdef __GNUC__
    return swap ? __builtin_bswap16((uint16_t)value) : (uint16_t)value;
#else
    return (uint16_t)(swap ? (value << 8 | value >> 8) : value);
#endif
}

/* The same for a value in the high half of a word; where one instruction swaps all four bytes it needs no shift. */
static inline uint16_t high_order(uint32_t value, unsigned swap)
{
#if defined(__GNUC__) && (defined(__arm__) || defined(__x86_64__))
    if (swap)
        return (uint16_t)__builtin_bswap32(value);
#endif
    return pixel_order(value >> 16, swap);
}

/* Channels, at most 1.0, rounded to a tile's pixel: 565 in the target's byte order, or a grey level. */
uint16_t sheen_finished(const struct colour_terms *t, unsigned is_565, unsigned swap, const uint32_t channel[3]);

/* A colour as a tile's pixel, rounded and not dithered: 565 in the target's byte order, or a grey level. */
uint16_t sheen_colour_pixel(const struct pixel_format *format, const uint8_t rgb[3]);

/*
 * The pixel in the high half of a word, where red's whole levels are already; blue's are shifted up to it, which shifts
 * red's out.
 */
SPECIALISED uint32_t packed_high(struct packed p)
{
    const uint32_t red_blue = p.red_blue & 0xf800f800u, green = (p.green >> 26) << 21;

#if defined(__ARM_ARCH_6M__) /* in this order it needs two registers only */
    return green | red_blue | red_blue << 5;
#else
    return red_blue | red_blue << 5 | green;
#endif
}

SPECIALISED uint16_t packed_565(struct packed p, unsigned swap)
{
    return high_order(packed_high(p), swap);
}

/* The same dithered; pair: threshold_pair of the pixel. */
SPECIALISED uint32_t dithered_high(const struct tile *t, const uint16_t *depth, struct packed p, uint32_t pair)
{
    (void)t;
    (void)depth;
    SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), p.red_blue >> 16, p.green >> 15, p.red_blue & 0xffffu, 11);
    p.red_blue += pair;
    p.green += pair << 15; /* the high half is shifted out */
    return packed_high(p);
}

SPECIALISED uint16_t dithered_565(const struct tile *t, const uint16_t *depth, struct packed p, uint32_t pair,
                                  unsigned swap)
{
    return high_order(dithered_high(t, depth, p, pair), swap);
}

/* A row's thresholds, and the shift that brings them to the draw's fraction bits. */
struct rounding {
    const uint8_t *threshold;
    unsigned shift;
};

SPECIALISED struct rounding rounding_of(const struct tile *t, const struct colour_terms *terms, int32_t y)
{
    struct rounding r = {threshold_row(t, t->dither, y), terms->fraction - 7u};

    return r;
}

/* The one rounding: floor(channel + threshold), each channel clamped to 1.0; grey, fraction, swap: the draw's own. */
SPECIALISED void put_rounded(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                             uint32_t r, uint32_t g, uint32_t b, unsigned grey, unsigned fraction, unsigned swap)
{
    SHEEN_TEST_TAP(t, at, r, g, b, fraction);
    r = clamped(r, terms->top[0]) + threshold;
    g = clamped(g, terms->top[1]);
    b = clamped(b, terms->top[2]);
    if (grey) {
        ((uint8_t *)t->pixels)[at] = (uint8_t)((r + g + b) >> fraction);
        return;
    }
    uint32_t value = (r >> fraction) << 11 | ((g + threshold) >> fraction) << 5 | (b + threshold) >> fraction;
    ((uint16_t *)t->pixels)[at] = pixel_order(value, swap);
}

/* put_rounded as a function, for builds for size. */
void sheen_put_clamped(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                       uint32_t r, uint32_t g, uint32_t b);

SPECIALISED void put_clamped(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                             uint32_t r, uint32_t g, uint32_t b, unsigned grey, unsigned fraction, unsigned swap)
{
    if (FAST_LOOPS)
        put_rounded(t, terms, threshold, at, r, g, b, grey, fraction, swap);
    else
        sheen_put_clamped(t, terms, threshold, at, r, g, b);
}

SPECIALISED void put_general(const struct tile *t, const struct colour_terms *terms, struct rounding rounding,
                             uint32_t at, int32_t x, uint32_t r, uint32_t g, uint32_t b)
{
    uint32_t threshold = (uint32_t)rounding.threshold[(uint32_t)x & 7u] << rounding.shift;

    put_clamped(t, terms, threshold, at, r, g, b, t->format->grey, terms->fraction, t->format->swap);
}

/* floor of channels that include the rounding and that no corner takes above the highest level. */
SPECIALISED uint16_t fast_pixel(uint32_t r, uint32_t g, uint32_t b, unsigned fraction, unsigned swap)
{
    return pixel_order((r >> fraction) << 11 | (g >> fraction) << 5 | b >> fraction, swap);
}

/* max(0, x) for a sum that rounding may have taken below 0. */
SPECIALISED uint32_t not_negative(uint32_t x)
{
    return (int32_t)x < 0 ? 0 : x;
}

/*
 * A 565 pixel in the machine's byte order, from channels with LOOP_FRACTION bits that include the rounding; clamped to
 * the highest level. Range: below 2^31, as int32_t; they may be below 0, which counts as 0, only if `below` is 1.
 */
SPECIALISED uint32_t clamped_565(uint32_t r, uint32_t g, uint32_t b, int below)
{
    r = (uint32_t)asr32((int32_t)r, LOOP_FRACTION);
    g = (uint32_t)asr32((int32_t)g, LOOP_FRACTION);
    b = (uint32_t)asr32((int32_t)b, LOOP_FRACTION);
#ifdef __ARM_FEATURE_SAT /* these become instructions that shift and saturate at once */
    (void)below;
    r = (uint32_t)max32(min32((int32_t)r, 31), 0);
    g = (uint32_t)max32(min32((int32_t)g, 63), 0);
    b = (uint32_t)max32(min32((int32_t)b, 31), 0);
#else
    uint32_t all = g >> 1 | r;
    OPAQUE(all); /* so that it is computed in place by instructions of two operands */
    if ((all | b) > 31) {
        if (below) {
            r = not_negative(r);
            g = not_negative(g);
            b = not_negative(b);
        }
        r = r < 31 ? r : 31;
        g = g < 63 ? g : 63;
        b = b < 31 ? b : 31;
    }
#endif
    return (r << 6 | g) << 5 | b;
}

/* Channels with LOOP_FRACTION bits. lit: L.N, UQ1.15; shines: 0: no highlight is added. */
struct loop_channels {
    uint32_t r, g, b;
};

SPECIALISED struct loop_channels loop_channels(const struct loop_terms *q, uint32_t lit, int shines, uint32_t specular)
{
    struct loop_channels at = {q->ab[0] + q->ab[1] * lit, q->ab[2] + q->ab[3] * lit, q->ab[4] + q->ab[5] * lit};

    if (shines) {
        at.r += q->c[0] * specular;
        at.g += q->c[1] * specular;
        at.b += q->c[2] * specular;
    }
    return at;
}

/*
 * A 565 pixel in the machine's byte order, from loop_channels and the threshold that is added to each of them before
 * the one rounding. Range: channels are below 2.0 plus a threshold, so below 2^31.
 */
SPECIALISED uint32_t loop_pixel(const struct tile *t, const uint16_t *depth, const struct loop_terms *q, uint32_t lit,
                                int shines, uint32_t specular, uint32_t threshold)
{
    const struct loop_channels at = loop_channels(q, lit, shines, specular);

    (void)t;
    (void)depth;
    if (threshold != 0)
        SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), at.r, at.g, at.b, LOOP_FRACTION);
    return clamped_565(at.r + threshold, at.g + threshold, at.b + threshold, 0);
}

#endif
