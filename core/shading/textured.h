/*
 * textured.h - private to the room of textures: its set-up and how its rows are drawn.
 */
#ifndef SHEEN_TEXTURED_H
#define SHEEN_TEXTURED_H

#include "shading.h"

/* What a pixel takes: all give what the first, which takes everything, would. */
enum textured_pixels {
    TEXTURED_ANY,
    TEXTURED_UNLIT, /* the others: nearest texels of 565 that repeat, without key; no light, */
    TEXTURED_LIT    /* or one that is alike in all channels and 1.0 at most, without a highlight */
};

/*
 * Linear on the screen: U and V in texels, Q15.16 modulo 2^32, light, specular intensity. Else these times weight over
 * `weight`, U and V times 2^up / 2^31, the others over 2.
 * Light: alike in all channels: UQ6.25; else the diffuse intensity, UQ2.30. specular: UQ2.30.
 */
struct textured_setup {
    struct setup s; /* fast: enum textured_pixels; detail: up, 0..30 */
    struct plane u, v, light, specular, weight;
};

/* What is stepped along a run. */
struct texel_at {
    uint32_t z, u, v, light, specular;
};

/* Pixels of a row, from (x, y) on, which stands at `depth` in the tile. */
struct texel_run {
    const struct tile *t;
    const struct draw *d;
    uint16_t *depth;
    int32_t x, y, count;
    unsigned pixels; /* enum textured_pixels */
};

void sheen_textured_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step);
void sheen_textured_blocks(const struct tile *t, const struct setup *s);

#endif
