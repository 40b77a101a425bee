/*
 * simple_polygon.h - polygons in the plane, for tests of triangulation. |coordinate| <= 2^28.
 */
#ifndef SIMPLE_POLYGON_H
#define SIMPLE_POLYGON_H

#include <stdint.h>

/* Twice the signed area of a, b, c: > 0 if they turn left. */
int64_t polygon_side(const int32_t a[2], const int32_t b[2], const int32_t c[2]);

/* Reverse the order of the corners from..to. */
void polygon_reverse(int32_t (*at)[2], unsigned from, unsigned to);

/*
 * Random corners within +-extent/2. No two edges have a point in common, except neighbours their corner, which may be
 * straight. 1, or 0 if no such polygon was found.
 */
int polygon_make_simple(int32_t (*at)[2], unsigned count, uint32_t extent, uint32_t *state);

#endif
