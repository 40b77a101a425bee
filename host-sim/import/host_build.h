/*
 * host_build.h - what the steps from polygons to a host mesh hand each other. Private to host_*.c.
 */
#ifndef SHEEN_HOST_BUILD_H
#define SHEEN_HOST_BUILD_H

#include "host_mesh.h"
#include "sheen.h"

/* One polygon in the core's integers, its corners numbered in order. */
struct sheen_host_local {
    int32_t *points;           /* 3 a corner */
    uint32_t *order, *scratch; /* 0, 1, 2 ...; SHEEN_TRIANGULATE_WORDS */
};

/* Corners are numbered over the polygons that are kept. */
struct sheen_host_build {
    const struct sheen_polygons *from;
    const struct sheen_host_options *options;
    struct sheen_host_mesh *mesh;
    struct sheen_host_local local; /* room for the largest polygon */
    double side[3];                /* of the bounding box */
    uint32_t *weld;                /* of each point */
    size_t weld_count;
    uint32_t *source;         /* of each corner: its number in the file */
    sheen_q30_t (*facing)[3]; /* the normal of each polygon */
    sheen_angle_t *angles;    /* of each corner */
    double (*normals)[3];     /* of each corner: unit */
    /* Another frame and its mesh, of which polygons alone are made; in it, the first one. NULL: none. */
    struct sheen_host_build *second;
    const struct sheen_host_build *first_frame;
};

/* The vertex, by place, of a corner. */
static inline uint32_t sheen_corner_weld(const struct sheen_host_build *build, size_t corner)
{
    return build->weld[build->from->corners[build->source[corner]]];
}

/* A unit vector of the core in double precision. */
void sheen_host_unit(const sheen_q30_t from[3], double unit[3]);

/* Room in build->local. 0, or SHEEN_ERR_MEMORY. */
int sheen_host_local_alloc(struct sheen_host_build *build);
void sheen_host_local_free(struct sheen_host_build *build);

/*
 * The polygon whose corners are points[corners[0..count-1]] to build->local.points: from its first corner, times
 * a power of two that takes its extent to 2^27..2^28. What is plane or straight in short numbers stays so, and a
 * normal is within 1e-8 where the polygon is no sliver.
 */
void sheen_host_localise(struct sheen_host_build *build, const uint32_t *corners, uint32_t count);

/* host_morph.c: 0, or SHEEN_ERR_ARGUMENT and *problem where another frame's polygons are not those of the mesh. */
int sheen_host_frames_fit(const struct sheen_polygons *first, const struct sheen_polygons *second, const char *name,
                          const char *second_name, struct sheen_problem *problem);

/* host_morph.c: mesh->second of the finished first frame. 0, or SHEEN_ERR_MEMORY. */
int sheen_host_second(const struct sheen_host_build *build);

/* Fills in build->normals. 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_CAPACITY and *problem: too many faces around vertices. */
int sheen_host_normals(struct sheen_host_build *build, const char *name, struct sheen_problem *problem);

#endif
