/*
 * terminal.c - pictures as text.
 *
 * U+2580, the upper half block, shows one colour above (the foreground) and one below (the background). Colours are set
 * with ISO 8613-6's 38;2 and 48;2, which most terminals accept, and only where they change.
 */
#include "terminal.h"

#include <string.h>

#define HALF_BLOCK "\xe2\x96\x80" /* UTF-8 of U+2580 */

static unsigned ratio(unsigned a, unsigned b, unsigned c)
{
    unsigned value = (unsigned)(((uint64_t)a * b + c / 2) / c);

    return value ? value : 1;
}

void sheen_terminal_size(unsigned width, unsigned height, unsigned max_columns, unsigned max_rows, unsigned *columns,
                         unsigned *rows)
{
    unsigned across = max_columns < width ? max_columns : width, down = ratio(across, height, width);

    if (across == 0)
        across = down = 1;
    if (down > 2 * max_rows) {
        down = max_rows ? 2 * max_rows : 1;
        across = ratio(down, width, height);
    }
    *columns = across;
    *rows = (down + 1) / 2;
}

/* The mean of the pixels [x0, x1) x [y0, y1), of which there is at least one. */
static void mean(const uint8_t *rgb, unsigned width, unsigned x0, unsigned x1, unsigned y0, unsigned y1,
                 uint8_t colour[3])
{
    unsigned sum[3] = {0, 0, 0}, count = (x1 - x0) * (y1 - y0);

    for (unsigned y = y0; y < y1; y++) {
        for (unsigned x = x0; x < x1; x++) {
            for (unsigned k = 0; k < 3; k++)
                sum[k] += rgb[3 * ((size_t)y * width + x) + k];
        }
    }
    for (unsigned k = 0; k < 3; k++)
        colour[k] = (uint8_t)((2 * sum[k] + count) / (2 * count));
}

/* The pixels [*from, *to) of cell i of n on a side of `length` pixels, at least one. */
static void cell(unsigned i, unsigned n, unsigned length, unsigned *from, unsigned *to)
{
    *from = (unsigned)((uint64_t)i * length / n);
    *to = (unsigned)((uint64_t)(i + 1) * length / n);
    if (*to == *from)
        ++*to;
}

void sheen_terminal_picture(FILE *stream, const uint8_t *rgb, unsigned width, unsigned height, unsigned columns,
                            unsigned rows, const char *line_end)
{
    for (unsigned row = 0; row < rows; row++) {
        uint8_t last[2][3] = {{0, 0, 0}, {0, 0, 0}};
        for (unsigned column = 0; column < columns; column++) {
            unsigned x0, x1, y0, y1;
            uint8_t colour[2][3];
            cell(column, columns, width, &x0, &x1);
            for (unsigned half = 0; half < 2; half++) {
                cell(2 * row + half, 2 * rows, height, &y0, &y1);
                mean(rgb, width, x0, x1, y0, y1, colour[half]);
                if (column == 0 || memcmp(colour[half], last[half], 3) != 0)
                    fprintf(stream, "\x1b[%d;2;%u;%u;%um", half ? 48 : 38, colour[half][0], colour[half][1],
                            colour[half][2]);
            }
            memcpy(last, colour, sizeof last);
            fputs(HALF_BLOCK, stream);
        }
        fprintf(stream, "\x1b[0m%s", line_end);
    }
}
