/*
 * sim_panel_ideal.h - the driver of the panel `ideal`.
 */
#ifndef SHEEN_SIM_PANEL_IDEAL_H
#define SHEEN_SIM_PANEL_IDEAL_H

#include "sheen_bus.h"
#include "sheen_target.h"

struct sheen_sim_ideal {
    const struct sheen_bus *bus;
    struct sheen_rect window; /* the last one sent; empty: none */
};

/* A target of that size, RGB565_BE, without alignment. */
void sheen_sim_ideal_target(struct sheen_sim_ideal *ideal, const struct sheen_bus *bus, uint16_t width, uint16_t height,
                            struct sheen_target *target);

#endif
