/*
 * inverse.h - private: division by a depth or a weight, in 32 bits.
 */
#ifndef SHEEN_INVERSE_H
#define SHEEN_INVERSE_H

#include "newton.h"
#include "products.h"

/*
 * 1/m as a seed and a correction: with u = m << up, 2^32 / u = 2 seed / 2^16 * (1 + lacks / 2^29), to 2^-28; |lacks| <
 * 2^15. The correction is Newton's step, applied to each product instead of to the seed, so that every product has a
 * 16-bit factor.
 */
struct inverse {
    uint32_t seed; /* UQ1.15 */
    int32_t lacks;
    int up;
};

/* m > 0. */
static inline struct inverse inverse_of(uint32_t m)
{
    unsigned up = clz32(m | 1); /* | 1 spares the compiler a test for 0 */
    uint32_t u = m << up;
    IN_REGISTER(u);
    uint32_t seed = reciprocal_seed(u);
    struct inverse i = {seed, asr32((int32_t)((1u << 31) - PRODUCT_FORM(share)(seed, u)), 2), (int)up};

    return i;
}

/*
 * The same for 1 / sqrt(x), x UQ0.32 in [1/4, 1): seed / 2^15 * (1 + lacks / 2^29); `up` is only stored for the caller.
 */
static inline struct inverse inverse_root(uint32_t x, unsigned up)
{
    const uint32_t seed = root_seed(x >> 1),
                   near = PRODUCT_FORM(share)(seed, PRODUCT_FORM(share)(seed, x)); /* UQ2.30 */
    struct inverse i = {seed, asr32((int32_t)((1u << 30) - near), 2), (int)up};

    return i;
}

/* v / u * 2^30, |v| < 2^31; for an inverse_root() v / sqrt(x) / 4. */
static inline int32_t over(struct inverse i, int32_t v)
{
    int32_t share = PRODUCT_FORM(signed_share)(i.seed, v); /* |share| < 2^30 */

    return share + asr32(asr32(share, 15) * i.lacks, 14);
}

#endif
