/*
 * polygons.h - a mesh as its file lists it: points, polygons, and what normals the file gives.
 *
 * Nothing is welded, fitted, averaged or split here. Every reader (mesh_file.c,
 * builtin.c) makes this, host_mesh.c works on it, and so does the reference of
 * the tests, in its own way.
 */
#ifndef SHEEN_POLYGONS_H
#define SHEEN_POLYGONS_H

#include <stddef.h>
#include <stdint.h>

#include "notes.h"

/* Faces of one material. */
struct sheen_group {
    char name[64];    /* the material's, cut; "" where it has none */
    uint8_t color[3]; /* base colour, sRGB, 255 = 1.0 */
    uint8_t has_color;
};

struct sheen_polygons {
    double (*points)[3]; /* as the file has them, node transforms applied, at most FLT_MAX */
    size_t point_count;
    uint32_t *first; /* polygon_count + 1: polygon p has the corners first[p] .. first[p + 1] - 1, 3 or more */
    size_t polygon_count;
    uint32_t *corners; /* the point of each corner */
    size_t corner_count;
    double (*normals)[3]; /* of each corner, any length, zero where the file has none; NULL: no normals at all */
    uint8_t (*colors)[3]; /* of each corner, sRGB; NULL: none */
    uint16_t *groups;     /* of each polygon, below group_count */
    struct sheen_group *group;
    size_t group_count; /* at least 1 */
    uint8_t z_up;       /* 1: the format's up is z (STL), which a command may turn to y; points are not turned */
    struct sheen_notes notes;
};

enum {
    SHEEN_WITH_NORMALS = 1,
    SHEEN_WITH_COLORS = 2
};

/*
 * Zeroed arrays of these sizes (polygons, corners and groups at least 1); `with`: SHEEN_WITH_... or-ed.
 * 0, or SHEEN_ERR_MEMORY; release with sheen_polygons_free in either case.
 */
int sheen_polygons_alloc(struct sheen_polygons *polygons, size_t points, size_t count, size_t corners, size_t groups,
                         int with);
void sheen_polygons_free(struct sheen_polygons *polygons);

/*
 * What every reader of files ends with: normals that are no number become zero, and a group without a
 * colour of its own takes the mean of its corners', with a note. `name`: of the file.
 */
void sheen_polygons_finish(struct sheen_polygons *polygons, const char *name);

/* z becomes up: (x, y, z) to (x, z, -y), points and normals. */
void sheen_polygons_turn(struct sheen_polygons *polygons);

/* What the comments above promise. 0, or SHEEN_ERR_ARGUMENT and *problem, which names `name` as the file. */
int sheen_polygons_check(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem);

#endif
