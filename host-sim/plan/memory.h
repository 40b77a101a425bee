/*
 * memory.h - RAM and flash that a mesh on a panel takes on a board.
 */
#ifndef SHEEN_PLAN_MEMORY_H
#define SHEEN_PLAN_MEMORY_H

#include "boards.h"
#include "scene.h"
#include "sheen_panel.h"

#define SHEEN_PLAN_STACK 2048u /* B: 1 KB of the core, as much for who calls it and for interrupts */

/* B on a processor of 32 bits. */
struct sheen_plan_ram {
    uint32_t arena;                        /* all of a frame's, sheen_arena_size() */
    uint32_t vertices, lists, bands, rest; /* of it */
    uint32_t all;                          /* with the stack, and the panel's state */
    uint32_t second_core;                  /* what it takes besides, two buffers each */
};

struct sheen_plan_flash {
    uint32_t core, panel, mesh, tables; /* tables: of powers, and a ramp */
    uint32_t textures;
    uint32_t all, small; /* -O2, as the costs; -Os */
};

/* Of a configuration, completed with sheen.h's defaults but the target; bits: of a pixel in the target's memory. */
void sheen_plan_ram(struct sheen_plan_ram *ram, const struct sheen_config *config, const struct sheen_target *target);

/*
 * Of a scene that has begun a frame. The core with what it names: shadings, fog, a pattern, a ramp, morphing, edges,
 * and where triangles are cut the clipper.
 */
void sheen_plan_flash(struct sheen_plan_flash *flash, enum sheen_plan_cpu cpu, const struct sheen_scene *scene,
                      int cuts, const struct sheen_panel_record *record);

#endif
