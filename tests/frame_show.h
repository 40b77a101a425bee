/*
 * frame_show.h - a stage on which objects move, leave and come back, with a user's own 2D.
 */
#ifndef FRAME_SHOW_H
#define FRAME_SHOW_H

#include "frame_stage.h"

#define SHOW_WIDTH 160 /* px, of the target */
#define SHOW_HEIGHT 120
#define SHOW_ACTORS 4

/* A user's own 2D: a pattern under and a marker over the triangles, in the target's byte order. */
struct show_painter {
    enum sheen_pixel pixel;
    int marker_x, marker_y; /* px, 9x9 */
};

/* How a show is drawn and sent. */
struct show_settings {
    enum sheen_pixel pixel;
    int band_rows, buffers, align_x, align_y;
    bool delayed, underlay, overlay, failures;
};

/* What a frame shows; it changes a little from frame to frame. */
struct show {
    struct actor actors[SHOW_ACTORS];
    bool on[SHOW_ACTORS];
    struct sheen_view view;
    struct show_painter painter;
    struct sheen_rect marks[2]; /* where the marker was and is */
    bool viewport_changed, background_changed;
};

void show_enter(struct actor *actor, uint32_t *seed);

/* Make the next frame: some actors move, leave or come; now and then viewport or background change. */
void show_change(struct show *show, const struct show_settings *settings, uint32_t *seed);

/* Begin, draw the actors that are on, mark where the marker was and is, end. 0 or the first negative code. */
int show_play(struct sheen_frame *frame, const struct stage *stage, const struct show *show);

/* Callbacks of the view; ctx is a struct show_painter. */
void show_underlay(void *ctx, const struct sheen_canvas *canvas);
void show_overlay(void *ctx, const struct sheen_canvas *canvas);

#endif
