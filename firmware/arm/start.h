/*
 * start.h - the reset code of start.c, and the functions that it calls.
 */
#ifndef START_H
#define START_H

#include <stdint.h>

/* The reset vector. */
__attribute__((noreturn)) void start(void);

/* Called after memory is set up and before main, for clocks and pins. A board defines it; the default is empty. */
void start_board(void);

/*
 * Called after a fault, with the pc of the instruction and the lr at that point; both
 * are 0 after a stack overflow. A program may define it; the default only stops.
 */
__attribute__((noreturn)) void start_fault(uint32_t pc, uint32_t lr);

#endif
