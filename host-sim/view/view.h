/*
 * view.h - a mesh that turns on a simulated glass, and what keys do to it; in a window or a terminal.
 *
 *   view.c          frames and bands          view_keys.c    what keys do
 *   view_status.c   the lines below           view_files.c   PNG and GIF
 *   view_window.c   SDL                       view_terminal.c, terminal.c   half blocks
 */
#ifndef SHEEN_VIEW_H
#define SHEEN_VIEW_H

#include "gif_file.h"
#include "turntable.h"
#include "view_glass.h"

struct sheen_viewer {
    struct sheen_options options; /* a copy, which the keys change */
    struct sheen_turntable table;
    struct sheen_glass_look look;
    unsigned room[2]; /* px that the glass may take up if no scale is given; 0: scale 1 */
    int number;       /* of the frame that is shown */
    int playing;
    int band;               /* the next band of a frame under way; -1: no frame is under way */
    int shown_band;         /* the last band that was sent by itself; -1: none */
    struct sheen_rect sent; /* the rectangle of shown_band that was sent, px; empty: nothing was */
    struct sheen_gif *gif;  /* the recording under way; NULL: none */
    unsigned gif_size[2];   /* px */
    int gif_frames;
    char message[sizeof(struct sheen_problem)]; /* what the last key did; "": nothing to tell */
};

/* Keys are their ASCII characters, and: */
enum sheen_key {
    SHEEN_KEY_ESCAPE = 27,
    SHEEN_KEY_LEFT = 256,
    SHEEN_KEY_RIGHT,
    SHEEN_KEY_UP,
    SHEEN_KEY_DOWN
};

/*
 * Loads the mesh, switches the panel on and draws the first frame. choice: as resolved from the options, which are
 * copied. *viewer MUST not be moved in memory; its room may be set afterwards, followed by sheen_viewer_look.
 * 0, or a negative code and *problem; close in either case.
 */
int sheen_viewer_open(struct sheen_viewer *viewer, const struct sheen_options *options,
                      const struct sheen_sim_choice *choice, struct sheen_problem *problem);

/* Closes the viewer; a recording still under way is written to its file. 0, or a negative code and *problem. */
int sheen_viewer_close(struct sheen_viewer *viewer, struct sheen_problem *problem);

/* Draw this frame again, with the options as they are now, and draw the next one. A frame under way is finished. */
int sheen_viewer_redraw(struct sheen_viewer *viewer, struct sheen_problem *problem);
int sheen_viewer_next(struct sheen_viewer *viewer, struct sheen_problem *problem);

/* Draws and sends one band of the next frame, or of the one under way. */
int sheen_viewer_band(struct sheen_viewer *viewer, struct sheen_problem *problem);

/* The rows of the last band that was sent by itself: first <= y < end. */
void sheen_viewer_rows(const struct sheen_viewer *viewer, int *first, int *end);

/* Switches to the panel and orientation in the options. The scale is chosen anew unless it was given. */
int sheen_viewer_panel(struct sheen_viewer *viewer, struct sheen_problem *problem);

/* Sets theme, scale and gap from the options, or where these do not say, from the panel and the room. */
void sheen_viewer_look(struct sheen_viewer *viewer);

/* Paints the glass as it looks: scale * width x scale * height values 0x00RRGGBB; stride in values. */
void sheen_viewer_paint(const struct sheen_viewer *viewer, uint32_t *out, unsigned stride);

/* Does what a key asks for. 1: end; 0: go on; a negative code and *problem: nothing can be shown any more. */
int sheen_viewer_key(struct sheen_viewer *viewer, int key, struct sheen_problem *problem);

/* ---- view_status.c: lines without newline, cut to size ---- */

/* Panel, frame or band, shading, size, orientation. */
void sheen_viewer_title(const struct sheen_viewer *viewer, char *text, size_t size);
/* Triangles, pixels, bytes on the bus, the highest frame rate that the panel's bus allows. */
void sheen_viewer_counts(const struct sheen_viewer *viewer, char *text, size_t size);

/* ---- view_files.c ---- */

/* What sheen_viewer_paint draws, as bytes r, g, b; free() it. NULL: not enough memory. size: px. */
uint8_t *sheen_viewer_picture(const struct sheen_viewer *viewer, unsigned size[2]);

/* Writes sheen-NNN.png, the first free number; the message names it. 0, or a negative code and *problem. */
int sheen_viewer_png(struct sheen_viewer *viewer, struct sheen_problem *problem);

/* A recording: begin; add the glass as it looks (a new size ends it); end, into path or (NULL) a new sheen-NNN.gif. */
int sheen_viewer_gif_begin(struct sheen_viewer *viewer, struct sheen_problem *problem);
int sheen_viewer_gif_add(struct sheen_viewer *viewer, struct sheen_problem *problem);
int sheen_viewer_gif_end(struct sheen_viewer *viewer, const char *path, struct sheen_problem *problem);

/* Adds the glass to the recording if there is one; an error becomes the message. */
void sheen_viewer_record(struct sheen_viewer *viewer);

/* ---- the window and the terminal: each runs until a key or options.view_frames ends it ---- */

/*
 * The px of the screen that a glass may take up; asks SDL. frames: how many are shown; 0: until a user, who needs to
 * see the window, ends it.
 */
int sheen_view_window_room(unsigned room[2], int frames, struct sheen_problem *problem);
int sheen_view_window(struct sheen_viewer *viewer, struct sheen_problem *problem);
int sheen_view_terminal(struct sheen_viewer *viewer, struct sheen_problem *problem);

#define SHEEN_VIEW_MS 50 /* per frame: 20 per second, as in the GIF */

#endif
