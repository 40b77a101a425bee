/*
 * guest.h - what guest.c and planned.c need of a processor in an emulator: cortex.c, riscv.c or lx106.c.
 */
#ifndef BENCH_GUEST_H
#define BENCH_GUEST_H

#include <stdint.h>

void guest_print(const char *text);
__attribute__((noreturn)) void guest_leave(int status);

/* The instructions between these two calls; how finely they are counted depends on the machine. */
void guest_count(void);
uint32_t guest_counted(void);

/* Runs 2 * rounds instructions. */
void guest_loop(uint32_t rounds);

/* In guest.c or planned.c: a machine's start-up code calls it when the memory is set up. */
__attribute__((noreturn)) void guest_main(void);

/* Prints the number and a space. */
static inline void guest_print_number(uint32_t n)
{
    char text[12];
    char *at = text + sizeof text - 1;

    *at = 0;
    do {
        *--at = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    guest_print(at);
    guest_print(" ");
}

#define GUEST_LOOPS 100000u

/* Runs a loop of known length first, so that the reader of the output can check the counter. */
static inline void guest_check_counter(void)
{
    guest_count();
    guest_loop(GUEST_LOOPS);
    uint32_t count = guest_counted();
    guest_print("loop ");
    guest_print_number(count);
    guest_print("of ");
    guest_print_number(2 * GUEST_LOOPS);
    guest_print("\n");
}

#endif
