/*
 * terminal.h - pictures as text: half blocks in 24-bit colour, two pixels per character.
 */
#ifndef SHEEN_TERMINAL_H
#define SHEEN_TERMINAL_H

#include <stdint.h>
#include <stdio.h>

/*
 * The size in characters that shows width x height pixels without distortion in at most max_columns x max_rows; it is
 * never larger than half a character per pixel.
 */
void sheen_terminal_size(unsigned width, unsigned height, unsigned max_columns, unsigned max_rows, unsigned *columns,
                         unsigned *rows);

/*
 * rgb: 3 bytes per pixel. Each half of a character has the mean colour of the pixels that it covers. Lines end with the
 * colours reset and `line_end`. After a failed write ferror(stream) is set.
 */
void sheen_terminal_picture(FILE *stream, const uint8_t *rgb, unsigned width, unsigned height, unsigned columns,
                            unsigned rows, const char *line_end);

#endif
