/*
 * demo.c - the scene: the default picture of `sheen render`, but with --edges none and --crease 180, turning by 6
 * degrees per frame.
 */
#include "demo.h"

#include <string.h>

#include "meshes/teapot.h"

#define DISTANCE 3.0 /* in units; the teapot's farthest vertex is 1 unit from its origin */

/* A light's vector points towards the light and may have any length. */
#define LIGHT(x, y, z, i)                                                                                              \
    {                                                                                                                  \
        .to = {SHEEN_Q30(x), SHEEN_Q30(y), SHEEN_Q30(z)}, .intensity = SHEEN_Q16(i)                                    \
    }
static const struct {
    struct sheen_light light[2];
    uint8_t count;
} lightings[] = {
    {{LIGHT(-0.4, 0.6, 0.8, 1.0)}, 1},                            /* from the left, above */
    {{LIGHT(0.8, 0.3, 0.5, 1.0)}, 1},                             /* from the right */
    {{LIGHT(-0.7, 0.3, 0.4, 0.7), LIGHT(0.8, 0.2, 0.1, 0.5)}, 2}, /* both */
};

static const struct {
    const char *name;
    const struct sheen_shader *shader;
} shadings[] = {{"phong", &sheen_phong}, {"slerp", &sheen_slerp}, {"flat", &sheen_flat}, {"gouraud", &sheen_gouraud}};

enum {
    LIGHTINGS = sizeof lightings / sizeof lightings[0],
    SHADINGS = sizeof shadings / sizeof shadings[0],
    TURN = 60, /* frames */
    /* A turn takes at most 508, 345 and 59 of these, whatever the panel. */
    MAX_FRONT = 512,
    MAX_USED = 380,
    MAX_CARRIED = 60
};

const char *demo_shading_name(const struct demo *demo)
{
    return shadings[demo->shading].name;
}

/* ---- the line of text ---- */

static char *append(char *to, const char *from)
{
    while (*from)
        *to++ = *from++;
    *to = '\0';
    return to;
}

/* value: 0..9999 */
static char *append_number(char *to, unsigned value)
{
    unsigned power = 1;

    while (value / power >= 10)
        power *= 10;
    for (; power > 0; power /= 10)
        *to++ = (char)('0' + value / power % 10);
    *to = '\0';
    return to;
}

static void put_text(void *ctx, const struct sheen_canvas *canvas)
{
    const struct demo *demo = ctx;

    sheen_canvas_text(canvas, canvas->pixel, &demo->text);
}

static void set_line(struct demo *demo, unsigned tenths)
{
    char *to = append(append(demo->line, demo_shading_name(demo)), " ");

    if (demo->held) {
        append_number(to, demo->number);
        return;
    }
    to = append_number(to, tenths / 10 < 999 ? tenths / 10 : 999);
    append_number(append(to, "."), tenths % 10);
}

/* ---- the scene ---- */

static void set_scene(struct demo *demo)
{
    const struct sheen_target *target = demo->target;
    int colour = sheen_pixel_bits((enum sheen_pixel)target->pixel) == 16;

    demo->material = (struct sheen_material){.base = {0xD8, 0xA0, 0x48},
                                             .highlight = {255, 255, 255},
                                             .ambient = SHEEN_Q16(0.2),
                                             .diffuse = SHEEN_Q16(0.8),
                                             .specular = SHEEN_Q16(0.35),
                                             .shine = &sheen_shine_32};
    if (!colour) /* white, so that grey panels use their full brightness */
        memset(demo->material.base, 255, sizeof demo->material.base);
    demo->view = (struct sheen_view){.fov = SHEEN_DEGREES(40),
                                     .z_near = SHEEN_Q24(DISTANCE - 1.05),
                                     .z_far = SHEEN_Q24(DISTANCE + 1.05),
                                     .dither = target->pixel != SHEEN_GREY256,
                                     .background = {0x10, 0x10, 0x18},
                                     .ctx = demo,
                                     .overlay = put_text};
    demo->text = (struct sheen_text){
        .line = demo->line, .x = 2, .y = 1, .scale = target->width >= 200 ? 2 : 1, .rgb = {255, 255, 255}};
    demo->draw = (struct sheen_object){.mesh = &teapot, .material = &demo->material, .shader = shadings[0].shader};
}

int demo_open(struct demo *demo, const struct sheen_target *target, void *arena, size_t *size, unsigned buffers,
              const struct demo_crew *crew)
{
    struct sheen_config config = {.target = target,
                                  .buffers = (uint8_t)buffers,
                                  .max_vertices = teapot.vertices,
                                  .max_used = MAX_USED,
                                  .max_triangles = MAX_FRONT,
                                  .max_draws = 1,
                                  .max_carried = MAX_CARRIED};

    if (crew != NULL) {
        config.workers = 2;
        config.lock = crew->lock;
        config.unlock = crew->unlock;
    }
    memset(demo, 0, sizeof *demo);
    demo->target = target;
    demo->crew = crew;
    set_scene(demo);
    int error = sheen_init(&demo->frame, arena, size, &config);
    if (error == SHEEN_OK)
        *size = sheen_arena_size(&config);
    return error;
}

void demo_key(struct demo *demo, int key)
{
    switch (key) {
    case 'h':
        demo->held = !demo->held;
        return;
    case 'n':
        break;
    case 's':
        demo->shading = (uint8_t)((demo->shading + 1u) % SHADINGS);
        demo->draw.shader = shadings[demo->shading].shader;
        break;
    case 'l':
        demo->light = (uint8_t)((demo->light + 1u) % LIGHTINGS);
        break;
    case '0':
        demo->number = 0;
        break;
    default:
        return;
    }
    demo->step = demo->held;
}

int demo_due(const struct demo *demo)
{
    return !demo->held || demo->step;
}

static void draw_other_share(void *frame)
{
    (void)sheen_bands(frame, 1); /* sheen_finish() returns its error too */
}

static int end_frame(struct demo *demo)
{
    if (demo->crew == NULL)
        return sheen_end(demo->frame);
    demo->crew->start(draw_other_share, demo->frame);
    (void)sheen_bands(demo->frame, 0);
    demo->crew->join();
    return sheen_finish(demo->frame);
}

int demo_frame(struct demo *demo, unsigned tenths)
{
    struct sheen_object *draw = &demo->draw;
    struct sheen_rect rect = sheen_text_rect(&demo->text, "GOURAUD 999.9  ");

    draw->lights = lightings[demo->light].light;
    draw->light_count = lightings[demo->light].count;
    sheen_pose_orbit(&draw->pose, SHEEN_DEGREES(30) + demo->number * DEMO_YAW_STEP, SHEEN_DEGREES(20), 0,
                     SHEEN_Q24(DISTANCE));
    set_line(demo, tenths);

    int error = sheen_begin(demo->frame, &demo->view);
    if (error == SHEEN_OK)
        error = sheen_draw(demo->frame, draw);
    if (error == SHEEN_OK)
        error = sheen_mark(demo->frame, rect);
    if (error == SHEEN_OK)
        error = end_frame(demo);
    if (error == SHEEN_OK && demo->held)
        error = sheen_wait(demo->frame);
    if (error == SHEEN_OK) {
        demo->step = 0;
        demo->number = (uint16_t)((demo->number + 1u) % TURN);
    }
    return error;
}
