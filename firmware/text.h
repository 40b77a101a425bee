/*
 * text.h - a line of text over a picture: 5x7 glyphs, drawn by the core's overlay callback.
 */
#ifndef TEXT_H
#define TEXT_H

#include "sheen.h"

#define TEXT_MAX 15

/* Glyphs: digits, A-Z (small letters show as these), '.', anything else as a space. */
struct text {
    char line[TEXT_MAX + 1]; /* ends with 0 */
    int16_t x, y;            /* px, of the first glyph's top left on the target */
    uint8_t scale;           /* 1: 5x7 px in a cell of 6 x 8 */
    uint8_t pixel;           /* enum sheen_pixel of the target */
};

/* Where the longest line would stand; clipped to a target of that size. */
struct sheen_rect text_rect(const struct text *text, unsigned width, unsigned height);

/* An overlay (sheen.h, struct sheen_view) whose ctx is a struct text: white glyphs, the rest left alone. */
void text_overlay(void *ctx, const struct sheen_canvas *canvas);

#endif
