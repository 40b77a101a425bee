/*
 * board.h - what sheen-panel opens: bus, sending thread, panel, backlight; and closes again, in order.
 */
#ifndef BOARD_H
#define BOARD_H

#include "options.h"
#include "sheen_linux_bus.h"
#include "sheen_panel.h"
#include "sheen_sender.h"

struct board {
    struct sheen_failure sending;     /* of the bus: the sending thread's while a write is under way */
    struct sheen_panel_record record; /* of the module, which the panel borrows */
    struct sheen_linux_bus bus;
    struct sheen_sender sender;
    struct sheen_panel panel;
    struct sheen_target target;
    struct sheen_pin backlight;
    int has_sender;
};

/* 0, or a negative code and *why; then nothing is open. The panel has not been spoken to yet. */
int board_open(struct board *board, const struct options *options, struct sheen_failure *why);

/* Gives everything back; before that, if dark, panel and backlight go off. The first error of these, if any. */
int board_close(struct board *board, int dark, struct sheen_failure *why);

/*
 * Frame by frame: waits for what --fps asks; the frame's first push will wait for the TE line, if there is one.
 * due_ns: when the next frame may begin, kept by this function, 0 at first.
 * 1: go on; 0: the program was told to stop.
 */
int board_pace(struct board *board, double fps, uint64_t *due_ns);

#endif
