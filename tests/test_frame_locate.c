/*
 * test_frame_locate.c - where points appear on the target, against double precision and against vertices that are
 * drawn.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "frame_test.h"

#include "frame/frame.h"

#define WIDTH 152
#define HEIGHT 120
#define UNIT 16777216.0 /* Q7.24 */
#define ONE 1073741824.0
#define FAR 257
#define RANGE 65020

static struct memory_target target;
static struct core_frame core;

static void open_frame(const struct sheen_view *view)
{
    struct sheen_config config;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 1);
    assert_int_equal(core_frame_make(&core, &config), SHEEN_OK);
    assert_int_equal(sheen_begin(core.frame, view), SHEEN_OK);
}

static void close_frame(void)
{
    assert_int_equal(sheen_end(core.frame), SHEEN_OK);
    core_frame_free(&core);
    memory_target_free(&target);
}

static void random_pose(struct sheen_pose *pose, uint32_t *state, double depth)
{
    sheen_pose_orbit(pose, stage_random(state), stage_random(state), stage_random(state), SHEEN_Q24(depth));
    pose->scale = SHEEN_Q16(stage_uniform(state, 0.5, 2));
    pose->translation[0] = SHEEN_Q24(stage_uniform(state, -2, 2));
    pose->translation[1] = SHEEN_Q24(stage_uniform(state, -2, 2));
}

static void place(const struct sheen_pose *pose, double v[3])
{
    const double from[3] = {v[0], v[1], v[2]};

    for (int k = 0; k < 3; k++) {
        v[k] = pose->translation[k] / UNIT;
        for (int i = 0; i < 3; i++)
            v[k] += pose->scale / 65536. * pose->rotation[3 * k + i] / ONE * from[i];
    }
}

/* The definition. Returns 1 if the point is clearly inside, 0 if clearly outside, -1 if it is too close to tell. */
static int expect(const struct sheen_view *view, const double v[3], double out[3])
{
    const struct sheen_rect port = view->viewport;
    double near = view->z_near / UNIT, far = view->z_far / UNIT, m = -v[2],
           per = view->orthographic ? view->orthographic / UNIT : m,
           focal = 32. * (port.y1 - port.y0) / tan(view->fov / 4294967296. * 3.14159265358979323846);

    out[0] = 32. * (port.x0 + port.x1) + focal * v[0] / per;
    out[1] = 32. * (port.y0 + port.y1) - focal * v[1] / per;
    out[2] = FAR + RANGE * (view->orthographic ? (far - m) / (far - near) : (1 / m - 1 / far) / (1 / near - 1 / far));
    double inside = fmin(fmin(out[0] - 64. * port.x0, 64. * port.x1 - out[0]),
                         fmin(out[1] - 64. * port.y0, 64. * port.y1 - out[1]));
    inside = fmin(inside, 1000 * fmin(m - near, far - m));
    return inside > 2 ? 1 : inside < -2 ? 0 : -1;
}

/* Points of a model and of the world, in random poses, with a viewport that is not centred. */
static void test_definition(void **unused)
{
    uint32_t state = 1;
    int count[2] = {0, 0};

    (void)unused;
    for (int i = 0; i < 400; i++) {
        struct sheen_view view = {.viewport = {16, 8, 120, 96}, .fov = SHEEN_DEGREES(60)};
        struct sheen_pose model;
        view.z_near = SHEEN_Q24(1);
        view.z_far = SHEEN_Q24(9);
        view.orthographic = i % 3 == 0 ? SHEEN_Q24(5) : 0;
        random_pose(&view.pose, &state, 5);
        random_pose(&model, &state, 0);
        open_frame(&view);
        for (int k = 0; k < 50; k++) {
            double v[3], exact[3];
            sheen_q24_t point[3];
            struct sheen_spot spot;
            for (int a = 0; a < 3; a++) {
                point[a] = SHEEN_Q24(stage_uniform(&state, -1, 1));
                v[a] = point[a] / UNIT;
            }
            if (k % 2)
                place(&model, v);
            place(&view.pose, v);
            int inside = expect(&view, v, exact);
            assert_int_equal(sheen_locate(core.frame, k % 2 ? &model : NULL, point, &spot), SHEEN_OK);
            if (inside < 0)
                continue;
            count[inside]++;
            assert_int_equal(spot.inside, inside);
            if (!inside)
                continue;
            assert_true(fabs(spot.x - exact[0]) < 1 && fabs(spot.y - exact[1]) < 1);
            assert_true(fabs(spot.depth - exact[2]) < 1);
        }
        close_frame();
    }
    assert_true(count[0] > 1000 && count[1] > 1000);
}

