/*
 * phong.h - private to the room of Phong shading: its set-ups and their rows.
 */
#ifndef SHEEN_PHONG_H
#define SHEEN_PHONG_H

#include "../triangle/reflection.h"
#include "shading.h"

/* One light, a root a pixel. */
struct phong_setup {
    struct setup s;
    int16_t x, y;             /* the pixel that `square` counts from */
    struct plane light, view; /* L.N and V.N, Q1.30 */
    struct quadric square;    /* N.N, UQ1.31 */
};

/* Several lights, or one by cells, and what the other ways do not take. */
struct phong_normals_setup {
    struct setup s;         /* detail: of cells, CELL_SHIFT and CELLS_IN_SQUARES */
    struct plane normal[3]; /* N, Q1.30 */
};

#define CELL_SHIFT(s) ((s)->detail & 7u) /* the logarithm of a cell's size, px */
#define CELLS_IN_SQUARES 8u              /* between channels 4 px apart a highlight is linear */

/*
 * A corner of a square of 4 px: 2^16 red + blue, UQ5.11 each, as an exact sum so that what blue borrows red gives back,
 * and green UQ6.26. Red is a multiple of 1/128 level: its sixteenth is whole and does not reach blue.
 */
struct corner {
    uint32_t red_blue, green;
};

/* A quarter of what `to` has more. */
SPECIALISED uint32_t quarter(uint32_t from, uint32_t to)
{
    return (uint32_t)asr32((int32_t)((to >> 1) - (from >> 1)), 1);
}

/* On the line between two corners, in row `i` of the 4. */
SPECIALISED struct corner side_of_square(const struct corner *top, const struct corner *bottom, uint32_t i)
{
    struct corner at = {top->red_blue + i * quarter(top->red_blue, bottom->red_blue),
                        top->green + i * quarter(top->green, bottom->green)};

    return at;
}

/* What changes along a row of a square, and its steps. */
struct square_at {
    uint32_t z;
    struct corner colour;
};

/* Where a row is: corners above and below the square's left end, and what stands in its next pixel. */
struct square_row {
    const struct corner *top, *bottom;
    uint32_t i; /* of the 4 rows */
    struct square_at at;
    uint16_t *depth, *pixel;
    const uint8_t *thresholds; /* of the row, NULL: no dither */
    uint32_t dz;
};

/* phong_cell_rows.c: columns x to before x1, within a square. */
void sheen_part_of_square(const struct tile *t, struct square_row *r, int32_t x, int32_t x1);
/* In the order of a panel's bus: the squares from column x on that end by x1; returns the next column. */
int32_t sheen_whole_squares(const struct tile *t, struct square_row *r, int32_t x, int32_t x1);

void sheen_phong_cell_rows(const struct tile *t, const struct setup *s);
void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

#endif
