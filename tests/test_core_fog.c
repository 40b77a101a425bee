/*
 * test_core_fog.c - fog at the ends of its range: walls that cross most of the depth within a pixel, and fogs that end
 * far in front of the near plane.
 */
#include <stdlib.h>

#include "test_core_worst.h"

#include "frame_stage.h"

#define SIZE 32 /* px, of the target */
#define FAR 257
#define RANGE 65020

/* What a frame left of two pixels. */
struct shown {
    int x[2], y; /* which ones */
    uint16_t pixel[2], depth[2];
};

static void look(void *ctx, const struct sheen_canvas *canvas)
{
    struct shown *shown = ctx;

    for (int i = 0; i < 2; i++) {
        const int x = shown->x[i] - canvas->rect.x0, y = shown->y - canvas->rect.y0;
        if (x < 0 || y < 0 || x >= canvas->rect.x1 - canvas->rect.x0 || y >= canvas->rect.y1 - canvas->rect.y0)
            continue;
        shown->pixel[i] = ((const uint16_t *)canvas->pixels)[y * (int)canvas->pitch + x];
        shown->depth[i] = canvas->depth[y * (int)canvas->pitch + x];
    }
}

/* Draws a white rectangle. x, z: of its left and right side, in units, z from a plane `distance` before the eye. */
static void draw_wall(struct shown *shown, struct sheen_view *view, sheen_q24_t distance, const double x[2],
                      const double z[2])
{
    static const uint8_t order[6] = {0, 1, 2, 0, 2, 3};
    int16_t position[12];
    const struct sheen_mesh mesh = {.positions = position,
                                    .indices = order,
                                    .index_bytes = 1,
                                    .vertices = 4,
                                    .triangles = 2,
                                    .scale = SHEEN_Q24(1)};
    const struct sheen_material white = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1)};
    struct sheen_object wall = {.mesh = &mesh, .material = &white, .shader = &sheen_flat};
    struct memory_target target;
    struct core_frame frame;

    for (int k = 0; k < 4; k++) {
        const int right = k == 1 || k == 2;
        position[3 * k] = (int16_t)lrint(x[right] * 32768);
        position[3 * k + 1] = k < 2 ? -16384 : 16384;
        position[3 * k + 2] = (int16_t)lrint(z[right] * 32768);
    }
    assert_int_equal(memory_target_init(&target, SIZE, SIZE, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &target.target, .max_vertices = 4, .max_triangles = 2};
    assert_int_equal(core_frame_make(&frame, &config), SHEEN_OK);
    view->overlay = look;
    view->ctx = shown;
    sheen_pose_identity(&wall.pose);
    wall.pose.translation[2] = -distance;
    assert_int_equal(sheen_render(frame.frame, view, &wall, 1), SHEEN_OK);
    assert_int_equal(sheen_wait(frame.frame), SHEEN_OK);
    core_frame_free(&frame);
    memory_target_free(&target);
}

/*
 * The wall is 1.9 px wide and reaches from near to far, so that its depths at the centres of its two pixels are more
 * than 2^15 steps apart. White fades into black by them.
 */
static void test_wall_across_the_depths(void **unused)
{
    struct sheen_fog fog = {.start = SHEEN_Q24(2), .end = SHEEN_Q24(4), .mixer = &sheen_fog_mixer};

    (void)unused;
    for (unsigned turned = 0; turned < 2; turned++) {
        struct sheen_view view = {.fov = SHEEN_DEGREES(90), /* at 1 unit 16 px are a unit */
                                  .z_near = SHEEN_Q24(2),
                                  .z_far = SHEEN_Q24(4),
                                  .orthographic = SHEEN_Q24(1),
                                  .fog = &fog};
        const double left = turned ? 10.0 : 10.1, x[2] = {(left - 16) / 16, (left + 1.9 - 16) / 16};
        const double z[2] = {turned ? -0.99 : 0.99, turned ? 0.99 : -0.99};
        struct shown shown = {.x = {10, 11}, .y = 9}; /* there both belong to one triangle */
        draw_wall(&shown, &view, SHEEN_Q24(3), x, z);
        assert_true(abs(shown.depth[0] - shown.depth[1]) > 32768);
        for (int i = 0; i < 2; i++) {
            const double green = 63.0 * (shown.depth[i] - FAR) / RANGE;
            assert_true(fabs((shown.pixel[i] >> 5 & 63) - green) < 1);
        }
    }
}

/* All that is drawn lies behind the fog's end, in perspective and without. */
static void test_end_long_before_near(void **unused)
{
    static const sheen_q24_t end[] = {2, 300, 10000, 60000, 102399, 102400, 102401, 204799, 204800, 300000};

    (void)unused;
    for (unsigned i = 0; i < sizeof end / sizeof end[0]; i++)
        for (int orthographic = 0; orthographic < 2; orthographic++) {
            struct sheen_fog fog = {.start = 1, .end = end[i], .color = {255, 0, 0}, .mixer = &sheen_fog_mixer};
            struct sheen_view view = {.z_near = SHEEN_Q24(100), .z_far = SHEEN_Q24(127), .fog = &fog};
            const double x[2] = {-0.9, 0.9}, z[2] = {0, 0};
            struct shown shown = {.x = {15, 16}, .y = SIZE / 2};
            if (orthographic) {
                if (end[i] < 300) /* less than 256 steps of depth from its start */
                    continue;
                view.orthographic = SHEEN_Q24(2);
                view.z_far = view.z_near + 65600;
            }
            view.fov = orthographic ? SHEEN_DEGREES(60) : SHEEN_DEGREES(1);
            draw_wall(&shown, &view, view.z_near + 20000, x, z);
            for (int k = 0; k < 2; k++) {
                assert_true(shown.depth[k] > FAR);
                assert_int_equal(shown.pixel[k], 0xf800);
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wall_across_the_depths),
        cmocka_unit_test(test_end_long_before_near),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
