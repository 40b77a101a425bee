/*
 * sheen_target.h - where finished pixels go: the seam between the core and a panel.
 *
 * The core knows a target only as this struct, whether it is filled in by a panel driver (hal/) or for a memory buffer,
 * an SDL texture or an LVGL canvas. Nothing here speaks of triangles: this is the only header of the core that the HAL
 * includes.
 *
 * Coordinates are pixels, x to the right and y down; (0, 0) is the top left pixel.
 */
#ifndef SHEEN_TARGET_H
#define SHEEN_TARGET_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Every function of sheen that can fail returns one of these, or the negative code of a user's callback, unchanged.
 */
enum sheen_error {
    SHEEN_OK = 0,
    SHEEN_ERR_ARGUMENT = -1,   /* a value outside its documented range, or missing */
    SHEEN_ERR_MEMORY = -2,     /* the arena is too small; the size needed is reported */
    SHEEN_ERR_CAPACITY = -3,   /* more vertices, triangles, draws or pieces than configured */
    SHEEN_ERR_STATE = -4,      /* a call out of order (draw before begin, ...) */
    SHEEN_ERR_DEGENERATE = -5, /* no direction: a zero vector, a polygon without area */
    SHEEN_ERR_BUS = -6,        /* the bus refused or broke off a transfer */
    SHEEN_ERR_TIMEOUT = -7,    /* the bus did not finish in time */
    SHEEN_ERR_UNSUPPORTED = -8 /* the panel or target cannot do what was asked */
};

/* A code of enum sheen_error in a few words, a static string. Never NULL. */
const char *sheen_strerror(int error);

/* Half-open: covers x0 <= x < x1, y0 <= y < y1. Empty if x0 >= x1 or y0 >= y1. */
struct sheen_rect {
    int16_t x0, y0, x1, y1; /* px */
};

/*
 * Byte order and size of a pixel in memory. 565 values are r << 11 | g << 5 | b. Grey levels are packed from left to
 * right, from the high bits of a byte on: 1 pixel per byte for 256 levels, 2 for 16, 8 for 2.
 */
enum sheen_pixel {
    SHEEN_RGB565_BE = 0, /* high byte first: what 8-bit SPI panels take */
    SHEEN_RGB565_LE,     /* low byte first: SDL, LVGL, 16-bit SPI on little-endian cores */
    SHEEN_GREY2,
    SHEEN_GREY16,
    SHEEN_GREY256
};

/* Bits of a pixel in memory: 16, 16, 1, 4, 8. */
static inline unsigned sheen_pixel_bits(enum sheen_pixel pixel)
{
    return pixel <= SHEEN_RGB565_LE ? 16u : pixel == SHEEN_GREY256 ? 8u : pixel == SHEEN_GREY16 ? 4u : 1u;
}

/* Bytes of a row of pixels. If the pixels do not fill the last byte its low bits are unused. */
static inline unsigned sheen_row_bytes(enum sheen_pixel pixel, unsigned pixels)
{
    return (pixels * sheen_pixel_bits(pixel) + 7u) / 8u;
}

/*
 * A target. The struct may be const; ctx is passed to both callbacks.
 *
 * push: send a rectangle. The pixels are stored row by row without gaps; a row takes sheen_row_bytes(pixel, x1 - x0)
 *   bytes. The rectangle's edges are multiples of align_x and align_y, or the target's edges. push MAY return before
 *   the pixels have left: the core does not touch the buffer until wait has returned, and never has two pushes under
 *   way. Returns 0, or a negative code; in that case no push is under way.
 * wait: block until the push under way is done and return its result (0 if none is under way). May be NULL if push
 *   always finishes before it returns.
 *
 * A negative code from either ends the frame (nothing more is pushed, by any worker), is returned to the caller
 * unchanged, and makes the next frame send everything. A frame calls neither of the two while one of them runs.
 */
struct sheen_target {
    void *ctx;                                                          /* passed to both */
    int (*push)(void *ctx, struct sheen_rect rect, const void *pixels); /* see above */
    int (*wait)(void *ctx);                                             /* see above; may be NULL */
    uint16_t width, height;                                             /* px, 1..640 and 1..480 */
    uint8_t pixel;                                                      /* enum sheen_pixel */
    uint8_t align_x, align_y; /* px, powers of two 1..16; 0 counts as 1; GREY16 needs x >= 2, GREY2 x >= 8 */
};

/* Pixels in memory, rows `stride` bytes apart: another library's canvas, a texture, a framebuffer. */
struct sheen_memory {
    void *pixels;  /* the top left one first */
    size_t stride; /* bytes, at least sheen_row_bytes of the width; a multiple of 2 on 565 */
    uint8_t pixel; /* enum sheen_pixel, set by sheen_memory_target */
};

/*
 * Make *target a target whose push copies into *memory, which is borrowed. On packed greys rectangles begin and end on
 * whole bytes. SHEEN_ERR_ARGUMENT if the stride is too small, or odd on 565, if `pixel` is unknown, or if pixels is
 * NULL; width and height are checked by sheen_init().
 */
int sheen_memory_target(struct sheen_target *target, struct sheen_memory *memory, uint16_t width, uint16_t height,
                        enum sheen_pixel pixel);

#ifdef __cplusplus
}
#endif
#endif
