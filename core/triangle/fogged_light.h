/*
 * fogged_light.h - private: blocks of colours under fog, between fogged_light.c, which makes them, and fog_rows.c.
 */
#ifndef SHEEN_FOGGED_LIGHT_H
#define SHEEN_FOGGED_LIGHT_H

#include "quadric.h"

#define LONGEST_BLOCK 16 /* px */

/* The run being drawn. */
struct fogged_run {
    const struct tile *t;
    uint16_t *depth;
    const threshold_t *thresholds; /* of the row */
    uint32_t dz;
};

/* Channels in 1/2048 level. */
struct fogged_colour {
    int32_t channel[3];
};

/* Draws n px (twice 1: 2 n px) from one colour to just before the other. */
void sheen_fogged_block(struct fogged_run *r, uint32_t z, const struct fogged_colour *from,
                        const struct fogged_colour *to, int32_t n, unsigned twice);
/* Draws a run on any target, with a ramp or without. */
void sheen_fogged_any_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                          struct shaded_run *run, unsigned second);

#endif
