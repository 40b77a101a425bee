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

/* `count` squares from column x on, the rows y to before `end` of them. */
struct square_line {
    const struct plane *depth;
    int32_t x, y, end, count;
    const struct span *span; /* of row y */
    const struct corner *top, *bottom;
};

void sheen_phong_squares(const struct tile *t, const struct square_line *l);
void sheen_phong_cell_rows(const struct tile *t, const struct setup *s);
void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

#endif
