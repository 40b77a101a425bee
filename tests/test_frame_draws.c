/*
 * test_frame_draws.c - several draws in a frame, values at the ends of their ranges, and calls out of order.
 */
#include <string.h>

#include "frame_test.h"

#define WIDTH 160
#define HEIGHT 120

/* ---- several draws ---- */

static void draw_actors(struct memory_target *target, const struct actor *actors, int count)
{
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;

    stage_config(&config, target, 3);
    config.max_shades = 2; /* otherwise the second draw's colours would be rounded without a table */
    stage_view(&view);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(stage_frame(f.frame, &view, &stage, actors, count), SHEEN_OK);
    core_frame_free(&f);
}

/*
 * One mesh drawn twice: side by side the picture must be both pictures together; one behind the other, either order of
 * drawing must give the same picture.
 */
static void two_draws_of_one_mesh(void **state)
{
    struct actor a = {STAGE_TORUS, 0, SHEEN_PHONG, -0.9, 0, 4, 0.8, 30, 40};
    struct actor b = {STAGE_TORUS, 1, SHEEN_GOURAUD, 1, 0.2, 5, 0.8, 80, 10}, behind = a;
    struct memory_target both, only_a, only_b, turned;
    int of_a = 0, of_b = 0;

    (void)state;
    assert_int_equal(memory_target_init(&both, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    assert_int_equal(memory_target_init(&only_a, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    assert_int_equal(memory_target_init(&only_b, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    assert_int_equal(memory_target_init(&turned, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    draw_actors(&both, (struct actor[]){a, b}, 2);
    draw_actors(&only_a, &a, 1);
    draw_actors(&only_b, &b, 1);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            unsigned p = memory_target_pixel(&only_a, x, y), q = memory_target_pixel(&only_b, x, y);
            assert_true(p == 4 || q == 4); /* the background is 000020, so at least one of the two is not here */
            assert_int_equal(memory_target_pixel(&both, x, y), p == 4 ? q : p);
            of_a += p != 4;
            of_b += q != 4;
        }
    }
    assert_true(of_a > 500 && of_b > 500);

    behind.depth = 6;
    behind.material = 2;
    draw_actors(&both, (struct actor[]){a, behind}, 2);
    draw_actors(&turned, (struct actor[]){behind, a}, 2);
    assert_memory_equal(both.memory, turned.memory, HEIGHT * both.row_bytes);
    assert_memory_not_equal(both.memory, only_a.memory, HEIGHT * both.row_bytes);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            if (memory_target_pixel(&only_a, x, y) != 4)
                assert_int_equal(memory_target_pixel(&both, x, y), memory_target_pixel(&only_a, x, y));
        }
    }
    memory_target_free(&both);
    memory_target_free(&only_a);
    memory_target_free(&only_b);
    memory_target_free(&turned);
}

/* Of triangles at the same depth the first drawn stays. */
static void first_drawn_stays(void **state)
{
    struct actor a = {STAGE_CUBE, 0, SHEEN_FLAT, 0, 0, 4, 1, 30, 40}, b = a;
    struct memory_target both, only_a;

    (void)state;
    b.material = 2;
    assert_int_equal(memory_target_init(&both, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    assert_int_equal(memory_target_init(&only_a, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    draw_actors(&both, (struct actor[]){a, b, b}, 3);
    draw_actors(&only_a, &a, 1);
    assert_memory_equal(both.memory, only_a.memory, HEIGHT * both.row_bytes);
    memory_target_free(&both);
    memory_target_free(&only_a);
}

/* ---- at the ends of ranges ---- */

static const int16_t corners[] = {-32000, -32000, -32000, 32000, -32000, 32767, 0, 32000, -32000};
static const int16_t normals[] = {0, 0, 32767, 23170, 0, 23170, 0, 23170, 23170};
static const uint8_t indices[] = {0, 1, 2};
static const struct sheen_triangle_edges borders = {{SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE}, 0, 0};
static const struct sheen_mesh triangle = {.positions = corners,
                                           .normals = normals,
                                           .polygon_normals = normals,
                                           .indices = indices,
                                           .index_bytes = 1,
                                           .vertices = 3,
                                           .triangles = 1,
                                           .scale = SHEEN_Q24(1),
                                           .edges = &borders};

/* Draws a frame of one object on a target of 64 x 64; `view` gives the fields that differ from the stage's view. */
static void show(const struct sheen_view *view, const struct sheen_object *object, uint32_t by_way[SHEEN_WAYS])
{
    struct memory_target target;
    struct core_frame f;

    assert_int_equal(memory_target_init(&target, 64, 64, SHEEN_RGB565_BE), 0);
    const struct sheen_config config = {
        .target = &target.target, .max_vertices = 3, .max_triangles = 1, .max_edges = 4, .smooth = 1};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(sheen_render(f.frame, view, object, 1), SHEEN_OK);
    sheen_frame_ways(f.frame, by_way);
    assert_int_equal(target.breaches, 0);
    core_frame_free(&f);
    memory_target_free(&target);
}

/* Light 36 times as bright as 1.0: a triangle in steep perspective must not count as linear. */
static void brightest(void **state)
{
    const struct sheen_light lights[4] = {{.to = {0, 0, 1}}, {.to = {0, 0, 1}}, {.to = {0, 0, 1}}, {.to = {0, 0, 1}}};
    const struct sheen_shader *const shaders[] = {&sheen_gouraud, &sheen_gouraud_colored};

    (void)state;
    for (int i = 0; i < 2 * 2 * 24; i++) {
        const struct sheen_material material = {.base = {255, 255, 255},
                                                .ambient = SHEEN_Q16(4),
                                                .diffuse = SHEEN_Q16(4),
                                                .specular = i & 1 ? SHEEN_Q16(4) : SHEEN_Q16(3),
                                                .shine = &sheen_shine_4};
        const struct sheen_object object = {.mesh = &triangle,
                                            .material = &material,
                                            .shader = shaders[i >> 1 & 1],
                                            .lights = lights,
                                            .light_count = 4};
        const struct sheen_view view = {.z_near = SHEEN_Q24(0.5),
                                        .pose.translation[2] = -SHEEN_Q24(2.5) - (i >> 2) * 40000};
        uint32_t by_way[SHEEN_WAYS];
        show(&view, &object, by_way);
        assert_int_equal(by_way[SHEEN_WAY_GOURAUD_LINEAR], 0);
        assert_int_equal(by_way[SHEEN_WAY_GOURAUD_QUADRATIC] + by_way[SHEEN_WAY_GOURAUD_QUOTIENT], 1);
    }
}

/* A point light that the view moves out of range lights nothing, and nothing overflows. */
static void farthest_light(void **state)
{
    const struct sheen_light light = {.at = {0, 0, SHEEN_Q24(-127.9)}, .radius = SHEEN_Q16(1), .points = &sheen_points};
    const struct sheen_material material = {.base = {80, 80, 80}, .ambient = SHEEN_Q16(0.2), .diffuse = SHEEN_Q16(0.5)};
    struct sheen_mesh large = triangle;

    (void)state;
    large.scale = SHEEN_Q24(2);
    const struct sheen_object object = {
        .mesh = &large, .material = &material, .shader = &sheen_gouraud_colored, .lights = &light, .light_count = 1};
    const struct sheen_view view = {.pose.translation[2] = SHEEN_Q24(-6)};
    uint32_t by_way[SHEEN_WAYS];
    show(&view, &object, by_way);
}

/* Viewports of one row, with edges drawn, one of which ends above the row, so that it has no row to step back to. */
static void single_rows(void **state)
{
    const struct sheen_material material = {.base = {200, 0, 0}, .ambient = SHEEN_Q16(0.5)};
    const struct sheen_edges *const kinds[] = {&sheen_edges_smooth, &sheen_edges_outline, &sheen_edges_wire};

    (void)state;
    for (int i = 0; i < 3 * 200; i++) {
        const struct sheen_object object = {
            .mesh = &triangle, .material = &material, .shader = &sheen_flat, .edges = kinds[i % 3]};
        /* a pixel is .21 units wide at the middle corner, which moves from a row above the viewport to one below */
        const struct sheen_view view = {.viewport = {0, (int16_t)(i % 64), 64, (int16_t)(i % 64 + 1)},
                                        .fov = SHEEN_DEGREES(4),
                                        .pose.translation = {0, SHEEN_Q24(0.75) + i * 14000, SHEEN_Q24(-4)}};
        uint32_t by_way[SHEEN_WAYS];
        show(&view, &object, by_way);
    }
}

/* ---- calls out of order ---- */

static void out_of_order(void **state)
{
    const struct actor actor = {STAGE_BALL, 0, SHEEN_GOURAUD, -0.8, 0, 4, 1, 30, 20};
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view, bad;
    struct sheen_object draw;

    (void)state;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 1);
    stage_view(&view);
    stage_draw(&stage, &actor, &draw);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_ERR_STATE);
    assert_int_equal(sheen_mark(f.frame, (struct sheen_rect){0, 0, 1, 1}), SHEEN_ERR_STATE);
    assert_int_equal(sheen_end(f.frame), SHEEN_ERR_STATE);
    assert_int_equal(sheen_finish(f.frame), SHEEN_ERR_STATE);
    assert_int_equal(sheen_band(f.frame, 0, 0), SHEEN_ERR_STATE);
    assert_int_equal(sheen_wait(f.frame), SHEEN_OK);
    for (int k = 0; k < 5; k++) {
        bad = view;
        bad.z_near = k == 0 ? -1 : bad.z_near;
        bad.z_far = k == 1 ? bad.z_near : bad.z_far;
        bad.fov = k == 2 ? 1 : k == 3 ? SHEEN_DEGREES(151) : bad.fov;
        if (k == 4)
            bad.viewport = (struct sheen_rect){0, 0, WIDTH + 1, HEIGHT};
        if (sheen_begin(f.frame, &bad) != SHEEN_ERR_ARGUMENT)
            fail_msg("bad view %d was taken", k);
    }
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_ERR_STATE);
    assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_OK);
    assert_int_equal(sheen_band(f.frame, 1, 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_band(f.frame, 0, sheen_band_count(f.frame)), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    assert_int_equal(sheen_end(f.frame), SHEEN_ERR_STATE);
    core_frame_free(&f);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_draws_of_one_mesh), cmocka_unit_test(first_drawn_stays), cmocka_unit_test(brightest),
        cmocka_unit_test(farthest_light),        cmocka_unit_test(single_rows),       cmocka_unit_test(out_of_order),
    };

    return cmocka_run_group_tests_name("frame_draws", tests, make_stage, free_stage);
}
