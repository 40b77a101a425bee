/*
 * count.h - counts of what a frame is made of, from the build of the core that counts (taps.h).
 */
#ifndef SHEEN_PLAN_COUNT_H
#define SHEEN_PLAN_COUNT_H

#include "feature_list.h"
#include "sheen.h"

struct sheen_plan_counts {
    uint32_t of[SHEEN_PLAN_COUNTS]; /* by enum sheen_plan_feature */
};

/* A feature's name, such as "FRAME" or "SHADES_SETUP", and its stage. */
const char *sheen_plan_feature_name(unsigned feature);
enum sheen_plan_stage sheen_plan_feature_stage(unsigned feature);

/* Sets all counts to 0; call it before sheen_begin(). */
void sheen_plan_counts_begin(void);

/* Returns what was counted since the last call, or since sheen_plan_counts_begin(). */
void sheen_plan_counts_take(struct sheen_plan_counts *counts);

/*
 * Adds a pushed rectangle to what sheen_plan_counts_take() returned before the push; bits_18: the driver makes three
 * bytes of each pixel.
 */
void sheen_plan_count_push(struct sheen_plan_counts *counts, enum sheen_pixel pixel, int bits_18, uint32_t pixels);

/* Adds what the frame's own counters say, once all has been drawn. */
void sheen_plan_count_draws(struct sheen_plan_counts *counts, const struct sheen_frame *frame, unsigned draws,
                            uint32_t vertices);

#endif
