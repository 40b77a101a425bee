/*
 * both.h - what both boards do the same way.
 */
#ifndef BOTH_H
#define BOTH_H

#include <stdint.h>

/* A bus's delay (sheen_bus.h) that feeds the watchdog once a millisecond. */
int both_delay(void *ctx, uint32_t us);

/*
 * down: a bit a key, 1 while it is pressed. Returns the letter in keys of the
 * lowest bit that was 0 at the last call, or -1. What is down at the first call
 * does not count.
 */
int both_pressed(uint8_t down, const char *keys);

#endif
