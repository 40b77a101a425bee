/*
 * picture.h - PNG and JPEG files as RGBA, reduced to what a texture may be.
 *
 * Row by row: of a picture no more is kept than its sums over the texels, so that the memory it takes does not grow
 * with it. Bytes are taken as they stand, without regard to gamma or profiles. Runs in the confined child.
 */
#ifndef SHEEN_PICTURE_H
#define SHEEN_PICTURE_H

#include <stddef.h>
#include <stdint.h>

#include "problem.h"

enum {
    SHEEN_PICTURE_MAX = 8192, /* px a side, of a file */
    SHEEN_TEXTURE_MAX = 512   /* texels a side */
};

struct sheen_image {
    uint16_t size[2]; /* width, height: powers of two up to SHEEN_TEXTURE_MAX */
    uint16_t from[2]; /* px, of the file */
    uint8_t *rgba;    /* 4 a texel, rows from the top; release with free() */
};

/*
 * Of a whole file's bytes: each side becomes the largest power of two that is at most its length and its `most`
 * (1..SHEEN_TEXTURE_MAX, a power of two): the mean by area, colours weighted by alpha, plain where alpha sums to 0.
 * `name`: what messages call it. 0, or SHEEN_ERR_ARGUMENT or _MEMORY and *problem; nothing is left to free then.
 */
int sheen_image_read(struct sheen_image *image, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem);

/* ---- between picture*.c ---- */

/* A picture that is being reduced. */
struct sheen_reducing {
    unsigned from[2], to[2]; /* width, height: px, texels */
    uint64_t *sums;          /* 7 a texel: alpha; r, g, b times alpha; r, g, b. Below 2^42 */
};

/* 0, or SHEEN_ERR_ARGUMENT for a size that is not read, or SHEEN_ERR_MEMORY. */
int sheen_reducing_open(struct sheen_reducing *reducing, uint32_t width, uint32_t height, const unsigned most[2],
                        const char *name, struct sheen_problem *problem);

/* `count` pixels of row y, x = first, first + step ...; channels: 3, r, g, b, or 4, with alpha. */
void sheen_reducing_row(struct sheen_reducing *reducing, uint32_t y, uint32_t first, uint32_t step, uint32_t count,
                        const uint8_t *pixels, unsigned channels);

/* Both give the whole picture to the sums that they open. 0, or an error and *problem. */
int sheen_png_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem);
int sheen_jpeg_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                      const char *name, struct sheen_problem *problem);

#endif
