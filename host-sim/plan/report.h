/*
 * report.h - a plan as text and as JSON.
 */
#ifndef SHEEN_PLAN_REPORT_H
#define SHEEN_PLAN_REPORT_H

#include <stdio.h>

#include "plan.h"

/* board: of one board all there is; -1: of all boards a line each. */
void sheen_plan_text(FILE *out, const struct sheen_plan *plan, int board);

/* One object, a line. */
void sheen_plan_json(FILE *out, const struct sheen_plan *plan, int board);

/* One line: the rows of a band, RAM, and frames a second on every board that has it, of what changes. */
void sheen_plan_brief(FILE *out, const struct sheen_plan *plan);

extern const char *const sheen_plan_stage_names[SHEEN_PLAN_STAGES];

/* What limits frames on a board: "RAM", "flash", "bus" or a stage's name. */
const char *sheen_plan_limit(const struct sheen_plan *plan, unsigned board);

#endif
