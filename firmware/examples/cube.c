/*
 * cube.c - a turning cube, Phong shaded: the smallest example.
 */
#include "meshes/cube.h"
#include "example.h"

static const struct sheen_material coral = {.base = {255, 127, 80},
                                            .ambient = SHEEN_Q16(.2),
                                            .diffuse = SHEEN_Q16(.7),
                                            .specular = SHEEN_Q16(.3),
                                            .shine = &sheen_shine_32};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};
static const struct sheen_view view = {.z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(6), .background = {16, 24, 48}};

int example(const struct sheen_target *target, unsigned frames)
{
    static uint64_t arena[48000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {
        .target = target, .buffers = 2, .max_vertices = cube.vertices, .max_triangles = cube.triangles};
    struct sheen_object object = {
        .mesh = &cube, .material = &coral, .shader = &sheen_phong, .lights = &lamp, .light_count = 1};
    struct sheen_frame *frame;
    int error = sheen_init(&frame, arena, &size, &config);

    for (unsigned i = 0; i < frames && !error; i++) {
        sheen_pose_orbit(&object.pose, sheen_degrees(30 + 6 * (int32_t)i), sheen_degrees(25), 0, SHEEN_Q24(3.2));
        error = sheen_render(frame, &view, &object, 1);
    }
    return error ? error : sheen_wait(frame);
}
