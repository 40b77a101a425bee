/*
 * scene.c - several objects in a world, and an eye that flies around them.
 */
#include "example.h"
#include "meshes/cube.h"
#include "meshes/teapot.h"

#define MATTE(r, g, b)                                                                                                 \
    {                                                                                                                  \
        .base = {r, g, b}, .ambient = SHEEN_Q16(.25), .diffuse = SHEEN_Q16(.7)                                         \
    }
static const struct sheen_material red = MATTE(210, 60, 50), green = MATTE(90, 160, 80), blue = MATTE(70, 110, 200);
static const struct sheen_light sun = {.to = {2, 5, 3}};

static void place(struct sheen_object *object, sheen_q24_t x, sheen_q24_t z, sheen_q16_t size)
{
    sheen_pose_identity(&object->pose);
    sheen_pose_scale(&object->pose, size);
    sheen_pose_translate(&object->pose, x, 0, z);
}

static struct sheen_object objects[] = {
    {.mesh = &teapot, .material = &blue, .shader = &sheen_gouraud, .lights = &sun, .light_count = 1},
    {.mesh = &cube, .material = &red, .shader = &sheen_flat, .lights = &sun, .light_count = 1},
    {.mesh = &cube, .material = &green, .shader = &sheen_flat, .lights = &sun, .light_count = 1}};

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[72000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target,
                                  .max_vertices = teapot_vertices + 2 * cube_vertices,
                                  .max_triangles = teapot_triangles + 2 * cube_triangles,
                                  .max_clipped = 64,
                                  .clipper = &sheen_clipper};

    place(&objects[0], 0, 0, SHEEN_Q16(1));
    place(&objects[1], SHEEN_Q24(-1.6), SHEEN_Q24(.6), SHEEN_Q16(.5));
    place(&objects[2], SHEEN_Q24(1.5), SHEEN_Q24(-.8), SHEEN_Q16(.6));
    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    static const sheen_q24_t centre[3] = {0, 0, 0};
    static const int32_t up[3] = {0, 1, 0};
    struct sheen_view view = {
        .fov = SHEEN_DEGREES(52), .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(12), .background = {150, 190, 230}};
    sheen_angle_t at = sheen_degrees(20 + 3 * (int32_t)(i % 120));
    sheen_q24_t eye[3] = {sheen_sin(at) / 64 * 5, SHEEN_Q24(2),
                          sheen_cos(at) / 64 * 5}; /* sines from Q1.30 to Q7.24, times radius 5 */
    int error = sheen_pose_look_at(&view.pose, eye, centre, up);

    return error ? error : sheen_render(frame, &view, objects, 3);
}
