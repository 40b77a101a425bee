/*
 * simplify.h - fewer triangles for the same shape, by meshoptimizer.
 */
#ifndef SHEEN_SIMPLIFY_H
#define SHEEN_SIMPLIFY_H

#include "problem.h"

/*
 * corners: *count of them, 3 per triangle, each the number of one of point_count points within 1 of the origin.
 * Leaves at most `most` corners if the shape allows it; *error is the error of the surface relative to the longest side
 * of the points' bounding box. Different points at the same place stay joined; with keeps_joins at any cost, so that
 * more may be left.
 * 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_UNSUPPORTED and *problem if this was built without meshoptimizer.
 */
int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem);

#endif
