/*
 * board.h - opens what sheen-panel needs (bus, sending thread, panel, backlight) and closes it again, in order.
 */
#ifndef BOARD_H
#define BOARD_H

#include "options.h"
#include "sheen_linux_bus.h"
#include "sheen_panel.h"
#include "sheen_sender.h"

struct board {
    struct sheen_failure sending; /* the bus's messages; only the sending thread uses it while a write is under way */
    struct sheen_panel_record record; /* the module's record, which the panel borrows */
    struct sheen_linux_bus bus;
    struct sheen_sender sender;
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_pin backlight;
    int has_sender;
};

/* Returns 0, or a negative code and *why; then nothing is open. Nothing is sent to the panel yet. */
int board_open(struct board *board, const struct options *options, struct sheen_failure *why);

/* Releases everything. If dark, it first switches panel and backlight off. Returns the first error of that, or 0. */
int board_close(struct board *board, int dark, struct sheen_failure *why);

/*
 * Call this before each frame: it waits as long as --fps asks. If there is a TE line, the frame's first push then waits
 * for that. due_ns: when the next frame may begin; this function updates it, start with 0.
 * Returns 1: go on; 0: a signal has asked the program to stop.
 */
int board_pace(struct board *board, double fps, uint64_t *due_ns);

#endif
