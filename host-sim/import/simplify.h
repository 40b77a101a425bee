/*
 * simplify.h - fewer triangles for the same shape, by meshoptimizer.
 */
#ifndef SHEEN_SIMPLIFY_H
#define SHEEN_SIMPLIFY_H

#include "problem.h"

/*
 * corners: *count of them, 3 a triangle, each the number of one of point_count points within 1 of the origin.
 * Leaves at most `most` corners where the shape allows it; *error is how far off the surface then is, of the
 * longest side of the points' box. Points that are equal but for their number keep what joins
 * them, with keeps_joins at any cost: there may be more left then.
 * 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_UNSUPPORTED and *problem where this was built without meshoptimizer.
 */
int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem);

#endif
