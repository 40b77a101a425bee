/*
 * exact_cover.h - coverage by 64-bit edge functions, without any rounding.
 */
#ifndef EXACT_COVER_H
#define EXACT_COVER_H

#include <stdbool.h>
#include <stdint.h>

/* Corners in 1/64 px, y down; |coordinate| < 2^30. */
struct cover_triangle {
    int32_t x[3], y[3];
};

/* Twice the signed area in 1/4096 px^2; > 0 if the corners run clockwise as seen. */
int64_t cover_area(const struct cover_triangle *t);

/*
 * Whether the centre of pixel (px, py) lies inside, on a top edge (horizontal, the interior below it) or on a left edge
 * (the interior to its right). Either winding; a triangle without area covers nothing.
 */
bool cover_inside(const struct cover_triangle *t, int32_t px, int32_t py);

#endif
