/*
 * bake_text.h - meshes, textures, power tables and ramps as a C header: const data for flash.
 */
#ifndef SHEEN_BAKE_TEXT_H
#define SHEEN_BAKE_TEXT_H

#include <stdio.h>

#include "quantise.h"
#include "texels.h"

/*
 * A mesh, or one of several: with groups each has its material's name and colour; several without show different
 * textures.
 */
struct sheen_bake {
    const struct sheen_quantised *meshes;
    const struct sheen_group *groups; /* of each mesh; NULL: one mesh without a group table */
    size_t count;
    const struct sheen_texels *texels; /* the textures */
    size_t texel_count;
    const uint32_t *pictures; /* of each mesh, 1 and the number of its texture, 0 for none; NULL: without textures */
    const char *name;         /* a C identifier: what the mesh is called */
    const char *source;       /* the command line that made it, for the header's comment */
    int flat;                 /* 1: with polygon normals, for flat shading */
    int edges;                /* 1: with the mesh's edges */
};

/* B of flash that a mesh takes on a 32-bit machine. */
size_t sheen_bake_bytes(const struct sheen_quantised *quantised, int flat, int edges);

/* The header's text. The same on every machine. 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_ARGUMENT where the stream fails. */
int sheen_bake_text(FILE *stream, const struct sheen_bake *bake);

/* Likewise of a power table, called `name`. */
int sheen_bake_shine_text(FILE *stream, const struct sheen_shine *shine, const char *name, const char *source);

/* Likewise of a texture. */
int sheen_bake_texture_text(FILE *stream, const struct sheen_texels *texels, const char *name, const char *source);

/* Likewise of a ramp. */
int sheen_bake_ramp_text(FILE *stream, const struct sheen_ramp *ramp, const char *name, const char *source);

#endif
