/* ref_split.h - polygon to triangles, private to the reference and its tests. */
#ifndef REF_SPLIT_H
#define REF_SPLIT_H

#include <stddef.h>
#include <stdint.h>

/* Newell's unit normal of a polygon; zero if it has no area. */
void ref_newell(const double (*position)[3], size_t count, double normal[3]);

/*
 * Split a polygon of `count` >= 3 corners with the unit normal `normal` into at most count - 2 triangles.
 * A polygon that is convex in the normal's plane becomes the fan (0, k, k + 1); from any other, ears are cut.
 * Returns how many triangles were written to out.
 */
size_t ref_split(const double (*position)[3], size_t count, const double normal[3], uint32_t (*out)[3]);

#endif
