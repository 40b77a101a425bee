/*
 * products.h - private: products of more than 32 bits, for vertices and triangles.
 *
 * Each has the two forms, wide and halves, that fixed.h describes.
 */
#ifndef SHEEN_PRODUCTS_H
#define SHEEN_PRODUCTS_H

#include "fixed.h"

/* floor(n v / 2^16), n < 2^16. */
static inline uint32_t wide_share(uint32_t n, uint32_t v)
{
    return (uint32_t)(((uint64_t)(n << 16) * v) >> 32);
}

static inline uint32_t halves_share(uint32_t n, uint32_t v)
{
    return n * (v >> 16) + ((n * (v & 0xffffu)) >> 16);
}

/* floor(n v / 2^17), n < 2^16. */
static inline int32_t wide_signed_share(uint32_t n, int32_t v)
{
    return (int32_t)asr64((int64_t)(int32_t)(n << 15) * v, 32);
}

static inline int32_t halves_signed_share(uint32_t n, int32_t v)
{
    return asr32((int32_t)n * asr32(v, 16) + (int32_t)((n * ((uint32_t)v & 0xffffu)) >> 16), 1);
}

/* floor(a b / 2^32). Range: a product of halves plus the carry into it stays below 2^31. */
static inline int32_t wide_high(int32_t a, int32_t b)
{
    return (int32_t)asr64((int64_t)a * b, 32);
}

static inline int32_t halves_high(int32_t a, int32_t b)
{
    const uint32_t a0 = (uint32_t)a & 0xffffu, b0 = (uint32_t)b & 0xffffu;
    const int32_t a1 = asr32(a, 16), b1 = asr32(b, 16), middle = a1 * (int32_t)b0 + (int32_t)(a0 * b0 >> 16);

    return a1 * b1 + asr32(middle, 16) + asr32((int32_t)a0 * b1 + (middle & 0xffff), 16);
}

/* round(a b / 2^30) of cosines in Q1.30, |cosine| <= 1.0. halves_cosines() splits them at 15 bits. */
static inline int32_t wide_cosines(int32_t a, int32_t b)
{
    return mul_round(a, b, 30);
}

static inline int32_t halves_cosines(int32_t a, int32_t b)
{
    const int32_t a0 = a & 0x7fff, b0 = b & 0x7fff, a1 = asr32(a, 15), b1 = asr32(b, 15);

    return a1 * b1 + asr32(a1 * b0 + a0 * b1 + asr32(a0 * b0, 15) + (1 << 14), 15);
}

/*
 * A row of a matrix (components |m| < 2^29, length at most 2^29.01) times a vector of 16-bit components: floor(sum /
 * 2^14). struct halves_row splits m into 2^14 high + low, so that the sums of both products stay below 2^31.
 */
struct wide_row {
    int32_t m[3]; /* m times 4 */
};

struct halves_row {
    int32_t high[3], low[3];
};

static inline void wide_row_set(struct wide_row *row, int k, int32_t m)
{
    row->m[k] = 4 * m;
}

static inline void halves_row_set(struct halves_row *row, int k, int32_t m)
{
    row->high[k] = asr32(m, 14);
    row->low[k] = m & 0x3fff;
}

/* The vector is scaled by 2^16, so that the result is the sum's high word. */
static inline int32_t wide_row_times(const struct wide_row *row, int32_t x, int32_t y, int32_t z)
{
    x *= 1 << 16;
    y *= 1 << 16;
    z *= 1 << 16;
    return (int32_t)asr64((int64_t)x * row->m[0] + (int64_t)y * row->m[1] + (int64_t)z * row->m[2], 32);
}

static inline int32_t halves_row_times(const struct halves_row *row, int32_t x, int32_t y, int32_t z)
{
    return x * row->high[0] + y * row->high[1] + z * row->high[2] +
           asr32(x * row->low[0] + y * row->low[1] + z * row->low[2], 14);
}

#endif
