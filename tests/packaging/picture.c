/*
 * picture.c - a program in C11 that is C++17 too: draws a lit cube and prints a sum of what is sent; with PANEL it
 * draws through a panel driver.
 */
#include <stdio.h>

#include "sheen.h"
#ifdef PANEL
#include "sheen_panel.h"
#endif

#define ROWS 16
#define SIDE 240

static uint32_t sum = 1, sent;

static void add(const void *bytes, size_t count)
{
    const uint8_t *byte = (const uint8_t *)bytes;

    for (sent += (uint32_t)count; count; count--)
        sum = (sum ^ *byte++) * 16777619u;
}

#ifdef PANEL
static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    (void)ctx;
    add(command, commands);
    add(data, count);
    return SHEEN_OK;
}

static int pass(void *ctx, uint32_t us)
{
    (void)ctx;
    (void)us;
    return SHEEN_OK;
}

static int open_target(struct sheen_target *target)
{
    static struct sheen_bus bus;
    static struct sheen_panel panel;
    int error;

    bus.send = send;
    bus.delay = pass;
    error = sheen_panel_open(&panel, sheen_panel_find("st7789-240x240"), &bus, 0);
    return error ? error : sheen_panel_target(&panel, target);
}
#else
static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    (void)ctx;
    add(pixels, (size_t)(rect.x1 - rect.x0) * (size_t)(rect.y1 - rect.y0) * 2);
    return SHEEN_OK;
}

static int open_target(struct sheen_target *target)
{
    target->push = push;
    target->width = target->height = SIDE;
    return SHEEN_OK;
}
#endif

#define C 18918 /* 32767 / sqrt(3) */
static const int16_t corners[] = {-C, -C, -C, C, -C, -C, -C, C, -C, C, C, -C, -C, -C, C, C, -C, C, -C, C, C, C, C, C};
static const uint8_t triangles[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                    1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};

int main(void)
{
    static uint64_t arena[SHEEN_ARENA_BYTES(SIDE, SIDE, 2, ROWS, 1, 8, 8, 12, 1, 0, 12) / 8];
    static struct sheen_target target;
    static struct sheen_mesh cube;
    static struct sheen_material gold;
    static struct sheen_light lamp;
    static struct sheen_config config;
    static struct sheen_view view;
    static struct sheen_object object;
    struct sheen_frame *frame;
    size_t size = sizeof arena;
    int error = open_target(&target);

    cube.positions = cube.normals = corners;
    cube.indices = triangles;
    cube.index_bytes = 1;
    cube.vertices = 8;
    cube.triangles = 12;
    cube.scale = SHEEN_Q24(1);
    gold.base[0] = 200;
    gold.base[1] = 160;
    gold.diffuse = SHEEN_Q16(.7);
    gold.specular = SHEEN_Q16(.3);
    gold.shine = &sheen_shine_32;
    lamp.to[0] = -5;
    lamp.to[1] = 7;
    lamp.to[2] = 5;
    object.mesh = &cube;
    object.material = &gold;
    object.lights = &lamp;
    object.light_count = 1;
    config.target = &target;
    config.band_rows = ROWS;
    config.max_vertices = 8;
    config.max_triangles = 12;
    config.max_draws = 1;
    config.max_carried = 12;
    if (!error)
        error = sheen_init(&frame, arena, &size, &config);

    const struct sheen_shader *const shaders[] = {&sheen_flat, &sheen_gouraud, &sheen_phong, &sheen_slerp};
    for (int i = 0; i < 4 && !error; i++) {
        object.shader = shaders[i];
        sheen_pose_orbit(&object.pose, sheen_degrees(30 * i), SHEEN_DEGREES(20), 0, SHEEN_Q24(3));
        error = sheen_render(frame, &view, &object, 1);
    }
    printf("sheen %s: %s, %u bytes, sum %08x\n", SHEEN_VERSION, sheen_strerror(error), (unsigned)sent, (unsigned)sum);
    return error != 0;
}
