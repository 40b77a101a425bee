/*
 * sheen_canvas.h - 2D under and over the triangles: areas, gradients, images, text, for a view's underlay and overlay.
 *
 * A callback gets a struct sheen_canvas for each rectangle that is sent. Everything drawn here is clipped to it, so
 * draw all of your 2D each time. For what changes from frame to frame call sheen_mark() with the rectangles where it
 * was and where it is, so that they are sent. Coordinates are pixels on the target. Nothing is dithered. The argument
 * `pixel` is the canvas's.
 *
 *     static void over(void *ctx, const struct sheen_canvas *canvas)
 *     {
 *         sheen_canvas_text(canvas, canvas->pixel, ctx);
 *     }
 */
#ifndef SHEEN_CANVAS_H
#define SHEEN_CANVAS_H

#include "sheen.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A colour as a canvas's pixel: the value that sheen clears to if the background has that colour. */
uint16_t sheen_canvas_colour(enum sheen_pixel pixel, const uint8_t rgb[3]);

/* Fill the part of rect inside the canvas. */
void sheen_canvas_fill(const struct sheen_canvas *canvas, enum sheen_pixel pixel, struct sheen_rect rect,
                       const uint8_t rgb[3]);

/* Rows of one colour each, from `first` at rect's top row to `last` at its bottom row. */
struct sheen_gradient {
    struct sheen_rect rect; /* px on the target */
    uint8_t first[3];       /* r, g, b of row y0 */
    uint8_t last[3];        /* r, g, b of row y1 - 1 */
};

/* Draw the part of the gradient inside the canvas. */
void sheen_canvas_gradient(const struct sheen_canvas *canvas, enum sheen_pixel pixel,
                           const struct sheen_gradient *gradient);

/* An image in a canvas's pixel format, usually const data in flash. */
struct sheen_image {
    const void *pixels; /* row by row: uint16_t in the target's byte order; on greys one byte per pixel, its level */
    unsigned pitch;     /* pixels from one row to the next; 0: width */
    uint16_t width;     /* px */
    uint16_t height;    /* px */
    int16_t x, y;       /* px on the target, of its top left pixel */
    uint8_t keyed;      /* 1: pixels equal to `key` are transparent */
    uint16_t key;       /* in the format of pixels: sheen_canvas_colour() of a colour */
};

/* Draw the part of the image inside the canvas. */
void sheen_canvas_image(const struct sheen_canvas *canvas, enum sheen_pixel pixel, const struct sheen_image *image);

/*
 * Glyphs of one bit per pixel. A glyph is `height` bytes, one per row from the top, its left pixel in bit width - 1.
 */
struct sheen_font {
    const uint8_t *rows;   /* glyph by glyph */
    uint8_t first, last;   /* the range of characters; others are drawn as a space */
    uint8_t width, height; /* px of a glyph, 1..8 and 1..255 */
    uint8_t advance;       /* px from one glyph to the next */
    uint8_t capitals;      /* 1: lower-case letters are drawn as capitals */
};

/* 5 x 7 px: ASCII from the space to the underscore, lower-case letters as capitals. */
extern const struct sheen_font sheen_font_5x7;

/* A line of text, drawn without a background. */
struct sheen_text {
    const char *line;              /* a C string */
    const struct sheen_font *font; /* NULL: sheen_font_5x7 */
    int16_t x, y;                  /* px on the target, of the first glyph's top left */
    uint8_t scale;                 /* 0 counts as 1 */
    uint8_t rgb[3];                /* all 0 is black */
};

/* Draw the part of the text inside the canvas. */
void sheen_canvas_text(const struct sheen_canvas *canvas, enum sheen_pixel pixel, const struct sheen_text *text);

/*
 * The rectangle that the text covers, for sheen_mark(): from its first glyph to the end of the last one, limited to
 * +-32767. line: NULL, or a line to measure in place of text->line (the longest one to come).
 */
struct sheen_rect sheen_text_rect(const struct sheen_text *text, const char *line);

#ifdef __cplusplus
}
#endif
#endif
