/*
 * colored_texels.h - private: texels whose light, or colour, has channels of its own at each corner.
 */
#ifndef SHEEN_COLORED_TEXELS_H
#define SHEEN_COLORED_TEXELS_H

#include "glow.h"
#include "shares.h"
#include "texels.h"

/* What a draw's texels come from is d->tint.texture. Of a triangle's corners, in the mesh's order: */
struct texel_corners {
    struct at_corners channel[6]; /* what a level of a texel is multiplied by, then the highlight; see color_corner */
    unsigned channels;            /* 3: there is no highlight, and nothing to clamp */
    struct at_corners place[3]; /* U and V, as sheen_texels_of has them; or unit normals before the eye, Q0.15, for: */
    void (*texel_of)(const struct sheen_texture *t, const uint32_t normal[3], uint32_t at[]); /* parts: Q1.30 */
};

/* Numbers of the mesh's corners become those of a piece's, where it is one. */
void sheen_mix_corners(struct at_corners *at, const struct shares_setup *s);
/* Channels: light at the mesh's corners, of their vertices or of the polygon, times vertices' colours. */
void sheen_color_corners(struct texel_corners *c, const struct shares_setup *s, const struct glow glow[3]);
/* Rows of a struct shares_setup. */
void sheen_colored_texels(const struct tile *t, const struct setup *s, const struct texel_corners *c);

/* A run of pixels along which all is linear: values at the first, and what the next one has more. */
#define TEXEL_VALUES 8 /* U, V, channels */

struct colored_run {
    const struct tile *t;
    const struct draw *d;
    uint32_t offset; /* of its first pixel in the tile */
    int32_t x, y, count;
    unsigned values; /* 5: there is no highlight, and nothing to clamp */
    unsigned plain;  /* 1: see plain_colored */
    uint32_t z, dz;
    uint32_t *from; /* values, which may be stepped */
    const uint32_t *step;
};

void sheen_colored_run(const struct colored_run *r);

#endif
