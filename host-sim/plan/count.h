/*
 * count.h - what a frame is made of, counted by the core that counts (taps.h).
 */
#ifndef SHEEN_PLAN_COUNT_H
#define SHEEN_PLAN_COUNT_H

#include "feature_list.h"
#include "sheen.h"

struct sheen_plan_counts {
    uint32_t of[SHEEN_PLAN_COUNTS]; /* by enum sheen_plan_feature */
};

/* "FRAME", "SHADES_SETUP" ..., and the stage. */
const char *sheen_plan_feature_name(unsigned feature);
enum sheen_plan_stage sheen_plan_feature_stage(unsigned feature);

/* Everything to 0; before sheen_begin. */
void sheen_plan_counts_begin(void);

/* What was counted since the last call, or since the beginning. */
void sheen_plan_counts_take(struct sheen_plan_counts *counts);

/*
 * Adds a pushed rectangle to what sheen_plan_counts_take gave before its push; bits_18: the driver makes three bytes of
 * a pixel.
 */
void sheen_plan_count_push(struct sheen_plan_counts *counts, enum sheen_pixel pixel, int bits_18, uint32_t pixels);

/* Adds what the frame's own counters say once its draws are done: to its first band. */
void sheen_plan_count_draws(struct sheen_plan_counts *counts, const struct sheen_frame *frame, unsigned draws,
                            uint32_t vertices);

#endif
