/*
 * driver.h - private to hal/: what a driver is, and the steps that drivers share.
 */
#ifndef SHEEN_DRIVER_H
#define SHEEN_DRIVER_H

#include "sheen_panel.h"

/*
 * Nothing here returns an error: the first one that the bus answers stays in
 * panel->error, and from then on nothing is sent, rested or waited for.
 *
 * init: from any state of the controller to a lit, oriented panel.
 * orient: tells a lit controller its orientation; NULL where the packer turns.
 * push: a rectangle that lies inside the target, aligned; may leave its last
 *   call of the bus under way (panel->flying). Pixels as in sheen_target.h.
 * reset_command: a reset by command for boards without a reset line, < 0: none.
 * command: sheen_panel_command or sheen_panel_low_command, as the controller reads parameters.
 * off: the commands that darken the glass and put the controller to sleep.
 * tearing_command: takes a parameter 0 and switches the TE output on, 0: none.
 * brightness_on: before the first brightness, command and parameter; 0: nothing.
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
    uint8_t write_command; /* before pixels; 0: none (greys) */
    uint8_t pixel;         /* enum sheen_pixel that it takes */
    uint8_t align;         /* px, a power of 2, of the target on both axes; a byte's pixels, or an address's */
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

void sheen_turn_of(const struct sheen_panel *panel, const struct sheen_rect *rect, struct sheen_turn *turn);

/*
 * Around what is said to the panel. take begins anew, without error, ends the push
 * before and acquires the bus (after an error it is not held); give releases it,
 * unless pixels still fly. An error makes the panel unknown. Both return it.
 */
int sheen_panel_take(struct sheen_panel *panel);
int sheen_panel_give(struct sheen_panel *panel);

/* A call of the bus (sheen_bus.h) whose data may fly on, untouched. */
void sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                        size_t count);

/* Waits for the call under way, if any. */
void sheen_panel_landed(struct sheen_panel *panel);

/* A command, and its parameters with D/C high. */
void sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);

/* The same with D/C low, for controllers whose parameters are commands; at most 15. */
void sheen_panel_low_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count);

/* Reset by the line, else by command, with the record's waits. */
void sheen_panel_reset(struct sheen_panel *panel);

/* The record's init table. */
void sheen_panel_steps(struct sheen_panel *panel);

/* 1, and remembers it, where axis 0 (x) or 1 (y) of the window, first << 16 | last, is not so already. */
static inline int sheen_panel_window_moves(struct sheen_panel *panel, unsigned axis, uint32_t window)
{
    if (panel->window[axis] == window)
        return 0;
    panel->window[axis] = window; /* an error on the way makes all unknown again */
    return 1;
}

/* Command, first, last (a byte each), where they differ from the last. */
void sheen_panel_set_window(struct sheen_panel *panel, unsigned axis, uint8_t command, unsigned first, unsigned last);

/*
 * For controllers whose parameters are commands, without a reset line: whatever they
 * still wait for from before, a harmless command sent often enough fills it in.
 */
void sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless);

#endif
