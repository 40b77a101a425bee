/*
 * test_frame_far.c - a floor of two triangles reaches from the near plane to a far plane that is up to 200,000 times as
 * far away. Lit from above it must have one colour, computed in double precision, within one step in its farthest
 * corners too.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_stage.h"

#define SIZE 240
#define BACKGROUND 0x001f
#define ROLL 3 /* degrees per turn */

static const int16_t positions[] = {-32767, 0, 32767, 32767, 0, 32767, 32767, 0, -32767, -32767, 0, -32767},
                     normals[] = {0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0};
static const uint8_t indices[] = {0, 1, 2, 0, 2, 3};

/* Counts the floor's pixels that have another colour; -1 if no floor is seen. */
static int count_others(const struct sheen_shader *shader, double ratio, int turn)
{
    const struct sheen_mesh mesh = {.positions = positions,
                                    .normals = normals,
                                    .indices = indices,
                                    .index_bytes = 1,
                                    .vertices = 4,
                                    .triangles = 2,
                                    .scale = SHEEN_Q24(60)};
    const struct sheen_light light = {.to = {0, SHEEN_Q30(1), 0}, .intensity = 65536};
    const struct sheen_material material = {
        .base = {255, 255, 255}, .ambient = SHEEN_Q16(0.1), .diffuse = SHEEN_Q16(0.6)};
    struct sheen_object floor = {
        .mesh = &mesh, .material = &material, .shader = shader, .lights = &light, .light_count = 1, .two_sided = 1};
    struct sheen_view view = {
        .fov = SHEEN_DEGREES(70), .z_near = SHEEN_Q24(60 / ratio), .z_far = SHEEN_Q24(60), .background = {0, 0, 255}};
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    const double green = 63 * (0.1 + 0.6 * cos(turn * ROLL * 3.14159265358979323846 / 180));
    int others = 0, covered = 0;

    assert_int_equal(memory_target_init(&target, SIZE, SIZE, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 1);
    config.max_clipped = 200;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    sheen_pose_orbit(&floor.pose, SHEEN_DEGREES(turn * 7.3), 0, SHEEN_DEGREES(turn * ROLL), 0);
    floor.pose.translation[1] = turn % 2 ? SHEEN_Q24(-0.01) : SHEEN_Q24(-1);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(f.frame, &floor), SHEEN_OK);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    for (int i = 0; i < SIZE * SIZE; i++) {
        const uint16_t pixel = memory_target_pixel(&target, i % SIZE, i / SIZE);
        covered += pixel != BACKGROUND;
        others += pixel != BACKGROUND && fabs((pixel >> 5 & 63) - green) > 1;
    }
    core_frame_free(&f);
    memory_target_free(&target);
    return covered > 0 ? others : -1;
}

static void floor_is_one_color(void **unused)
{
    static const struct sheen_shader *const shaders[] = {&sheen_gouraud, &sheen_phong, &sheen_slerp,
                                                         &sheen_slerp_colored};
    static const double ratios[] = {250, 4000, 30000, 200000};

    (void)unused;
    for (int i = 0; i < 16; i++) {
        int others = 0;
        for (int turn = 0; turn < 12; turn++)
            others |= count_others(shaders[i / 4], ratios[i % 4], turn);
        assert_int_equal(others, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(floor_is_one_color)};

    return cmocka_run_group_tests_name("frame_far", tests, NULL, NULL);
}
