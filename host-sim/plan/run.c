/*
 * run.c - frames of a mesh that turns on a panel, counted band by band.
 */
#include "run.h"

#include <string.h>

/* Notes what the last push sent. Call it when the next push begins or the frame has ended: by then all has left. */
static void note_bus(struct sheen_plan_run *run)
{
    struct sheen_sim_counters bus = sheen_sim_bus_counters(sheen_sim_panel_bus(run->table.panel));

    if (run->bands > 0) {
        run->band[run->bands - 1].bytes = (uint32_t)(bus.bytes - run->bytes);
        run->band[run->bands - 1].calls = (uint32_t)(bus.transactions - run->calls);
    }
    run->bytes = bus.bytes;
    run->calls = bus.transactions;
}

static int watched_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct sheen_plan_run *run = ctx;
    const struct sheen_panel_record *record = run->table.choice.record;
    struct sheen_plan_band *band = &run->band[run->bands];

    note_bus(run);
    band->pixels = (uint32_t)(rect.x1 - rect.x0) * (uint32_t)(rect.y1 - rect.y0);
    sheen_plan_counts_take(&band->counts);
    sheen_plan_count_push(&band->counts, (enum sheen_pixel)run->panel->pixel, record && record->bits_18, band->pixels);
    run->bands++;
    return run->panel->push(run->panel->ctx, rect, pixels);
}

static int watched_wait(void *ctx)
{
    const struct sheen_plan_run *run = ctx;

    return run->panel->wait ? run->panel->wait(run->panel->ctx) : SHEEN_OK;
}

int sheen_plan_open(struct sheen_plan_run *run, const struct sheen_options *options,
                    const struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    memset(run, 0, sizeof *run);
    int error = sheen_turntable_open(&run->table, options, choice, problem);
    if (error)
        return error;
    run->panel = sheen_sim_panel_target(run->table.panel);
    run->target = *run->panel;
    run->target.ctx = run;
    run->target.push = watched_push;
    run->target.wait = watched_wait;
    error = sheen_scene_retarget(&run->table.scene, &run->target);
    return error ? sheen_turntable_problem(&run->table, error, problem) : SHEEN_OK;
}

void sheen_plan_close(struct sheen_plan_run *run)
{
    sheen_turntable_close(&run->table);
}

/* Adds what was counted after the last push, and the frame's own counters. */
static void count_rest(struct sheen_plan_run *run)
{
    const struct sheen_scene *scene = &run->table.scene;
    struct sheen_plan_counts rest, *last;
    struct sheen_stats stats;
    uint32_t vertices = 0;

    if (run->bands == 0) /* nothing was sent */
        memset(&run->band[run->bands++], 0, sizeof run->band[0]);
    sheen_plan_counts_take(&rest);
    last = &run->band[run->bands - 1].counts;
    for (unsigned i = 0; i < SHEEN_PLAN_COUNTS; i++)
        last->of[i] += rest.of[i];
    for (size_t i = 0; i < scene->count; i++)
        vertices += scene->meshes[i].mesh.vertices;
    sheen_frame_stats(scene->frame, &stats);
    run->setups = stats.setups;
    sheen_plan_count_draws(&run->front, scene->frame, (unsigned)scene->count, vertices);
}

int sheen_plan_draw(struct sheen_plan_run *run, int number, int whole, struct sheen_problem *problem)
{
    struct sheen_scene *scene = &run->table.scene;
    unsigned room;
    int error;

    do { /* again if the frame was made anew with more room: the attempts that found it too small are not counted */
        room = scene->config.max_clipped;
        if (whole)
            sheen_invalidate(scene->frame);
        run->bands = 0;
        note_bus(run);
        sheen_plan_counts_begin();
        error = sheen_scene_begin(scene, number);
        if (room != scene->config.max_clipped && !error)
            (void)sheen_finish(scene->frame);
    } while (!error && room != scene->config.max_clipped);
    sheen_plan_counts_take(&run->front);
    if (!error)
        error = sheen_end(scene->frame);
    if (!error)
        error = sheen_wait(scene->frame);
    if (error)
        return sheen_turntable_problem(&run->table, error, problem);
    note_bus(run);
    count_rest(run);
    return SHEEN_OK;
}

void sheen_plan_sum(const struct sheen_plan_run *run, struct sheen_plan_counts *counts)
{
    *counts = run->front;
    for (unsigned b = 0; b < run->bands; b++)
        for (unsigned i = 0; i < SHEEN_PLAN_COUNTS; i++)
            counts->of[i] += run->band[b].counts.of[i];
}
