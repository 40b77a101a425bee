/*
 * turntable.c - a mesh that turns on a simulated panel.
 */
#include "turntable.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glass.h"
#include "notes.h"
#include "progress.h"

const char *sheen_turntable_panel_name(const struct sheen_turntable *table)
{
    return table->choice.record ? table->choice.record->name : "ideal";
}

int sheen_turntable_choose(struct sheen_sim_choice *choice, const struct sheen_options *options,
                           struct sheen_problem *problem)
{
    char why[4096 + 100]; /* the name in it may have any length; the problem shortens it */
    int error = sheen_sim_choose(choice, options->panel, options->orientation, options->size[0], options->size[1], why,
                                 sizeof why);

    return error ? sheen_problem(problem, error, "%s", why) : SHEEN_OK;
}

int sheen_turntable_check(struct sheen_sim_choice *choice, const struct sheen_options *options,
                          struct sheen_problem *problem)
{
    int error = sheen_turntable_choose(choice, options, problem);

    if (!error && options->band > choice->height)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--band '%d': out of range 1..%u", options->band,
                             choice->height);
    return error;
}

static void close_panel(struct sheen_turntable *table)
{
    free(table->values);
    free(table->rgb);
    sheen_sim_panel_close(table->panel);
    table->values = NULL;
    table->rgb = NULL;
    table->panel = NULL;
}

int sheen_turntable_open_panel(struct sheen_turntable *table, const struct sheen_sim_choice *choice,
                               struct sheen_problem *problem)
{
    size_t pixels = (size_t)choice->width * choice->height;

    table->choice = *choice;
    table->values = malloc(pixels * sizeof *table->values);
    table->rgb = malloc(pixels * 3);
    int error = table->values && table->rgb ? sheen_sim_panel_open(&table->panel, choice) : SHEEN_ERR_MEMORY;
    if (!error)
        error = sheen_sim_panel_init(table->panel);
    return error ? sheen_problem(problem, error, "%s: %s", sheen_turntable_panel_name(table), sheen_strerror(error))
                 : SHEEN_OK;
}

int sheen_turntable_open(struct sheen_turntable *table, const struct sheen_options *options,
                         const struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    memset(table, 0, sizeof *table);
    table->options = options;
    int error = sheen_turntable_open_panel(table, choice, problem);
    if (error)
        return error;
    sheen_progress("reading the mesh", 0, 0);
    error = sheen_scene_open(&table->scene, options, sheen_sim_panel_target(table->panel), problem);
    sheen_progress_end();
    return error;
}

int sheen_turntable_panel(struct sheen_turntable *table, const struct sheen_sim_choice *choice,
                          struct sheen_problem *problem)
{
    close_panel(table);
    int error = sheen_turntable_open_panel(table, choice, problem);
    if (error)
        return error;
    error = sheen_scene_retarget(&table->scene, sheen_sim_panel_target(table->panel));
    return error ? sheen_problem(problem, error, "%s: %s", sheen_turntable_panel_name(table), sheen_strerror(error))
                 : SHEEN_OK;
}

void sheen_turntable_close(struct sheen_turntable *table)
{
    sheen_scene_close(&table->scene);
    close_panel(table);
    memset(table, 0, sizeof *table);
}

int sheen_turntable_read(struct sheen_turntable *table, struct sheen_problem *problem)
{
    const char *panel = sheen_turntable_panel_name(table);
    size_t pixels = (size_t)table->choice.width * table->choice.height;

    if (sheen_sim_panel_complaints(table->panel) > 0)
        return sheen_problem(problem, SHEEN_ERR_BUS, "%s: the controller complains: %s", panel,
                             sheen_sim_panel_complaint(table->panel));
    int error = sheen_sim_panel_picture(table->panel, table->values);
    if (error)
        return sheen_problem(problem, error, "%s: %s", panel, sheen_strerror(error));
    for (size_t i = 0; i < pixels; i++)
        sheen_sim_expand(table->values[i], sheen_sim_panel_levels(table->panel), table->rgb + 3 * i);
    return SHEEN_OK;
}

/* Why a frame has no pixel of the mesh; NULL: it has some. */
static const char *why_empty(const struct sheen_turntable *table)
{
    struct sheen_stats stats;

    if (table->options->opacity * 64 < 0.5)
        return "--opacity leaves no pixel";
    sheen_frame_stats(table->scene.frame, &stats);
    if (stats.covered > 0)
        return NULL;
    if (stats.drawn > 0)
        return "what faces the eye is smaller than a pixel";
    if (table->options->two_sided)
        return "the mesh is outside the view";
    return stats.front > 0 ? "what faces the eye is outside the view, the rest is turned away (--cull none draws it)"
                           : "all faces are turned away or outside the view (--cull none draws those turned away)";
}

static void warn_if_empty(struct sheen_turntable *table)
{
    const char *why = table->warned ? NULL : why_empty(table);
    struct sheen_problem line;

    if (!why)
        return;
    table->warned = 1;
    sheen_problem(&line, 0, "%s: nothing to be seen: %s", table->options->mesh, why);
    fprintf(stderr, "sheen: warning: %s\n", line.text);
}

/* Where the picture may have holes: once, and not if a warning has named --cull already. */
static void note_inside(struct sheen_turntable *table)
{
    struct sheen_notes notes = {0};

    if (!table->scene.shows_inside || table->warned)
        return;
    table->scene.shows_inside = 0;
    sheen_note(&notes, SHEEN_NOTE_DONE, "%s: not closed; --cull none also draws the faces seen from behind",
               table->options->mesh);
    sheen_notes_print(&notes, 0);
}

int sheen_turntable_problem(const struct sheen_turntable *table, int error, struct sheen_problem *problem)
{
    const char *mesh = table->options->mesh, *text = sheen_strerror(error);

    if (error != SHEEN_ERR_CAPACITY)
        return sheen_problem(problem, error, "%s: %s", mesh, text);
    return sheen_problem(problem, error, "%s: %s: %s", mesh, text,
                         sheen_subject_name(sheen_frame_about(table->scene.frame, NULL)));
}

int sheen_turntable_draw(struct sheen_turntable *table, int number, struct sheen_problem *problem)
{
    sheen_sim_bus_counters_reset(sheen_sim_panel_bus(table->panel));
    int error = sheen_scene_draw(&table->scene, number);
    if (!error)
        error = sheen_wait(table->scene.frame);
    if (error)
        return sheen_turntable_problem(table, error, problem);
    warn_if_empty(table);
    note_inside(table);
    return sheen_turntable_read(table, problem);
}
