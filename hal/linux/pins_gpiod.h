/*
 * pins_gpiod.h - private: the few calls in which libgpiod 1.6 and 2 differ.
 *
 * pins_gpiod_v1.c and pins_gpiod_v2.c each hold all of them; CMake compiles the
 * one that fits the installed library. gpiod_chip_open and gpiod_chip_close are
 * the same in both. int functions return 0, or -1 with errno, and are made again
 * after EINTR here, not by their callers.
 */
#ifndef SHEEN_PINS_GPIOD_H
#define SHEEN_PINS_GPIOD_H

#include "sheen_pins.h"

#include <stddef.h>

#define SHEEN_CONSUMER "sheen"
#define SHEEN_LIST_THEM "sheen-panel --list shows chips and lines"

/* pins_find.c: where a line is. path: of a chip's device, of which it need not be known that it exists. */
struct sheen_pin_place {
    char path[64];
    unsigned offset;
    int by_name; /* found by its own name or its chip's label */
};
int sheen_pin_find(struct sheen_pin_place *place, const char *line, struct sheen_failure *why);

/* Opens a chip, or says why not and leaves errno. */
int sheen_chip_open(struct gpiod_chip **chip, const char *path, struct sheen_failure *why);
int sheen_chip_fail(struct sheen_failure *why, const char *path, int error);

/* The chip's label (cut to size) and number of lines. */
int sheen_gpiod_describe(struct gpiod_chip *chip, char *label, size_t size, unsigned *lines);

/* name, consumer, used and output of a line. */
int sheen_gpiod_info(struct gpiod_chip *chip, unsigned offset, struct sheen_pin_info *info);

/* On the open chip in pin->chip: an output at pin->level, or an input with rising edges. */
int sheen_gpiod_output(struct sheen_pin *pin, unsigned offset);
int sheen_gpiod_rising(struct sheen_pin *pin, unsigned offset);

int sheen_gpiod_set(struct sheen_pin *pin, int level);

/* 1: an edge came and is taken from the queue; 0: none within timeout_us (0: do not wait); a signal is an error. */
int sheen_gpiod_edge(struct sheen_pin *pin, uint32_t timeout_us);

void sheen_gpiod_release(struct sheen_pin *pin);

#endif
