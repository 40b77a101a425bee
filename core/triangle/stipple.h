/*
 * stipple.h - private: how the rows of a draw that leaves pixels out are drawn.
 */
#ifndef SHEEN_STIPPLE_H
#define SHEEN_STIPPLE_H

#include "triangle.h"

/* How many depths are saved at a time. */
#define KEPT_DEPTHS 256
#define STIPPLED_ROWS 16

/* A triangle's rows in a tile while they are drawn: one strip of columns after the other, some rows at a time. */
struct stippled_rows {
    struct span span[STIPPLED_ROWS];
    uint16_t depth[KEPT_DEPTHS];
    const struct span *whole; /* the spans of all its rows */
    unsigned rows, row;       /* how many rows, and the next one */
    int32_t first_row;
    int32_t x, end; /* the strip's first column, and where the triangle ends */
};

/*
 * begin: makes *d a draw that leaves pixels out; SHEEN_ERR_ARGUMENT if transparency or phase are out of range.
 * hide: called until it returns 0. Each time it returns 1, *t holds the next rows that s->rows has to draw; when it
 *   returns 0, *t is as it was at first.
 */
struct sheen_stipple {
    int (*begin)(struct draw *d, const struct sheen_object *object);
    int (*hide)(struct stippled_rows *r, struct tile *t, const struct setup *s);
};

#endif
