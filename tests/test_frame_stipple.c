/*
 * test_frame_stipple.c - stippled draws, and fog. Pixels that a stippled draw leaves in are those of the opaque draw;
 * the others keep their colour and depth. That holds whatever the bands and workers.
 */
#include <stdio.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 152
#define HEIGHT 120

static unsigned picture[4][HEIGHT][WIDTH];

/* The Bayer matrix, B2n = [[4 B, 4 B + 2], [4 B + 3, 4 B + 1]] from B1 = [0]. */
static int bayer(int x, int y)
{
    static const int quarter[2][2] = {{0, 2}, {3, 1}};
    int b = 0;

    for (int bit = 0; bit < 3; bit++)
        b = 4 * b + quarter[y >> bit & 1][x >> bit & 1];
    return b;
}

/* Large and small objects, reaching out of the picture, behind and in front of each other. */
static const struct actor cast[] = {{STAGE_TORUS, 0, SHEEN_FLAT, 0.2, 0.1, 3, 1.1, 40, 50},
                                    {STAGE_CUBE, 1, SHEEN_FLAT, -0.4, -0.3, 2.6, 1, 25, 35},
                                    {STAGE_BALL, 2, SHEEN_FLAT, 0.5, 0.4, 1.9, 0.9, 10, 20}};

static const struct sheen_fog fog = {SHEEN_Q24(2), SHEEN_Q24(4), {180, 190, 200}, &sheen_fog_mixer};

static const struct sheen_fog line_fog = {SHEEN_Q24(2), SHEEN_Q24(4), {180, 190, 200}, &sheen_line_fog_mixer};

#define LINES 2 /* fog on lines only */

struct case_of {
    enum sheen_pixel pixel;
    enum sheen_shading shading;
    unsigned rows, workers, transparency, phase;
    int dither, affine, fog;
};

/* Draws the actors whose bits are set, the first one with the case's transparency. */
static void draw(const struct case_of *c, unsigned actors, unsigned to[HEIGHT][WIDTH])
{
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, c->pixel), 0);
    stage_config(&config, &target, 3);
    config.band_rows = (uint16_t)c->rows;
    config.workers = (uint8_t)c->workers;
    config.max_shades = 3; /* so that having a table does not depend on the number of draws */
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    view.dither = (uint8_t)c->dither;
    view.affine = (uint8_t)c->affine;
    view.fog = c->fog == LINES ? &line_fog : c->fog ? &fog : NULL;
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    for (unsigned i = 0; i < 3; i++) {
        struct sheen_object object;
        struct actor actor = cast[i];
        if ((actors >> i & 1u) == 0)
            continue;
        actor.shading = c->shading;
        stage_draw(&stage, &actor, &object);
        object.two_sided = 1;
        object.stipple = &sheen_stipple;
        object.transparency = (uint8_t)(i == 0 ? c->transparency : 0);
        object.phase = (uint8_t)c->phase;
        assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
    }
    for (unsigned band = 0; band < sheen_band_count(f.frame); band++)
        assert_int_equal(sheen_band(f.frame, band % c->workers, band), SHEEN_OK);
    assert_int_equal(sheen_finish(f.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(f.frame), SHEEN_OK);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            to[y][x] = memory_target_pixel(&target, x, y);
    assert_int_equal(target.breaches, 0);
    core_frame_free(&f);
    memory_target_free(&target);
}

static int is_drawn(const struct case_of *c, int x, int y)
{
    return bayer((x + (int)c->phase) & 7, y & 7) < 64 - (int)c->transparency;
}

/* Pixels of [1], with the first actor stippled, must be those of [0], with it opaque, or of [3], without it. */
static void check(const struct case_of *c)
{
    struct case_of whole = *c;
    long drawn = 0;

    whole.transparency = 0;
    for (unsigned actors = 1; actors <= 7; actors += 6) {
        draw(&whole, actors, picture[0]);
        draw(&whole, actors - 1, picture[3]);
        draw(c, actors, picture[1]);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const unsigned expected = picture[is_drawn(c, x, y) ? 0 : 3][y][x];
                if (picture[1][y][x] != expected)
                    fail_msg("%d shading, %u of 64 left out, phase %u, %u rows, pixel (%d, %d): %x in place of %x",
                             (int)c->shading, c->transparency, c->phase, c->rows, x, y, picture[1][y][x], expected);
                drawn += picture[1][y][x] != picture[3][y][x];
            }
    }
    assert_true(c->transparency == 64 ? drawn == 0 : drawn > 0);
}

