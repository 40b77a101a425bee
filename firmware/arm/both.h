/*
 * both.h - what both boards do the same way.
 */
#ifndef BOTH_H
#define BOTH_H

#include <stdint.h>

/* The function delay of a bus (sheen_bus.h); feeds the watchdog once a millisecond. */
int both_delay(void *ctx, uint32_t us);

/*
 * down: one bit per key, 1 while the key is pressed; keys: one letter per bit, from bit
 * 0. Returns the letter of the lowest bit that is 1 and was 0 at the last call, or -1.
 * Keys that are down at the first call do not count.
 */
int both_pressed(uint8_t down, const char *keys);

#endif
