/*
 * run.h - frames of a mesh that turns on a panel, counted band by band.
 */
#ifndef SHEEN_PLAN_RUN_H
#define SHEEN_PLAN_RUN_H

#include "count.h"
#include "turntable.h"

/* What happens between two pushes, and the second push. */
struct sheen_plan_band {
    struct sheen_plan_counts counts;
    uint32_t pixels, bytes, calls; /* of the push: its pixels, bytes on the wire and calls of the bus */
};

struct sheen_plan_run {
    struct sheen_turntable table;
    struct sheen_target target; /* the panel's, with pushes watched */
    const struct sheen_target *panel;
    uint64_t bytes, calls;          /* the bus's totals at the last push */
    struct sheen_plan_counts front; /* of the last frame, what comes before its bands */
    unsigned bands;                 /* that were sent */
    uint32_t setups;
    struct sheen_plan_band band[480];
};

/* As sheen_turntable_open; close in either case. */
int sheen_plan_open(struct sheen_plan_run *run, const struct sheen_options *options,
                    const struct sheen_sim_choice *choice, struct sheen_problem *problem);
void sheen_plan_close(struct sheen_plan_run *run);

/* Draws frame `number`; whole: all of it is sent, else what changed. 0, or a negative code and *problem. */
int sheen_plan_draw(struct sheen_plan_run *run, int number, int whole, struct sheen_problem *problem);

/* The counts of the whole last frame. */
void sheen_plan_sum(const struct sheen_plan_run *run, struct sheen_plan_counts *counts);

#endif
