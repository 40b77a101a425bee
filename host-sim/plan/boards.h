/*
 * boards.h - what `sheen plan` knows of boards: data, a board a row.
 */
#ifndef SHEEN_PLAN_BOARDS_H
#define SHEEN_PLAN_BOARDS_H

#include "costs.h"
#include "problem.h"

struct sheen_plan_board {
    const char *name;      /* as on the command line */
    const char *title;     /* as people say it */
    const char *processor; /* its core */
    uint32_t clock_hz, bus_hz;
    uint32_t ram, flash;     /* B that a program has */
    unsigned cores;          /* 1 or 2 */
    enum sheen_plan_cpu cpu; /* whose costs its own are */
    int measured;            /* 1: they are cycles of this processor, from an emulator of it */
    int nearest;             /* 1: the processor is another one, the nearest that can be counted */
    double cycles;           /* an instruction takes, an estimate; measured: 1 */
    const char *basis;       /* how cycles come about, a few words */
};

/* The boards in order; NULL past the last. */
const struct sheen_plan_board *sheen_plan_board_at(unsigned index);

/* Its index, by name without regard to capitals; else negative, and *problem names the nearest. */
int sheen_plan_board_find(const char *name, struct sheen_problem *problem);

#endif
