/*
 * riscv.c - rv32imc on qemu's virt board; with -icount shift=0 its instruction counter is exact.
 */
#include "guest.h"

void bench_reset(void);

__attribute__((naked, section(".vectors"))) void bench_reset(void)
{
    __asm__ volatile(".option arch, +zicsr\n"
                     "la sp, bench_stack_top\n"
                     "la t0, bench_fault\n"
                     "csrw mtvec, t0\n"
                     "la t0, bench_bss_start\n"
                     "la t1, bench_bss_end\n"
                     "1: sw zero, 0(t0)\n"
                     "addi t0, t0, 4\n"
                     "bltu t0, t1, 1b\n"
                     "j guest_main");
}

/* Semihosting: a call to the debugger, which qemu answers at these three instructions if they are uncompressed. */
static int host_call(int operation, const void *argument)
{
    register int a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;

    __asm__ volatile(".option push\n.option norvc\n.balign 16\nslli zero, zero, 0x1f\nebreak\nsrai zero, zero, 7\n"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
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

__attribute__((used, aligned(4))) static void bench_fault(void)
{
    guest_print("fault\n");
    guest_leave(1);
}

static uint32_t since;

static uint32_t instructions(void)
{
    uint32_t count;

    __asm__ volatile(".option push\n.option arch, +zicsr\ncsrr %0, minstret\n.option pop" : "=r"(count) : : "memory");
    return count;
}

void guest_count(void)
{
    since = instructions();
}

uint32_t guest_counted(void)
{
    return instructions() - since;
}

void guest_loop(uint32_t rounds)
{
    __asm__ volatile("1: addi %0, %0, -1\n bnez %0, 1b" : "+r"(rounds) : : "memory");
}