static void test_left_out(void **unused)
{
    static const uint8_t transparency[] = {1, 13, 31, 32, 33, 48, 60, 63, 64};

    (void)unused;
    for (unsigned i = 0; i < 4 * sizeof transparency; i++) {
        static const unsigned rows[] = {16, 120, 5, 33};
        const struct case_of c = {.pixel = i % 3 == 2 ? SHEEN_RGB565_LE : SHEEN_RGB565_BE,
                                  .shading = (enum sheen_shading)(i % 4),
                                  .rows = rows[(i + i / 4) % 4],
                                  .workers = 1 + i % 3,
                                  .transparency = transparency[i / 4],
                                  .phase = i * 3 % 8,
                                  .affine = i % 5 == 4,
                                  .fog = i / 4 % 2};
        check(&c);
    }
}

static void test_greys(void **unused)
{
    static const enum sheen_pixel grey[] = {SHEEN_GREY2, SHEEN_GREY16, SHEEN_GREY256};

    (void)unused;
    for (unsigned i = 0; i < 12; i++) {
        const struct case_of c = {.pixel = grey[i % 3],
                                  .shading = (enum sheen_shading)(i % 4),
                                  .rows = 16,
                                  .workers = 1,
                                  .transparency = 8 + 4 * i,
                                  .phase = 1,
                                  .fog = i / 4 % 2};
        check(&c);
    }
}

/*
 * A stippled draw is dithered with other thresholds than an opaque one, so its colours are only compared between
 * different bands; pixels that are left out must be those of the picture without the draw.
 */
static void test_dithered(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < 16; i++) {
        struct case_of c = {.pixel = i & 4 ? SHEEN_GREY16 : SHEEN_RGB565_BE,
                            .shading = (enum sheen_shading)(i % 4),
                            .rows = 16,
                            .workers = 1,
                            .transparency = i & 8 ? 20 : 40,
                            .dither = 1,
                            .fog = i / 2 % 2};
        draw(&c, 7, picture[0]);
        draw(&c, 6, picture[2]);
        c.rows = 7;
        c.workers = 2;
        draw(&c, 7, picture[1]);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                assert_int_equal(picture[0][y][x], picture[1][y][x]);
                assert_true(is_drawn(&c, x, y) || picture[0][y][x] == picture[2][y][x]);
            }
    }
}

static void test_arguments(void **unused)
{
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;
    struct sheen_object good;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 3);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    stage_draw(&stage, &cast[0], &good);
    good.stipple = &sheen_stipple;
    good.transparency = 32;
    for (int i = 0; i < 4; i++) {
        struct sheen_object object = good;
        object.transparency = i == 1 ? 65 : 32;
        object.phase = i == 2 ? 8 : 7;
        object.stipple = i == 3 ? NULL : good.stipple;
        assert_int_equal(sheen_render(f.frame, &view, &object, 1), i > 0 ? SHEEN_ERR_ARGUMENT : SHEEN_OK);
        if (i > 0)
            assert_int_equal(sheen_frame_about(f.frame, NULL), SHEEN_ABOUT_TRANSPARENCY);
    }
    assert_string_equal(sheen_subject_name(SHEEN_ABOUT_TRANSPARENCY), "transparency");
    core_frame_free(&f);
    memory_target_free(&target);
}

/* A draw that is refused for its transparency leaves the frame as it was: the picture, what is linked, the shades. */
static void test_refused(void **unused)
{
    static const struct actor others[] = {{STAGE_BALL, 1, SHEEN_GOURAUD, -0.4, -0.3, 2.6, 1, 25, 35},
                                          {STAGE_BALL, 2, SHEEN_GOURAUD, 0.5, 0.4, 1.9, 0.9, 10, 20}};

    (void)unused;
    for (int refused = 0; refused < 3; refused++) {
        struct memory_target target;
        struct sheen_config config;
        struct sheen_view view;
        struct core_frame f;
        struct sheen_object object;
        assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
        stage_config(&config, &target, 3);
        config.max_shades = 1;
        assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
        stage_view(&view);
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
        stage_draw(&stage, &cast[0], &object);
        object.stipple = &sheen_stipple;
        object.transparency = 32;
        assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
        stage_draw(&stage, &others[0], &object); /* if it succeeded it would occupy the one table of shades */
        object.transparency = refused == 1 ? 32 : 65;
        object.stipple = refused == 1 ? NULL : &sheen_stipple;
        if (refused)
            assert_int_equal(sheen_draw(f.frame, &object), SHEEN_ERR_ARGUMENT);
        stage_draw(&stage, &others[1], &object);
        assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
        assert_int_equal(sheen_end(f.frame), SHEEN_OK);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                picture[refused][y][x] = memory_target_pixel(&target, x, y);
        core_frame_free(&f);
        memory_target_free(&target);
    }
    assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
    assert_memory_equal(picture[2], picture[0], sizeof picture[0]);
}

