/*
 * simple_polygon.h - polygons in the plane, for tests of what cuts them up. |coordinate| <= 2^28.
 */
#ifndef SIMPLE_POLYGON_H
#define SIMPLE_POLYGON_H

#include <stdint.h>

/* Twice the signed area of a, b, c: > 0 where they turn left. */
int64_t polygon_side(const int32_t a[2], const int32_t b[2], const int32_t c[2]);

/* Turn the corners from..to around. */
void polygon_reverse(int32_t (*at)[2], unsigned from, unsigned to);

/*
 * Random corners within +-extent/2; no two edges have a point in common but neighbours their corner, which may be
 * straight. 0 where no such polygon was found.
 */
int polygon_make_simple(int32_t (*at)[2], unsigned count, uint32_t extent, uint32_t *state);

#endif
