/*
 * gif_file.h - frames to an animated GIF, with giflib. It is kept in memory until it is complete and written.
 */
#ifndef SHEEN_GIF_FILE_H
#define SHEEN_GIF_FILE_H

#include <stdint.h>

#include "problem.h"

struct sheen_gif;

/* delay_cs: hundredths of a second per frame; the animation repeats. 0, or SHEEN_ERR_MEMORY; close in either case. */
int sheen_gif_open(struct sheen_gif **gif, unsigned width, unsigned height, unsigned delay_cs);

/*
 * Adds a frame of width * height * 3 bytes with a palette of its own: exact up to 256 colours, otherwise each pixel
 * gets the nearest of 256 chosen 565 colours. 0, or a negative code: then only sheen_gif_close() may follow.
 */
int sheen_gif_add(struct sheen_gif *gif, const uint8_t *rgb);

/* Ends the animation and writes it. 0, or a negative code and *problem. Only sheen_gif_close() may follow. */
int sheen_gif_write(struct sheen_gif *gif, const char *path, struct sheen_problem *problem);

/* NULL is allowed. */
void sheen_gif_close(struct sheen_gif *gif);

#endif
