/*
 * your_mesh.c - your own model turns. `sheen bake model.stl -o mesh.h` writes what is included here; the arena is
 * asked for its size, so that any mesh will do.
 */
#include <stdlib.h>

#include "example.h"
#ifndef MESH
#include "meshes/teapot.h" /* yours */
#define MESH teapot
#endif

static const struct sheen_material clay = {.base = {190, 120, 90}, .ambient = SHEEN_Q16(.2), .diffuse = SHEEN_Q16(.8)};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};
static const struct sheen_view view = {
    .z_near = SHEEN_Q24(1.5), .z_far = SHEEN_Q24(4.5), .background = {230, 230, 220}};

int example(const struct sheen_target *target, unsigned frames)
{
    struct sheen_config config = {.target = target, .max_vertices = MESH.vertices, .max_triangles = MESH.triangles};
    size_t size = sheen_arena_size(&config);
    void *arena = malloc(size); /* aligned to 8, as malloc's is */
    struct sheen_frame *frame;
    struct sheen_object object = {.mesh = &MESH,
                                  .material = &clay,
                                  .shader = &sheen_gouraud,
                                  .lights = &lamp,
                                  .light_count = 1,
                                  .two_sided = 1}; /* one may see into it */
    int error = arena ? sheen_init(&frame, arena, &size, &config) : SHEEN_ERR_MEMORY;

    for (unsigned i = 0; i < frames && !error; i++) {
        sheen_pose_orbit(&object.pose, sheen_degrees(30 + 6 * (int32_t)i), sheen_degrees(20), 0, SHEEN_Q24(3));
        error = sheen_render(frame, &view, &object, 1);
    }
    if (!error)
        error = sheen_wait(frame);
    free(arena);
    return error;
}
