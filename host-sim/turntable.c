/*
 * turntable.c - a mesh that turns on a simulated panel.
 */
#include "turntable.h"

#include <stdlib.h>
#include <string.h>

#include "glass.h"

int sheen_turntable_open(struct sheen_turntable *table, const struct sheen_options *options,
                         const struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    size_t pixels = (size_t)choice->width * choice->height;

    memset(table, 0, sizeof *table);
    table->options = options;
    table->choice = *choice;
    table->values = malloc(pixels * sizeof *table->values);
    table->rgb = malloc(pixels * 3);
    int error = table->values && table->rgb ? sheen_sim_panel_open(&table->panel, choice) : SHEEN_ERR_MEMORY;
    if (!error)
        error = sheen_sim_panel_init(table->panel);
    if (error)
        return sheen_problem(problem, error, "%s: %s", options->panel, sheen_strerror(error));
    return sheen_scene_open(&table->scene, options, sheen_sim_panel_target(table->panel), problem);
}

void sheen_turntable_close(struct sheen_turntable *table)
{
    sheen_scene_close(&table->scene);
    free(table->values);
    free(table->rgb);
    if (table->panel)
        sheen_sim_panel_close(table->panel);
    memset(table, 0, sizeof *table);
}

static int read_picture(struct sheen_turntable *table)
{
    size_t pixels = (size_t)table->choice.width * table->choice.height;
    int error = sheen_sim_panel_picture(table->panel, table->values);

    for (size_t i = 0; !error && i < pixels; i++)
        sheen_sim_expand(table->values[i], sheen_sim_panel_levels(table->panel), table->rgb + 3 * i);
    return error;
}

int sheen_turntable_draw(struct sheen_turntable *table, int number, struct sheen_problem *problem)
{
    const char *panel = table->choice.record ? table->choice.record->name : "ideal";

    sheen_sim_bus_counters_reset(sheen_sim_panel_bus(table->panel));
    int error = sheen_scene_draw(&table->scene, number);
    if (!error)
        error = sheen_wait(table->scene.frame);
    if (error)
        return sheen_problem(problem, error, "%s: %s", table->options->mesh, sheen_strerror(error));
    if (sheen_sim_panel_complaints(table->panel) > 0)
        return sheen_problem(problem, SHEEN_ERR_BUS, "%s: the controller complains: %s", panel,
                             sheen_sim_panel_complaint(table->panel));
    error = read_picture(table);
    return error ? sheen_problem(problem, error, "%s: %s", panel, sheen_strerror(error)) : SHEEN_OK;
}
