/*
 * start.c - from reset to main on a Cortex-M, and what happens on a fault.
 *
 * The linker script (sections.ld) places the vector table and start() first in flash and
 * defines the addresses below. No interrupts are used, so the 16 system vectors suffice.
 */
#include "start.h"

/* Symbols of the linker script; only their addresses mean something. */
extern uint32_t link_stack_bottom[], link_stack_top[], link_text_load[], link_text_start[], link_text_end[],
    link_data_load[], link_data_start[], link_data_end[], link_bss_start[], link_bss_end[];

int main(void);

/* The default; a program that can print defines a better one. */
__attribute__((weak, noreturn)) void start_fault(uint32_t pc, uint32_t lr)
{
    (void)pc;
    (void)lr;
    for (;;)
        ;
}

__attribute__((weak)) void start_board(void)
{
}

/*
 * The processor has pushed r0-r3, r12, lr, pc, xpsr (Armv6-M manual, B1.5.6), unless
 * the stack has overflowed: then pc and lr are reported as 0. start_fault() never
 * returns, so it gets the whole stack, from the top. If the fault is on another core,
 * whose stack lies above this one, the stack pointer stays as it is.
 */
__attribute__((naked)) static void on_fault(void)
{
    __asm volatile("    mrs r2, msp\n"
                   "    ldr r3, =link_stack_bottom\n"
                   "    movs r0, #0\n"
                   "    movs r1, #0\n"
                   "    cmp r2, r3\n"
                   "    blo 1f\n"
                   "    ldr r0, [r2, #24]\n"
                   "    ldr r1, [r2, #20]\n"
                   "1:  ldr r3, =link_stack_top\n"
                   "    cmp r2, r3\n"
                   "    bhi 2f\n"
                   "    mov sp, r3\n"
                   "2:  ldr r3, =start_fault\n"
                   "    bx r3\n");
}

/* volatile: memcpy() and memset(), which a compiler may call for these loops, may not have been copied to RAM yet. */
__attribute__((always_inline)) static inline void copy(volatile uint32_t *to, const uint32_t *end, const uint32_t *from)
{
    if (to != from)
        while (to < end)
            *to++ = *from++;
}

/* Calls functions only when they are where they run. */
__attribute__((section(".start"), noreturn)) void start(void)
{
    copy(link_text_start, link_text_end, link_text_load);
    copy(link_data_start, link_data_end, link_data_load);
    for (volatile uint32_t *to = link_bss_start; to < link_bss_end; to++)
        *to = 0;
    start_board();
    main();
    for (;;)
        ;
}

/* Stack, reset, NMI, HardFault and, on an M3, the faults that become HardFaults unless they are enabled. */
__attribute__((section(".vectors"), used)) static const union {
    const void *stack;
    void (*code)(void);
} vectors[16] = {{.stack = link_stack_top}, {.code = start},    {.code = on_fault}, {.code = on_fault},
                 {.code = on_fault},        {.code = on_fault}, {.code = on_fault}};
