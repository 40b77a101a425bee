/*
 * view_letters.h - letters on pixels in memory; none where sheen was built without cairo (no_letters.c).
 */
#ifndef SHEEN_VIEW_LETTERS_H
#define SHEEN_VIEW_LETTERS_H

/* Pixels 0xRRGGBB, a row every `pitch` bytes, a multiple of 4. */
struct sheen_letters {
    void *pixels;
    int width, height, pitch;
};

/* A line of text from x on, its foot at y, in px; grey 0..255. */
void sheen_letters(const struct sheen_letters *letters, int x, int y, int grey, const char *line);

/* After the last line: gives back what is kept of the font. */
void sheen_letters_end(void);

#endif
