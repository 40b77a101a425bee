/*
 * cmd_render.c - `sheen render`: a mesh to a picture, or a series of pictures.
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "builtin.h"
#include "commands.h"
#include "frame_name.h"
#include "gif_file.h"
#include "png_file.h"
#include "progress.h"
#include "stats_json.h"
#include "textures_out.h"

#define GIF_DELAY_CS 5 /* 20 frames per second */

static int is_gif(const char *path)
{
    return strcasecmp(sheen_ending(path), ".gif") == 0;
}

/* Checks what no option can check by itself. 0, or SHEEN_ERR_ARGUMENT and *problem: a wrong command line. */
static int check(const struct sheen_options *options, struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    int error = sheen_turntable_check(choice, options, problem);

    if (error)
        return error;
    if (!options->out)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no output given (-o OUT.png)");
    const char *ending = sheen_ending(options->out);
    if (*ending && !is_gif(options->out) && strcasecmp(ending, ".png") != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no pictures in %s are written, only .png and .gif",
                             options->out, ending);
    if (options->frames > 1 && !is_gif(options->out) && !sheen_frame_name_varies(options->out))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %d frames need one %%d or %%0Nd in the name, or a .gif",
                             options->out, options->frames);
    error = sheen_textures_out_check(options, problem);
    return error ? error : sheen_builtin_check(options->mesh, problem);
}

/* Adds a frame to the animation, or writes it to a file of its own. */
static int put_frame(const struct sheen_turntable *table, struct sheen_gif *gif, int number,
                     struct sheen_problem *problem)
{
    const char *out = table->options->out;
    char path[4096];

    if (gif) {
        int error = sheen_gif_add(gif, table->rgb);
        return error ? sheen_problem(problem, error, "%s: not enough memory", out) : SHEEN_OK;
    }
    if (sheen_frame_name(path, sizeof path, out, number, (size_t)table->options->frames) != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", out, strerror(ENAMETOOLONG));
    return sheen_png_write(path, table->rgb, table->choice.width, table->choice.height, problem);
}

static int draw_frames(struct sheen_turntable *table, struct sheen_gif *gif, struct sheen_problem *problem)
{
    int error = SHEEN_OK, frames = table->options->frames;

    for (int number = 0; !error && number < frames; number++) {
        if (frames > 1 && !table->options->stats) /* the lines of --stats show progress too */
            sheen_progress("frame", number + 1, frames);
        error = sheen_turntable_draw(table, number, problem);
        if (!error)
            error = put_frame(table, gif, number, problem);
        if (!error && table->options->stats && sheen_stats_json(stdout, table, number) != 0)
            error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "standard output: %s", strerror(errno));
    }
    sheen_progress_end();
    return error;
}

static int render(struct sheen_turntable *table, struct sheen_problem *problem)
{
    const char *out = table->options->out;
    struct sheen_gif *gif = NULL;

    if (!is_gif(out))
        return draw_frames(table, NULL, problem);
    int error = sheen_gif_open(&gif, table->choice.width, table->choice.height, GIF_DELAY_CS);
    error = error ? sheen_problem(problem, error, "%s: not enough memory", out) : draw_frames(table, gif, problem);
    if (!error)
        error = sheen_gif_write(gif, out, problem);
    sheen_gif_close(gif);
    return error;
}

static int textures_out(const struct sheen_scene *scene, struct sheen_problem *problem)
{
    if (sheen_scene_shading(scene) >= SHEEN_MATCAP)
        return sheen_textures_out(scene->options, &scene->matcap, 1, problem);
    return sheen_textures_out(scene->options, scene->texels, scene->texel_count, problem);
}

enum sheen_exit sheen_cmd_render(struct sheen_options *options)
{
    struct sheen_turntable table;
    struct sheen_sim_choice choice;
    struct sheen_problem problem;

    if (check(options, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    int error = sheen_turntable_open(&table, options, &choice, &problem);
    int is_usage = table.scene.is_usage;
    if (!error)
        error = textures_out(&table.scene, &problem);
    if (!error)
        error = render(&table, &problem);
    sheen_turntable_close(&table);
    return error ? sheen_fail(is_usage ? SHEEN_EXIT_USAGE : SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
