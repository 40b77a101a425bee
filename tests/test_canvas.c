/*
 * test_canvas.c - areas, gradients, images and text over and under a frame.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "memory_target.h"
#include "sheen_canvas.h"

#define WIDTH 48
#define HEIGHT 32

struct scene {
    enum sheen_pixel pixel;
    struct sheen_text text;
    struct sheen_gradient gradient;
    struct sheen_image image;
    struct sheen_rect area;
    uint8_t rgb[3];
};

static void draw_area(void *ctx, const struct sheen_canvas *canvas)
{
    const struct scene *s = ctx;

    assert_int_equal(canvas->pixel, s->pixel);
    sheen_canvas_fill(canvas, canvas->pixel, s->area, s->rgb);
}

static void draw_all(void *ctx, const struct sheen_canvas *canvas)
{
    const struct scene *s = ctx;

    sheen_canvas_gradient(canvas, s->pixel, &s->gradient);
    sheen_canvas_image(canvas, s->pixel, &s->image);
    sheen_canvas_text(canvas, s->pixel, &s->text);
}

/* A frame without an object; the memory stays. */
static void show(struct memory_target *t, const struct sheen_view *view, uint16_t rows)
{
    static uint64_t arena[4096];
    struct sheen_config config = {.target = &t->target, .band_rows = rows, .max_vertices = 1, .max_triangles = 1};
    struct sheen_frame *frame;
    size_t size = sizeof arena;

    assert_int_equal(sheen_init(&frame, arena, &size, &config), SHEEN_OK);
    assert_int_equal(sheen_render(frame, view, NULL, 0), SHEEN_OK);
    assert_int_equal(t->breaches, 0);
}

/* An area of a colour over everything is the background of that colour, on every target. */
static void test_fill_is_background(void **state)
{
    static const uint8_t colours[][3] = {{0, 0, 0}, {255, 255, 255}, {200, 160, 80}, {3, 127, 250}, {128, 128, 128}};

    (void)state;
    for (int pixel = 0; pixel <= SHEEN_GREY256; pixel++) {
        for (size_t c = 0; c < sizeof colours / sizeof colours[0]; c++) {
            struct scene scene = {.pixel = (enum sheen_pixel)pixel, .area = {-32768, -32768, 32767, 32767}};
            struct memory_target filled, cleared;
            struct sheen_view view = {.ctx = &scene, .underlay = draw_area}, plain = {.ctx = NULL};

            memcpy(scene.rgb, colours[c], 3);
            memcpy(plain.background, colours[c], 3);
            assert_int_equal(memory_target_init(&filled, WIDTH, HEIGHT, scene.pixel), 0);
            assert_int_equal(memory_target_init(&cleared, WIDTH, HEIGHT, scene.pixel), 0);
            show(&filled, &view, 16);
            show(&cleared, &plain, 16);
            assert_memory_equal(filled.memory, cleared.memory, filled.row_bytes * HEIGHT);
            memory_target_free(&filled);
            memory_target_free(&cleared);
        }
    }
}

static const uint16_t dots[2 * 3] = {1, 2, 3, 4, 5, 6};

static struct scene full_scene(enum sheen_pixel pixel)
{
    return (struct scene){
        .pixel = pixel,
        .text = {.line = "Ab:9 and more than fits", .x = -3, .y = 5, .scale = 2, .rgb = {255, 255, 255}},
        .gradient = {{2, 3, 40, 30}, {10, 20, 30}, {250, 128, 0}},
        .image = {.pixels = dots, .width = 3, .height = 2, .x = 46, .y = 15}};
}

/* Any height of the bands gives the same pixels. */
static void test_any_band(void **state)
{
    static const uint16_t rows[] = {1, 2, 5, 16, HEIGHT};
    static const enum sheen_pixel pixels[] = {SHEEN_RGB565_BE, SHEEN_GREY256, SHEEN_GREY2};

    (void)state;
    for (int p = 0; p < 3; p++) {
        struct scene scene = full_scene(pixels[p]);
        struct sheen_view view = {.ctx = &scene, .overlay = draw_all};
        struct memory_target first, other;

        assert_int_equal(memory_target_init(&first, WIDTH, HEIGHT, pixels[p]), 0);
        show(&first, &view, 3);
        for (int i = 0; i < 5; i++) {
            assert_int_equal(memory_target_init(&other, WIDTH, HEIGHT, pixels[p]), 0);
            show(&other, &view, rows[i]);
            assert_memory_equal(other.memory, first.memory, first.row_bytes * HEIGHT);
            memory_target_free(&other);
        }
        memory_target_free(&first);
    }
}

