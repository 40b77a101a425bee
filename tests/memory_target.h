/*
 * memory_target.h - a target that keeps its pixels in memory and checks the core.
 *
 * It counts every breach of the target's contract (sheen_target.h): a rectangle that is out of range, empty or not
 * aligned, a push before the last one was waited for, a buffer that changed between push and wait.
 */
#ifndef MEMORY_TARGET_H
#define MEMORY_TARGET_H

#include <stdbool.h>

#include "sheen_target.h"

struct memory_target {
    struct sheen_target target; /* what the core gets; ctx is this struct */
    uint8_t *memory;            /* row by row, row_bytes each */
    size_t row_bytes;
    bool delayed; /* push only notes the rectangle, wait takes the pixels, as DMA does */

    int breaches;             /* of the contract */
    const char *first_breach; /* what the first one was */
    long pushes, area, bytes; /* since memory_target_begin */
    uint8_t *times;           /* per pixel: how often it was sent since memory_target_begin */

    long fail_push, fail_wait; /* counted down: the push or wait that makes it 0 fails; 0: none */
    int fail_code;

    bool in_flight;
    struct sheen_rect rect;
    const void *pixels;
    uint8_t *copy;
};

/* 0, or -1 if memory is short. */
int memory_target_init(struct memory_target *t, int width, int height, enum sheen_pixel pixel);
void memory_target_free(struct memory_target *t);

/* Start counting anew; the pixels stay. */
void memory_target_begin(struct memory_target *t);

/* A pixel as a 565 value or a grey level. */
unsigned memory_target_pixel(const struct memory_target *t, int x, int y);

#endif
