/*
 * glass.h - what an observer sees.
 */
#ifndef SHEEN_GLASS_H
#define SHEEN_GLASS_H

#include "controller.h"

/*
 * What the glass shows at rotation 0, column 0.. from the left, row 0.. from the top: an RGB565 value or a grey level;
 * 0 if nothing is lit.
 */
uint16_t sheen_sim_glass(const struct sheen_sim_controller *controller, unsigned column, unsigned row);

/* 0 if a round glass has no pixel there, else 1. */
int sheen_sim_glass_has(const struct sheen_sim_module *module, unsigned column, unsigned row);

/*
 * Where a viewer's pixel (x, y) is on the glass: its column and row at rotation 0. The viewer has turned (and, from 4
 * on, mirrored) the glass to orientation 0..7.
 */
void sheen_sim_glass_place(const struct sheen_sim_module *module, unsigned orientation, unsigned x, unsigned y,
                           unsigned *column, unsigned *row);

/* Expands a value to 3 bytes r, g, b; max_level as in struct sheen_sim_chip. */
void sheen_sim_expand(uint16_t value, unsigned max_level, uint8_t rgb[3]);

#endif
