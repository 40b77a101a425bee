/*
 * your_mesh.c - your own model turns. `sheen bake model.stl -o mesh.h` writes the header to include here. The program
 * asks for the size of the arena, so that it works with any mesh.
 */
#include <stdlib.h>

#include "example.h"
#ifndef MESH
#include "meshes/teapot.h" /* replace this by your header, and teapot by its name */
#define MESH teapot
#endif

static const struct sheen_material clay = {.base = {190, 120, 90}, .ambient = SHEEN_Q16(.2), .diffuse = SHEEN_Q16(.8)};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};
static const struct sheen_view view = {
    .z_near = SHEEN_Q24(1.5), .z_far = SHEEN_Q24(4.5), .background = {230, 230, 220}};

static struct sheen_object object = {.mesh = &MESH,
                                     .material = &clay,
                                     .shader = &sheen_gouraud,
                                     .lights = &lamp,
                                     .light_count = 1,
                                     .two_sided = 1}; /* in case one can see into it */

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    struct sheen_config config = {.target = target, .max_vertices = MESH.vertices, .max_triangles = MESH.triangles};
    size_t size = sheen_arena_size(&config);
    void *arena = malloc(size); /* an arena must be aligned to 8, and malloc does that; keep it as long as the frame */

    return arena ? sheen_init(frame, arena, &size, &config) : SHEEN_ERR_MEMORY;
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    sheen_pose_orbit(&object.pose, sheen_degrees(30 + 3 * (int32_t)(i % 120)), sheen_degrees(20), 0, SHEEN_Q24(3));
    return sheen_render(frame, &view, &object, 1);
}
