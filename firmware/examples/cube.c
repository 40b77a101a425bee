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

static struct sheen_object object = {
    .mesh = &cube, .material = &coral, .shader = &sheen_phong, .lights = &lamp, .light_count = 1};

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[48000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {
        .target = target, .buffers = 2, .max_vertices = cube.vertices, .max_triangles = cube.triangles};

    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    sheen_pose_orbit(&object.pose, sheen_degrees(30 + 3 * (int32_t)(i % 120)), sheen_degrees(25), 0, SHEEN_Q24(3.2));
    return sheen_render(frame, &view, &object, 1);
}
