/*
 * taps.h - the core's taps in the build that counts (SHEEN_TAPS, core/pixel/build.h). Only one thread at a time may
 * draw, because the counts are global.
 */
#ifndef SHEEN_PLAN_TAPS_H
#define SHEEN_PLAN_TAPS_H

#include <stdint.h>

#include "feature_list.h"

struct tile;
struct setup;
struct surface_corners;
struct gradients;

extern uint32_t sheen_plan_counted[SHEEN_PLAN_COUNTS]; /* since sheen_plan_counts_begin */

void sheen_plan_setup(const struct surface_corners *corners, const struct gradients *gradients);
void sheen_plan_rows(const struct tile *tile, const struct setup *setup);

#define SHEEN_TAP(what, count) (sheen_plan_counted[SHEEN_PLAN_##what] += (uint32_t)(count))
#define SHEEN_TAP_SETUP(corners, gradients) sheen_plan_setup(corners, gradients)
#define SHEEN_TAP_ROWS(tile, setup) sheen_plan_rows(tile, setup)

#endif
