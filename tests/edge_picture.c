/*
 * edge_picture.c - draws a scene with its edges by the core.
 */
#include "edge_picture.h"

#include <string.h>

enum {
    CLIPPED = 4096
};

static int bands(struct sheen_frame *frame, const struct edge_drawing *drawing)
{
    unsigned count = sheen_band_count(frame), workers = drawing->workers > 1 ? (unsigned)drawing->workers : 1;
    int status = SHEEN_OK;

    for (unsigned i = 0; i < count && status == SHEEN_OK; i++)
        status = sheen_band(frame, i % workers, drawing->bottom_up ? count - 1 - i : i);
    return status == SHEEN_OK ? sheen_finish(frame) : status;
}

static int draw_frame(struct sheen_frame *frame, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                      const struct edge_drawing *drawing)
{
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_material material;
    struct core_tables tables;
    struct sheen_view view;
    struct sheen_fog fog;
    struct sheen_object object = {.mesh = mesh,
                                  .material = &material,
                                  .lights = lights,
                                  .light_count = (uint8_t)scene->light_count,
                                  .shader = sheen_shader_of((unsigned)scene->shading),
                                  .two_sided = scene->two_sided,
                                  .edges = drawing->edges};
    int status = core_material(&material, &tables, scene);

    memcpy(material.line, drawing->line, sizeof material.line);
    core_view(&view, scene);
    core_fog(&fog, scene);
    view.fog = scene->fog ? &fog : NULL;
    core_pose(&object.pose, scene);
    core_lights(lights, scene);
    if (status == SHEEN_OK && (status = sheen_begin(frame, &view)) == SHEEN_OK &&
        (status = sheen_draw(frame, &object)) == SHEEN_OK && (status = bands(frame, drawing)) == SHEEN_OK)
        status = sheen_wait(frame);
    return status;
}

static int draw(struct sheen_frame *frame, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                const struct edge_drawing *drawing)
{
    struct ref_scene before = *scene;
    int status = SHEEN_OK;

    before.translation[0] += 0.25;
    before.translation[1] -= 0.25;
    if (drawing->second)
        status = draw_frame(frame, &before, mesh, drawing);
    return status == SHEEN_OK ? draw_frame(frame, scene, mesh, drawing) : status;
}

int edge_picture(uint16_t *values, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                 const struct edge_drawing *drawing)
{
    struct memory_target target;
    struct core_frame f;

    if (memory_target_init(&target, scene->width, scene->height, drawing->pixel) != 0)
        return SHEEN_ERR_MEMORY;
    const struct sheen_config config = {.target = &target.target,
                                        .band_rows = (uint16_t)drawing->band_rows,
                                        .buffers = (uint8_t)drawing->buffers,
                                        .workers = (uint8_t)drawing->workers,
                                        .max_vertices = (uint16_t)(mesh->vertices + CLIPPED),
                                        .max_triangles = (uint16_t)(mesh->triangles + CLIPPED),
                                        .max_clipped = CLIPPED,
                                        .clipper = &sheen_clipper,
                                        .max_edges = (uint16_t)(drawing->edges ? 4 * mesh->triangles : 0),
                                        .smooth = drawing->edges == &sheen_edges_smooth};
    int status = core_frame_make(&f, &config);
    if (status == SHEEN_OK) {
        status = draw(f.frame, scene, mesh, drawing);
        core_frame_free(&f);
    }
    for (int i = 0; i < scene->width * scene->height; i++)
        values[i] = (uint16_t)memory_target_pixel(&target, i % scene->width, i / scene->width);
    if (status == SHEEN_OK && target.breaches > 0)
        status = SHEEN_ERR_STATE;
    memory_target_free(&target);
    return status;
}

void edge_channels(double out[3], const struct edge_drawing *drawing, unsigned value)
{
    static const double most[] = {0, 0, 1, 15, 255};

    if (drawing->pixel <= SHEEN_RGB565_LE) {
        out[0] = (value >> 11) / 31.0;
        out[1] = (value >> 5 & 63) / 63.0;
        out[2] = (value & 31) / 31.0;
        return;
    }
    for (int k = 0; k < 3; k++)
        out[k] = value / most[drawing->pixel];
}
