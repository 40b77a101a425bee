/*
 * texels.h - a picture as the core's texels: 565 values, or a palette of them.
 */
#ifndef SHEEN_TEXELS_H
#define SHEEN_TEXELS_H

#include "polygons.h"
#include "sheen.h"

struct sheen_texels {
    struct sheen_texture texture; /* points into the arrays below; keyed where a texel is transparent */
    uint16_t *values;             /* 565, a texel, rows from the top; through the palette where there is one */
    uint8_t *indices;             /* into the palette, as the texture has them; NULL: there is none */
    uint16_t *palette;            /* 565 */
    unsigned colors;              /* of the palette, the key's included; 0: there is none */
};

/*
 * colors: 0, or 2..256, at most so many values, the key's included; up to 16 of them take 4 bits a texel, more take 8.
 * A picture that has no more keeps them. The same on every machine. 0, or SHEEN_ERR_MEMORY. Release with
 * sheen_texels_free in either case.
 */
int sheen_texels_make(struct sheen_texels *texels, const struct sheen_picture *picture, unsigned colors, int bilinear);
void sheen_texels_free(struct sheen_texels *texels);

/* B of flash that texels and palette take, and on a 32-bit machine the struct. */
size_t sheen_texels_bytes(const struct sheen_texels *texels);

/* r, g, b to the nearest 565 value, and what it shows. */
uint16_t sheen_to_565(const uint8_t rgb[3]);
void sheen_from_565(uint16_t value, uint8_t rgb[3]);

/* ---- palette.c ---- */

struct sheen_histogram_color {
    uint16_t value;  /* 565 */
    uint32_t count;  /* texels, more than 0 */
    uint16_t chosen; /* what stands for it */
};

/*
 * Chooses at most `most` values, 1..256, for the colours, 1 or more and in ascending order: median cut, then at most so
 * many rounds of means; SHEEN_PALETTE_ROUNDS end nearly all pictures'. Fills in `chosen`. 0, or SHEEN_ERR_MEMORY.
 */
#define SHEEN_PALETTE_ROUNDS 64
int sheen_palette_choose(struct sheen_histogram_color *colors, size_t count, unsigned most, int rounds);

#endif
