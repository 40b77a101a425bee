/*
 * ticks.h - time on a Cortex-M: the processor's clocks, counted by SysTick.
 *
 * SysTick counts down, with 24 bits; ticks() extends the count to 32 bits, if it is
 * called at least once in 2^24 clocks (0.13 s at 125 MHz). Every wait and every band of
 * a frame calls it.
 */
#ifndef TICKS_H
#define TICKS_H

#include <stdint.h>

/* hz: the processor's clock. */
void ticks_open(uint32_t hz);

/* Clocks since ticks_open, modulo 2^32. */
uint32_t ticks(void);

/* The number of processor clocks in us microseconds, us at most 10^6. */
uint32_t ticks_of_us(uint32_t us);

/* Lets at least us microseconds pass. */
void ticks_delay_us(uint32_t us);

#endif
