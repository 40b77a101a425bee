/*
 * host_build.h - the data shared by the steps from polygons to a host mesh. Private to host_*.c.
 */
#ifndef SHEEN_HOST_BUILD_H
#define SHEEN_HOST_BUILD_H

#include "host_mesh.h"
#include "sheen.h"

/* One polygon in the core's integers, its corners numbered in order. */
struct sheen_host_local {
    int32_t *points;           /* 3 per corner */
    uint32_t *order, *scratch; /* 0, 1, 2 ...; SHEEN_TRIANGULATE_WORDS */
};

/* Corners are numbered through all polygons that are kept. */
struct sheen_host_build {
    const struct sheen_polygons *from;
    const struct sheen_host_options *options;
    struct sheen_host_mesh *mesh;
    struct sheen_host_local local; /* room for the largest polygon */
    double side[3];                /* of the bounding box */
    uint32_t *weld;                /* per point */
    size_t weld_count;
    uint32_t *source;         /* per corner: its number in the file */
    sheen_q30_t (*facing)[3]; /* the normal, per polygon */
    sheen_angle_t *angles;    /* per corner */
    double (*normals)[3];     /* per corner: unit vectors */
    /* The other frame's build and mesh, of which only polygons are made; in that build, the first one. NULL: none. */
    struct sheen_host_build *second;
    const struct sheen_host_build *first_frame;
};

/* A corner's vertex, by place. */
static inline uint32_t sheen_corner_weld(const struct sheen_host_build *build, size_t corner)
{
    return build->weld[build->from->corners[build->source[corner]]];
}

/* A unit vector of the core in double precision. */
void sheen_host_unit(const sheen_q30_t from[3], double unit[3]);

/* Allocates build->local. 0, or SHEEN_ERR_MEMORY. */
int sheen_host_local_alloc(struct sheen_host_build *build);
void sheen_host_local_free(struct sheen_host_build *build);

/*
 * Puts the polygon with the corners points[corners[0..count-1]] into build->local.points: relative to its first corner,
 * times a power of two that brings its extent to 2^27..2^28. What is plane or straight in short numbers stays so, and a
 * normal is within 1e-8 unless the polygon is a sliver.
 */
void sheen_host_localise(struct sheen_host_build *build, const uint32_t *corners, uint32_t count);

/* host_morph.c: 0, or SHEEN_ERR_ARGUMENT and *problem if another frame's polygons do not match the mesh's. */
int sheen_host_frames_fit(const struct sheen_polygons *first, const struct sheen_polygons *second, const char *name,
                          const char *second_name, struct sheen_problem *problem);

/* host_morph.c: makes mesh->second once the first frame is finished. 0, or SHEEN_ERR_MEMORY. */
int sheen_host_second(const struct sheen_host_build *build);

/* Fills in build->normals. 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_CAPACITY and *problem: too many faces around vertices. */
int sheen_host_normals(struct sheen_host_build *build, const char *name, struct sheen_problem *problem);

#endif
