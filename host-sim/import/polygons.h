/*
 * polygons.h - a mesh as its file lists it: points, polygons, and what normals, colours and textures the file gives.
 *
 * Nothing is welded, fitted, averaged or split here. Every reader (mesh_file.c, builtin.c)
 * makes this; host_mesh.c works on it, and so does the tests' reference, in its own way.
 */
#ifndef SHEEN_POLYGONS_H
#define SHEEN_POLYGONS_H

#include <stddef.h>
#include <stdint.h>

#include "notes.h"

enum sheen_wrap {
    SHEEN_WRAP_REPEAT,
    SHEEN_WRAP_CLAMP,
    SHEEN_WRAP_MIRROR
};

#define SHEEN_CUT_ALL 2.0 /* a cut-off that no texel reaches */

/* A texture: where its picture is and, once read (textures.h), its texels. */
struct sheen_picture {
    char *name;           /* a file's path, or a name for the bytes; NULL once read */
    unsigned char *bytes; /* a PNG or JPEG inside the mesh's file; NULL: it is a file of its own */
    size_t count;
    uint8_t wrap[2];  /* in u and v: enum sheen_wrap; mirroring textures are unfolded when read, and then repeat */
    double cutoff;    /* texels with a smaller alpha / 255 are transparent; 0..1, or SHEEN_CUT_ALL */
    uint16_t size[2]; /* width and height: powers of two, 1..512; 0: not read yet */
    uint8_t *rgba;    /* 4 bytes per texel, rows from the top */
};

/* Faces of one material. */
struct sheen_group {
    char name[64];    /* the material's, truncated; "" if it has none */
    uint8_t color[3]; /* base colour, sRGB, 255 = 1.0 */
    uint8_t has_color;
    uint32_t picture; /* 1 + the number of its texture; 0: none */
};

struct sheen_polygons {
    double (*points)[3]; /* as in the file, with node transforms applied; at most FLT_MAX */
    size_t point_count;
    uint32_t *first; /* polygon_count + 1: polygon p has the corners first[p] .. first[p + 1] - 1, 3 or more */
    size_t polygon_count;
    uint32_t *corners; /* the point of each corner */
    size_t corner_count;
    double (*normals)[3]; /* per corner, any length, zero if the file has none; NULL: no normals at all */
    uint8_t (*colors)[3]; /* per corner, sRGB; NULL: none */
    double (*uvs)[2];     /* per corner, v downwards, NaN if the file has none; NULL: none at all */
    uint16_t *groups;     /* per polygon, below group_count */
    struct sheen_group *group;
    size_t group_count; /* at least 1 */
    struct sheen_picture *picture;
    size_t picture_count;
    uint8_t z_up;    /* 1: the format's up is z (STL); points are as in the file, a command may turn them */
    unsigned target; /* input to a reader: see struct sheen_texture_options */
    struct sheen_notes notes;
};

enum {
    SHEEN_WITH_NORMALS = 1,
    SHEEN_WITH_COLORS = 2,
    SHEEN_WITH_UVS = 4 /* all NaN */
};

/*
 * Allocates zeroed arrays of these sizes (polygons, corners and groups at least 1); `with`: SHEEN_WITH_... or-ed.
 * 0, or SHEEN_ERR_MEMORY; release with sheen_polygons_free in either case.
 */
int sheen_polygons_alloc(struct sheen_polygons *polygons, size_t points, size_t count, size_t corners, size_t groups,
                         int with);
void sheen_polygons_free(struct sheen_polygons *polygons);

/*
 * Adds a texture, or finds one like it: returns its number + 1, for a group; 0: no memory. The strings of *picture
 * belong to the polygons from here on. No group refers to it yet.
 */
uint32_t sheen_polygons_picture(struct sheen_polygons *polygons, struct sheen_picture *picture);

void sheen_picture_free(struct sheen_picture *picture);

/* Drops all textures, and the groups' references to them. */
void sheen_polygons_drop_pictures(struct sheen_polygons *polygons);

/* 1 if every corner of the polygon has uv and its group has a texture. */
int sheen_polygons_is_textured(const struct sheen_polygons *polygons, size_t polygon);

/* The last step of every reader of files: normals that are not numbers become zero. */
void sheen_polygons_finish(struct sheen_polygons *polygons);

/* Turns points and normals from z up to y up: (x, y, z) to (x, z, -y). */
void sheen_polygons_turn(struct sheen_polygons *polygons);

/* Checks all that the comments above say. 0, or SHEEN_ERR_ARGUMENT and *problem, which names `name` as the file. */
int sheen_polygons_check(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem);

#endif
