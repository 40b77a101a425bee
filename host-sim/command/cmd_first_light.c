/*
 * cmd_first_light.c - `sheen first-light`: the test picture, through a panel's driver, as its glass shows it.
 */
#include <stdlib.h>
#include <strings.h>

#include "commands.h"
#include "frame_name.h"
#include "glass.h"
#include "png_file.h"
#include "sheen_first_light.h"
#include "turntable.h"

/* Bytes of a band buffer: 16 rows of the widest picture in 565. */
#define BAND_BYTES (640 * 16 * 2)

static int write_glass(struct sheen_sim_panel *panel, const struct sheen_sim_choice *choice, const char *path,
                       struct sheen_problem *problem)
{
    size_t pixels = (size_t)choice->width * choice->height;
    uint16_t *values = malloc(pixels * sizeof *values);
    uint8_t *rgb = malloc(pixels * 3);
    int error = values && rgb ? sheen_sim_panel_picture(panel, values) : SHEEN_ERR_MEMORY;

    if (error) {
        sheen_problem(problem, error, "%s: %s", path, sheen_strerror(error));
    } else {
        for (size_t i = 0; i < pixels; i++)
            sheen_sim_expand(values[i], sheen_sim_panel_levels(panel), rgb + 3 * i);
        error = sheen_png_write(path, rgb, choice->width, choice->height, problem);
    }
    free(values);
    free(rgb);
    return error;
}

static int draw(struct sheen_sim_panel *panel, const char *name, struct sheen_problem *problem)
{
    static uint8_t buffer[BAND_BYTES];
    int error = sheen_first_light(sheen_sim_panel_target(panel), buffer, sizeof buffer);

    if (error)
        return sheen_problem(problem, error, "%s: %s", name, sheen_strerror(error));
    if (sheen_sim_panel_complaints(panel) > 0)
        return sheen_problem(problem, SHEEN_ERR_BUS, "%s: the controller complains: %s", name,
                             sheen_sim_panel_complaint(panel));
    return SHEEN_OK;
}

enum sheen_exit sheen_cmd_first_light(struct sheen_options *options)
{
    struct sheen_sim_choice choice;
    struct sheen_sim_panel *panel;
    struct sheen_problem problem;

    if (sheen_turntable_choose(&choice, options, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    if (!options->out) {
        sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "no output given (-o OUT.png)");
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    }
    const char *ending = sheen_ending(options->out);
    if (*ending && strcasecmp(ending, ".png") != 0) {
        sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "%s: no pictures in %s are written, only .png", options->out,
                      ending);
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    }
    int error = sheen_sim_panel_open(&panel, &choice);
    if (error)
        sheen_problem(&problem, error, "%s: %s", options->panel, sheen_strerror(error));
    else
        error = draw(panel, options->panel, &problem);
    if (!error)
        error = write_glass(panel, &choice, options->out, &problem);
    sheen_sim_panel_close(panel);
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
