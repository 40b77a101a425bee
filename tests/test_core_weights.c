/*
 * test_core_weights.c - weights (1/m) at the ends of their range, where the rounding of planes takes them beyond: views
 * that are hardly deep, whose weights come near 1.0, and views so deep that the weight at far is 0.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame_stage.h"

#define WIDTH 640
#define HEIGHT 480
#define UNIT 16777216.0

/* Far apart, so that normals are interpolated by shares. */
static const int16_t normals[12] = {0, 0, 32767, 28377, 0, 16384, 28377, 0, 16384, 0, 0, 32767};
static const uint8_t order[6] = {0, 1, 2, 0, 2, 3};
static uint16_t texels[64];

struct wall {
    int16_t positions[12], uvs[8];
    uint8_t colors[12];
    struct sheen_mesh mesh;
    struct sheen_view view;
    struct sheen_object object;
};

/* A wall that fills much of the picture; its left side lies `deeper` units behind its right side, at m. */
static void make_wall(struct wall *w, double near, double far, double m, double deeper, double reach)
{
    memset(w, 0, sizeof *w);
    for (int k = 0; k < 4; k++) {
        const int right = k == 1 || k == 2, above = k >= 2;
        w->positions[3 * k] = (int16_t)(right ? 32000 : -32000);
        w->positions[3 * k + 1] = (int16_t)(above ? 20000 : -20000);
        w->uvs[2 * k] = (int16_t)(right ? 32767 : 0);
        w->uvs[2 * k + 1] = (int16_t)(above ? 0 : 32767);
        memset(&w->colors[3 * k], right ? 80 : 255, 3);
    }
    w->mesh = (struct sheen_mesh){.positions = w->positions,
                                  .normals = normals,
                                  .uvs = w->uvs,
                                  .uv_bits = 15,
                                  .colors = w->colors,
                                  .indices = order,
                                  .index_bytes = 1,
                                  .vertices = 4,
                                  .triangles = 2,
                                  .scale = (sheen_q24_t)lrint(reach)};
    w->view = (struct sheen_view){
        .fov = SHEEN_DEGREES(1), .z_near = (sheen_q24_t)lrint(near), .z_far = (sheen_q24_t)lrint(far)};
    const double turn = asin(deeper / (2 * reach * 32000 / 32768));
    sheen_pose_orbit(&w->object.pose, (sheen_angle_t)(int64_t)lrint(turn / 6.283185307179586 * 4294967296), 0, 0,
                     (sheen_q24_t)lrint(m + fabs(deeper) / 2));
}

/* Draws the wall and returns its pixels. */
static uint16_t *draw_wall(const struct wall *w, const struct sheen_shader *shader, struct memory_target *target)
{
    const struct sheen_texture texture = {.texels = texels, .width_log2 = 3, .height_log2 = 3};
    const struct sheen_material white = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1), .texture = &texture};
    struct sheen_object object = w->object;
    struct core_frame frame;

    object.mesh = &w->mesh;
    object.material = &white;
    object.shader = shader;
    assert_int_equal(memory_target_init(target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &target->target,
                                        .max_vertices = 4,
                                        .max_triangles = 20,
                                        .max_clipped = 20,
                                        .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&frame, &config), SHEEN_OK);
    assert_int_equal(sheen_render(frame.frame, &w->view, &object, 1), SHEEN_OK);
    assert_int_equal(sheen_wait(frame.frame), SHEEN_OK);
    core_frame_free(&frame);
    return (uint16_t *)(void *)target->memory;
}

/* Pixels that two shaders draw clearly differently; *drawn: those that the first one draws. */
static int apart(const struct wall *w, const struct sheen_shader *first, const struct sheen_shader *second, int *drawn)
{
    struct memory_target one, other;
    const uint16_t *a = draw_wall(w, first, &one), *b = draw_wall(w, second, &other);
    int count = 0;

    *drawn = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        *drawn += a[i] != 0;
        count += abs((a[i] >> 5 & 63) - (b[i] >> 5 & 63)) > 1;
    }
    memory_target_free(&one);
    memory_target_free(&other);
    return count;
}

/*
 * 65020 far / (far - near) is 2^30: at near a weight is within 2^-29 of 1.0. That of the side away from it is some 500
 * steps of 2^-30 less, over as many pixels, so that a plane's step, a whole one, is up to half a step off.
 */
static void test_weights_near_one(void **unused)
{
    const double far = 1651402374, near = far - 100000;

    (void)unused;
    for (int i = 0; i < 16; i++) {
        struct wall w;
        int drawn;
        make_wall(&w, near, far, near + 3, (i % 2 ? -1 : 1) * (440 + 20 * i), 0.9 * UNIT);
        assert_int_equal(apart(&w, &sheen_gouraud_colored, &sheen_phong_colored, &drawn), 0);
        assert_true(drawn > 50000);
        memset(w.colors, 255, sizeof w.colors);
        const int off = apart(&w, &sheen_textured, &sheen_textured_colored, &drawn);
        assert_true(off < drawn / 30); /* at texels' borders */
    }
}

/*
 * A wall from the near plane to the far plane, at which a weight is 0, less than its plane's rounding. Of what is drawn
 * there nothing is expected but that the sanitizers see no negative shift (preset asan).
 */
static void test_weights_near_zero(void **unused)
{
    struct memory_target target;
    struct wall w;

    (void)unused;
    make_wall(&w, 31, 50 * UNIT, 25 * UNIT, 0, 30 * UNIT);
    sheen_pose_orbit(&w.object.pose, 3813607552u, 1237204047u, 1220866516u, 117189625);
    w.object.pose.translation[0] = 147574160;
    w.object.pose.translation[1] = 319596879;
    w.object.two_sided = 1;
    w.view.fov = 632246492u;
    (void)draw_wall(&w, &sheen_textured_colored, &target);
    memory_target_free(&target);
}

static int make_texels(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < 64; i++)
        texels[i] = (uint16_t)(0x2104 + ((i & 7) + (i >> 3)) % 8 * 0x18e3);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_weights_near_one),
        cmocka_unit_test(test_weights_near_zero),
    };

    return cmocka_run_group_tests(tests, make_texels, NULL);
}
