/*
 * textures.h - which textures of a mesh are shown, and their pictures. Runs where the mesh was read, in the confined
 * child.
 */
#ifndef SHEEN_TEXTURES_H
#define SHEEN_TEXTURES_H

#include "polygons.h"

enum sheen_wrap_option {
    SHEEN_WRAP_OF_FILE, /* repeat if the file says nothing */
    SHEEN_ALL_REPEAT,
    SHEEN_ALL_CLAMP
};

struct sheen_texture_options {
    const char *file; /* a picture for all faces that have uv; NULL: the mesh's own textures */
    int wrap;         /* enum sheen_wrap_option */
    unsigned most;    /* texels a side: a power of two, 1..512; 0: no textures at all */
    int square;       /* 1: pictures that are not square are refused */
    double cutoff;    /* replaces every texture's cutoff; below 0: does not */
    unsigned
        target; /* of a glTF file: 1 and the number of the morph target that is read whole; 0: as the file weighs */
};

#define SHEEN_UV_SPAN 8192.0 /* texels between the least and the largest uv of a texture's faces */

/*
 * Reads the pictures that a face shows, reduced, with mirroring ones unfolded, and drops the others; if options is
 * NULL, drops all of them and the uv. 0, or an error and *problem: a picture that is missing or broken, uv that are no
 * numbers or too far apart, a picture for a mesh without uv. name: the mesh's.
 */
int sheen_textures_read(struct sheen_polygons *polygons, const struct sheen_texture_options *options, const char *name,
                        struct sheen_problem *problem);

#endif