/* Whatever lies at full fog has the fog's colour. */
static void test_full_fog(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < 20; i++) {
        struct memory_target target;
        struct sheen_config config;
        struct sheen_view view;
        struct core_frame f;
        struct sheen_object object;
        struct actor actor = cast[0];
        assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, (enum sheen_pixel)(i / 4)), 0);
        stage_config(&config, &target, 3);
        assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
        stage_view(&view);
        const struct sheen_fog near = {1, SHEEN_Q24(1.2), {77, 123, 201}, &sheen_fog_mixer};
        view.fog = &near;
        memcpy(view.background, near.color, sizeof view.background);
        view.dither = i % 2;
        actor.shading = (enum sheen_shading)(i % 4);
        stage_draw(&stage, &actor, &object);
        assert_int_equal(sheen_render(f.frame, &view, &object, 1), SHEEN_OK);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(memory_target_pixel(&target, x, y), memory_target_pixel(&target, 0, 0));
        core_frame_free(&f);
        memory_target_free(&target);
    }
}

/* Fog for lines only leaves faces as they are without fog. */
static void test_line_fog(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < 20; i++) {
        struct case_of c = {.pixel = (enum sheen_pixel)(i / 4),
                            .shading = (enum sheen_shading)(i % 4),
                            .rows = 16,
                            .workers = 1,
                            .dither = i % 3 == 0};
        draw(&c, 7, picture[0]);
        c.fog = LINES;
        draw(&c, 7, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
        c.fog = 1;
        draw(&c, 7, picture[1]);
        assert_memory_not_equal(picture[0], picture[1], sizeof picture[0]);
    }
}

static void test_fog_arguments(void **unused)
{
    static const struct sheen_fog wrong[] = {{0, SHEEN_Q24(2), {0, 0, 0}, &sheen_fog_mixer},
                                             {-1, SHEEN_Q24(2), {0, 0, 0}, &sheen_fog_mixer},
                                             {SHEEN_Q24(2), SHEEN_Q24(2), {0, 0, 0}, &sheen_fog_mixer},
                                             {SHEEN_Q24(2), SHEEN_Q24(2.01), {0, 0, 0}, &sheen_fog_mixer},
                                             {SHEEN_Q24(100), SHEEN_Q24(127), {0, 0, 0}, &sheen_fog_mixer},
                                             {SHEEN_Q24(2), SHEEN_Q24(2.01), {0, 0, 0}, &sheen_line_fog_mixer},
                                             {SHEEN_Q24(2), SHEEN_Q24(4), {0, 0, 0}, NULL}};
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 3);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        view.fog = &wrong[i];
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_ERR_ARGUMENT);
        assert_int_equal(sheen_frame_about(f.frame, NULL), SHEEN_ABOUT_FOG);
    }
    assert_string_equal(sheen_subject_name(SHEEN_ABOUT_FOG), "fog");
    view.fog = &fog;
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_finish(f.frame), SHEEN_OK);
    /* Thin view volumes in fog that reaches far beyond both planes. */
    static const struct {
        sheen_q24_t near, far;
        struct sheen_fog fog;
        int orthographic;
    } thin[] = {{SHEEN_Q24(8), SHEEN_Q24(10), {SHEEN_Q24(0.0004), SHEEN_Q24(9.9), {0, 0, 0}, &sheen_fog_mixer}, 0},
                {SHEEN_Q24(1), SHEEN_Q24(1.1), {SHEEN_Q24(0.0001), SHEEN_Q24(1.09), {0, 0, 0}, &sheen_fog_mixer}, 0},
                {SHEEN_Q24(127), SHEEN_Q24(127.01), {1, INT32_MAX, {0, 0, 0}, &sheen_fog_mixer}, 0},
                {SHEEN_Q24(0.01), SHEEN_Q24(0.0101), {1, SHEEN_Q24(100), {0, 0, 0}, &sheen_fog_mixer}, 1},
                {1, 2, {1, INT32_MAX, {0, 0, 0}, &sheen_fog_mixer}, 1}};
    for (unsigned i = 0; i < sizeof thin / sizeof *thin; i++) {
        view.fog = &thin[i].fog;
        view.z_near = thin[i].near;
        view.z_far = thin[i].far;
        view.orthographic = thin[i].orthographic ? SHEEN_Q24(1) : 0;
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
        assert_int_equal(sheen_finish(f.frame), SHEEN_OK);
    }
    core_frame_free(&f);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_left_out), cmocka_unit_test(test_greys),
                                       cmocka_unit_test(test_dithered), cmocka_unit_test(test_arguments),
                                       cmocka_unit_test(test_refused),  cmocka_unit_test(test_full_fog),
                                       cmocka_unit_test(test_line_fog), cmocka_unit_test(test_fog_arguments)};

    return cmocka_run_group_tests_name("frame_stipple", tests, make_stage, free_stage);
}
