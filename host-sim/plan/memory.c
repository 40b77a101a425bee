/*
 * memory.c - RAM and flash that a mesh on a panel takes on a board.
 */
#include <stdint.h>

/* The boards' pointers have 32 bits, whatever those of this machine have: sheen_arena.h goes by this. */
#undef UINTPTR_MAX
#define UINTPTR_MAX 0xffffffffu
#include "sheen_arena.h"

#include "memory.h"

#include "bake_text.h"
#include "ramps.h"

#define PANEL_STATE 128u /* struct sheen_panel, the bus and the target */

static uint32_t or_else(uint32_t value, uint32_t fallback)
{
    return value != 0 ? value : fallback;
}

void sheen_plan_ram(struct sheen_plan_ram *ram, const struct sheen_config *config, const struct sheen_target *target)
{
    const uint32_t align = or_else(target->align_y, 1), pixel = target->pixel > SHEEN_RGB565_LE ? 1 : 2;
    const uint32_t used = or_else(config->max_used, config->max_vertices), buffers = or_else(config->buffers, 1);
    uint32_t rows = or_else(config->band_rows, 16);

    rows = rows > target->height ? target->height : rows;
    rows = (rows + align - 1) / align * align;
    ram->arena = (uint32_t)SHEEN_ARENA_BYTES(target->width, target->height, pixel, rows, buffers, config->max_vertices,
                                             used, config->max_triangles, or_else(config->max_draws, 4),
                                             config->max_clipped, or_else(config->max_carried, 80));
    ram->vertices = config->max_vertices * 2u + used * SHEEN_BYTES_VERTEX;
    ram->lists = config->max_triangles * (uint32_t)SHEEN_BYTES_ENTRY;
    ram->bands = target->width * rows * (2 + buffers * pixel);
    ram->rest = ram->arena - ram->vertices - ram->lists - ram->bands;
    ram->all = ram->arena + SHEEN_PLAN_STACK + PANEL_STATE;
}

static enum sheen_plan_driver driver_kind(const struct sheen_panel_record *record)
{
    static const struct sheen_panel_driver *const drivers[SHEEN_PLAN_DRIVERS] = {
        &sheen_driver_dcs,     &sheen_driver_ssd1351, &sheen_driver_grey,
        &sheen_driver_ssd1322, &sheen_driver_ssd1306, &sheen_driver_sh1106};
    unsigned kind = SHEEN_PLAN_DCS;

    while (record && kind + 1 < SHEEN_PLAN_DRIVERS && drivers[kind] != record->driver)
        kind++;
    return (enum sheen_plan_driver)kind;
}

/* The polygons' normals go with every mesh: they pass over what faces away. */
void sheen_plan_flash(struct sheen_plan_flash *flash, enum sheen_plan_cpu cpu, const struct sheen_scene *scene,
                      const struct sheen_panel_record *record)
{
    const int is_matcap = sheen_scene_shading(scene) >= SHEEN_MATCAP;
    const enum sheen_shading shade = is_matcap ? SHEEN_GOURAUD : sheen_scene_shading(scene);

    flash->core = sheen_plan_core_flash[cpu][0][shade];
    flash->panel = record ? sheen_plan_panel_flash[cpu][0][driver_kind(record)] : 0;
    flash->mesh = flash->textures = 0;
    for (size_t i = 0; i < scene->count; i++)
        flash->mesh += (uint32_t)sheen_bake_bytes(&scene->meshes[i], 1, 0);
    if (is_matcap)
        flash->textures = (uint32_t)sheen_texels_bytes(&scene->matcap);
    for (size_t i = 0; i < scene->texel_count && !is_matcap; i++)
        flash->textures += (uint32_t)sheen_texels_bytes(&scene->texels[i]);
    flash->tables = (scene->options->specular > 0 ? (uint32_t)sizeof scene->shine : 0) +
                    (scene->options->ramp.kind != SHEEN_RAMP_LAMBERT ? SHEEN_RAMP_BYTES : 0);
    flash->all = flash->core + flash->panel + flash->mesh + flash->tables + flash->textures;
    flash->small = flash->all - flash->core - flash->panel + sheen_plan_core_flash[cpu][1][shade] +
                   (record ? sheen_plan_panel_flash[cpu][1][driver_kind(record)] : 0);
}
