/*
 * driver.h - private to hal/: what a driver is, and the steps that drivers share.
 */
#ifndef SHEEN_DRIVER_H
#define SHEEN_DRIVER_H

#include "sheen_panel.h"

/*
 * These functions return no error: the first error of the bus stays in panel->error,
 * and from then on they send nothing and wait for nothing.
 *
 * init: brings the controller from any state to a lit, oriented panel.
 * orient: sends the orientation to a lit controller; NULL: the driver rearranges pixels instead.
 * push: sends an aligned rectangle inside the target; may leave its last call of
 *   the bus under way (panel->in_flight). Pixels as in sheen_target.h.
 * command: sheen_panel_command or sheen_panel_low_command, depending on the controller.
 * reset_command: resets the controller on boards without a reset line; < 0: none.
 * off: the commands that darken the glass and put the controller to sleep.
 * tearing_command: switches the TE output on; its one parameter is 0. 0: no such command.
 * brightness_on: command and parameter that come before a brightness; 0: none.
 */
struct sheen_panel_driver {
    void (*init)(struct sheen_panel *panel);
    void (*orient)(struct sheen_panel *panel);
    void (*push)(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels);
    void (*command)(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);
    int16_t reset_command;
    uint8_t off[2], off_count;
    uint8_t tearing_command;
    uint8_t brightness_on[2];
    uint8_t write_command; /* sent before grey pixels; 0: none */
    uint8_t pixel;         /* the pixel format it supports, enum sheen_pixel */
    uint8_t align;         /* px, alignment of the target on both axes: pixels per byte or address, a power of 2 */
};

/*
 * A rectangle on the glass in rotation 0, and where its pixels are in the rectangle
 * that the core pushed: pixel (i, j) on the glass is pixel number
 * start + i * right + j * down of the core's rectangle, counted row by row.
 */
struct sheen_turn {
    int32_t start, right, down;
    int16_t x, y, w, h; /* px, on the glass */
};

void sheen_turn_of(const struct sheen_panel *panel, const struct sheen_rect *rect, struct sheen_turn *turn);

/*
 * Call these before and after sending. take clears the last error, waits for the push
 * under way and acquires the bus (on an error the bus is not held). give releases the
 * bus, unless pixels are still under way. Both return panel->error; after an error the
 * panel's state counts as unknown.
 */
int sheen_panel_take(struct sheen_panel *panel);
int sheen_panel_give(struct sheen_panel *panel);

/* Calls the bus's send (sheen_bus.h). The data may still be under way afterwards: leave them untouched. */
void sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                        size_t count);

/* Waits for the call of the bus that is under way, if any. */
void sheen_panel_await(struct sheen_panel *panel);

/* Sends a command with D/C low and its parameters with D/C high, and waits until they have left. */
void sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);

/* The same, but parameters too leave with D/C low, for controllers that read them as commands; at most 15. */
void sheen_panel_low_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);

/* Resets the controller by the reset line, or without one by command, with the record's waits. */
void sheen_panel_reset(struct sheen_panel *panel);

/* Sends the record's init table. */
void sheen_panel_steps(struct sheen_panel *panel);

/* Whether axis 0 (x) or 1 (y) of the window, first << 16 | last, must be sent because it changes; remembers it. */
static inline int sheen_panel_window_update(struct sheen_panel *panel, unsigned axis, uint32_t window)
{
    if (panel->window[axis] == window)
        return 0;
    panel->window[axis] = window; /* if sending fails, the next initialisation forgets it */
    return 1;
}

/* Sends command, first, last (one byte each), unless first and last are as sent before. */
void sheen_panel_set_window(struct sheen_panel *panel, unsigned axis, uint8_t command, unsigned first, unsigned last);

/*
 * Without a reset line, a controller that reads parameters as commands may still be
 * waiting for parameters of an earlier command. This sends a harmless command often
 * enough to fill them in.
 */
void sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless);

#endif
