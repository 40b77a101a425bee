/*
 * glass.h - what an observer sees.
 */
#ifndef SHEEN_GLASS_H
#define SHEEN_GLASS_H

#include "controller.h"

/*
 * The glass as it stands at rotation 0: column 0.. from the left, row 0.. from
 * the top. An RGB565 value or a grey level; 0 where nothing is lit.
 */
uint16_t sheen_sim_glass(const struct sheen_sim_controller *controller, unsigned column, unsigned row);

/* 0 where a round glass has no pixel there, else 1. */
int sheen_sim_glass_has(const struct sheen_sim_module *module, unsigned column, unsigned row);

/*
 * Where the viewer who has turned (and, from 4 on, mirrored) the glass to
 * orientation 0..7 finds his pixel (x, y) on the glass at rotation 0.
 */
void sheen_sim_glass_place(const struct sheen_sim_module *module, unsigned orientation, unsigned x, unsigned y,
                           unsigned *column, unsigned *row);

/* 3 bytes r, g, b of a value; max_level as in struct sheen_sim_chip. */
void sheen_sim_expand(uint16_t value, unsigned max_level, uint8_t rgb[3]);

#endif
