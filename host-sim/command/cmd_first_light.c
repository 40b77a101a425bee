/*
 * cmd_first_light.c - `sheen first-light`: the test picture, through a panel's driver, as its glass shows it.
 */
#include <strings.h>

#include "commands.h"
#include "frame_name.h"
#include "png_file.h"
#include "sheen_first_light.h"
#include "turntable.h"

/* Bytes of a band buffer: 16 rows of the widest picture in 565. */
#define BAND_BYTES (640 * 16 * 2)

/* Checks what no option can check by itself. 0, or SHEEN_ERR_ARGUMENT and *problem: a wrong command line. */
static int check(const struct sheen_options *options, struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    int error = sheen_turntable_choose(choice, options, problem);

    if (error)
        return error;
    if (!options->out)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no output given (-o OUT.png)");
    const char *ending = sheen_ending(options->out);
    if (*ending && strcasecmp(ending, ".png") != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no pictures in %s are written, only .png", options->out,
                             ending);
    return SHEEN_OK;
}

static int draw(struct sheen_turntable *table, struct sheen_problem *problem)
{
    static uint8_t buffer[BAND_BYTES];
    int error = sheen_first_light(sheen_sim_panel_target(table->panel), buffer, sizeof buffer);

    if (error)
        return sheen_problem(problem, error, "%s: %s", sheen_turntable_panel_name(table), sheen_strerror(error));
    error = sheen_turntable_read(table, problem);
    return error ? error
                 : sheen_png_write(table->options->out, table->rgb, table->choice.width, table->choice.height, problem);
}

enum sheen_exit sheen_cmd_first_light(struct sheen_options *options)
{
    struct sheen_turntable table = {.options = options};
    struct sheen_sim_choice choice;
    struct sheen_problem problem;

    if (check(options, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    int error = sheen_turntable_open_panel(&table, &choice, &problem);
    if (!error)
        error = draw(&table, &problem);
    sheen_turntable_close(&table);
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
