/*
 * test_panel_canvas.h - an ideal memory beside a simulated panel: both are pushed the same, then compared.
 */
#ifndef TEST_PANEL_CANVAS_H
#define TEST_PANEL_CANVAS_H

#include "sim_panel.h"

struct canvas {
    struct sheen_sim_panel *panel;
    const struct sheen_target *target;
    uint16_t *ideal; /* what was pushed, a value a pixel, row by row */
    uint16_t *seen;  /* the picture as last read back */
    uint8_t *buffer; /* pixels on their way */
    uint32_t noise;
};

/* The simulated panel, chosen as by sheen_sim_choose(); fails the test where it cannot be had. */
void canvas_open(struct canvas *canvas, const char *name, int orientation, unsigned width, unsigned height);

/* A panel of a record of one's own, named as one that can be simulated. */
void canvas_open_choice(struct canvas *canvas, const struct sheen_sim_choice *choice);

void canvas_close(struct canvas *canvas);

/* Pushes noise to a rectangle and waits. The bus's error, if any. */
int canvas_push(struct canvas *canvas, struct sheen_rect rect);

/* The whole picture in bands of so many rows. */
int canvas_push_all(struct canvas *canvas, unsigned band);

/* A rectangle of noisy place and size, on the target's alignment. */
struct sheen_rect canvas_rect(struct canvas *canvas);

/* Pixels (of those that the glass has) that differ from the ideal memory. */
unsigned canvas_differences(struct canvas *canvas);

/* No complaint of controller and bus, else the test fails with the first. */
void canvas_quiet(const struct canvas *canvas);

/* Packs one pixel of a row in the target's format. */
void canvas_put(uint8_t *row, enum sheen_pixel pixel, unsigned x, uint16_t value);

#endif
