/*
 * simplify.c - fewer triangles for the same shape, by meshoptimizer.
 */
#include "simplify.h"

#include <meshoptimizer.h>
#include <stdlib.h>
#include <string.h>

#define ANY_ERROR 1.0f /* an error as large as the mesh */
#define COARSE 0.01f   /* above this error a coarse grid is tried too */

/*
 * Collapses edge by edge, which keeps joined parts joined and ends when no edge may be collapsed. A machine of
 * many small parts then keeps too many triangles, or loses large parts before small ones. In these cases, unless
 * keeps_joins, it also simplifies by a coarse grid, and takes that if edges left too many or none, or were worse.
 */
int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem)
{
    unsigned *made = malloc(2 * *count * sizeof *made), *coarse = made + *count;
    float off = 0, coarse_off = 0;

    (void)problem;
    if (!made)
        return SHEEN_ERR_MEMORY;
    size_t by_grid = 0, left = meshopt_simplify(made, corners, *count, points[0], point_count, sizeof *points, most,
                                                ANY_ERROR, 0, &off);
    if (!keeps_joins && (left > most || off > COARSE))
        by_grid = meshopt_simplifySloppy(coarse, corners, *count, points[0], point_count, sizeof *points, most,
                                         ANY_ERROR, &coarse_off);
    int is_coarse = by_grid > 0 && (left > most || left == 0 || coarse_off < off);
    *count = is_coarse ? by_grid : left;
    memcpy(corners, is_coarse ? coarse : made, *count * sizeof *made);
    *error = (double)(is_coarse ? coarse_off : off);
    free(made);
    return SHEEN_OK;
}
