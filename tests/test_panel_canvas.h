/*
 * test_panel_canvas.h - a simulated panel and an ideal memory that is pushed the same pixels; then both are compared.
 */
#ifndef TEST_PANEL_CANVAS_H
#define TEST_PANEL_CANVAS_H

#include "sim_panel.h"

struct canvas {
    struct sheen_sim_panel *panel;
    const struct sheen_target *target;
    uint16_t *ideal; /* what was pushed, one value per pixel, row by row */
    uint16_t *seen;  /* the picture as last read back */
    uint8_t *buffer; /* pixels under way */
    uint32_t noise;
};

/* Opens a simulated panel, chosen as in sheen_sim_choose(); the test fails if there is no such panel. */
void canvas_open(struct canvas *canvas, const char *name, int orientation, unsigned width, unsigned height);

/* Opens a panel with a record of the caller's own, whose name is that of a panel that can be simulated. */
void canvas_open_choice(struct canvas *canvas, const struct sheen_sim_choice *choice);

void canvas_close(struct canvas *canvas);

/* Pushes noise to a rectangle and waits. Returns the bus's error, if any. */
int canvas_push(struct canvas *canvas, struct sheen_rect rect);

/* Pushes the whole picture in bands of `band` rows. */
int canvas_push_all(struct canvas *canvas, unsigned band);

/* A rectangle of random place and size, aligned as the target needs. */
struct sheen_rect canvas_rect(struct canvas *canvas);

/* How many pixels differ from the ideal memory, not counting those that the glass does not have. */
unsigned canvas_differences(struct canvas *canvas);

/* Fails the test with the first complaint of controller or bus, if there is any. */
void canvas_quiet(const struct canvas *canvas);

/* Packs one pixel into a row in the target's format. */
void canvas_put(uint8_t *row, enum sheen_pixel pixel, unsigned x, uint16_t value);

#endif
