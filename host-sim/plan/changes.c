/*
 * changes.c - what to change first: each change is tried, over fewer views.
 */
#include <stdio.h>
#include <stdlib.h>

#include "plan.h"

#define VIEWS 12
#define WORTH 1.03 /* changes are shown that raise the rate by more than this factor */

static double rate_of(const struct sheen_plan *plan, unsigned board)
{
    return 1 / plan->times[board][0].mean.period[plan->options->buffers > 1];
}

/* The rate with other options; 0 if they fail, say because the mesh cannot be simplified, or if RAM is short. */
static double try_rate(struct sheen_plan *tried, const struct sheen_plan *plan, const struct sheen_options *options,
                       unsigned board)
{
    const struct sheen_plan_board *b = sheen_plan_board_at(board);
    struct sheen_problem ignored;

    if (sheen_plan_make(tried, options, &plan->choice, VIEWS, &ignored) != 0)
        return 0;
    return sheen_plan_ram_short(tried, b) ? 0 : rate_of(tried, board);
}

/* Adds changes that make the look cheaper, from number n on. Returns the number past the last. */
static unsigned looks(const struct sheen_plan *plan, struct sheen_options *changed, struct sheen_plan_change *changes,
                      unsigned n)
{
    static const int cheaper[SHEEN_ALL_SHADINGS] = {
        [SHEEN_FLAT] = -1,           [SHEEN_GOURAUD] = SHEEN_FLAT,         [SHEEN_PHONG] = SHEEN_GOURAUD,
        [SHEEN_SLERP] = SHEEN_PHONG, [SHEEN_MATCAP] = SHEEN_MATCAP_VERTEX, [SHEEN_MATCAP_VERTEX] = -1};
    const struct sheen_options *now = plan->options;
    const int shade = cheaper[plan->shade];

    if (shade >= 0) {
        changed[n].shade = shade;
        snprintf(changes[n++].what, sizeof changes->what, "--shade %s", sheen_shading_word((unsigned)shade));
    }
    if (now->bilinear) {
        changed[n].bilinear = 0;
        snprintf(changes[n++].what, sizeof changes->what, "--filter nearest");
    }
    if (now->edges == SHEEN_SMOOTH || now->edges == SHEEN_OUTLINE) {
        changed[n].edges = SHEEN_NO_EDGES;
        snprintf(changes[n++].what, sizeof changes->what, "--edges none");
    }
    return n;
}

/* Makes options that each differ from the present ones in one thing. Returns their number. */
static unsigned variants(const struct sheen_plan *plan, unsigned board, struct sheen_options *changed,
                         struct sheen_plan_change *changes)
{
    const struct sheen_plan_board *b = sheen_plan_board_at(board);
    const struct sheen_options *now = plan->options;
    const double hz = sheen_plan_bus_hz(plan, b);
    const int rows = (int)sheen_plan_band_rows(plan);
    unsigned n = 0;

    for (unsigned i = 0; i < SHEEN_PLAN_CHANGES; i++) {
        changed[i] = *now;
        changed[i].quiet = 1;
    }
    if (now->buffers < 2) {
        changed[n].buffers = 2;
        snprintf(changes[n++].what, sizeof changes->what, "--buffers 2");
    }
    if (2 * rows <= plan->target.height) {
        changed[n].band = 2 * rows;
        snprintf(changes[n++].what, sizeof changes->what, "--band %d", 2 * rows);
    }
    if (sheen_plan_ram_short(plan, b) && rows > 1) {
        changed[n].band = rows / 2;
        snprintf(changes[n++].what, sizeof changes->what, "--band %d", rows / 2);
    }
    if (hz < b->bus_hz) {
        changed[n].bus_clock = (2 * hz < b->bus_hz ? 2 * hz : b->bus_hz) / 1e6;
        snprintf(changes[n].what, sizeof changes->what, "--bus-clock %g, beyond what the panel is rated for",
                 changed[n].bus_clock);
        n++;
    }
    n = looks(plan, changed, changes, n);
    if (plan->target.pixel <= SHEEN_RGB565_LE && now->undithered <= 0) {
        changed[n].undithered = 1;
        snprintf(changes[n++].what, sizeof changes->what, "--dither off");
    }
    if (plan->triangles >= 64) {
        changed[n].reduce = (int)plan->triangles / 2;
        snprintf(changes[n].what, sizeof changes->what, "--reduce %d", changed[n].reduce);
        n++;
    }
    return n;
}

static int by_rate(const void *a, const void *b)
{
    const struct sheen_plan_change *p = a, *q = b;

    return (p->rate < q->rate) - (p->rate > q->rate);
}

unsigned sheen_plan_changes(const struct sheen_plan *plan, unsigned board, struct sheen_plan_change *changes,
                            double *now)
{
    struct sheen_options changed[SHEEN_PLAN_CHANGES];
    struct sheen_options quiet = *plan->options;
    struct sheen_plan *tried = malloc(sizeof *tried);
    unsigned n = variants(plan, board, changed, changes), kept = 0;

    quiet.quiet = 1;
    *now = tried ? try_rate(tried, plan, &quiet, board) : 0;
    for (unsigned i = 0; i < n && tried; i++) {
        changes[kept] = changes[i];
        changes[kept].rate = try_rate(tried, plan, &changed[i], board);
        kept += changes[kept].rate > WORTH * *now;
    }
    free(tried);
    qsort(changes, kept, sizeof *changes, by_rate);
    return kept;
}
