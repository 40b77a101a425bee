/*
 * view_letters.h - letters on pixels in memory; no letters if sheen is built without cairo (no_letters.c).
 */
#ifndef SHEEN_VIEW_LETTERS_H
#define SHEEN_VIEW_LETTERS_H

/* Pixels 0xRRGGBB; rows are `pitch` bytes apart, a multiple of 4. */
struct sheen_letters {
    void *pixels;
    int width, height, pitch;
};

/* Draws a line of text from x on with its baseline at y, in px; grey: 0..255. */
void sheen_letters(const struct sheen_letters *letters, int x, int y, int grey, const char *line);

/* Frees what is kept of the font; call it after the last line. */
void sheen_letters_end(void);

#endif
