/*
 * sheen_pins.h - single GPIO lines of a Linux board, through libgpiod 1.6 or 2.
 *
 * A line can be named in any of these ways:
 *
 *   gpiochip0:25  /dev/gpiochip0:25  0:25    chip and offset
 *   pinctrl-bcm2835:25                       the chip's label and offset; stays valid when chips are renumbered
 *   GPIO25                                   the line's own name, if only one line has it
 *
 * Every line is requested by itself. The values of lines requested together are
 * matched by position, and libgpiod 1.6 then sets a line other than the one asked
 * for. A line by itself cannot be mixed up, may be on any chip, and costs one ioctl
 * per change; sheen_pin_set() makes none if the level stays the same.
 *
 * The lines' consumer is "sheen". The kernel releases the lines of a process when
 * it ends, however it ends.
 */
#ifndef SHEEN_PINS_H
#define SHEEN_PINS_H

#include "sheen_failure.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct gpiod_chip;
struct gpiod_line;
struct gpiod_line_request;

/* All zero: no line; closing it is allowed. Fields are private to hal/linux. */
struct sheen_pin {
    struct gpiod_chip *chip;            /* NULL: no line */
    struct gpiod_line *line;            /* libgpiod 1 */
    struct gpiod_line_request *request; /* libgpiod 2 */
    int level;                          /* the level last driven; -1: unknown */
    char name[96];                      /* for messages: "GPIO25 (gpiochip0:25)" */
};

/*
 * Take a line as an output that starts at level 0 or 1, or as an input for rising
 * edges. SHEEN_ERR_ARGUMENT: there is no such line; SHEEN_ERR_BUS: it cannot be
 * opened, or is in use. After an error *pin is all zero.
 */
int sheen_pin_output(struct sheen_pin *pin, const char *line, int level, struct sheen_failure *why);
int sheen_pin_rising(struct sheen_pin *pin, const char *line, struct sheen_failure *why);

/* Drives an output. SHEEN_ERR_BUS: the kernel refuses. */
int sheen_pin_set(struct sheen_pin *pin, int level, struct sheen_failure *why);

/* Waits for the next rising edge; edges before the call do not count. SHEEN_ERR_TIMEOUT after timeout_us. */
int sheen_pin_await(struct sheen_pin *pin, uint32_t timeout_us, struct sheen_failure *why);

/* Releases the line; its level is then up to the board. */
void sheen_pin_close(struct sheen_pin *pin);

static inline int sheen_pin_is_open(const struct sheen_pin *pin)
{
    return pin->chip != NULL;
}

/* What is known about a line. A missing string is ""; the strings are valid only during the call that gets them. */
struct sheen_pin_info {
    const char *chip, *label; /* "gpiochip0", "pinctrl-bcm2835" */
    unsigned offset;          /* in its chip */
    char name[64];            /* the line's own name */
    char consumer[64];        /* who holds it */
    int used, output;         /* 1: somebody holds it; 1: it is an output */
};

/*
 * Calls each() for every line of every chip that this user may open, in order,
 * until each() returns a value other than 0; returns that value, or 0 at the end.
 * SHEEN_ERR_BUS: there is no chip, or none that this user may open.
 */
int sheen_pins_each(int (*each)(void *ctx, const struct sheen_pin_info *info), void *ctx, struct sheen_failure *why);

/* The version of libgpiod in use, "1.6.3". */
const char *sheen_pins_version(void);

#ifdef __cplusplus
}
#endif
#endif
