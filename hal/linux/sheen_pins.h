/*
 * sheen_pins.h - single GPIO lines of a Linux board, through libgpiod 1.6 or 2.
 *
 * A line is named the ways people name it:
 *
 *   gpiochip0:25  /dev/gpiochip0:25  0:25    chip and offset
 *   pinctrl-bcm2835:25                       the chip's label and offset; stays when the numbers of chips change
 *   GPIO25                                   the line's own name, if one line only bears it
 *
 * Every line is a request of its own. Lines requested together share their
 * values by position, and libgpiod 1.6 sets another line than the one that was
 * asked for; alone, a line cannot be mistaken, may be on any chip, and costs one
 * ioctl a change, which sheen_pin_set spares where the level stays.
 *
 * Consumer is "sheen". The kernel releases the lines of a process that ends,
 * however it ends.
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

/* All zero: no line, which may be closed again. Fields are private to hal/linux. */
struct sheen_pin {
    struct gpiod_chip *chip;            /* NULL: no line */
    struct gpiod_line *line;            /* libgpiod 1 */
    struct gpiod_line_request *request; /* libgpiod 2 */
    int level;                          /* as last driven; -1: unknown */
    char name[96];                      /* for messages: "GPIO25 (gpiochip0:25)" */
};

/*
 * Take a line as an output that starts at level 0 or 1, or as an input whose
 * rising edges are awaited. SHEEN_ERR_ARGUMENT: there is no such line;
 * SHEEN_ERR_BUS: it cannot be had. *pin is then all zero.
 */
int sheen_pin_output(struct sheen_pin *pin, const char *line, int level, struct sheen_failure *why);
int sheen_pin_rising(struct sheen_pin *pin, const char *line, struct sheen_failure *why);

/* Drives an output. SHEEN_ERR_BUS: the kernel refuses. */
int sheen_pin_set(struct sheen_pin *pin, int level, struct sheen_failure *why);

/* Waits for the next rising edge; those of before do not count. SHEEN_ERR_TIMEOUT after timeout_us. */
int sheen_pin_await(struct sheen_pin *pin, uint32_t timeout_us, struct sheen_failure *why);

/* Gives the line back; its level is then up to the board. */
void sheen_pin_close(struct sheen_pin *pin);

static inline int sheen_pin_is_open(const struct sheen_pin *pin)
{
    return pin->chip != NULL;
}

/* What is known of a line. Texts are "" where there is none, and last as long as the call they are handed to. */
struct sheen_pin_info {
    const char *chip, *label; /* "gpiochip0", "pinctrl-bcm2835" */
    unsigned offset;          /* in its chip */
    char name[64];            /* the line's own */
    char consumer[64];        /* who holds it */
    int used, output;         /* 1: somebody holds it; it is an output */
};

/*
 * Calls each() for every line of every chip that may be opened, in order, until
 * it returns other than 0, and returns that. SHEEN_ERR_BUS: there is no chip, or
 * none may be opened.
 */
int sheen_pins_each(int (*each)(void *ctx, const struct sheen_pin_info *info), void *ctx, struct sheen_failure *why);

/* The version of libgpiod in use, "1.6.3". */
const char *sheen_pins_version(void);

#ifdef __cplusplus
}
#endif
#endif
