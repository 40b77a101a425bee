/*
 * vector.c - unit vectors.
 */
#include "vector.h"
#include "fixed.h"
#include "newton.h"

/*
 * The vector is scaled by a power of two until its largest component lies in [2^30, 2^31); then |v|^2 / 4 < 3 * 2^60
 * fits 64 bits, of which the reciprocal root needs only the highest 32.
 */
int sheen_normalize_wide(const int64_t v[3], sheen_q30_t out[3])
{
    uint64_t bits = 0;
    for (int k = 0; k < 3; k++)
        bits |= v[k] < 0 ? 0u - (uint64_t)v[k] : (uint64_t)v[k];
    if (bits == 0)
        return SHEEN_ERR_DEGENERATE;

    const unsigned zeros = clz64(bits) - 1;
    int32_t part[3];
    uint64_t square = 0;
    for (int k = 0; k < 3; k++) {
        /* in [-2^31, 2^31), the largest of magnitude 2^30 or more; -2^31 only if a floor made it */
        part[k] = (int32_t)(uint32_t)((uint64_t)v[k] << zeros >> 32);
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

    return sheen_normalize_wide(wide, out);
}
