/*
 * boards.h - the boards that `sheen plan` knows: a table, one row per board.
 */
#ifndef SHEEN_PLAN_BOARDS_H
#define SHEEN_PLAN_BOARDS_H

#include "costs.h"
#include "problem.h"

struct sheen_plan_board {
    const char *name;      /* as on the command line */
    const char *title;     /* the usual name */
    const char *processor; /* the processor's core */
    uint32_t clock_hz, bus_hz;
    uint32_t ram, flash;     /* B that a program can use */
    unsigned cores;          /* 1 or 2 */
    enum sheen_plan_cpu cpu; /* the processor whose costs are used */
    int measured;            /* 1: the costs are cycles of this very processor, from its emulator */
    int nearest;             /* 1: cpu is another processor, the nearest that can be counted */
    double cycles;           /* per instruction, an estimate; 1 if measured */
    const char *basis;       /* how the cycles are found, in a few words */
    int flash_is_slow;       /* 1: the cycles are those of code in RAM, as flash is outside the chip, its cache small */
};

/* The boards in order; NULL past the last. */
const struct sheen_plan_board *sheen_plan_board_at(unsigned index);

/* The index of the board of that name, in upper or lower case; else negative, and *problem names the nearest. */
int sheen_plan_board_find(const char *name, struct sheen_problem *problem);

#endif
