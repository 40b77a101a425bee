/*
 * ticks.c - processor clocks from the RP2040's timer, in steps of a microsecond. Both cores share the timer, but each
 * has a SysTick of its own, so SysTick would not do.
 */
#include "ticks.h"

#include "registers.h"

#define CLOCKS_PER_US (CLOCK_HZ / 1000000u)

static uint32_t opened;

void ticks_open(uint32_t hz)
{
    (void)hz;
    opened = TIMER_RAW_LOW;
}

uint32_t ticks(void)
{
    return (TIMER_RAW_LOW - opened) * CLOCKS_PER_US;
}

uint32_t ticks_of_us(uint32_t us)
{
    return us * CLOCKS_PER_US;
}

void ticks_delay_us(uint32_t us)
{
    uint32_t since = TIMER_RAW_LOW;

    while (TIMER_RAW_LOW - since <= us)
        ;
}
