/*
 * cortex.c - the scenes on a Cortex-M in qemu (mps2-an385), instructions counted by SysTick.
 *
 * With -icount shift=0 an instruction takes 1 ns of the machine's time and a tick
 * of the 25 MHz clock 40 ns: 40 instructions, and 24 bits of ticks are 671 million. A loop of known length comes first,
 * so that the reader of the output can check the scale.
 */
#include <stdint.h>

#include "scenes.h"

#define SYST_CSR (*(volatile uint32_t *)0xe000e010)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018)
#define COUNTED_TO_0 0x10000u /* in SYST_CSR, since it was last read */
#define INSTRUCTIONS_A_TICK 40
#define LOOPS 100000u

extern uint32_t bench_bss_start, bench_bss_end, bench_stack_top;
void bench_reset(void);
static void fault(void);

static uint64_t arena[46 * 1024];

__attribute__((section(".vectors"), used)) static const uintptr_t vectors[16] = {
    (uintptr_t)&bench_stack_top, (uintptr_t)bench_reset, (uintptr_t)fault, (uintptr_t)fault};

/* Semihosting: the debugger's door, which qemu opens. */
static int host_call(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void print(const char *text)
{
    (void)host_call(4, text); /* SYS_WRITE0 */
}

static void print_number(uint32_t n)
{
    char text[12];
    char *at = text + sizeof text - 1;

    *at = 0;
    do {
        *--at = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    print(at);
}

static __attribute__((noreturn)) void leave(int status)
{
    const uint32_t block[2] = {0x20026, (uint32_t)status}; /* application exit */

    for (;;)
        (void)host_call(0x20, block); /* SYS_EXIT_EXTENDED */
}

static void fault(void)
{
    print("fault\n");
    leave(1);
}

/* It counts down from the end of its 24 bits. */
static void counter_start(void)
{
    SYST_CVR = 0;
    (void)SYST_CSR;
}

static uint32_t counter_stop(void)
{
    uint32_t ticks = (0u - SYST_CVR) & 0xffffffu;

    if (SYST_CSR & COUNTED_TO_0) {
        print("the counter ran over\n");
        leave(1);
    }
    return ticks * INSTRUCTIONS_A_TICK;
}

/* Two instructions a round. */
static void known_length(void)
{
    uint32_t n = LOOPS;

    counter_start();
    __asm__ volatile(".syntax unified\n1: subs %0, #1\n bne 1b" : "+l"(n) : : "cc", "memory");
    uint32_t count = counter_stop();
    print("loop ");
    print_number(count);
    print(" of 200000\n");
}

static int measure(const struct bench_scene *scene, enum sheen_shading shading, int band_rows)
{
    static const char *const name[] = {"flat", "gouraud", "phong", "slerp"};
    static struct bench bench;

    bench_config(&bench, scene, shading, band_rows);
    int status = bench_begin(&bench, arena, sizeof arena);
    if (status == SHEEN_OK)
        status = bench_first(&bench);
    counter_start();
    if (status == SHEEN_OK)
        status = bench_measured(&bench);
    uint32_t count = counter_stop();
    print(scene->name);
    print(" ");
    print(name[shading]);
    print(" ");
    print_number((uint32_t)band_rows);
    print(" ");
    print(status < 0 ? sheen_strerror(status) : "");
    if (status == SHEEN_OK)
        print_number(count);
    print("\n");
    return status;
}

void bench_reset(void)
{
    for (uint32_t *p = &bench_bss_start; p < &bench_bss_end; p++)
        *p = 0;
    SYST_RVR = 0xffffff;
    SYST_CVR = 0;
    SYST_CSR = 5; /* the processor's clock, no interrupt */
    known_length();
    for (int scene = 0; scene < BENCH_SCENES; scene++) {
        for (int shading = SHEEN_FLAT; shading <= SHEEN_SLERP; shading++) {
            if (measure(&bench_scenes[scene], (enum sheen_shading)shading, 16) < 0 ||
                measure(&bench_scenes[scene], (enum sheen_shading)shading, BENCH_HEIGHT) < 0)
                leave(1);
        }
    }
    leave(0);
}
