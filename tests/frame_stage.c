/*
 * frame_stage.c - a few objects on a stage.
 */
#include "frame_stage.h"

#include <string.h>

#include "shapes.h"

static int make_mesh(struct core_mesh *mesh, enum stage_mesh which)
{
    static const struct ref_mesh_options options = {.fit = true, .crease = -1};
    struct ref_mesh reference;
    struct shape shape;
    int status = which == STAGE_BALL    ? shape_sphere(&shape, 12, 16)
                 : which == STAGE_TORUS ? shape_torus(&shape, 0.7, 0.3, 16, 10)
                                        : shape_cube(&shape);

    if (status == 0)
        status = ref_mesh_build(&reference, &shape.polygons, &options);
    shape_free(&shape);
    if (status != 0)
        return SHEEN_ERR_MEMORY;
    status = core_mesh_make(mesh, &reference);
    ref_mesh_free(&reference);
    return status == 0 ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

int stage_make(struct stage *stage)
{
    static const uint8_t base[3][3] = {{200, 160, 80}, {60, 200, 120}, {230, 60, 60}};
    static const uint8_t shininess[3] = {8, 32, 128};

    memset(stage, 0, sizeof *stage);
    stage->light[0] = (struct sheen_light){.to = {SHEEN_Q30(-0.5), SHEEN_Q30(0.7), SHEEN_Q30(0.5)}, .intensity = 65536};
    for (int i = 0; i < 3; i++) {
        stage->material[i] = (struct sheen_material){.highlight = {255, 255, 255},
                                                     .ambient = SHEEN_Q16(0.1),
                                                     .diffuse = SHEEN_Q16(0.6),
                                                     .specular = SHEEN_Q16(0.3),
                                                     .shine = &stage->shine[i]};
        memcpy(stage->material[i].base, base[i], sizeof base[i]);
        int status = sheen_shine_make(&stage->shine[i], shininess[i]);
        if (status < 0)
            return status;
    }
    for (int i = 0; i < STAGE_MESHES; i++) {
        int status = make_mesh(&stage->mesh[i], (enum stage_mesh)i);
        if (status < 0) {
            stage_free(stage);
            return status;
        }
    }
    return SHEEN_OK;
}

void stage_free(struct stage *stage)
{
    for (int i = 0; i < STAGE_MESHES; i++)
        core_mesh_free(&stage->mesh[i]);
}

void stage_draw(const struct stage *stage, const struct actor *actor, struct sheen_object *draw)
{
    *draw = (struct sheen_object){.mesh = &stage->mesh[actor->mesh].mesh,
                                  .material = &stage->material[actor->material],
                                  .lights = stage->light,
                                  .light_count = 1,
                                  .shader = sheen_shader_of((unsigned)actor->shading)};
    sheen_pose_orbit(&draw->pose, SHEEN_DEGREES(actor->yaw), SHEEN_DEGREES(actor->pitch), 0, 0);
    draw->pose.scale = SHEEN_Q16(actor->size);
    draw->pose.translation[0] = SHEEN_Q24(actor->x);
    draw->pose.translation[1] = SHEEN_Q24(actor->y);
    draw->pose.translation[2] = SHEEN_Q24(-actor->depth);
}

void stage_view(struct sheen_view *view)
{
    *view = (struct sheen_view){
        .fov = SHEEN_DEGREES(50), .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(12), .background = {0, 0, 0x20}};
}

int stage_frame(struct sheen_frame *frame, const struct sheen_view *view, const struct stage *stage,
                const struct actor *actors, int count)
{
    int status = sheen_begin(frame, view);

    for (int i = 0; i < count && status == SHEEN_OK; i++) {
        struct sheen_object draw;
        stage_draw(stage, &actors[i], &draw);
        status = sheen_draw(frame, &draw);
    }
    if (status == SHEEN_OK)
        status = sheen_end(frame);
    return status == SHEEN_OK ? sheen_wait(frame) : status;
}

void stage_config(struct sheen_config *config, const struct memory_target *target, int actors)
{
    *config = (struct sheen_config){.target = &target->target,
                                    .max_vertices = (uint16_t)(200 * actors),
                                    .max_triangles = (uint16_t)(400 * actors),
                                    .max_draws = (uint16_t)actors,
                                    .clipper = &sheen_clipper,
                                    .quads = &sheen_quads};
}

uint32_t stage_random(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

double stage_uniform(uint32_t *state, double low, double high)
{
    return low + (high - low) * (stage_random(state) >> 8) / 16777216.0;
}
