/*
 * cmd_render.c - `sheen render`: a mesh to a picture, or a row of pictures.
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "builtin.h"
#include "commands.h"
#include "frame_name.h"
#include "png_file.h"
#include "stats_json.h"

/* What one option cannot judge by itself. 0, or SHEEN_ERR_ARGUMENT and *problem: a wrong command line. */
static int check(const struct sheen_options *options, struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    int error = sheen_sim_choose(choice, options->panel, options->orientation, options->size[0], options->size[1],
                                 problem->text, sizeof problem->text);

    if (error)
        return error;
    if (options->band > choice->height)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--band '%d': out of range 1..%u", options->band,
                             choice->height);
    if (!options->out)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no output given (-o OUT.png)");
    if (options->frames > 1 && !sheen_frame_name_varies(options->out))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %d frames need one %%d or %%0Nd in the name",
                             options->out, options->frames);
    return sheen_builtin_check(options->mesh, problem);
}

static int write_frame(const struct sheen_turntable *table, int number, struct sheen_problem *problem)
{
    char path[4096];

    if (sheen_frame_name(path, sizeof path, table->options->out, number) != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", table->options->out, strerror(ENAMETOOLONG));
    return sheen_png_write(path, table->rgb, table->choice.width, table->choice.height, problem);
}

static int render(struct sheen_turntable *table, struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    for (int number = 0; !error && number < table->options->frames; number++) {
        error = sheen_turntable_draw(table, number, problem);
        if (!error)
            error = write_frame(table, number, problem);
        if (!error && table->options->stats && sheen_stats_json(stdout, table, number) != 0)
            error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "standard output: %s", strerror(errno));
    }
    return error;
}

enum sheen_exit sheen_cmd_render(struct sheen_options *options)
{
    struct sheen_turntable table;
    struct sheen_sim_choice choice;
    struct sheen_problem problem;

    if (check(options, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    int error = sheen_turntable_open(&table, options, &choice, &problem);
    if (!error)
        error = render(&table, &problem);
    sheen_turntable_close(&table);
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
