/*
 * normals.c - the normals of polygons (run at load, not while drawing).
 */
#include "normals.h"
#include "../math/fixed.h"
#include "../sheen.h"

/* The bitwise OR of all coordinate distances from a polygon's first corner: as many bits as the largest; < 2^30. */
static uint32_t reach(const int32_t *points, const uint32_t *corners, unsigned count)
{
    const int32_t *origin = points + 3 * (size_t)corners[0];
    uint32_t all = 0;

    for (unsigned i = 1; i < count; i++)
        for (int k = 0; k < 3; k++)
            all |= magnitude32(points[3 * (size_t)corners[i] + (size_t)k] - origin[k]);
    return all;
}

/* Newell's sum, exact: part k is high[k] * 2^drop + low[k], 0 <= low < 2^31 * count. */
struct newell {
    int64_t high[3], low[3];
    unsigned drop; /* 0..31 */
};

/* Adds the term of the edge from p to q, with `origin` as the origin. */
static void add_edge(struct newell *sum, const int32_t *origin, const int32_t *p, const int32_t *q)
{
    for (int k = 0; k < 3; k++) {
        int m = k == 2 ? 0 : k + 1, n = k == 0 ? 2 : k - 1;
        int64_t am = p[m] - origin[m], an = p[n] - origin[n], bm = q[m] - origin[m], bn = q[n] - origin[n];
        int64_t term = am * bn - an * bm, high = asr64(term, sum->drop);
        sum->high[k] += high;
        sum->low[k] += term - high * ((int64_t)1 << sum->drop);
    }
}

/*
 * Newell's sum is cyclic and does not depend on the origin: with the first corner as the origin, the terms of the two
 * edges at that corner vanish and only differences are needed.
 * Range: differences are below 2^d (d <= 30), a term of two products below 2^(2d + 1), the sum of count - 2 terms
 * below 2^(2d + 1 + c). If that exceeds 62 bits, the excess low bits of each term are summed separately.
 */
int sheen_polygon_normal(const int32_t *points, const uint32_t *corners, unsigned count, sheen_q30_t normal[3])
{
    unsigned bits = 2 * (32 - clz32(reach(points, corners, count))) + 1 + (32 - clz32(count - 2));
    struct newell sum = {.drop = bits > 62 ? bits - 62 : 0};
    const int32_t *origin = points + 3 * (size_t)corners[0];
    uint64_t large = 0;

    for (unsigned i = 1; i + 1 < count; i++)
        add_edge(&sum, origin, points + 3 * (size_t)corners[i], points + 3 * (size_t)corners[i + 1]);
    for (int k = 0; k < 3; k++) {
        sum.high[k] += asr64(sum.low[k], sum.drop);
        sum.low[k] &= ((int64_t)1 << sum.drop) - 1;
        large |= (uint64_t)(sum.high[k] < 0 ? ~sum.high[k] : sum.high[k]);
    }
    /*
     * If the high parts are below 2^31, the whole sum fits 62 bits and is used, so that an area of exactly zero is
     * seen; otherwise the low part is less than 2^-30 of the sum and is dropped.
     */
    if (large >> 31 == 0) {
        for (int k = 0; k < 3; k++)
            sum.high[k] = sum.high[k] * ((int64_t)1 << sum.drop) + sum.low[k];
    }
    return sheen_normalize_wide(sum.high, normal);
}

/*
 * Range: parts of u and v are at most 2^29, so a part of the cross product is at most 2^59. It is split at bit 29: its
 * high part times 2^30 is at most 2^60, its low part times 2^30 below 2^59, and three of either fit 62 bits.
 */
int sheen_turn(const int32_t u[3], const int32_t v[3], const sheen_q30_t normal[3])
{
    const int64_t below = ((int64_t)1 << 29) - 1;
    int64_t high = 0, low = 0;

    for (int k = 0; k < 3; k++) {
        int m = k == 2 ? 0 : k + 1, n = k == 0 ? 2 : k - 1;
        int64_t cross = (int64_t)u[m] * v[n] - (int64_t)u[n] * v[m];
        high += asr64(cross, 29) * normal[k];
        low += (cross & below) * normal[k];
    }
    high += asr64(low, 29);
    return high < 0 ? -1 : high > 0 || (low & below) != 0;
}
