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

/* The same with 4 bytes per pixel: red, green, blue and alpha. */
int sheen_png_write_rgba(const char *path, const uint8_t *rgba, unsigned width, unsigned height,
                         struct sheen_problem *problem);

/* Reads a picture into *rgb; free() it. 0, or a negative code and *problem, and *rgb is NULL. */
int sheen_png_read(const char *path, uint8_t **rgb, unsigned *width, unsigned *height, struct sheen_problem *problem);

#endif
