/*
 * colored_texels.h - private: textured triangles whose corners have light, or a colour, of three channels each.
 */
#ifndef SHEEN_COLORED_TEXELS_H
#define SHEEN_COLORED_TEXELS_H

#include "glow.h"
#include "shares.h"
#include "texels.h"

/* What a triangle has at its corners, in the mesh's order. Its texture is the draw's tint.texture. */
struct texel_corners {
    struct at_corners channel[6]; /* 3 that multiply a texel's levels, 3 of the highlight: see color_corner */
    unsigned channels;            /* 6, or 3: there is no highlight, and nothing to clamp */
    struct at_corners place[3];   /* U and V as of sheen_texels_of; with texel_of unit normals in eye space, Q0.15 */
    /* U and V of a normal, whose parts are Q1.30; NULL: U and V are linear in space. */
    void (*texel_of)(const struct sheen_texture *t, const uint32_t normal[3], uint32_t at[]);
};

/* If the triangle is a piece, turns values at the mesh's corners into values at the piece's corners. */
void sheen_mix_corners(struct at_corners *at, const struct shares_setup *s);
/* Fills in the channels. glow: at the mesh's corners, of vertices or of the polygon; vertex colours multiply it. */
void sheen_color_corners(struct texel_corners *c, const struct shares_setup *s, const struct glow glow[3]);
/* Draws the rows of a struct shares_setup. */
void sheen_colored_texels(const struct tile *t, const struct setup *s, const struct texel_corners *c);

/* A run of pixels along which all values are linear: `from` at the first pixel, `step` per pixel. */
#define TEXEL_VALUES 8 /* U, V, channels */

struct colored_run {
    const struct tile *t;
    const struct draw *d;
    uint32_t offset; /* of its first pixel in the tile */
    int32_t x, y, count;
    unsigned values; /* 8, or 5: there is no highlight, and nothing to clamp */
    unsigned plain;  /* 1: see plain_colored */
    uint32_t z, dz;
    uint32_t *from; /* may be overwritten */
    const uint32_t *step;
};

void sheen_colored_run(const struct colored_run *r);

#endif
