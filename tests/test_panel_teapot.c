/*
 * test_panel_teapot.c - the whole path: the core draws a teapot on every panel in every orientation.
 *
 * What the glass shows must equal the same frame in plain memory of the same size and pixel format. There are two
 * buffers, so that bands are drawn while others are being sent.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../host-sim/command/shadings.h"
#include "memory_target.h"
#include "quantise.h"
#include "test_panel_canvas.h"

static struct sheen_quantised teapot;
static struct sheen_material material = {.base = {255, 220, 180},
                                         .highlight = {255, 255, 255},
                                         .ambient = SHEEN_Q16(0.1),
                                         .diffuse = SHEEN_Q16(0.8),
                                         .specular = SHEEN_Q16(0.3),
                                         .shine = &sheen_shine_32};

static int load(void **state)
{
    const struct sheen_host_options options = {0};
    struct sheen_host_mesh mesh;
    struct sheen_problem problem;

    (void)state;
    if (sheen_host_mesh_load(&mesh, "builtin:teapot", &options, &problem) < 0)
        return -1;
    int error = sheen_quantise(&teapot, &mesh, SHEEN_ALL_PARTS);
    sheen_host_mesh_free(&mesh);
    return error;
}

static int release(void **state)
{
    (void)state;
    sheen_quantised_free(&teapot);
    return 0;
}

/* What the core needs to draw on a target. */
struct scene {
    struct sheen_frame *frame;
    void *arena;
    uint8_t dither;
};

static void scene_open(struct scene *scene, const struct sheen_target *target)
{
    const struct sheen_config config = {
        .target = target, .buffers = 2, .max_vertices = teapot.mesh.vertices, .max_triangles = teapot.mesh.triangles};
    size_t size = sheen_arena_size(&config);

    scene->arena = malloc(size);
    scene->dither = sheen_pixel_bits((enum sheen_pixel)target->pixel) < 8;
    assert_non_null(scene->arena);
    assert_int_equal(sheen_init(&scene->frame, scene->arena, &size, &config), 0);
}

/* Draws the teapot at turn n and waits for its last pixel. Returns the first error, which ends the frame. */
static int scene_draw(struct scene *scene, unsigned n)
{
    const struct sheen_light light = {.to = {SHEEN_Q30(-0.5), SHEEN_Q30(0.7), SHEEN_Q30(0.5)},
                                      .intensity = SHEEN_Q16(1)};
    const struct sheen_view view = {.fov = SHEEN_DEGREES(40),
                                    .z_near = SHEEN_Q24(1.95),
                                    .z_far = SHEEN_Q24(4.05),
                                    .dither = scene->dither,
                                    .background = {0, 0, 32}};
    struct sheen_object what = {
        .mesh = &teapot.mesh, .material = &material, .lights = &light, .light_count = 1, .shader = &sheen_phong};
    int error;

    sheen_pose_orbit(&what.pose, SHEEN_DEGREES(30) + n * SHEEN_DEGREES(6), SHEEN_DEGREES(20), 0, SHEEN_Q24(3));
    assert_int_equal(sheen_begin(scene->frame, &view), 0);
    assert_int_equal(sheen_draw(scene->frame, &what), 0);
    error = sheen_end(scene->frame);
    return error < 0 ? error : sheen_wait(scene->frame);
}

/* Two frames, the second of which sends only what changed. */
static void draw(const struct sheen_target *target)
{
    struct scene scene;

    scene_open(&scene, target);
    assert_int_equal(scene_draw(&scene, 0), 0);
    assert_int_equal(scene_draw(&scene, 1), 0);
    free(scene.arena);
}

