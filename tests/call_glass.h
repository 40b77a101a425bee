/*
 * call_glass.h - a panel for random sequences of calls: what it shows, what is under way, and whether the core keeps to
 * the contract of sheen_target.h and of the configuration's lock. A breach fails the test where it happens.
 */
#ifndef CALL_GLASS_H
#define CALL_GLASS_H

#include <stdbool.h>

#include "sheen.h"

#define GLASS_WIDTH 40
#define GLASS_HEIGHT 24
#define GLASS_PIXELS (GLASS_WIDTH * GLASS_HEIGHT)

struct glass {
    struct sheen_target target;
    uint16_t shown[GLASS_PIXELS]; /* values or levels, row by row of target.width */
    uint8_t times[GLASS_PIXELS];  /* sent since glass_begin */
    struct sheen_rect viewport;   /* pushes stay inside */
    unsigned pushes, area;        /* since glass_begin, those that succeeded */
    unsigned events;              /* pushes, waits and, counted by their owner, the user's own 2D */

    bool late;                /* the pixels leave when wait is called */
    int fail_push, fail_wait; /* what the next one returns; 0: it succeeds */
    int failed;               /* what the first one that failed since this was cleared has returned */
    bool has_lock, locked;    /* lock and unlock are what the configuration got; locked: between the two */
    uint32_t noise;           /* a generator: what a panel shows after an error, or after power was lost */

    bool broken; /* a push or a wait of the frame failed: no further push */
    bool flying;
    struct sheen_rect rect;
    const void *pixels;
    uint8_t copy[2 * GLASS_PIXELS];
};

/* width, height up to GLASS_WIDTH and GLASS_HEIGHT; waits: there is a wait. */
void glass_make(struct glass *g, int width, int height, enum sheen_pixel pixel, bool waits);

/* lock and unlock for a configuration; ctx: the glass. */
void glass_lock(void *ctx);
void glass_unlock(void *ctx);

/* A frame begins: counts start anew. */
void glass_begin(struct glass *g, struct sheen_rect viewport);

/* It shows anything now. */
void glass_scribble(struct glass *g);

#endif
