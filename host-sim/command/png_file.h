/*
 * png_file.h - pictures to PNG files and back: 8 bits each of red, green and blue.
 */
#ifndef SHEEN_PNG_FILE_H
#define SHEEN_PNG_FILE_H

#include <stdint.h>

#include "problem.h"

/* rgb: width * height * 3 bytes, row by row from the top. 0, or a negative code and *problem; never half a file. */
int sheen_png_write(const char *path, const uint8_t *rgb, unsigned width, unsigned height,
                    struct sheen_problem *problem);

/* The same of 4 bytes a pixel, with alpha. */
int sheen_png_write_rgba(const char *path, const uint8_t *rgba, unsigned width, unsigned height,
                         struct sheen_problem *problem);

/* *rgb is the caller's to free. 0, or a negative code and *problem, *rgb then NULL. */
int sheen_png_read(const char *path, uint8_t **rgb, unsigned *width, unsigned *height, struct sheen_problem *problem);

#endif
