/*
 * tile.h - private: a band's tile of pixels, its thresholds, and the depth test.
 */
#ifndef SHEEN_TILE_H
#define SHEEN_TILE_H

#include "terms.h"

/*
 * What is added before the one rounding, by row y mod 8 and column x mod 8: the thresholds (B + 1/2) / 64 of the 8x8
 * Bayer matrix, in 1/128. The ninth row is 1/2 throughout: no dither.
 */
#define NO_DITHER 8
extern const uint8_t sheen_thresholds[9][8];

/*
 * The same with B's base-4 digits reversed, for draws that leave out pixels by B itself: the pixels that are left have
 * low B only, so B's thresholds would all be low.
 */
extern const uint8_t sheen_reversed_thresholds[9][8];

/*
 * Thresholds in 1/2048 for channels with 11 fraction bits: each word has its threshold in both halves (shifting it to
 * 24 fraction bits drops the high one), each row is stored twice over. Loops that do not count columns find a pixel's
 * threshold by the address of its depth, relative to an entry that is chosen for each row of a tile (DITHER_ROW).
 */
#if FAST_LOOPS
typedef uint32_t threshold_t;
#define THRESHOLD(t) ((t)*0x100010u)
#else
typedef uint8_t threshold_t;
#define THRESHOLD(t) (t)
#endif
extern const threshold_t sheen_dither_rows[8][16];

static inline uint32_t threshold_pair(const threshold_t *row, const uint16_t *depth)
{
#if !FAST_LOOPS
    return row[(uintptr_t)depth >> 1 & 7u] * 0x100010u;
#elif defined(__ARM_ARCH_6M__) /* two shifts */
    return *(const uint32_t *)((const char *)row + ((uint32_t)(uintptr_t)depth << 28 >> 27));
#else
    return row[(uintptr_t)depth >> 1 & 7u];
#endif
}

/* A row of a triangle inside the tile: x0 <= x < x1; empty if x0 >= x1. */
struct span {
    int16_t x0, x1;
};

/*
 * The next span. Without OPAQUE gcc keeps two pointers, one to read spans and one to compare with the end. On ARMv6-M,
 * where loads of int16_t have no offset, that does no harm.
 */
static inline const struct span *next_span(const struct span *span)
{
    span++;
#if !defined(__ARM_ARCH_6M__)
    OPAQUE(span);
#endif
    return span;
}

/* The facet (a side of a polygon or triangle) that was lit last in a tile: a polygon's triangles mostly follow. */
struct lit_facet {
    const void *draw; /* NULL: none yet */
    uint32_t facet;
    uint16_t diffuse, specular; /* as in struct lit */
    uint16_t pixel;             /* for flat shading without dither */
};

/* A band's pixels while it is drawn: rows without gaps, as wide as its rectangle. */
struct tile {
    struct sheen_rect rect; /* px on the target */
    uint16_t pitch;         /* px */
    uint8_t dither;
    void *pixels; /* uint16_t, or uint8_t on grey */
    uint16_t *depth;
    intptr_t to_pixel; /* on 565: bytes from a pixel's depth to its colour */
    const struct pixel_format *format;
    const uint8_t (*thresholds)[8];        /* sheen_thresholds, or the reversed ones */
    const threshold_t *const *dither_rows; /* by y & 7, for specialised loops: entries of sheen_dither_rows */
    int32_t centre_x, centre_y;            /* the viewport's, 1/64 px on the target: where struct vertex counts from */
    const struct span *spans;
    int16_t first_row; /* the row of spans[0] */
    uint16_t rows;     /* number of spans */
    struct lit_facet facet;
#if SHEEN_STATS
    uint32_t *shaded;
#endif
};

/*
 * The thresholds of row y, starting at the entry relative to which a depth's address finds its threshold. line: the
 * address that column 0's depth would have. For specialised loops sheen_dither_begin has chosen them for the whole
 * tile.
 */
#if FAST_LOOPS
void sheen_dither_begin(const struct tile *t, const threshold_t *thresholds[8]);
#define DITHER_ROW(t, line, y) ((void)(line), (t)->dither_rows[(y)&7])
#else
#define DITHER_ROW(t, line, y) (&sheen_dither_rows[(y)&7][-(unsigned)((uintptr_t)(line) >> 1) & 7u])
#endif

/* The index of pixel (x, y) in the tile. */
SPECIALISED uint32_t tile_offset(const struct tile *t, int32_t x, int32_t y)
{
    return (uint32_t)(y - t->rect.y0) * t->pitch + (uint32_t)(x - t->rect.x0);
}

/* The depth test: 1 if z (UQ16.16 of z16) is nearer, and then it is stored; on a tie the first drawn stays. */
SPECIALISED int nearer(const struct tile *t, uint16_t *depth, uint32_t z)
{
    uint32_t z16 = z >> 16;

    (void)t;
    if (z16 <= *depth)
        return 0;
    *depth = (uint16_t)z16;
    COUNT_SHADED(t);
    return 1;
}

/* On 565: where the colour that belongs to a depth is. */
static inline uint16_t *pixel_at(uint16_t *depth, intptr_t to_pixel)
{
    return (uint16_t *)(void *)((char *)depth + to_pixel);
}

/* Row y's thresholds. */
static inline const uint8_t *threshold_row(const struct tile *t, unsigned dither, int32_t y)
{
    return t->thresholds[dither ? (unsigned)y & 7u : NO_DITHER];
}

/* Packs a tile's grey levels, one per byte, as the target has them, in place. */
void sheen_pack_grey(const struct pixel_format *format, uint8_t *pixels, unsigned width, unsigned rows);

#endif
