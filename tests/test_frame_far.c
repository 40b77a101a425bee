/*
 * test_frame_far.c - a floor of two triangles reaches from the near plane to a far plane that is up to 200,000 times as
 * far away. Lit from above it must have one colour, computed in double precision, within one step in its farthest
 * corners too; so must a triangle with a far edge and oblique normals.
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

/* ---- oblique normals ---- */

#define WIDE 320
#define REACH 30 /* units */

/*
 * Triangles from just beyond the near plane to almost the far plane, 60 units away. Of the first four the far edge goes
 * through the centres of a row of pixels, of the others through those of a column.
 */
struct far_triangle {
    int32_t near; /* Q7.24 */
    int16_t at[9];
};

static const struct far_triangle far_triangles[] = {
    {SHEEN_Q24(0.01), {-1, -4, 32755, -24420, 3924, -24740, 27133, 4360, -31130}},
    {SHEEN_Q24(0.01), {3, -4, 32755, -24420, 4622, -24740, 27133, 5135, -31130}},
    {SHEEN_Q24(0.03), {1, -12, 32729, -27133, 13276, -31130, 27133, 13276, -31130}},
    {SHEEN_Q24(0.03), {9, -12, 32729, -27133, 7074, -31130, 27133, 7074, -31130}},
    {SHEEN_Q24(0.01), {4, 1, 32755, -5320, -24420, -24740, -5911, 21319, -31130}},
    {SHEEN_Q24(0.03), {12, -1, 32729, -5331, -27133, -31130, -5331, 21319, -31130}},
    {SHEEN_Q24(0.03), {12, 2, 32729, -10174, -27133, -31130, -10174, 21319, -31130}}};

/* Its normals are equal and lie between the axes, where rounding makes short ones shortest. As count_others. */
static int count_oblique(const struct sheen_shader *shader, const struct far_triangle *triangle)
{
    static const int16_t oblique[] = {18918, 18918, 18918, 18918, 18918, 18918, 18918, 18918, 18918};
    static const uint8_t corners[] = {0, 2, 1};
    const struct sheen_mesh mesh = {.positions = triangle->at,
                                    .normals = oblique,
                                    .indices = corners,
                                    .index_bytes = 1,
                                    .vertices = 3,
                                    .triangles = 1,
                                    .scale = SHEEN_Q24(REACH)};
    const struct sheen_light light = {.to = {1 << 29, 1 << 29, 1 << 29}, .intensity = 32768},
                             lights[2] = {light, light};
    const struct sheen_material material = {
        .base = {255, 255, 255}, .ambient = SHEEN_Q16(0.1), .diffuse = SHEEN_Q16(0.6)};
    struct sheen_object object = {
        .mesh = &mesh, .material = &material, .shader = shader, .lights = lights, .light_count = 2};
    const struct sheen_view view = {
        .fov = SHEEN_DEGREES(40), .z_near = triangle->near, .z_far = SHEEN_Q24(60), .background = {0, 0, 255}};
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    int others = 0, covered = 0;

    assert_int_equal(memory_target_init(&target, WIDE, SIZE, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 1);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    sheen_pose_identity(&object.pose);
    object.pose.translation[2] = -SHEEN_Q24(REACH);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    for (int i = 0; i < WIDE * SIZE; i++) {
        const uint16_t pixel = memory_target_pixel(&target, i % WIDE, i / WIDE);
        covered += pixel != BACKGROUND;
        others += pixel != BACKGROUND && fabs((pixel >> 5 & 63) - 63 * 0.7) > 1;
    }
    core_frame_free(&f);
    memory_target_free(&target);
    return covered > 5000 ? others : -1;
}

static void oblique_normals_are_one_color(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof far_triangles / sizeof far_triangles[0]; i++) {
        assert_int_equal(count_oblique(&sheen_phong, &far_triangles[i]), 0);
        assert_int_equal(count_oblique(&sheen_slerp, &far_triangles[i]), 0);
    }
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(floor_is_one_color),
                                       cmocka_unit_test(oblique_normals_are_one_color)};

    return cmocka_run_group_tests_name("frame_far", tests, NULL, NULL);
}
