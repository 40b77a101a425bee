/*
 * planned.h - frames that the costs of `sheen plan` are found from, and held to: made by planned_export.c of the file
 * `planned`, run on processors by planned.c.
 */
#ifndef BENCH_PLANNED_H
#define BENCH_PLANNED_H

#include "sheen.h"
#include "sheen_panel.h"

#define PLANNED_FRAMES 2 /* of each: the first sends everything, the second what changed */

struct planned {
    const char *name;
    const char *panel;
    uint8_t orientation, shading, light_count, two_sided;
    uint16_t draws;
    struct sheen_config config; /* but the target */
    struct sheen_view view;
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_pose pose[PLANNED_FRAMES];
    const struct sheen_mesh *const *meshes;
    const struct sheen_material *materials;
};

extern const struct planned planned[];
extern const unsigned planned_count;

#endif
