/*
 * view_keys.c - what keys do: most change the options, as if the new values had been given on the command line.
 */
#include <math.h>
#include <stdio.h>

#include "view.h"

#define TURN_DEG 10       /* per press of an arrow key */
#define LIGHT_TURN_DEG 30 /* about the line of sight */
#define MAX_SCALE 16

/* Moves each light on a cone about the line of sight. */
static void turn_lights(struct sheen_light_list *lights)
{
    double angle = LIGHT_TURN_DEG * M_PI / 180;

    for (int i = 0; i < lights->count; i++) {
        double x = lights->to[i][0], y = lights->to[i][1];
        lights->to[i][0] = x * cos(angle) - y * sin(angle);
        lights->to[i][1] = x * sin(angle) + y * cos(angle);
    }
}

/* Steps cyclically through the panels in the table's order and then ideal; each in its default orientation and size. */
static int change_panel(struct sheen_viewer *viewer, int step, struct sheen_problem *problem)
{
    struct sheen_options *options = &viewer->options;
    int count = 0, at = -1;

    for (; sheen_panel_at((size_t)count); count++) {
        if (sheen_panel_at((size_t)count) == viewer->table.choice.record)
            at = count;
    }
    at = ((at < 0 ? count : at) + step + count + 1) % (count + 1);
    options->panel = at == count ? "ideal" : sheen_panel_at((size_t)at)->name;
    options->orientation = -1;
    options->size[0] = options->size[1] = 0;
    return sheen_viewer_panel(viewer, problem);
}

/* Turns the glass as if in the hand; ideal, plain memory, looks the same in every orientation. */
static int change_orientation(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    if (!viewer->table.choice.record)
        return SHEEN_OK;
    viewer->options.orientation = (int)(viewer->table.choice.orientation + 1) % 8;
    viewer->options.size[0] = viewer->options.size[1] = 0;
    return sheen_viewer_panel(viewer, problem);
}

static void change_scale(struct sheen_viewer *viewer, int step)
{
    int scale = (int)viewer->look.scale + step;

    viewer->options.scale = scale < 1 ? 1 : scale > MAX_SCALE ? MAX_SCALE : scale;
    sheen_viewer_look(viewer);
}

/* Keys that change how the glass looks but not what is drawn. 1 if the key is one of these. */
static int look_key(struct sheen_viewer *viewer, int key)
{
    switch (key) {
    case '+':
    case '=':
        change_scale(viewer, 1);
        return 1;
    case '-':
        change_scale(viewer, -1);
        return 1;
    case 'x':
        viewer->options.gap = (int)(viewer->look.gap + 1) % (int)(viewer->look.scale < 4 ? viewer->look.scale : 4);
        sheen_viewer_look(viewer);
        return 1;
    case 't':
        viewer->options.theme = (int)viewer->look.theme % (SHEEN_THEMES - 1) + 1;
        sheen_viewer_look(viewer);
        return 1;
    default:
        return 0;
    }
}

/* A scene that can only be lit flat or gouraud goes on from gouraud to the unlit matcaps; after the last, the first. */
static int next_shading(const struct sheen_scene *scene)
{
    const int shading = (int)sheen_scene_shading(scene);

    if (sheen_scene_corners_alone(scene) && shading == SHEEN_GOURAUD)
        return SHEEN_MATCAP;
    return (shading + 1) % SHEEN_ALL_SHADINGS;
}

/* Keys that change what is drawn. 1 if the key is one of these. */
static int scene_key(struct sheen_viewer *viewer, int key)
{
    struct sheen_options *options = &viewer->options;

    switch (key) {
    case 's':
        options->shade = next_shading(&viewer->table.scene);
        return 1;
    case 'l':
        turn_lights(&options->lights);
        return 1;
    case 'd':
        options->undithered = viewer->table.scene.view.dither;
        return 1;
    case 'e':
        options->edges = ((int)sheen_scene_edging(&viewer->table.scene) + 1) % SHEEN_EDGINGS;
        return 1;
    case 'a':
        options->affine = !options->affine;
        return 1;
    case 'o':
        options->ortho = !options->ortho;
        return 1;
    case SHEEN_KEY_LEFT:
    case SHEEN_KEY_RIGHT:
        options->yaw += key == SHEEN_KEY_RIGHT ? TURN_DEG : -TURN_DEG;
        return 1;
    case SHEEN_KEY_UP:
    case SHEEN_KEY_DOWN:
        options->pitch += key == SHEEN_KEY_DOWN ? TURN_DEG : -TURN_DEG;
        return 1;
    default:
        return 0;
    }
}

/* A file that cannot be written only gives a message, no error. */
static int file_key(struct sheen_viewer *viewer, int key)
{
    struct sheen_problem problem;
    int error = key == 'w'    ? sheen_viewer_png(viewer, &problem)
                : viewer->gif ? sheen_viewer_gif_end(viewer, NULL, &problem)
                              : sheen_viewer_gif_begin(viewer, &problem);

    if (error)
        snprintf(viewer->message, sizeof viewer->message, "%s", problem.text);
    return SHEEN_OK;
}

static int step_key(struct sheen_viewer *viewer, int key, struct sheen_problem *problem)
{
    viewer->playing = 0;
    int error = key == 'n' ? sheen_viewer_next(viewer, problem) : sheen_viewer_band(viewer, problem);
    if (!error)
        sheen_viewer_record(viewer);
    return error;
}

int sheen_viewer_key(struct sheen_viewer *viewer, int key, struct sheen_problem *problem)
{
    viewer->message[0] = '\0';
    if (look_key(viewer, key))
        return SHEEN_OK;
    if (scene_key(viewer, key))
        return sheen_viewer_redraw(viewer, problem);
    switch (key) {
    case 'q':
    case SHEEN_KEY_ESCAPE:
        return 1;
    case ' ':
        viewer->playing = !viewer->playing;
        return SHEEN_OK;
    case 'n':
    case 'b':
        return step_key(viewer, key, problem);
    case 'p':
    case 'P':
        return change_panel(viewer, key == 'p' ? 1 : -1, problem);
    case 'r':
        return change_orientation(viewer, problem);
    case 'w':
    case 'g':
        return file_key(viewer, key);
    default:
        return SHEEN_OK;
    }
}
