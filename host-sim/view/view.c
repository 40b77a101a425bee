/*
 * view.c - draws frames and bands of a mesh that turns on a simulated glass.
 */
#include "view.h"

#include <string.h>

/* An overlay: the core calls it for each rectangle that it sends. */
static void note_sent(void *ctx, const struct sheen_canvas *canvas)
{
    struct sheen_viewer *viewer = ctx;

    viewer->sent = canvas->rect;
}

/* The theme of the glass that the panel is sold with. */
static enum sheen_theme own_theme(const struct sheen_sim_choice *choice)
{
    if (!choice->record)
        return SHEEN_THEME_PLAIN;
    /* The controllers of OLEDs are Solomon Systech's SSD13xx, SSD03xx and Sino Wealth's SH1106. */
    const char *name = choice->record->name;
    return strncmp(name, "ssd", 3) == 0 || strncmp(name, "sh1", 3) == 0 ? SHEEN_THEME_OLED : SHEEN_THEME_LCD;
}

void sheen_viewer_look(struct sheen_viewer *viewer)
{
    const struct sheen_options *options = &viewer->options;
    const struct sheen_sim_choice *choice = &viewer->table.choice;
    struct sheen_glass_look *look = &viewer->look;

    look->theme = options->theme == SHEEN_THEME_AUTO ? own_theme(choice) : (enum sheen_theme)options->theme;
    look->scale = (unsigned)options->scale;
    if (!look->scale) {
        unsigned across = viewer->room[0] / choice->width, down = viewer->room[1] / choice->height;
        look->scale = across < down ? across : down;
        look->scale = look->scale < 1 ? 1 : look->scale > 8 ? 8 : look->scale;
    }
    look->gap = options->gap >= 0 ? (unsigned)options->gap : look->scale >= 4;
    if (look->gap >= look->scale)
        look->gap = look->scale - 1;
}

int sheen_viewer_open(struct sheen_viewer *viewer, const struct sheen_options *options,
                      const struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    memset(viewer, 0, sizeof *viewer);
    viewer->options = *options;
    viewer->playing = 1;
    viewer->band = viewer->shown_band = -1;
    int error = sheen_turntable_open(&viewer->table, &viewer->options, choice, problem);
    if (error)
        return error;
    viewer->table.scene.view.ctx = viewer;
    viewer->table.scene.view.overlay = note_sent;
    sheen_viewer_look(viewer);
    return sheen_viewer_redraw(viewer, problem);
}

int sheen_viewer_close(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    int error = viewer->gif ? sheen_viewer_gif_end(viewer, NULL, problem) : SHEEN_OK;

    sheen_turntable_close(&viewer->table);
    return error;
}

/* ---- a frame ---- */

/* Sends the next band of the frame under way and waits until it is on the glass. The last band finishes the frame. */
static int send_band(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    struct sheen_frame *frame = viewer->table.scene.frame;

    viewer->sent = (struct sheen_rect){0, 0, 0, 0};
    viewer->shown_band = viewer->band;
    int error = sheen_band(frame, 0, (unsigned)viewer->band);
    if (!error)
        error = sheen_wait(frame);
    if (!error && ++viewer->band == (int)sheen_band_count(frame)) {
        viewer->band = -1;
        error = sheen_finish(frame);
    }
    return error ? sheen_turntable_problem(&viewer->table, error, problem) : SHEEN_OK;
}

static int finish(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    int under_way = viewer->band >= 0, error = SHEEN_OK;

    while (!error && viewer->band >= 0)
        error = send_band(viewer, problem);
    viewer->shown_band = -1;
    return error || !under_way ? error : sheen_turntable_read(&viewer->table, problem);
}

int sheen_viewer_redraw(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    int error = finish(viewer, problem);

    if (error)
        return error;
    sheen_scene_look(&viewer->table.scene);
    return sheen_turntable_draw(&viewer->table, viewer->number, problem);
}

/* A frame under way is finished: it is the next one. */
int sheen_viewer_next(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    if (viewer->band >= 0)
        return finish(viewer, problem);
    viewer->number++;
    return sheen_viewer_redraw(viewer, problem);
}

int sheen_viewer_band(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    if (viewer->band < 0) {
        sheen_sim_bus_counters_reset(sheen_sim_panel_bus(viewer->table.panel));
        error = sheen_scene_begin(&viewer->table.scene, ++viewer->number);
        viewer->band = error ? -1 : 0;
    }
    if (error)
        return sheen_turntable_problem(&viewer->table, error, problem);
    error = send_band(viewer, problem);
    return error ? error : sheen_turntable_read(&viewer->table, problem);
}

/* The height of bands is computed as the core chooses it (struct sheen_config). */
void sheen_viewer_rows(const struct sheen_viewer *viewer, int *first, int *end)
{
    const struct sheen_target *target = viewer->table.scene.target;
    int height = target->height, align = target->align_y ? target->align_y : 1;
    int rows = viewer->options.band ? viewer->options.band : 16;

    rows = (rows + align - 1) / align * align;
    *first = viewer->shown_band * rows;
    *end = *first + rows < height ? *first + rows : height;
}

int sheen_viewer_panel(struct sheen_viewer *viewer, struct sheen_problem *problem)
{
    struct sheen_options *options = &viewer->options;
    struct sheen_sim_choice choice;
    int error = sheen_turntable_choose(&choice, options, problem);

    if (!error)
        error = finish(viewer, problem);
    if (error)
        return error;
    if (options->band > choice.height)
        options->band = choice.height;
    error = sheen_turntable_panel(&viewer->table, &choice, problem);
    if (error)
        return error;
    sheen_viewer_look(viewer);
    return sheen_viewer_redraw(viewer, problem);
}

/* ---- how it looks ---- */

static int has_pixel(const void *panel, unsigned x, unsigned y)
{
    return sheen_sim_panel_has(panel, x, y);
}

void sheen_viewer_paint(const struct sheen_viewer *viewer, uint32_t *out, unsigned stride)
{
    const struct sheen_turntable *table = &viewer->table;
    struct sheen_glass_picture picture = {.rgb = table->rgb,
                                          .width = table->choice.width,
                                          .height = table->choice.height,
                                          .has = has_pixel,
                                          .panel = table->panel};

    sheen_glass_draw(&picture, &viewer->look, out, stride);
}
