/*
 * memory.c - RAM and flash that a mesh on a panel needs on a board.
 */
#include <stdint.h>

/* The boards' pointers have 32 bits, whatever this machine's have; sheen_arena.h takes their size from this macro. */
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
    const uint32_t carried = or_else(
        config->max_carried, config->max_triangles < SHEEN_PLAN_CARRIED ? config->max_triangles : SHEEN_PLAN_CARRIED);
    uint32_t rows = or_else(config->band_rows, 16);

    rows = rows > target->height ? target->height : rows;
    rows = (rows + align - 1) / align * align;
    ram->arena =
        (uint32_t)SHEEN_ARENA_BYTES(target->width, target->height, pixel, rows, buffers, config->max_vertices, used,
                                    config->max_triangles, or_else(config->max_draws, 4), config->max_clipped, carried);
    if (config->max_edges > 0)
        ram->arena += (uint32_t)SHEEN_EDGE_BYTES(target->width, pixel, rows, buffers, config->max_edges);
    if (config->smooth)
        ram->arena += (uint32_t)SHEEN_SMOOTH_BYTES(target->width, rows);
    ram->vertices = config->max_vertices * 2u + used * SHEEN_BYTES_VERTEX;
    ram->lists = config->max_triangles * (uint32_t)SHEEN_BYTES_ENTRY + config->max_edges * (uint32_t)SHEEN_BYTES_EDGE;
    ram->bands = target->width * rows * (2 + buffers * pixel);
    ram->rest = ram->arena - ram->vertices - ram->lists - ram->bands;
    ram->all = ram->arena + SHEEN_PLAN_STACK + PANEL_STATE;
    ram->second_core = (2 - buffers) * target->width * rows * pixel + SHEEN_PLAN_STACK +
                       (uint32_t)SHEEN_WORKER_BYTES(target->width, pixel, rows, 2, config->max_triangles, carried);
    if (config->max_edges > 0)
        ram->second_core += (uint32_t)SHEEN_EDGE_WORKER_BYTES(target->width, pixel, rows, 2);
    if (config->smooth)
        ram->second_core += (uint32_t)SHEEN_SMOOTH_BYTES(target->width, rows);
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

static unsigned shader_index(const struct sheen_shader *shader)
{
    static const struct sheen_shader *const shaders[SHEEN_PLAN_SHADERS] = {
        &sheen_flat,
        &sheen_gouraud,
        &sheen_phong,
        &sheen_slerp,
        &sheen_flat_colored,
        &sheen_gouraud_colored,
        &sheen_textured_flat,
        &sheen_textured,
        &sheen_matcap,
        &sheen_matcap_vertex,
        &sheen_textured_flat_colored,
        &sheen_textured_colored,
        &sheen_matcap_colored,
        &sheen_matcap_vertex_colored,
        &sheen_phong_colored,
        &sheen_slerp_colored,
    };
    unsigned i = 0;

    while (i + 1 < SHEEN_PLAN_SHADERS && shaders[i] != shader)
        i++;
    return i;
}

/* What a scene names: one bit per shader, above them one bit per extra. cuts: 1 if triangles are clipped. */
static uint32_t named_of(const struct sheen_scene *scene, int cuts)
{
    uint32_t shaders = 0, extras = (uint32_t)(cuts != 0) << SHEEN_PLAN_EXTRA_CLIPPER;

    for (size_t i = 0; i < scene->count; i++) {
        struct sheen_object o;
        sheen_scene_object(scene, 0, i, &o);
        shaders |= 1u << shader_index(o.shader);
        extras |= (uint32_t)(o.transparency > 0) << SHEEN_PLAN_EXTRA_STIPPLE;
        extras |= (uint32_t)(o.material->ramp != NULL) << SHEEN_PLAN_EXTRA_RAMP;
        extras |= (uint32_t)(o.morph != NULL) << SHEEN_PLAN_EXTRA_MORPH;
        extras |= (uint32_t)(o.edges == &sheen_edges_smooth) << SHEEN_PLAN_EXTRA_SMOOTH;
        extras |= (uint32_t)(o.edges == &sheen_edges_outline) << SHEEN_PLAN_EXTRA_OUTLINE;
        extras |= (uint32_t)(o.edges == &sheen_edges_wire) << SHEEN_PLAN_EXTRA_WIRE;
    }
    extras |= (uint32_t)(scene->view.fog != NULL) << SHEEN_PLAN_EXTRA_FOG;
    return shaders | extras << SHEEN_PLAN_SHADERS;
}

/* The core's B of flash: flat, and for each shader named what it has more than flat. small: 1 for -Os. */
static uint32_t core_flash(enum sheen_plan_cpu cpu, unsigned small, uint32_t named)
{
    const uint32_t *shader = sheen_plan_core_flash[cpu][small], *extra = sheen_plan_extra_flash[cpu][small];
    uint32_t sum = shader[0];

    for (unsigned i = 0; i < SHEEN_PLAN_SHADERS; i++)
        sum += (named >> i & 1u) * (shader[i] - shader[0]);
    for (unsigned i = 0; i < SHEEN_PLAN_EXTRAS; i++)
        sum += (named >> SHEEN_PLAN_SHADERS >> i & 1u) * extra[i];
    return sum;
}

/* Every mesh counts with its polygons' normals, because they are used to pass over polygons that face away. */
void sheen_plan_flash(struct sheen_plan_flash *flash, enum sheen_plan_cpu cpu, const struct sheen_scene *scene,
                      int cuts, const struct sheen_panel_record *record)
{
    const struct sheen_options *options = scene->options;
    const int is_matcap = options->shade >= SHEEN_MATCAP, edges = sheen_scene_edging(scene) != SHEEN_NO_EDGES;
    const uint32_t named = named_of(scene, cuts);

    flash->core = core_flash(cpu, 0, named);
    flash->panel = record ? sheen_plan_panel_flash[cpu][0][driver_kind(record)] : 0;
    flash->mesh = flash->textures = 0;
    for (size_t i = 0; i < scene->count; i++)
        flash->mesh += (uint32_t)sheen_bake_bytes(&scene->meshes[i], 1, edges);
    if (is_matcap)
        flash->textures = (uint32_t)sheen_texels_bytes(&scene->matcap);
    for (size_t i = 0; i < scene->texel_count && !is_matcap; i++)
        flash->textures += (uint32_t)sheen_texels_bytes(&scene->texels[i]);
    flash->tables = (options->specular > 0 ? (uint32_t)sizeof scene->shine : 0) +
                    (options->ramp.kind != SHEEN_RAMP_LAMBERT ? SHEEN_RAMP_BYTES : 0);
    flash->all = flash->core + flash->panel + flash->mesh + flash->tables + flash->textures;
    flash->small = flash->all - flash->core - flash->panel + core_flash(cpu, 1, named) +
                   (record ? sheen_plan_panel_flash[cpu][1][driver_kind(record)] : 0);
}
