/*
 * texels.h - a picture as the core's texels: 565 values, or a palette of them.
 */
#ifndef SHEEN_TEXELS_H
#define SHEEN_TEXELS_H

#include "polygons.h"
#include "sheen.h"

struct sheen_texels {
    struct sheen_texture texture; /* points into the arrays below; keyed if a texel is transparent */
    uint16_t *values;             /* 565, one per texel, rows from the top; after the palette if there is one */
    uint8_t *indices;             /* into the palette, packed as in the texture; NULL: no palette */
    uint16_t *palette;            /* 565 */
    unsigned colors;              /* entries of the palette, the key included; 0: no palette */
};

/*
 * colors: 0: no palette; 2..256: at most so many values, the key included; up to 16 take 4 bits per texel, more take 8.
 * A picture with no more values than that keeps them. The same on every machine. 0, or SHEEN_ERR_MEMORY. Release with
 * sheen_texels_free in either case.
 */
int sheen_texels_make(struct sheen_texels *texels, const struct sheen_picture *picture, unsigned colors, int bilinear);
void sheen_texels_free(struct sheen_texels *texels);

/* Bytes of flash for texels, palette and, on a 32-bit machine, the struct. */
size_t sheen_texels_bytes(const struct sheen_texels *texels);

/* r, g, b to the nearest 565 value, and back to the colour that it shows. */
uint16_t sheen_to_565(const uint8_t rgb[3]);
void sheen_from_565(uint16_t value, uint8_t rgb[3]);

/* ---- palette.c ---- */

struct sheen_histogram_color {
    uint16_t value;  /* 565 */
    uint32_t count;  /* texels, more than 0 */
    uint16_t chosen; /* the value that replaces it */
};

/*
 * Chooses at most `most` values, 1..256, to replace the colours, of which there are 1 or more in ascending order:
 * median cut, then at most `rounds` of k-means; SHEEN_PALETTE_ROUNDS are enough for nearly all pictures. Fills in
 * `chosen`. 0, or SHEEN_ERR_MEMORY.
 */
#define SHEEN_PALETTE_ROUNDS 64
int sheen_palette_choose(struct sheen_histogram_color *colors, size_t count, unsigned most, int rounds);

#endif