/* Glyph by glyph against what stands here. */
static void test_glyphs(void **state)
{
    static const char *const glyphs[7] = {".###..............", "#...#..##.......#.", "#...#..##......#..",
                                          "#####.........#...", "#...#..##....#....", "#...#..##...#.....",
                                          "#...#............."};
    struct scene scene = {.pixel = SHEEN_RGB565_LE, .text = {.line = "a:/", .x = 1, .y = 2, .rgb = {255, 255, 255}}};
    struct sheen_view view = {.ctx = &scene, .overlay = draw_all};
    struct memory_target t;

    (void)state;
    assert_int_equal(memory_target_init(&t, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    show(&t, &view, 16);
    for (int y = 0; y < 7; y++)
        for (int x = 0; x < 17; x++)
            assert_int_equal(memory_target_pixel(&t, 1 + x, 2 + y), glyphs[y][x] == '#' ? 0xFFFF : 0);
    memory_target_free(&t);
}

static void test_places(void **state)
{
    struct scene scene = full_scene(SHEEN_RGB565_LE);
    struct sheen_view view = {.ctx = &scene, .overlay = draw_all};
    struct memory_target t;
    struct sheen_rect r = sheen_text_rect(&scene.text, "ABC");

    (void)state;
    assert_int_equal(r.x0, -3);
    assert_int_equal(r.y0, 5);
    assert_int_equal(r.x1, -3 + 3 * 12);
    assert_int_equal(r.y1, 5 + 14);
    struct sheen_font close = sheen_font_5x7; /* a glyph reaches into the next */
    struct sheen_text text = scene.text;
    close.advance = 3;
    text.font = &close;
    assert_int_equal(sheen_text_rect(&text, "ABC").x1, -3 + 2 * (3 + 3 + 5));
    assert_int_equal(sheen_text_rect(&text, "").x1, -3);
    scene.text.x = 32000;
    assert_int_equal(sheen_text_rect(&scene.text, NULL).x1, 32000 + 23 * 12);
    scene.text.line = "";
    assert_int_equal(memory_target_init(&t, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    show(&t, &view, 7);
    /* The gradient's first and last row: 10, 20, 30 and 250, 128, 0 as 565; nothing beside it. */
    assert_int_equal(memory_target_pixel(&t, 2, 3), 1u << 11 | 5u << 5 | 4u);
    assert_int_equal(memory_target_pixel(&t, 39, 29), 30u << 11 | 32u << 5);
    assert_int_equal(memory_target_pixel(&t, 40, 29), 0);
    assert_int_equal(memory_target_pixel(&t, 39, 30), 0);
    assert_int_equal(memory_target_pixel(&t, 1, 3), 0);
    /* The image's columns that fit. */
    assert_int_equal(memory_target_pixel(&t, 46, 15), 1);
    assert_int_equal(memory_target_pixel(&t, 47, 15), 2);
    assert_int_equal(memory_target_pixel(&t, 46, 16), 4);
    assert_int_equal(memory_target_pixel(&t, 47, 16), 5);
    memory_target_free(&t);
}

/* Pixels of the key's value leave what is there; the others, and all where nothing is keyed, are put. */
static void test_keyed_image(void **state)
{
    static const uint8_t levels[2 * 3] = {1, 2, 3, 3, 2, 1};
    static const uint16_t key[] = {3, 3};

    (void)state;
    for (int wide = 0; wide < 2; wide++)
        for (int keyed = 0; keyed < 2; keyed++) {
            const void *pixels = wide ? (const void *)dots : (const void *)levels;
            struct scene scene = {
                .pixel = wide ? SHEEN_RGB565_LE : SHEEN_GREY256,
                .text = {.line = ""},
                .image = {.pixels = pixels, .width = 3, .height = 2, .x = -1, .y = 5, .key = key[wide]}};
            struct sheen_view view = {.ctx = &scene, .overlay = draw_all, .background = {255, 255, 255}};
            struct memory_target t;

            scene.image.keyed = (uint8_t)keyed;
            assert_int_equal(memory_target_init(&t, WIDTH, HEIGHT, scene.pixel), 0);
            show(&t, &view, 6); /* a row of it in either band */
            for (int y = 0; y < 2; y++)
                for (int x = 0; x < 2; x++) {
                    unsigned is = wide ? dots[3 * y + x + 1] : levels[3 * y + x + 1], white = wide ? 0xFFFF : 255;
                    assert_int_equal(memory_target_pixel(&t, x, 5 + y), keyed && is == key[wide] ? white : is);
                }
            memory_target_free(&t);
        }
}

int main(void)
{
    static const struct CMUnitTest tests[] = {cmocka_unit_test(test_fill_is_background),
                                              cmocka_unit_test(test_any_band), cmocka_unit_test(test_glyphs),
                                              cmocka_unit_test(test_places), cmocka_unit_test(test_keyed_image)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