/* Draws the frame to plain memory, as values; at least a fiftieth of it must not be background. */
static void draw_ideal(const struct sheen_target *like, uint16_t *values)
{
    struct memory_target memory;
    unsigned lit = 0;

    assert_int_equal(memory_target_init(&memory, like->width, like->height, (enum sheen_pixel)like->pixel), 0);
    memory.target.align_x = like->align_x;
    memory.target.align_y = like->align_y;
    draw(&memory.target);
    for (int y = 0; y < like->height; y++) {
        for (int x = 0; x < like->width; x++) {
            uint16_t value = (uint16_t)memory_target_pixel(&memory, x, y);

            values[y * like->width + x] = value;
            lit += value != values[0];
        }
    }
    assert_int_equal(memory.breaches, 0);
    if (lit * 50 <= (unsigned)like->width * like->height)
        fail_msg("only %u of %u x %u pixels (format %u) are not background", lit, like->width, like->height,
                 like->pixel);
    memory_target_free(&memory);
}

static void draw_on(const char *name, uint16_t *ideal[2])
{
    for (unsigned k = 0; k < 8; k++) {
        struct canvas canvas;
        size_t bytes;

        canvas_open(&canvas, name, (int)k, 0, 0);
        bytes = (size_t)canvas.target->width * canvas.target->height * sizeof *canvas.ideal;
        if (k < 2) /* for each of the two sizes once; the other orientations have one of these sizes */
            draw_ideal(canvas.target, ideal[k]);
        memcpy(canvas.ideal, ideal[k & 1], bytes);
        draw(canvas.target);
        if (canvas_differences(&canvas))
            fail_msg("%s, orientation %u: %u pixels differ", name, k, canvas_differences(&canvas));
        canvas_quiet(&canvas);
        canvas_close(&canvas);
    }
}

static void every_panel_and_orientation(void **state)
{
    static uint16_t upright[640 * 480], turned[640 * 480];
    uint16_t *ideal[2] = {upright, turned};
    size_t i;

    (void)state;
    for (i = 0; sheen_panel_at(i); i++)
        draw_on(sheen_panel_at(i)->name, ideal);
    assert_int_equal(i, 33);
}

/* Two frames with a fault at operation n: the core returns the error, and its next frame is whole. */
static void fail_at(const char *name, uint16_t *ideal, enum sheen_sim_fault fault, uint64_t n)
{
    struct canvas canvas;
    struct scene scene;
    int error;

    canvas_open(&canvas, name, -1, 0, 0);
    memcpy(canvas.ideal, ideal, (size_t)canvas.target->width * canvas.target->height * sizeof *ideal);
    scene_open(&scene, canvas.target);
    sheen_sim_bus_fault(sheen_sim_panel_bus(canvas.panel), fault, n);
    error = scene_draw(&scene, 0);
    if (error == 0)
        error = scene_draw(&scene, 1);
    assert_int_equal(error, fault == SHEEN_FAULT_TIMEOUT ? SHEEN_ERR_TIMEOUT : SHEEN_ERR_BUS);
    assert_int_equal(scene_draw(&scene, 1), 0);
    if (canvas_differences(&canvas))
        fail_msg("%s, %s at operation %u: the next frame is wrong", name, sheen_sim_fault_name(fault), (unsigned)n + 1);
    canvas_quiet(&canvas);
    free(scene.arena);
    canvas_close(&canvas);
}

static void errors_pass_through_the_core(void **state)
{
    static const char *const panels[] = {"st7735-80x160", "ssd1306-72x40"};
    static const enum sheen_sim_fault faults[] = {SHEEN_FAULT_SHORT, SHEEN_FAULT_TIMEOUT, SHEEN_FAULT_BROWN_OUT};
    static uint16_t ideal[160 * 80];

    (void)state;
    for (size_t p = 0; p < sizeof panels / sizeof panels[0]; p++) {
        struct canvas canvas;

        canvas_open(&canvas, panels[p], -1, 0, 0);
        draw_ideal(canvas.target, ideal);
        draw(canvas.target);
        uint64_t operations = sheen_sim_panel_bus(canvas.panel)->operations;
        canvas_close(&canvas);
        assert_true(operations > 60);
        for (size_t f = 0; f < sizeof faults / sizeof faults[0]; f++)
            for (uint64_t n = 0; n < operations; n++)
                fail_at(panels[p], ideal, faults[f], n);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_panel_and_orientation),
                                       cmocka_unit_test(errors_pass_through_the_core)};

    return cmocka_run_group_tests_name("panel_teapot", tests, load, release);
}
