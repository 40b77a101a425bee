/*
 * input.c - a knob, or a finger on the glass, turns the model, which then turns on by itself and comes to rest.
 *
 * board_turned() returns an encoder's count since the last call, or the pixels that a finger has moved.
 */
#include "example.h"
#include "meshes/teapot.h"

static const struct sheen_material jade = {.base = {90, 180, 140},
                                           .ambient = SHEEN_Q16(.2),
                                           .diffuse = SHEEN_Q16(.65),
                                           .specular = SHEEN_Q16(.3),
                                           .shine = &sheen_shine_16};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};
static const struct sheen_view view = {
    .z_near = SHEEN_Q24(1.9), .z_far = SHEEN_Q24(4.1), .background = {235, 232, 225}};

static struct sheen_object object = {
    .mesh = &teapot, .material = &jade, .shader = &sheen_phong, .lights = &lamp, .light_count = 1, .two_sided = 1};

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[64000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target, .max_vertices = teapot.vertices, .max_triangles = teapot.triangles};

    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    static sheen_angle_t yaw = SHEEN_DEGREES(30);
    static int32_t speed; /* 1/16 degree per picture */

    (void)i;
    speed += board_turned() * 24;
    yaw += (sheen_angle_t)speed * SHEEN_DEGREES(1 / 16.);
    speed = speed * 7 / 8;
    sheen_pose_orbit(&object.pose, yaw, sheen_degrees(20), 0, SHEEN_Q24(3));
    return sheen_render(frame, &view, &object, 1);
}
