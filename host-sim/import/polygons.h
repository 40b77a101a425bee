/*
 * polygons.h - a mesh as its file lists it: points, polygons, and what normals, colours and textures the file gives.
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

enum sheen_wrap {
    SHEEN_WRAP_REPEAT,
    SHEEN_WRAP_CLAMP,
    SHEEN_WRAP_MIRROR
};

#define SHEEN_CUT_ALL 2.0 /* a cut-off that no texel reaches */

/* A texture: where its picture is, and, once it was read (textures.h), what is in it. */
struct sheen_picture {
    char *name;           /* a file's path, or what to call the bytes; NULL once it was read */
    unsigned char *bytes; /* of a PNG or JPEG within the mesh's file; NULL: it is a file of its own */
    size_t count;
    uint8_t wrap[2];  /* in u and v: enum sheen_wrap; mirrors are unfolded as it is read, and repeat then */
    double cutoff;    /* a texel is transparent where alpha / 255 is less; 0..1, or SHEEN_CUT_ALL */
    uint16_t size[2]; /* width and height: powers of two, 1..512; 0: not read */
    uint8_t *rgba;    /* 4 bytes a texel, rows from the top */
};

/* Faces of one material. */
struct sheen_group {
    char name[64];    /* the material's, cut; "" where it has none */
    uint8_t color[3]; /* base colour, sRGB, 255 = 1.0 */
    uint8_t has_color;
    uint32_t picture; /* of its texture: 1 and its number; 0: none */
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
    double (*uvs)[2];     /* of each corner, v downwards, NaN where the file has none; NULL: none at all */
    uint16_t *groups;     /* of each polygon, below group_count */
    struct sheen_group *group;
    size_t group_count; /* at least 1 */
    struct sheen_picture *picture;
    size_t picture_count;
    uint8_t z_up;    /* 1: the format's up is z (STL), which a command may turn to y; points are not turned */
    unsigned target; /* what a reader is asked for, see struct sheen_texture_options */
    struct sheen_notes notes;
};

enum {
    SHEEN_WITH_NORMALS = 1,
    SHEEN_WITH_COLORS = 2,
    SHEEN_WITH_UVS = 4 /* all NaN */
};

/*
 * Zeroed arrays of these sizes (polygons, corners and groups at least 1); `with`: SHEEN_WITH_... or-ed.
 * 0, or SHEEN_ERR_MEMORY; release with sheen_polygons_free in either case.
 */
int sheen_polygons_alloc(struct sheen_polygons *polygons, size_t points, size_t count, size_t corners, size_t groups,
                         int with);
void sheen_polygons_free(struct sheen_polygons *polygons);

/*
 * One more texture, or one like it that is there: its number plus 1 for a group; 0 without memory. The strings of
 * *picture are the polygons' from here on. No group refers to it yet.
 */
uint32_t sheen_polygons_picture(struct sheen_polygons *polygons, struct sheen_picture *picture);

void sheen_picture_free(struct sheen_picture *picture);

/* All of them, and what groups say of them. */
void sheen_polygons_drop_pictures(struct sheen_polygons *polygons);

/* 1: every corner of the polygon has uv and its group a texture. */
int sheen_polygons_is_textured(const struct sheen_polygons *polygons, size_t polygon);

/* What every reader of files ends with: normals that are no number become zero. */
void sheen_polygons_finish(struct sheen_polygons *polygons);

/* z becomes up: (x, y, z) to (x, z, -y), points and normals. */
void sheen_polygons_turn(struct sheen_polygons *polygons);

/* What the comments above promise. 0, or SHEEN_ERR_ARGUMENT and *problem, which names `name` as the file. */
int sheen_polygons_check(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem);

#endif
