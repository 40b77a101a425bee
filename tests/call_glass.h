/*
 * call_glass.h - a panel for random sequences of calls. It knows what it shows and which push is under way, and checks
 * that the core keeps the contract of sheen_target.h and of the configuration's lock. A breach fails the test at once.
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
    uint16_t shown[GLASS_PIXELS]; /* 565 values or grey levels, rows of target.width */
    uint8_t times[GLASS_PIXELS];  /* how often each pixel was sent since glass_begin */
    struct sheen_rect viewport;   /* pushes MUST stay inside */
    unsigned pushes, area;        /* successful pushes since glass_begin, and their area in px */
    unsigned events;              /* pushes, waits and calls of the 2D callbacks, which count themselves */

    bool late;                /* pixels are read when wait is called, not during the push */
    int fail_push, fail_wait; /* the code that the next push or wait returns; 0: it succeeds */
    int failed;               /* the code of the first push or wait that failed since this was set to 0 */
    bool has_lock, locked;    /* the configuration has glass_lock and glass_unlock; locked: between the two calls */
    uint32_t noise;           /* random generator of what the panel shows after an error or loss of power */

    bool broken; /* a push or a wait of this frame failed, so no push may follow */
    bool flying; /* a push is under way: */
    struct sheen_rect rect;
    const void *pixels;
    uint8_t copy[2 * GLASS_PIXELS];
};

/* width, height: up to GLASS_WIDTH and GLASS_HEIGHT; waits: the target has a wait callback. */
void glass_make(struct glass *g, int width, int height, enum sheen_pixel pixel, bool waits);

/* The lock and unlock of a configuration; ctx: the glass. */
void glass_lock(void *ctx);
void glass_unlock(void *ctx);

/* A frame begins: start counting anew. */
void glass_begin(struct glass *g, struct sheen_rect viewport);

/* Make the panel show noise. */
void glass_scribble(struct glass *g);

#endif
