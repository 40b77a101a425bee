/*
 * host_build.h - what the steps from polygons to a host mesh hand each other. Private to host_*.c.
 */
#ifndef SHEEN_HOST_BUILD_H
#define SHEEN_HOST_BUILD_H

#include "host_mesh.h"

/* Corners are numbered over the polygons that are kept. */
struct sheen_host_build {
    const struct sheen_polygons *from;
    const struct sheen_host_options *options;
    struct sheen_host_mesh *mesh;
    uint32_t *weld; /* of each point */
    size_t weld_count;
    uint32_t *source;     /* of each corner: its number in the file */
    double (*normals)[3]; /* of each corner: unit */
};

/* The vertex, by place, of a corner. */
static inline uint32_t sheen_corner_weld(const struct sheen_host_build *build, size_t corner)
{
    return build->weld[build->from->corners[build->source[corner]]];
}

/* Fills in build->normals. 0, or SHEEN_ERR_MEMORY. */
int sheen_host_normals(struct sheen_host_build *build);

/*
 * Newell's unit normal of the polygon whose corners are points[corners[0..count-1]];
 * 0 where it has no area, and normal is then zero.
 */
int sheen_host_newell(const double (*points)[3], const uint32_t *corners, uint32_t count, double normal[3]);

/*
 * Split a polygon with that unit normal: out takes count - 2 triangles of indices
 * below count. 0, or SHEEN_ERR_MEMORY.
 */
int sheen_host_split(const double (*points)[3], const uint32_t *corners, uint32_t count, const double normal[3],
                     uint32_t (*out)[3]);

#endif
