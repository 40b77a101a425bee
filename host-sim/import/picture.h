/*
 * picture.h - PNG and JPEG files as RGBA, reduced to the size of a texture.
 *
 * They are read row by row, and only sums over the texels are kept, so memory does not grow with the picture. Bytes are
 * taken as they are, without regard to gamma or profiles. Runs in the confined child.
 */
#ifndef SHEEN_PICTURE_H
#define SHEEN_PICTURE_H

#include <stddef.h>
#include <stdint.h>

#include "problem.h"

enum {
    SHEEN_PICTURE_MAX = 8192, /* px a side, in a file */
    SHEEN_TEXTURE_MAX = 512   /* texels a side */
};

struct sheen_image {
    uint16_t size[2]; /* width, height: powers of two up to SHEEN_TEXTURE_MAX */
    uint16_t from[2]; /* px, in the file */
    uint8_t *rgba;    /* 4 bytes per texel, rows from the top; release with free() */
};

/*
 * Reads a picture from a whole file's bytes. Each side becomes the largest power of two that is at most its length and
 * its `most` (1..SHEEN_TEXTURE_MAX, a power of two). Texels are means by area, of colours weighted by alpha, or not
 * weighted if alpha sums to 0. `name`: what messages call it. 0, or SHEEN_ERR_ARGUMENT or _MEMORY and *problem; nothing
 * is left to free then.
 */
int sheen_image_read(struct sheen_image *image, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem);

/* ---- between picture*.c ---- */

/* A picture while it is reduced. */
struct sheen_reducing {
    unsigned from[2], to[2]; /* width, height: px, texels */
    uint64_t *sums;          /* 7 per texel: alpha; r, g, b times alpha; r, g, b. Below 2^42 */
};

/* 0, SHEEN_ERR_ARGUMENT for a size that is not supported, or SHEEN_ERR_MEMORY. */
int sheen_reducing_open(struct sheen_reducing *reducing, uint32_t width, uint32_t height, const unsigned most[2],
                        const char *name, struct sheen_problem *problem);

/* Adds `count` pixels of row y, at x = first, first + step ...; channels: 3 (r, g, b) or 4 (with alpha). */
void sheen_reducing_row(struct sheen_reducing *reducing, uint32_t y, uint32_t first, uint32_t step, uint32_t count,
                        const uint8_t *pixels, unsigned channels);

/* Both open the sums and add the whole picture to them. 0, or an error and *problem. */
int sheen_png_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem);
int sheen_jpeg_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                      const char *name, struct sheen_problem *problem);

#endif
