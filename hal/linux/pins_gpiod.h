/*
 * pins_gpiod.h - private: the few calls in which libgpiod 1.6 and 2 differ.
 *
 * pins_gpiod_v1.c and pins_gpiod_v2.c each define the sheen_gpiod_ functions; CMake
 * compiles the file for the installed library. gpiod_chip_open and gpiod_chip_close
 * are the same in both versions. int functions return 0, or -1 with errno, and
 * repeat calls that EINTR or EAGAIN interrupts.
 */
#ifndef SHEEN_PINS_GPIOD_H
#define SHEEN_PINS_GPIOD_H

#include "sheen_pins.h"

#include <stddef.h>

#define SHEEN_CONSUMER "sheen"
#define SHEEN_LIST_THEM "sheen-panel --list shows chips and lines"

/* Finds a line by what people call it (pins_find.c). The chip's device at `path` may turn out not to exist. */
struct sheen_pin_place {
    char path[64];
    unsigned offset;
    int by_name; /* found by its own name or its chip's label */
};
int sheen_pin_find(struct sheen_pin_place *place, const char *line, struct sheen_failure *why);

/* Opens a chip, or explains the error in *why and leaves errno set. */
int sheen_chip_open(struct gpiod_chip **chip, const char *path, struct sheen_failure *why);
int sheen_chip_fail(struct sheen_failure *why, const char *path, int error);

/* Reads the chip's label (cut to size) and number of lines. */
int sheen_gpiod_describe(struct gpiod_chip *chip, char *label, size_t size, unsigned *lines);

/* Fills in name, consumer, used and output of a line. */
int sheen_gpiod_info(struct gpiod_chip *chip, unsigned offset, struct sheen_pin_info *info);

/* Request a line of the open chip pin->chip: as an output at pin->level, or as an input for rising edges. */
int sheen_gpiod_output(struct sheen_pin *pin, unsigned offset);
int sheen_gpiod_rising(struct sheen_pin *pin, unsigned offset);

int sheen_gpiod_set(struct sheen_pin *pin, int level);

/* 1: took an edge from the queue; 0: none came within timeout_us (0: does not wait); -1: error, also after a signal. */
int sheen_gpiod_edge(struct sheen_pin *pin, uint32_t timeout_us);

void sheen_gpiod_release(struct sheen_pin *pin);

#endif
