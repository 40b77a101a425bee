/*
 * fogged_light.h - private: blocks of colours under fog, between fogged_light.c, which makes them, and fog_rows.c.
 */
#ifndef SHEEN_FOGGED_LIGHT_H
#define SHEEN_FOGGED_LIGHT_H

#include "quadric.h"

#define LONGEST 16 /* px of a block, at the most */

/* A run on its way. */
struct fogged_run {
    const struct tile *t;
    uint16_t *depth;
    const threshold_t *thresholds; /* of the row */
    uint32_t dz;
};

/* Levels in 1/2048. */
struct fogged_colour {
    int32_t channel[3];
};

/* From a colour to before another, n px, and `twice` 1: 2 n. */
void sheen_fogged_block(struct fogged_run *r, uint32_t z, const struct fogged_colour *from,
                        const struct fogged_colour *to, int32_t n, unsigned twice);
/* Any target, by a ramp or without. */
void sheen_fogged_any_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                          struct shaded_run *run, unsigned second);

#endif
