/*
 * guest.h - a processor in qemu, as guest.c sees it: cortex.c, riscv.c.
 */
#ifndef BENCH_GUEST_H
#define BENCH_GUEST_H

#include <stdint.h>

void guest_print(const char *text);
__attribute__((noreturn)) void guest_leave(int status);

/* Instructions between the two calls; each machine says how fine it counts. */
void guest_count(void);
uint32_t guest_counted(void);

/* 2 * rounds instructions. */
void guest_loop(uint32_t rounds);

/* guest.c: what a machine's start-up code calls once its memory is set up. */
__attribute__((noreturn)) void guest_main(void);

#endif
