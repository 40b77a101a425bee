/*
 * start.h - what start.c calls, and is called by.
 */
#ifndef START_H
#define START_H

#include <stdint.h>

/* The reset vector. */
__attribute__((noreturn)) void start(void);

/* Called before main, after memory is set up: clocks and pins. start.c's own does nothing; a board defines one. */
void start_board(void);

/*
 * After a fault: pc of the instruction and lr of the code around it; both 0 after
 * a stack that ran over. start.c's own only stops; a program may define one.
 */
__attribute__((noreturn)) void start_fault(uint32_t pc, uint32_t lr);

#endif
