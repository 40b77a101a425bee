/*
 * driver.h - private to hal/: what a driver is, and the steps that drivers share.
 */
#ifndef SHEEN_DRIVER_H
#define SHEEN_DRIVER_H

#include "sheen_panel.h"

/*
 * init: from any state of the controller to a lit, oriented panel.
 * orient: tells a lit controller its orientation; NULL where the packer turns.
 * push: a rectangle that lies inside the target, aligned; may leave its last
 *   call of the bus under way (panel->flying). Pixels as in sheen_target.h.
 * reset_command: a reset by command for boards without a reset line, < 0: none.
 * off: the commands that darken the glass and put the controller to sleep.
 * tearing_command: takes a parameter 0 and switches the TE output on, 0: none.
 * brightness_on: before the first brightness, command and parameter; 0: nothing.
 */
struct sheen_panel_driver {
    int (*init)(struct sheen_panel *panel);
    int (*orient)(struct sheen_panel *panel);
    int (*push)(struct sheen_panel *panel, struct sheen_rect rect, const uint8_t *pixels);
    int16_t reset_command;
    uint8_t off[2], off_count;
    uint8_t tearing_command;
    uint8_t brightness_on[2];
    uint8_t write_command;  /* before pixels; 0: none (greys) */
    uint8_t low_parameters; /* 1: parameters leave with D/C low, as commands do */
    uint8_t align_x,
        align_y; /* px, a power of 2, of the target; of both axes the larger where the driver turns pixels */
};

/*
 * A rectangle on the glass at rotation 0, and where its pixels stand in the
 * rectangle that the core handed over: pixel (i, j) of the glass's rectangle is
 * number start + i * right + j * down of the core's, counted along its rows.
 */
struct sheen_turn {
    int32_t start, right, down;
    int16_t x, y, w, h; /* px, on the glass */
};

void sheen_turn_of(const struct sheen_panel *panel, struct sheen_rect rect, struct sheen_turn *turn);

/*
 * Around what is said to the panel: take collects the push before and acquires the
 * bus (after an error it is not held); give releases it, unless pixels still fly, and
 * returns error, which makes the panel unknown.
 */
int sheen_panel_take(struct sheen_panel *panel);
int sheen_panel_give(struct sheen_panel *panel, int error);

/* A call of the bus (sheen_bus.h) that has left on return. */
int sheen_panel_send(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                     size_t count);

/* The same, but the data may fly on, untouched; sheen_panel_landed() collects them. */
int sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                       size_t count);

/* Waits for the call under way, if any. */
int sheen_panel_landed(struct sheen_panel *panel);

/* A command and its parameters, with D/C as the driver has it; at most 15 where low_parameters. */
int sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);

/* Reset by the line, else by command, with the record's waits. */
int sheen_panel_reset(struct sheen_panel *panel);

/* The record's init table. */
int sheen_panel_steps(struct sheen_panel *panel);

/* 1, and remembers it, where axis 0 (x) or 1 (y) of the window is not first..last already. */
int sheen_panel_window_moves(struct sheen_panel *panel, unsigned axis, unsigned first, unsigned last);

/* Command, first, last (a byte each), where they differ from the last. */
int sheen_panel_set_window(struct sheen_panel *panel, unsigned axis, uint8_t command, unsigned first, unsigned last);

/*
 * For controllers whose parameters are commands, without a reset line: whatever they
 * still wait for from before, a harmless command sent often enough fills it in.
 */
int sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless);

/*
 * RAM pixels before the glass on an axis: gap where the axis counts upwards,
 * the rest beyond the glass where it counts downwards.
 */
static inline uint16_t sheen_panel_offset(uint16_t ram, uint16_t glass, uint16_t gap, int downwards)
{
    return (uint16_t)(downwards ? ram - glass - gap : gap);
}

#endif
