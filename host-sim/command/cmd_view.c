/*
 * cmd_view.c - `sheen view`: a mesh that turns on the simulated glass, in a window, as text or in a GIF.
 */
#include <strings.h>

#include "builtin.h"
#include "commands.h"
#include "frame_name.h"
#include "progress.h"
#include "view.h"

#define GIF_FRAMES 60 /* a whole turn in the default step of 6 degrees */

/* Checks what no option can check by itself. 0, or SHEEN_ERR_ARGUMENT and *problem: a wrong command line. */
static int check(const struct sheen_options *options, struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    int error = sheen_turntable_check(choice, options, problem);

    if (error)
        return error;
    if (options->scale && options->gap >= options->scale)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--gap '%d': out of range 0..%d", options->gap,
                             options->scale - 1);
    if (options->out && options->terminal)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "--gif and --terminal exclude each other");
    const char *ending = sheen_ending(options->out ? options->out : "");
    if (*ending && strcasecmp(ending, ".gif") != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no animations in %s are written, only .gif",
                             options->out, ending);
    return sheen_builtin_check(options->mesh, problem);
}

/* Draws every frame of the animation, then writes the file. */
static int write_gif(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    int frames = viewer->options.view_frames ? viewer->options.view_frames : GIF_FRAMES;
    int error = sheen_viewer_gif_begin(viewer, problem);

    for (int number = 1; !error && number < frames; number++) {
        sheen_progress("frame", number, frames);
        error = sheen_viewer_next(viewer, problem);
        if (!error)
            error = sheen_viewer_gif_add(viewer, problem);
    }
    sheen_progress_end();
    return error ? error : sheen_viewer_gif_end(viewer, viewer->options.out, problem);
}

/* Finds the px that the glass may take up: in a window what the screen has, in a GIF 480x360. */
static int find_room(const struct sheen_options *options, unsigned room[2], struct sheen_problem *problem)
{
    room[0] = options->terminal ? 1 : 480;
    room[1] = options->terminal ? 1 : 360;
    return options->terminal || options->out ? SHEEN_OK : sheen_view_window_room(room, options->view_frames, problem);
}

enum sheen_exit sheen_cmd_view(struct sheen_options *options)
{
    struct sheen_viewer viewer;
    struct sheen_sim_choice choice;
    struct sheen_problem problem, at_close;

    if (check(options, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    int error = sheen_viewer_open(&viewer, options, &choice, &problem);
    enum sheen_exit failure = viewer.table.scene.is_usage ? SHEEN_EXIT_USAGE : SHEEN_EXIT_FAILURE;
    if (!error)
        error = find_room(options, viewer.room, &problem);
    if (!error) {
        sheen_viewer_look(&viewer);
        error = options->out        ? write_gif(&viewer, &problem)
                : options->terminal ? sheen_view_terminal(&viewer, &problem)
                                    : sheen_view_window(&viewer, &problem);
    }
    if (error && viewer.gif) {
        sheen_gif_close(
            viewer.gif); /* closed here, so that sheen_viewer_close does not write an unfinished animation */
        viewer.gif = NULL;
    }
    int closed = sheen_viewer_close(&viewer, &at_close);
    return error ? sheen_fail(failure, &problem) : closed ? sheen_fail(SHEEN_EXIT_FAILURE, &at_close) : SHEEN_EXIT_OK;
}
