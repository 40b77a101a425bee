/*
 * builtin.h - meshes that need no file: builtin:teapot, teapot-fine, sphere, torus, cube.
 */
#ifndef SHEEN_BUILTIN_H
#define SHEEN_BUILTIN_H

#include "polygons.h"

#define SHEEN_BUILTIN "builtin:"

/*
 * name: with the prefix. 0, SHEEN_ERR_ARGUMENT and *problem for an unknown name, or
 * SHEEN_ERR_MEMORY. Release with sheen_polygons_free in any case.
 */
int sheen_builtin(struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem);

/* 0 for the name of a file or of an existing builtin, else SHEEN_ERR_ARGUMENT and *problem. */
int sheen_builtin_check(const char *name, struct sheen_problem *problem);

/* Newell's teapot: 32 bicubic patches of 4 x 4 quads, y up, the spout towards +x. */
int sheen_builtin_teapot(struct sheen_polygons *polygons);

/* The same with 10 x 10 quads per patch, for pictures whose outlines are to be smooth. */
int sheen_builtin_fine_teapot(struct sheen_polygons *polygons);

/*
 * A grid of (rows + 1) x (columns + 1) points, already in polygons->points from
 * `base` on, as quads whose corners run (row, column), (row + 1, column), (row + 1,
 * column + 1), (row, column + 1), or the other way around; a quad with two
 * neighbouring corners at the same place becomes a triangle. Adds to polygon_count and
 * corner_count, for which the arrays MUST have room: 4 corners per quad.
 */
void sheen_builtin_grid(struct sheen_polygons *polygons, size_t base, unsigned rows, unsigned columns, int reverse);

#endif
