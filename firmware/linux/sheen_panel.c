/*
 * sheen-panel - a turning mesh on a small panel that is wired to a Linux board.
 *
 *   options -> board (bus, sending thread, panel, lines) -> scene -> frames
 *
 * Exit status 0: the frames are done, or a signal asked to stop; 2: a wrong command
 * line; 1: any other error. After an error one line on standard error explains it.
 */
#include "board.h"
#include "list.h"
#include "meter.h"
#include "options.h"
#include "sheen_first_light.h"
#include "stop.h"

#include "../../host-sim/command/scene.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BAND_ROWS 16 /* for the test picture */

/* Reports a frame's error, with the bus's message if the bus has failed. */
static int frame_failed(struct board *board, int error, struct sheen_failure *why)
{
    if (board->sending.text[0])
        return sheen_failed(why, error, "%s", board->sending.text);
    return sheen_failed(why, error, "the frame: %s", sheen_strerror(error));
}

/* Draws frames until there are enough, a signal comes or a frame fails. */
static int run_frames(struct board *board, struct sheen_scene *scene, const struct options *options,
                      struct sheen_failure *why)
{
    struct meter meter;
    uint64_t due_ns = 0;
    int error = 0;

    meter_start(&meter);
    for (int number = 0; number < options->frames || options->frames == 0; number = (number + 1) % INT_MAX) {
        if (!board_pace(board, options->fps, &due_ns))
            return 0;
        error = sheen_scene_draw(scene, number);
        if (error < 0)
            return frame_failed(board, error, why);
        if (!options->quiet)
            meter_frame(&meter, &board->sender);
    }
    error = sheen_wait(scene->frame);
    return error < 0 ? frame_failed(board, error, why) : 0;
}

static int show_mesh(struct board *board, const struct options *options, struct sheen_failure *why)
{
    struct sheen_scene scene;
    struct sheen_problem problem;
    int error;

    error = sheen_scene_open(&scene, &options->view, &board->target, &problem);
    if (error == 0)
        error = run_frames(board, &scene, options, why);
    else
        sheen_failed(why, error, "%s", problem.text);
    sheen_scene_close(&scene);
    return error;
}

/* Shows the test picture. With --frames it returns at once and the picture stays; otherwise it waits for a signal. */
static int show_first_light(struct board *board, const struct options *options, struct sheen_failure *why)
{
    size_t bytes = (size_t)board->target.width * BAND_ROWS * 2;
    void *band = malloc(bytes);
    int error = band ? sheen_first_light(&board->target, band, bytes) : SHEEN_ERR_MEMORY;

    free(band);
    if (error < 0)
        return frame_failed(board, error, why);
    if (options->frames == 0)
        stop_wait();
    return 0;
}

static int run(const struct options *options, struct sheen_failure *why)
{
    struct board board;
    int error, closing;

    stop_watch();
    error = board_open(&board, options, why);
    if (error < 0)
        return error;
    error = options->first_light ? show_first_light(&board, options, why) : show_mesh(&board, options, why);
    /* After a signal the panel goes dark, because nobody draws on it any more; otherwise the last picture stays. */
    closing = board_close(&board, stop_asked(), error < 0 ? NULL : why);
    return error < 0 ? error : closing;
}

int main(int argc, char **argv)
{
    struct options options;
    struct sheen_failure why = {""};
    int status = options_read(&options, argc, argv, &why);

    if (status == 0 && options.help) {
        options_help();
    } else if (status == 0 && options.man) {
        options_man();
    } else if (status == 0 && options.version) {
        printf("sheen-panel %s, libgpiod %s\n", SHEEN_VERSION, sheen_pins_version());
    } else if (status == 0 && options.panels) {
        list_panels();
    } else if (status == 0 && options.list) {
        status = list_lines(&why) < 0;
    } else if (status == 0) {
        status = options_check(&options, &why);
        if (status == 0)
            status = run(&options, &why) < 0;
    }
    if (status == 0 && (fflush(stdout) != 0 || ferror(stdout)))
        status = sheen_failed(&why, 1, "standard output: %s", strerror(errno));
    if (status) {
        struct sheen_problem line; /* makes text from a file or the command line safe to print on a terminal */
        sheen_problem(&line, status, "%s", why.text);
        fprintf(stderr, "sheen-panel: %s\n", line.text);
    }
    return status;
}
