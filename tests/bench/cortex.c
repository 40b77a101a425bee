/*
 * cortex.c - a Cortex-M of Arm's MPS2 boards in qemu; SysTick counts instructions.
 *
 * With -icount shift=0 an instruction takes 1 ns of the machine's time, so a tick is TICK_NS instructions (40 at the 25
 * MHz of mps2-an385 and an386, 50 at the 20 MHz of an505); 24 bits of ticks are 671 million instructions.
 */
#include "guest.h"

#define SYST_CSR (*(volatile uint32_t *)0xe000e010)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018)
#define COUNTED_TO_0 0x10000u /* in SYST_CSR: it reached 0 since SYST_CSR was last read */

extern uint32_t bench_bss_start, bench_bss_end, bench_stack_top;
void bench_reset(void);
static void fault(void);

__attribute__((section(".vectors"), used)) static const uintptr_t vectors[16] = {
    (uintptr_t)&bench_stack_top, (uintptr_t)bench_reset, (uintptr_t)fault, (uintptr_t)fault};

/* Semihosting: a call to the debugger, which qemu answers. */
static int host_call(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void guest_print(const char *text)
{
    (void)host_call(4, text); /* SYS_WRITE0 */
}

void guest_leave(int status)
{
    const uint32_t block[2] = {0x20026, (uint32_t)status}; /* application exit */

    for (;;)
        (void)host_call(0x20, block); /* SYS_EXIT_EXTENDED */
}

static void fault(void)
{
    guest_print("fault\n");
    guest_leave(1);
}

#ifdef COUNTED_BY_HOST /* rp2040.mjs counts: cycles */

void guest_count(void)
{
    (void)host_call(0x100, (const void *)0);
}

uint32_t guest_counted(void)
{
    return (uint32_t)host_call(0x101, (const void *)0);
}

#else

/* SysTick counts down from the largest value of 24 bits. */
void guest_count(void)
{
    SYST_CVR = 0;
    (void)SYST_CSR;
}

uint32_t guest_counted(void)
{
    uint32_t ticks = (0u - SYST_CVR) & 0xffffffu;

    if (SYST_CSR & COUNTED_TO_0) {
        guest_print("the counter ran over\n");
        guest_leave(1);
    }
    return ticks * TICK_NS;
}

#endif

void guest_loop(uint32_t rounds)
{
    __asm__ volatile(".syntax unified\n1: subs %0, #1\n bne 1b" : "+l"(rounds) : : "cc", "memory");
}

void bench_reset(void)
{
    for (uint32_t *p = &bench_bss_start; p < &bench_bss_end; p++)
        *p = 0;
    SYST_RVR = 0xffffff;
    SYST_CVR = 0;
    SYST_CSR = 5; /* the processor's clock, no interrupt */
    guest_main();
}
