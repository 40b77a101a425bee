/*
 * planned.h - frames from which the costs of `sheen plan` are found and against which they are checked: those that
 * planned_export.c makes from the file `planned`, and the bench's own (planned_bench.c). planned.c runs both on
 * processors.
 */
#ifndef BENCH_PLANNED_H
#define BENCH_PLANNED_H

#include "scenes.h"
#include "sheen.h"
#include "sheen_panel.h"

#define PLANNED_FRAMES 2 /* per scene: the first frame sends everything, the second what changed */

struct planned {
    const char *name;
    const char *panel;
    uint8_t orientation;
    uint16_t draws;
    struct sheen_config config; /* except the target */
    struct sheen_view view;
    struct sheen_pose pose[PLANNED_FRAMES]; /* of all objects */
    const struct sheen_object *objects;
};

extern const struct planned planned[];
extern const unsigned planned_count;

/* Sets *bench up as frame i of the bench's scenes, for bench_begin(), and writes its name. 0 if there is no frame i. */
int planned_bench(struct bench *bench, unsigned i, char name[40]);

#endif
