/*
 * stipple.h - private: how the rows of a draw that leaves pixels out are drawn.
 */
#ifndef SHEEN_STIPPLE_H
#define SHEEN_STIPPLE_H

#include "triangle.h"

/* Depths that are kept at a time. */
#define KEPT_DEPTHS 256
#define STIPPLED_ROWS 16

/* A triangle's rows in a tile on their way: a strip of columns after the other, some rows of it at a time. */
struct stippled_rows {
    struct span span[STIPPLED_ROWS];
    uint16_t depth[KEPT_DEPTHS];
    const struct span *whole; /* of all its rows, */
    unsigned rows, row;       /* how many, and the next */
    int32_t first_row;
    int32_t x, end; /* the strip's first column, and where the triangle ends */
};

/*
 * begin: makes *d such a draw; SHEEN_ERR_ARGUMENT where transparency or phase are out of range.
 * hide: makes *t the first rows that s->rows is to draw, then the next, while it returns 1; before 0, what it was.
 */
struct sheen_stipple {
    int (*begin)(struct draw *d, const struct sheen_object *object);
    int (*hide)(struct stippled_rows *r, struct tile *t, const struct setup *s);
};

#endif
