/*
 * gauge.c - a dial: eleven marks and a needle, made of one mesh in many poses, and the value in digits.
 */
#include "example.h"
#include "meshes/cube.h"
#include "sheen_canvas.h"

#define MARKS 11
#define LOWEST (-120) /* the lowest mark, degrees clockwise from the top; the highest is at +120 */

static const struct sheen_material ivory = {
    .base = {230, 225, 205}, .ambient = SHEEN_Q16(.3), .diffuse = SHEEN_Q16(.7)};
static const struct sheen_material red = {.base = {220, 40, 30},
                                          .ambient = SHEEN_Q16(.3),
                                          .diffuse = SHEEN_Q16(.6),
                                          .specular = SHEEN_Q16(.5),
                                          .shine = &sheen_shine_32};
static const struct sheen_light lamp = {.to = {-3, 5, 6}};

struct figures {
    struct sheen_text text;
    char line[4];
};

static void over(void *ctx, const struct sheen_canvas *canvas)
{
    const struct figures *figures = ctx;

    sheen_canvas_text(canvas, canvas->pixel, &figures->text);
}

/* Poses the object, a small cube, at `distance` from the middle, `degrees` clockwise from the top. */
static int put_cube(struct sheen_object *object, sheen_q16_t size, sheen_q24_t distance, int32_t degrees)
{
    int error;

    sheen_pose_identity(&object->pose);
    error = sheen_pose_scale(&object->pose, size);
    if (!error)
        error = sheen_pose_translate(&object->pose, 0, distance, 0);
    if (!error)
        error = sheen_pose_rotate(&object->pose, 2, sheen_degrees(-degrees));
    return error;
}

static int pose_all(struct sheen_object *marks, struct sheen_object *needle, unsigned needles, int32_t degrees)
{
    int error = 0;

    for (int32_t i = 0; i < MARKS && !error; i++)
        error = put_cube(&marks[i], i % 5 ? SHEEN_Q16(.06) : SHEEN_Q16(.11), SHEEN_Q24(1), LOWEST + 24 * i);
    for (unsigned i = 0; i < needles && !error; i++) /* overlapping cubes, each smaller than the last */
        error = put_cube(&needle[i], SHEEN_Q16(.14) - (sheen_q16_t)i * SHEEN_Q16(.008),
                         (sheen_q24_t)i * SHEEN_Q24(.052), degrees);
    return error;
}

#define NEEDLE 16

static struct figures figures;
static struct sheen_view view = {.z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(6), .background = {14, 16, 20}};
static struct sheen_object objects[MARKS + NEEDLE];

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[64000 / 8];
    static const sheen_q24_t eye[3] = {0, SHEEN_Q24(-1.2), SHEEN_Q24(3.2)}, centre[3] = {0, 0, 0};
    static const int32_t up[3] = {0, 1, 0};
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target,
                                  .max_vertices = (uint16_t)((MARKS + NEEDLE) * cube.vertices),
                                  .max_triangles = (uint16_t)((MARKS + NEEDLE) * cube.triangles),
                                  .max_draws = MARKS + NEEDLE};
    int error = sheen_init(frame, arena, &size, &config);

    for (unsigned i = 0; i < MARKS + NEEDLE; i++)
        objects[i] = (struct sheen_object){.mesh = &cube,
                                           .material = i < MARKS ? &ivory : &red,
                                           .shader = i < MARKS ? &sheen_flat : &sheen_phong,
                                           .lights = &lamp,
                                           .light_count = 1};
    figures.text = (struct sheen_text){.line = figures.line,
                                       .x = (int16_t)(target->width / 2 - 22),
                                       .y = (int16_t)(target->height * 3 / 4),
                                       .scale = 4,
                                       .rgb = {230, 225, 205}};
    view.ctx = &figures;
    view.overlay = over;
    return error ? error : sheen_pose_look_at(&view.pose, eye, centre, up);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    const unsigned value = (70 + i) % 100;
    int error = pose_all(objects, objects + MARKS, NEEDLE, LOWEST + (int32_t)value * 240 / 100);

    figures.line[0] = (char)('0' + value / 10);
    figures.line[1] = (char)('0' + value % 10);
    if (!error)
        error = sheen_begin(frame, &view);
    for (unsigned k = 0; k < MARKS + NEEDLE && !error; k++)
        error = sheen_draw(frame, &objects[k]);
    if (!error)
        error = sheen_mark(frame, sheen_text_rect(&figures.text, NULL));
    return error ? error : sheen_end(frame);
}
