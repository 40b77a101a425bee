/*
 * turntable.h - a mesh that turns on a simulated panel: what `render` writes and `view` shows.
 *
 *   scene -> panel driver -> bus -> simulated controller -> picture
 */
#ifndef SHEEN_TURNTABLE_H
#define SHEEN_TURNTABLE_H

#include "scene.h"
#include "sim_panel.h"

struct sheen_turntable {
    const struct sheen_options *options;
    struct sheen_scene scene; /* what is drawn */
    struct sheen_sim_choice choice;
    struct sheen_sim_panel *panel;
    uint16_t *values; /* the picture as the viewer sees it: 565 values or grey levels */
    uint8_t *rgb;     /* the same, 3 bytes per pixel */
    int warned;       /* 1: the warning that nothing is to be seen was printed */
};

/* The panel that the options ask for. 0, or SHEEN_ERR_ARGUMENT and *problem. */
int sheen_turntable_choose(struct sheen_sim_choice *choice, const struct sheen_options *options,
                           struct sheen_problem *problem);

/* The same, and checks that --band is within the picture's rows. */
int sheen_turntable_check(struct sheen_sim_choice *choice, const struct sheen_options *options,
                          struct sheen_problem *problem);

/*
 * Loads, allocates, initialises the panel. choice: as resolved from the options.
 * options is borrowed. 0, or a negative code and *problem; close in either case.
 */
int sheen_turntable_open(struct sheen_turntable *table, const struct sheen_options *options,
                         const struct sheen_sim_choice *choice, struct sheen_problem *problem);
void sheen_turntable_close(struct sheen_turntable *table);

/* Opens the panel alone, in a zeroed *table, as sheen_turntable_read() needs it. Returns as sheen_turntable_open(). */
int sheen_turntable_open_panel(struct sheen_turntable *table, const struct sheen_sim_choice *choice,
                               struct sheen_problem *problem);

/*
 * Draws frame `number` (yaw + number * yaw_step) and reads the picture off the glass. The first time that nothing is to
 * be seen, a warning on standard error says why; with the first frame, a line tells of a mesh that is not closed.
 */
int sheen_turntable_draw(struct sheen_turntable *table, int number, struct sheen_problem *problem);

/* Puts the core's error into *problem; of a capacity its name too, as the frame already had the most room possible. */
int sheen_turntable_problem(const struct sheen_turntable *table, int error, struct sheen_problem *problem);

/* Moves the meshes to another panel, just switched on. Returns as open does; on error only close may follow. */
int sheen_turntable_panel(struct sheen_turntable *table, const struct sheen_sim_choice *choice,
                          struct sheen_problem *problem);

/* The panel's full name. */
const char *sheen_turntable_panel_name(const struct sheen_turntable *table);

/* Returns the controller's complaint as an error, or reads the picture off the glass. No push may be under way. */
int sheen_turntable_read(struct sheen_turntable *table, struct sheen_problem *problem);

#endif
