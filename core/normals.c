/*
 * normals.c - unit vectors and the normals of polygons (at load, not in draw).
 */
#include "fixed.h"
#include "newton.h"
#include "sheen.h"

/*
 * v / |v| for any v but 0. The vector is scaled by a power of two until its
 * largest part lies in [2^30, 2^31); then |v|^2 / 4 < 3 * 2^60 fits 64 bits and
 * the reciprocal root needs 32 of them.
 */
static int normalize64(const int64_t v[3], sheen_q30_t out[3])
{
    uint64_t bits = 0;
    for (int k = 0; k < 3; k++)
        bits |= v[k] < 0 ? 0u - (uint64_t)v[k] : (uint64_t)v[k];
    if (bits == 0)
        return SHEEN_ERR_DEGENERATE;

    unsigned zeros = clz64(bits);
    int32_t part[3];
    uint64_t square = 0;
    for (int k = 0; k < 3; k++) {
        int64_t scaled = zeros >= 33 ? v[k] * ((int64_t)1 << (zeros - 33)) : asr64(v[k], 33 - zeros);
        part[k] = (int32_t)scaled; /* |part| < 2^31, one of them >= 2^30 */
        square += (uint64_t)((int64_t)part[k] * part[k]) >> 2;
    }

    /* x = square * 2^up / 2^64 in [1/4, 1), so |part| = sqrt(x) * 2^(33 - up/2) and
       part / |part| = part * root / 2^(64 - up/2); up is 2 or 4. */
    unsigned up = clz64(square) & ~1u;
    uint32_t root = sheen_reciprocal_root((uint32_t)((square << up) >> 32)); /* UQ1.31 */
    for (int k = 0; k < 3; k++)
        out[k] = (int32_t)round_shift64(part[k] * (int64_t)root, 34 - up / 2);
    return SHEEN_OK;
}

int sheen_normalize(const int32_t v[3], sheen_q30_t out[3])
{
    const int64_t wide[3] = {v[0], v[1], v[2]};

    return normalize64(wide, out);
}

/*
 * Newell's sum is cyclic and does not depend on the origin; taken from the first
 * corner it needs the differences only.
 * Range: differences <= 2^29, products <= 2^58, so six terms of two products stay
 * below 2^62.6; longer sums drop 16 bits of each term first.
 */
int sheen_polygon_normal(const int32_t *points, const uint32_t *corners, unsigned count, sheen_q30_t normal[3])
{
    unsigned scale = count <= 8 ? 0 : 16; /* count - 2 terms */
    const int32_t *origin = points + 3 * (size_t)corners[0];
    int64_t sum[3] = {0, 0, 0};

    for (unsigned i = 1; i + 1 < count; i++) {
        const int32_t *p = points + 3 * (size_t)corners[i], *q = points + 3 * (size_t)corners[i + 1];
        int64_t a[3], b[3];
        for (int k = 0; k < 3; k++) {
            a[k] = (int64_t)p[k] - origin[k];
            b[k] = (int64_t)q[k] - origin[k];
        }
        sum[0] += asr64(a[1] * b[2] - a[2] * b[1], scale);
        sum[1] += asr64(a[2] * b[0] - a[0] * b[2], scale);
        sum[2] += asr64(a[0] * b[1] - a[1] * b[0], scale);
    }
    return normalize64(sum, normal);
}
