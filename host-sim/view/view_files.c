/*
 * view_files.c - the glass as it looks, to PNG and GIF.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "png_file.h"
#include "view.h"

uint8_t *sheen_viewer_picture(const struct sheen_viewer *viewer, unsigned size[2])
{
    size[0] = viewer->table.choice.width * viewer->look.scale;
    size[1] = viewer->table.choice.height * viewer->look.scale;
    size_t count = (size_t)size[0] * size[1];
    uint32_t *values = malloc(count * sizeof *values);
    uint8_t *rgb = malloc(count * 3);

    if (values && rgb) {
        sheen_viewer_paint(viewer, values, size[0]);
        for (size_t i = 0; i < count; i++) {
            rgb[3 * i] = (uint8_t)(values[i] >> 16);
            rgb[3 * i + 1] = (uint8_t)(values[i] >> 8);
            rgb[3 * i + 2] = (uint8_t)values[i];
        }
    } else {
        free(rgb);
        rgb = NULL;
    }
    free(values);
    return rgb;
}

/* The first name sheen-001.ending .. sheen-999.ending that no file has. */
static int free_name(char *name, size_t size, const char *ending, struct sheen_problem *problem)
{
    for (int number = 1; number <= 999; number++) {
        snprintf(name, size, "sheen-%03d.%s", number, ending);
        if (access(name, F_OK) != 0 && errno == ENOENT)
            return SHEEN_OK;
    }
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "sheen-999.%s: all numbers are taken", ending);
}

int sheen_viewer_png(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    char name[32];
    unsigned size[2];
    int error = free_name(name, sizeof name, "png", problem);

    if (error)
        return error;
    uint8_t *rgb = sheen_viewer_picture(viewer, size);
    error = rgb ? sheen_png_write(name, rgb, size[0], size[1], problem)
                : sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", name);
    free(rgb);
    if (!error)
        snprintf(viewer->message, sizeof viewer->message, "%s written", name);
    return error;
}

/* ---- a recording ---- */

static void drop_gif(struct sheen_viewer *viewer)
{
    sheen_gif_close(viewer->gif);
    viewer->gif = NULL;
}

int sheen_viewer_gif_begin(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    viewer->gif_size[0] = viewer->table.choice.width * viewer->look.scale;
    viewer->gif_size[1] = viewer->table.choice.height * viewer->look.scale;
    viewer->gif_frames = 0;
    if (sheen_gif_open(&viewer->gif, viewer->gif_size[0], viewer->gif_size[1], SHEEN_VIEW_MS / 10) != 0) {
        drop_gif(viewer);
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "recording: not enough memory");
    }
    return sheen_viewer_gif_add(viewer, problem);
}

int sheen_viewer_gif_add(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    unsigned size[2];
    uint8_t *rgb = sheen_viewer_picture(viewer, size);
    int error = SHEEN_OK;

    if (rgb && memcmp(size, viewer->gif_size, sizeof size) != 0) {
        free(rgb);
        return sheen_viewer_gif_end(viewer, NULL, problem);
    }
    if (!rgb || sheen_gif_add(viewer->gif, rgb) != 0) {
        drop_gif(viewer);
        error = sheen_problem(problem, SHEEN_ERR_MEMORY, "recording: not enough memory");
    } else {
        viewer->gif_frames++;
    }
    free(rgb);
    return error;
}

int sheen_viewer_gif_end(struct sheen_viewer *viewer, const char *path, struct sheen_problem *problem)
{
    char name[32];
    int error = path ? SHEEN_OK : free_name(name, sizeof name, "gif", problem);

    if (!path)
        path = name;
    if (!error)
        error = sheen_gif_write(viewer->gif, path, problem);
    if (!error)
        snprintf(viewer->message, sizeof viewer->message, "%s written, %d frames", path, viewer->gif_frames);
    drop_gif(viewer);
    return error;
}

void sheen_viewer_record(struct sheen_viewer *viewer)
{
    struct sheen_problem problem;

    if (viewer->gif && sheen_viewer_gif_add(viewer, &problem) != 0)
        snprintf(viewer->message, sizeof viewer->message, "%s", problem.text);
}
