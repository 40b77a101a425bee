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

struct phong_cells_setup {
    struct phong_normals_setup of;
    struct plane light, view; /* L.N and V.N, Q1.30 */
};

#define CELL_SHIFT(s) ((s)->detail & 7u) /* the logarithm of a cell's size, px */
#define CELLS_IN_SQUARES 8u              /* between channels 4 px apart a highlight is linear */

/* What `to` has more, in 4 steps. */
SPECIALISED struct packed packed_quarter(struct packed from, struct packed to)
{
    struct packed quarter = {(uint32_t)asr32((int32_t)((to.red_blue >> 1) - (from.red_blue >> 1)), 1),
                             (uint32_t)asr32((int32_t)((to.green >> 1) - (from.green >> 1)), 1)};

    return quarter;
}

/* Of squares of 4 px: a lower corner, and in which steps of a row it comes from the one above. */
struct square_corner {
    struct packed at, down;
};

/* The squares from column x to before x1, the rows y to before `end` of them. */
struct square_line {
    const struct plane *depth;
    int32_t x, x1, y, end;
    const struct span *span; /* of row y */
    const struct square_corner *corner;
};

/*
 * phong_cell_rows.c: columns x to before x1 of row y, within a square; whole squares, in the order of a panel's bus:
 * 1 where no row has parts of others.
 */
void sheen_part_of_square(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y);
int sheen_whole_squares(const struct tile *t, const struct square_line *l);

/* Pixels of a row: at the first, and what the next one has more; d: N.N, whose step changes by `bend`. */
struct root_run {
    uint32_t z, ln, nv, d, step;
    uint32_t dz, dln, dnv, bend;
};

/* phong_rows.c: columns x to before x1, x < x1; *run is used up. */
void sheen_root_run(const struct tile *t, const struct draw *draw, int32_t x, int32_t x1, int32_t y,
                    struct root_run *run);

void sheen_phong_cell_rows(const struct tile *t, const struct setup *s);
void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

#endif
