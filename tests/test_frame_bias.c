/*
 * test_frame_bias.c - depth bias: a draw stores its depths plus the bias and keeps its colours. Of two draws at the
 * same place the one with the larger bias shows. Depths are compared exactly with those of the unbiased picture.
 */
#include <string.h>

#include "frame_test.h"

#define WIDTH 152
#define HEIGHT 120
#define FAR 257
#define NEAR 65277

static const struct actor cast[] = {{STAGE_TORUS, 0, SHEEN_FLAT, 0.2, 0.1, 3, 1.1, 40, 50},
                                    {STAGE_TORUS, 1, SHEEN_FLAT, 0.2, 0.1, 3, 1.1, 40, 50}};

struct shot {
    unsigned colour[HEIGHT][WIDTH];
    uint16_t depth[HEIGHT][WIDTH];
};

static struct shot shots[4];

/* Saves the depths that the triangles left. */
static void keep_depth(void *ctx, const struct sheen_canvas *canvas)
{
    struct shot *shot = ctx;

    for (int y = canvas->rect.y0; y < canvas->rect.y1; y++)
        for (int x = canvas->rect.x0; x < canvas->rect.x1; x++)
            shot->depth[y][x] =
                canvas->depth[(unsigned)(y - canvas->rect.y0) * canvas->pitch + (unsigned)(x - canvas->rect.x0)];
}

/* Draws the first `count` actors of the cast with these biases. */
static void take(struct shot *shot, enum sheen_shading shading, double z_near, const int *bias, unsigned count)
{
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 2);
    config.band_rows = 24;
    config.max_shades = 2;
    config.max_clipped = 2000;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    view.z_near = SHEEN_Q24(z_near);
    view.overlay = keep_depth;
    view.ctx = shot;
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    for (unsigned i = 0; i < count; i++) {
        struct sheen_object object;
        struct actor actor = cast[i];
        actor.shading = shading;
        stage_draw(&stage, &actor, &object);
        object.depth_bias = (int16_t)bias[i];
        assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
    }
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(f.frame), SHEEN_OK);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            shot->colour[y][x] = memory_target_pixel(&target, x, y);
    core_frame_free(&f);
    memory_target_free(&target);
}

static void same_colours(const struct shot *a, const struct shot *b)
{
    assert_memory_equal(a->colour, b->colour, sizeof a->colour);
}

/* Every pixel's depth is exactly the unbiased one plus the bias; light and its perspective do not change. */
static void test_left(void **unused)
{
    static const int biases[] = {1, -1, 100, -257, 4095, -4096};
    const int none = 0;

    (void)unused;
    for (unsigned shading = 0; shading < 4; shading++) {
        take(&shots[0], (enum sheen_shading)shading, 1, &none, 1);
        for (unsigned i = 0; i < 6; i++) {
            int drawn = 0;
            take(&shots[1], (enum sheen_shading)shading, 1, &biases[i], 1);
            same_colours(&shots[0], &shots[1]);
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH; x++) {
                    const int depth = shots[0].depth[y][x];
                    assert_int_equal(shots[1].depth[y][x], depth > FAR ? depth + biases[i] : FAR);
                    drawn += depth > FAR;
                }
            assert_true(drawn > 1000);
        }
    }
}

/* Sums beyond the depths of the far and near planes are clamped there; nothing wraps. */
static void test_held(void **unused)
{
    const int none = 0, most = 4095, least = -4096;
    int held = 0;

    (void)unused;
    take(&shots[0], SHEEN_GOURAUD, 2.5, &none, 1); /* the near plane cuts the near side */
    take(&shots[1], SHEEN_GOURAUD, 2.5, &most, 1);
    take(&shots[2], SHEEN_GOURAUD, 0.03, &none, 1); /* small depths everywhere */
    take(&shots[3], SHEEN_GOURAUD, 0.03, &least, 1);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            assert_true(shots[1].depth[y][x] >= shots[0].depth[y][x] && shots[1].depth[y][x] <= NEAR + 1);
            held += shots[1].depth[y][x] >= NEAR - 1;
            assert_int_equal(shots[3].depth[y][x], FAR);
        }
    assert_true(held > 100);
    assert_true(memcmp(shots[2].colour, shots[3].colour, sizeof shots[2].colour) != 0);
}

/* Two draws at the same place: on a tie the first one drawn stays; one step of bias decides. */
static void test_decides(void **unused)
{
    static const int biases[][2] = {{0, 0}, {0, 1}, {0, -1}, {5, 4}, {-7, -6}};

    (void)unused;
    for (unsigned i = 0; i < 5; i++) {
        const int second = biases[i][1] > biases[i][0];
        struct sheen_material materials[2] = {stage.material[0], stage.material[1]};
        take(&shots[0], SHEEN_PHONG, 1, biases[i], 2);
        stage.material[0] = materials[second];
        take(&shots[1], SHEEN_PHONG, 1, &biases[i][second], 1);
        stage.material[0] = materials[0];
        same_colours(&shots[0], &shots[1]);
        assert_memory_equal(shots[0].depth, shots[1].depth, sizeof shots[0].depth);
    }
}

static void test_arguments(void **unused)
{
    static const int16_t biases[] = {-4096, 4095, -4097, 4096};
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 1);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    for (unsigned i = 0; i < 4; i++) {
        struct sheen_object object;
        stage_draw(&stage, &cast[0], &object);
        object.depth_bias = biases[i];
        assert_int_equal(sheen_render(f.frame, &view, &object, 1), i < 2 ? SHEEN_OK : SHEEN_ERR_ARGUMENT);
        if (i >= 2)
            assert_int_equal(sheen_frame_about(f.frame, NULL), SHEEN_ABOUT_DEPTH_BIAS);
    }
    assert_string_equal(sheen_subject_name(SHEEN_ABOUT_DEPTH_BIAS), "depth_bias");
    core_frame_free(&f);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_left), cmocka_unit_test(test_held),
                                       cmocka_unit_test(test_decides), cmocka_unit_test(test_arguments)};

    return cmocka_run_group_tests_name("frame_bias", tests, make_stage, free_stage);
}
