/*
 * newton.c - Newton's steps from a table's seed, or from a line; no division anywhere.
 *
 * Lecture, "Newton's Method": for f(r) = 1/r - x the step is r (2 - x r), for f(r) = 1/r^2 - x it is r (3 - x r^2) / 2.
 * They turn a seed's relative error e into e^2 and 3/2 e^2: 2^-14.7 becomes 2^-29.
 */
#include "newton.h"
#include "fixed.h"

/* The product of two UQ1.31, or of UQ0.32 and UQ1.31, saturated. */
static APART uint32_t times(uint32_t a, uint32_t b)
{
    const uint64_t product = (uint64_t)a * b;

    return product >> 63 != 0 ? UINT32_MAX : (uint32_t)(product >> 31);
}

uint32_t sheen_reciprocal(uint32_t x)
{
    uint32_t seed = reciprocal_seed(x) << 16; /* UQ1.31 */
    uint32_t product = mul_high(x, seed);     /* UQ1.31, near 1.0 */

    return times(seed, 0u - product); /* r (2 - x r) */
}

uint32_t sheen_ratio(uint32_t a, uint32_t b)
{
    unsigned zeros = clz32(b);

    return times(a << zeros, sheen_reciprocal(b << zeros));
}

uint32_t sheen_root_step(uint32_t x, uint32_t root)
{
    uint32_t square = mul_high(root, root); /* UQ2.30, in [1, 4] */
    uint32_t product = mul_high(x, square); /* UQ2.30, near 1.0 */

    return times(root, (3u << 30) - product); /* r (3 - x r^2) / 2: reading UQ2.30 as UQ1.31 halves it */
}

/*
 * Starts from a line whose error is below 9 %. Relative errors of the line and after each step: 2^-3.5, 2^-6.4, 2^-12,
 * 2^-23, 2^-29.
 */
uint32_t sheen_reciprocal_root(uint32_t x)
{
    const uint32_t high = x >> 16;
    uint32_t root = 70000 - (40000 * high >> 16); /* UQ1.15 */

    for (int step = 0; step < 2; step++)
        root = root * ((3u << 15) - (high * (root * root >> 16) >> 15)) >> 16;
    return sheen_root_step(x, sheen_root_step(x, root << 16));
}
