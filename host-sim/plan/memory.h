/*
 * memory.h - RAM and flash that a mesh on a panel needs on a board.
 */
#ifndef SHEEN_PLAN_MEMORY_H
#define SHEEN_PLAN_MEMORY_H

#include "boards.h"
#include "scene.h"
#include "sheen_panel.h"

#define SHEEN_PLAN_STACK 2048u /* B: 1 KB for the core, as much for its caller and for interrupts */
#define SHEEN_PLAN_CARRIED 80u /* set-ups carried by default, at most: sheen.h */

/* In B on a 32-bit processor. */
struct sheen_plan_ram {
    uint32_t arena;                        /* a frame's, sheen_arena_size() */
    uint32_t vertices, lists, bands, rest; /* parts of the arena */
    uint32_t all;                          /* the arena, the stack and the panel's state */
    uint32_t second_core;                  /* what a second core needs besides, with two buffers for each core */
};

struct sheen_plan_flash {
    uint32_t core, panel, mesh, tables; /* tables: the power table and a ramp */
    uint32_t textures;
    uint32_t all, small; /* everything at -O2, as the costs are; everything at -Os */
};

/* The RAM of a configuration (fields of 0 stand for sheen.h's defaults) on `target`; config->target is not read. */
void sheen_plan_ram(struct sheen_plan_ram *ram, const struct sheen_config *config, const struct sheen_target *target);

/*
 * The flash of a scene that has begun a frame: the core with what the scene names (shadings, fog, a pattern, a ramp,
 * morphing, edges), with the clipper if triangles are cut; panel, meshes, tables and textures.
 */
void sheen_plan_flash(struct sheen_plan_flash *flash, enum sheen_plan_cpu cpu, const struct sheen_scene *scene,
                      int cuts, const struct sheen_panel_record *record);

#endif
