/*
 * bake_text.h - meshes, textures, power tables and ramps as a C header: const data for flash.
 */
#ifndef SHEEN_BAKE_TEXT_H
#define SHEEN_BAKE_TEXT_H

#include <stdio.h>

#include "quantise.h"
#include "texels.h"

/*
 * One mesh or several. With groups, each mesh has its material's name and colour; several meshes without groups differ
 * in their textures.
 */
struct sheen_bake {
    const struct sheen_quantised *meshes;
    const struct sheen_group *groups; /* per mesh; NULL: no group table */
    size_t count;
    const struct sheen_texels *texels; /* the textures */
    size_t texel_count;
    const uint32_t *pictures; /* per mesh, its texture's number + 1, or 0 for none; NULL: no textures */
    const char *name;         /* a C identifier: what the mesh is called */
    const char *source;       /* the command line that made it, for the header's comment */
    int flat;                 /* 1: with polygon normals, for flat shading */
    int edges;                /* 1: with the mesh's edges */
};

/* The bytes of flash that a mesh needs on a 32-bit machine. */
size_t sheen_bake_bytes(const struct sheen_quantised *quantised, int flat, int edges);

/* Writes the header, the same on every machine. 0, SHEEN_ERR_MEMORY, or SHEEN_ERR_ARGUMENT if the stream fails. */
int sheen_bake_text(FILE *stream, const struct sheen_bake *bake);

/* The same for a power table, called `name`. */
int sheen_bake_shine_text(FILE *stream, const struct sheen_shine *shine, const char *name, const char *source);

/* The same for a texture. */
int sheen_bake_texture_text(FILE *stream, const struct sheen_texels *texels, const char *name, const char *source);

/* The same for a ramp. */
int sheen_bake_ramp_text(FILE *stream, const struct sheen_ramp *ramp, const char *name, const char *source);

#endif
