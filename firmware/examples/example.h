/*
 * example.h - what each example is: a function that draws to a target, whatever that is.
 *
 * A board's program opens its panel and calls example(); the doors beside this file do that for other projects'
 * displays. Colour targets of 240x240 are what the sizes below were chosen for.
 */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include "sheen.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws so many frames, and waits for the last one. 0 or a code of enum sheen_error. */
int example(const struct sheen_target *target, unsigned frames);

/* The board's part where an example asks for it: steps that a knob was turned since the last call (input.c); */
int board_turned(void);
/* runs work(ctx) on the other core, once, and comes back at once; tells whether it has ended; a lock (two_cores.c). */
void board_start(void (*work)(void *ctx), void *ctx);
int board_ended(void);
void board_lock(void *ctx);
void board_unlock(void *ctx);

#ifdef __cplusplus
}
#endif
#endif
