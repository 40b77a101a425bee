/*
 * planned.h - frames that the costs of `sheen plan` are found from, and held to: made by planned_export.c of the file
 * `planned`, run on processors by planned.c; and the bench's own (planned_bench.c), which both draw.
 */
#ifndef BENCH_PLANNED_H
#define BENCH_PLANNED_H

#include "scenes.h"
#include "sheen.h"
#include "sheen_panel.h"

#define PLANNED_FRAMES 2 /* of each: the first sends everything, the second what changed */

struct planned {
    const char *name;
    const char *panel;
    uint8_t orientation;
    uint16_t draws;
    struct sheen_config config; /* but the target */
    struct sheen_view view;
    struct sheen_pose pose[PLANNED_FRAMES]; /* of all objects */
    const struct sheen_object *objects;
};

extern const struct planned planned[];
extern const unsigned planned_count;

/* Frame i of the bench's scenes, ready for bench_begin, and what it is called: 0 past the last. */
int planned_bench(struct bench *bench, unsigned i, char name[40]);

#endif
