/*
 * ticks.c - SysTick as a 32-bit counter of clocks (Armv6-M and Armv7-M manuals, B3.3).
 */
#include "ticks.h"

#define SYST_CSR (*(volatile uint32_t *)0xE000E010u) /* 4: processor clock, 1: enable */
#define SYST_RVR (*(volatile uint32_t *)0xE000E014u)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018u)
#define SYST_MASK 0xFFFFFFu

static uint32_t clocks_per_us, total, last;

void ticks_open(uint32_t hz)
{
    clocks_per_us = hz / 1000000u;
    total = 0;
    SYST_RVR = SYST_MASK;
    SYST_CVR = 0; /* any write clears it, so that it starts from the reload value */
    SYST_CSR = 5;
    last = SYST_CVR & SYST_MASK;
}

uint32_t ticks(void)
{
    uint32_t now = SYST_CVR & SYST_MASK;

    total += (last - now) & SYST_MASK;
    last = now;
    return total;
}

uint32_t ticks_of_us(uint32_t us)
{
    return us * clocks_per_us;
}

void ticks_delay_us(uint32_t us)
{
    /* In pieces, so that the number of clocks fits into 32 bits. */
    while (us > 0) {
        uint32_t piece = us < 1000 ? us : 1000, start = ticks();

        while (ticks() - start <= ticks_of_us(piece))
            ;
        us -= piece;
    }
}
