/*
 * two_cores.c - two workers share the bands of a frame, one on this core, one on the other.
 *
 * The board provides functions that start work on the other core, and a lock (example.h): on a Pico with multicore_fifo
 * and a mutex, on an ESP32 with a task pinned to core 1, elsewhere with a thread.
 */
#include "example.h"
#include "meshes/teapot.h"

/* An error ends the frame for both workers; sheen_finish() returns it. */
static void draw_other_share(void *frame)
{
    (void)sheen_bands(frame, 1);
}

static const struct sheen_material gold = {.base = {200, 160, 80},
                                           .ambient = SHEEN_Q16(.15),
                                           .diffuse = SHEEN_Q16(.6),
                                           .specular = SHEEN_Q16(.4),
                                           .shine = &sheen_shine_32};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};
static const struct sheen_view view = {.z_near = SHEEN_Q24(1.9), .z_far = SHEEN_Q24(4.1), .background = {20, 20, 28}};

static struct sheen_object object = {
    .mesh = &teapot, .material = &gold, .shader = &sheen_phong, .lights = &lamp, .light_count = 1, .two_sided = 1};

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[104000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target,
                                  .workers = 2,
                                  .max_vertices = teapot.vertices,
                                  .max_triangles = teapot.triangles,
                                  .lock = board_lock,
                                  .unlock = board_unlock};

    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    int error = sheen_begin(frame, &view);

    sheen_pose_orbit(&object.pose, sheen_degrees(30 + 3 * (int32_t)(i % 120)), sheen_degrees(20), 0, SHEEN_Q24(3));
    if (!error)
        error = sheen_draw(frame, &object);
    if (error)
        return error;
    board_start(draw_other_share, frame);
    (void)sheen_bands(frame, 0);
    while (!board_ended())
        ;
    return sheen_finish(frame);
}
