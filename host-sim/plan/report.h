/*
 * report.h - a plan as text and as JSON.
 */
#ifndef SHEEN_PLAN_REPORT_H
#define SHEEN_PLAN_REPORT_H

#include <stdio.h>

#include "plan.h"

/* board: everything about that board; -1: one line for each board. */
void sheen_plan_text(FILE *out, const struct sheen_plan *plan, int board);

/* One JSON object, on one line. */
void sheen_plan_json(FILE *out, const struct sheen_plan *plan, int board);

/* One line: rows per band, RAM, and frames per second (what changed is sent) on each board with memory enough. */
void sheen_plan_brief(FILE *out, const struct sheen_plan *plan);

extern const char *const sheen_plan_stage_names[SHEEN_PLAN_STAGES];

/* What limits frames on a board: "RAM", "flash", "bus" or a stage's name. */
const char *sheen_plan_limit(const struct sheen_plan *plan, unsigned board);

#endif
