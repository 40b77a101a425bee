/*
 * textures.h - which textures of a mesh are shown, and their pictures. Runs where the mesh was read, in the confined
 * child.
 */
#ifndef SHEEN_TEXTURES_H
#define SHEEN_TEXTURES_H

#include "polygons.h"

enum sheen_wrap_option {
    SHEEN_WRAP_OF_FILE, /* repeat where it says nothing */
    SHEEN_ALL_REPEAT,
    SHEEN_ALL_CLAMP
};

struct sheen_texture_options {
    const char *file; /* a picture for every face that has uv; NULL: the mesh's own */
    int wrap;         /* enum sheen_wrap_option */
    unsigned most;    /* texels a side: a power of two, 1..512; 0: no textures at all */
    int square;       /* 1: one that is not is refused */
    double cutoff;    /* in place of every texture's; below 0: none */
    unsigned
        target; /* of a glTF file: 1 and the number of the morph target that is read whole; 0: as the file weighs */
};

#define SHEEN_UV_SPAN 8192.0 /* texels between the least and the largest uv of a texture's faces */

/*
 * Reads the pictures that a face shows, reduced, mirrored ones unfolded, and drops the others, with options NULL all
 * of them and the uv. 0, or an error and *problem: a picture that is not there or not right, uv that are no numbers
 * or too far apart, a picture for a mesh without uv. name: of the mesh.
 */
int sheen_textures_read(struct sheen_polygons *polygons, const struct sheen_texture_options *options, const char *name,
                        struct sheen_problem *problem);

#endif
