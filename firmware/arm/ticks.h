/*
 * ticks.h - time on a Cortex-M: the processor's clocks, counted by SysTick.
 *
 * SysTick counts 24 bits down; ticks() makes 32 bits of them, as long as it
 * is called at least once in 2^24 clocks (0.13 s at 125 MHz). Every wait and every
 * band of a frame calls it.
 */
#ifndef TICKS_H
#define TICKS_H

#include <stdint.h>

/* hz: of the processor. */
void ticks_open(uint32_t hz);

/* Clocks since ticks_open, modulo 2^32. */
uint32_t ticks(void);

/* How many clocks the processor makes in so many microseconds (at most 10^6 of them). */
uint32_t ticks_of_us(uint32_t us);

/* Lets at least us microseconds pass. */
void ticks_delay_us(uint32_t us);

#endif