/* The vertices that a draw transformed lie where sheen_locate() puts them. */
static void test_vertices(void **unused)
{
    static const struct actor ball = {STAGE_BALL, 0, SHEEN_FLAT, 0.4, -0.3, 4, 1.2, 40, 25};
    const struct sheen_mesh *mesh = &stage.mesh[STAGE_BALL].mesh;
    struct sheen_view view;
    struct sheen_object object;
    int compared = 0;

    (void)unused;
    stage_view(&view);
    stage_draw(&stage, &ball, &object);
    open_frame(&view);
    assert_int_equal(sheen_draw(core.frame, &object), SHEEN_OK);
    for (unsigned i = 0; i < mesh->vertices; i++) {
        uint16_t at = core.frame->place[i];
        sheen_q24_t point[3];
        struct sheen_spot spot;
        if (at >= core.frame->used)
            continue;
        const struct vertex *v = &core.frame->vertex[at];
        for (int k = 0; k < 3; k++)
            point[k] =
                mesh->offset[k] + (sheen_q24_t)((int64_t)mesh->scale * mesh->positions[3 * i + (unsigned)k] / 32768);
        assert_int_equal(sheen_locate(core.frame, &object.pose, point, &spot), SHEEN_OK);
        assert_true(abs(spot.x - target_x(core.frame, v->x)) <= 1 && abs(spot.y - target_y(core.frame, v->y)) <= 1);
        assert_true(abs(spot.depth - v->z) <= 1);
        compared++;
    }
    close_frame();
    assert_true(compared > 50);
}

/* A point in front of z_near or beyond z_far has no place on the screen; a point far to the side lies on that side. */
static void test_outside(void **unused)
{
    static const sheen_q24_t before[3] = {0, 0, SHEEN_Q24(-0.5)}, beyond[3] = {0, 0, SHEEN_Q24(-12.5)},
                             behind[3] = {0, 0, SHEEN_Q24(5)}, aside[3] = {SHEEN_Q24(-100), 0, SHEEN_Q24(-2)};
    static const sheen_q24_t *const nowhere[] = {before, beyond, behind};
    struct sheen_spot spot;
    struct sheen_view view;

    (void)unused;
    stage_view(&view);
    open_frame(&view);
    for (int i = 0; i < 3; i++) {
        memset(&spot, 0x55, sizeof spot);
        assert_int_equal(sheen_locate(core.frame, NULL, nowhere[i], &spot), SHEEN_OK);
        assert_true(spot.x == 0 && spot.y == 0 && spot.depth == 0 && spot.inside == 0);
    }
    assert_int_equal(sheen_locate(core.frame, NULL, aside, &spot), SHEEN_OK);
    assert_int_equal(spot.x, 64 * (WIDTH / 2 - 511));
    assert_int_equal(spot.y, 32 * HEIGHT);
    assert_true(spot.depth > FAR && spot.inside == 0);
    close_frame();
}

static void test_refused(void **unused)
{
    static const sheen_q24_t point[3] = {0, 0, SHEEN_Q24(-3)}, corner[3] = {INT32_MAX, INT32_MAX, 0};
    struct sheen_spot spot, before;
    struct sheen_pose bad = {.scale = -1}, turned;
    struct sheen_view view;

    (void)unused;
    memset(&spot, 0x55, sizeof spot);
    before = spot;
    stage_view(&view);
    open_frame(&view);
    assert_int_equal(sheen_locate(core.frame, &bad, point, &spot), SHEEN_ERR_ARGUMENT);
    sheen_pose_orbit(&turned, SHEEN_DEGREES(45), 0, SHEEN_DEGREES(45), 0);
    assert_int_equal(sheen_locate(core.frame, &turned, corner, &spot), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_finish(core.frame), SHEEN_OK);
    assert_int_equal(sheen_locate(core.frame, NULL, point, &spot), SHEEN_ERR_STATE);
    assert_memory_equal(&spot, &before, sizeof spot);
    assert_int_equal(sheen_begin(core.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_band(core.frame, 0, 0), SHEEN_OK);
    assert_int_equal(sheen_locate(core.frame, NULL, point, &spot), SHEEN_OK); /* also while the bands are drawn */
    assert_int_equal(spot.inside, 1);
    close_frame();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_definition), cmocka_unit_test(test_vertices),
                                       cmocka_unit_test(test_outside), cmocka_unit_test(test_refused)};

    return cmocka_run_group_tests(tests, make_stage, free_stage);
}
