/*
 * phong.h - private to the room of Phong shading: its set-ups and their rows.
 */
#ifndef SHEEN_PHONG_H
#define SHEEN_PHONG_H

#include "../triangle/reflection.h"
#include "shading.h"

/* One light, one root per pixel. */
struct phong_setup {
    struct setup s;
    int16_t x, y;             /* the pixel that `square` counts from */
    struct plane light, view; /* L.N and V.N, Q1.30 */
    struct quadric square;    /* N.N, UQ1.31 */
};

/* Several lights, one light by cells, and triangles that the other ways do not take. */
struct phong_normals_setup {
    struct setup s;         /* detail: of cells, CELL_SHIFT and CELLS_IN_SQUARES */
    struct plane normal[3]; /* N, Q1.30 */
};

struct phong_cells_setup {
    struct phong_normals_setup of;
    struct plane light, view; /* L.N and V.N, Q1.30 */
};

#define CELL_SHIFT(s) ((s)->detail & 7u) /* the logarithm of a cell's size, px */
#define CELLS_IN_SQUARES 8u              /* a highlight's channels may be linear over squares of 4 px */

/* The step per pixel between channels that are 4 px apart. */
SPECIALISED struct packed packed_quarter(struct packed from, struct packed to)
{
    struct packed quarter = {(uint32_t)asr32((int32_t)((to.red_blue >> 1) - (from.red_blue >> 1)), 1),
                             (uint32_t)asr32((int32_t)((to.green >> 1) - (from.green >> 1)), 1)};

    return quarter;
}

/* A lower corner of squares of 4 px, and the step per row by which it is reached from the corner above. */
struct square_corner {
    struct packed at, down;
};

/* A line of squares: columns x to before x1, of which rows y to before `end` are drawn. */
struct square_line {
    const struct plane *depth;
    int32_t x, x1, y, end;
    const struct span *span; /* of row y */
    const struct square_corner *corner;
};

/*
 * phong_cell_rows.c. sheen_part_of_square: columns x to before x1 of row y, within one square. sheen_whole_squares: the
 * whole squares of a line, in a panel's byte order; 1 if no row has parts of squares besides.
 */
void sheen_part_of_square(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y);
int sheen_whole_squares(const struct tile *t, const struct square_line *l);

void sheen_phong_cell_rows(const struct tile *t, const struct setup *s);
void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

#endif
