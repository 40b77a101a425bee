/*
 * example.h - the function that each example defines; it draws to any target.
 *
 * A board's program opens its panel and calls example(); the doors in the folders beside this file do so for other
 * projects' displays. The examples' arenas and sizes are meant for colour targets of 240x240.
 */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include "sheen.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws `frames` frames and waits until the last one has been sent. Returns 0 or a code of enum sheen_error. */
int example(const struct sheen_target *target, unsigned frames);

/* The board defines these for the examples that use them. input.c: steps that a knob was turned since the last call. */
int board_turned(void);
/* two_cores.c: runs work(ctx) once on the other core and returns at once; whether that has ended; a lock. */
void board_start(void (*work)(void *ctx), void *ctx);
int board_ended(void);
void board_lock(void *ctx);
void board_unlock(void *ctx);

#ifdef __cplusplus
}
#endif
#endif
