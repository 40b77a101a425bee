/*
 * overlay.c - text and 2D: a sky under the triangles, a line of text and a bar over them.
 *
 * 2D areas that change must be marked (sheen_mark), so that they are sent: here the text and the bar.
 */
#include "example.h"
#include "meshes/cube.h"
#include "sheen_canvas.h"

struct hud {
    struct sheen_gradient sky;
    struct sheen_text text;
    struct sheen_rect bar;
    char line[12];
};

static void under(void *ctx, const struct sheen_canvas *canvas)
{
    const struct hud *hud = ctx;

    sheen_canvas_gradient(canvas, canvas->pixel, &hud->sky);
}

static void over(void *ctx, const struct sheen_canvas *canvas)
{
    static const uint8_t green[3] = {80, 220, 120};
    const struct hud *hud = ctx;

    sheen_canvas_text(canvas, canvas->pixel, &hud->text);
    sheen_canvas_fill(canvas, canvas->pixel, hud->bar, green);
}

/* "CHARGE 42%" */
static void set_charge(struct hud *hud, unsigned percent, int16_t width, int16_t height)
{
    static const char word[] = "CHARGE ";
    char *to = hud->line;

    for (const char *from = word; *from;)
        *to++ = *from++;
    *to++ = (char)('0' + percent / 10 % 10);
    *to++ = (char)('0' + percent % 10);
    *to++ = '%';
    *to = '\0';
    hud->text = (struct sheen_text){.line = hud->line, .x = 8, .y = 8, .scale = 3, .rgb = {255, 255, 255}};
    hud->bar = (struct sheen_rect){8, (int16_t)(height - 16), (int16_t)(8 + (width - 16) * (int)percent / 100),
                                   (int16_t)(height - 8)};
}

static const struct sheen_material steel = {.base = {150, 160, 175},
                                            .ambient = SHEEN_Q16(.25),
                                            .diffuse = SHEEN_Q16(.6),
                                            .specular = SHEEN_Q16(.4),
                                            .shine = &sheen_shine_16};
static const struct sheen_light lamp = {.to = {-5, 7, 5}};

static struct hud hud;
static struct sheen_object object = {
    .mesh = &cube, .material = &steel, .shader = &sheen_phong, .lights = &lamp, .light_count = 1};

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[40000 / 8];
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target, .max_vertices = cube.vertices, .max_triangles = cube.triangles};
    struct sheen_rect all = {0, 0, (int16_t)target->width, (int16_t)target->height};

    hud = (struct hud){.sky = {all, {20, 40, 110}, {150, 100, 120}}};
    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    const struct sheen_view view = {
        .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(6), .ctx = &hud, .underlay = under, .overlay = over};
    const int16_t w = hud.sky.rect.x1, h = hud.sky.rect.y1;
    int error;

    set_charge(&hud, (42 + i) % 100, w, h);
    sheen_pose_orbit(&object.pose, sheen_degrees(30 + 3 * (int32_t)(i % 120)), sheen_degrees(25), 0, SHEEN_Q24(3.4));
    error = sheen_begin(frame, &view);
    if (!error)
        error = sheen_draw(frame, &object);
    if (!error)
        error = sheen_mark(frame, sheen_text_rect(&hud.text, NULL));
    if (!error)
        error = sheen_mark(frame, (struct sheen_rect){8, (int16_t)(h - 16), (int16_t)(w - 8), (int16_t)(h - 8)});
    return error ? error : sheen_end(frame);
}
