/*
 * example.h - the functions that each example defines; it draws to any target.
 *
 * A board's program opens its panel, sets the example up and draws one picture after the other; the doors in the
 * folders beside this file do so for other projects' displays. The examples' arenas and sizes are meant for colour
 * targets of 240x240.
 */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include <limits.h>

#include "sheen.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets up a frame for `target`, which must live as long as the frame. Returns 0 or a code of enum sheen_error. */
int example_init(struct sheen_frame **frame, const struct sheen_target *target);

/* Draws picture i of a movement that never ends; i counts from 0. Returns 0 or a code of enum sheen_error. */
int example_draw(struct sheen_frame *frame, unsigned i);

/* How many pictures doors with a loop of their own draw: so many that they never stop, or as the build says. */
#ifndef EXAMPLE_FRAMES
#define EXAMPLE_FRAMES UINT_MAX
#endif

/* Draws `frames` pictures and waits until the last one has been sent. Returns 0 or a code of enum sheen_error. */
static inline int example_run(const struct sheen_target *target, unsigned frames)
{
    struct sheen_frame *frame;
    int error = example_init(&frame, target);

    for (unsigned i = 0; i < frames && !error; i++)
        error = example_draw(frame, i);
    return error ? error : sheen_wait(frame);
}

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
