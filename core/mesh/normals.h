/*
 * normals.h - private: helpers that the files on polygons share.
 */
#ifndef SHEEN_NORMALS_H
#define SHEEN_NORMALS_H

#include "../math/vector.h"

/* out = a - b. Range: |coordinate| <= 2^28, so the difference is at most 2^29. */
static inline void sheen_subtract(const int32_t *a, const int32_t *b, int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

/* The sign of (u x v).normal, exact: 1 if v points to the left of u. Parts of u and v are at most 2^29. */
int sheen_turn(const int32_t u[3], const int32_t v[3], const sheen_q30_t normal[3]);

#endif
