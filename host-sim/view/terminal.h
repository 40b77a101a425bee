/*
 * terminal.h - pictures as text: half blocks in 24-bit colour, two pixels a character.
 */
#ifndef SHEEN_TERMINAL_H
#define SHEEN_TERMINAL_H

#include <stdint.h>
#include <stdio.h>

/*
 * The size in characters that shows width x height pixels, their shape kept, in at
 * most max_columns x max_rows: never larger than a pixel to half a character.
 */
void sheen_terminal_size(unsigned width, unsigned height, unsigned max_columns, unsigned max_rows, unsigned *columns,
                         unsigned *rows);

/*
 * rgb: 3 bytes a pixel. Each half of a character is the mean of what it covers.
 * Lines end with the colours reset and `line_end`. A failed write is left in ferror.
 */
void sheen_terminal_picture(FILE *stream, const uint8_t *rgb, unsigned width, unsigned height, unsigned columns,
                            unsigned rows, const char *line_end);

#endif
