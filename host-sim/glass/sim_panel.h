/*
 * sim_panel.h - a simulated panel by name: the shipped driver, a bus, a controller, the glass.
 *
 *   core -> target -> panel driver (hal/) -> sim_bus -> controller -> glass -> the viewer's picture
 *
 * The panel `ideal` is plain RGB565 memory of any size from 8x8 to 640x480, with a driver of a few lines
 * (sim_panel_ideal.c). It is behind the same bus, so that its counters compare with other panels'.
 */
#ifndef SHEEN_SIM_PANEL_H
#define SHEEN_SIM_PANEL_H

#include "sheen_i2c.h"
#include "sheen_panel.h"
#include "sim_bus.h"

/* What `sheen render` asks for, resolved; width and height are the picture's in this orientation. */
struct sheen_sim_choice {
    const struct sheen_panel_record *record; /* NULL: ideal */
    unsigned orientation;                    /* 0..7 */
    uint16_t width, height;                  /* px */
    uint8_t i2c;                             /* the I2C address; 0: SPI */
};

/*
 * Resolves a choice by the command line's rules. orientation: 0..7, or -1 if not given; width and height: 0 if not
 * given. With a size alone, the first orientation that has this size is chosen; with neither, the panel's default one.
 * `ideal` takes any size (default 320x240) and looks the same in every orientation.
 * SHEEN_ERR_ARGUMENT: there is no such panel, or it cannot have that size; why (of why_size bytes) then holds a line
 * without newline that says so.
 */
int sheen_sim_choose(struct sheen_sim_choice *choice, const char *panel, int orientation, unsigned width,
                     unsigned height, char *why, size_t why_size);

/* The B on the wire for the pixels of a whole frame. */
unsigned sheen_sim_frame_bytes(const struct sheen_panel_record *record);

struct sheen_sim_panel;

/*
 * Allocates and powers the panel; nothing is sent. A caller's own record is simulated on the hardware of the record's
 * name. 0, or SHEEN_ERR_MEMORY or _ARGUMENT.
 */
int sheen_sim_panel_open(struct sheen_sim_panel **panel, const struct sheen_sim_choice *choice);
void sheen_sim_panel_close(struct sheen_sim_panel *panel);

/* The target to draw on; valid until the panel is closed. */
const struct sheen_target *sheen_sim_panel_target(struct sheen_sim_panel *panel);

/* Initialises the panel now, so that the first frame's counters hold pixels only. */
int sheen_sim_panel_init(struct sheen_sim_panel *panel);

/* The driver starts anew, as after a restart of its machine; the controller stays as it is. */
int sheen_sim_panel_restart(struct sheen_sim_panel *panel);

/*
 * The picture as the viewer sees it: the glass turned and, for orientations 4..7, mirrored back. Row by row,
 * choice.width x choice.height values: RGB565, or levels 0..sheen_sim_panel_levels(). Dark pixels are 0, and so are
 * those that a round glass lacks.
 * SHEEN_ERR_STATE while a write is under way (wait for the target first).
 */
int sheen_sim_panel_picture(struct sheen_sim_panel *panel, uint16_t *values);

/* The highest grey level: 1, 15; 0: the values are RGB565. */
unsigned sheen_sim_panel_levels(const struct sheen_sim_panel *panel);

/* 0 if a round glass has no pixel at the viewer's (x, y), else 1. */
int sheen_sim_panel_has(const struct sheen_sim_panel *panel, unsigned x, unsigned y);

/* Complaints of controller and bus since the start, and the text of the first ("" for none). */
unsigned sheen_sim_panel_complaints(const struct sheen_sim_panel *panel);
const char *sheen_sim_panel_complaint(const struct sheen_sim_panel *panel);

/* The driver; NULL for ideal. */
struct sheen_panel *sheen_sim_panel_driver(struct sheen_sim_panel *panel);

/* The bus, for counters, faults and hand-written bytes. */
struct sheen_sim_bus *sheen_sim_panel_bus(struct sheen_sim_panel *panel);

#endif
