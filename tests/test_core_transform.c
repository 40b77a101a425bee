/*
 * test_core_transform.c - model to eye to screen against double precision.
 *
 * Tolerances: eye coordinates 6 raw steps of Q7.24, or of 2^-24 scale / 16 where the mesh is larger than 16 units;
 * screen coordinates 1/2 step of 1/64 px (the snapping: 1/128 px) and 0.02 for the reciprocals; z16 1/2 step,
 * 2^-27 of depth / m, and what holding near far / (far - near) in Q7.24 makes of it; weights what the rounding of z16
 * makes of 1/m. Flags are exact: at the limit a vertex is inside, one raw step beyond it is not.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"

#define PI 3.14159265358979323846
#define UNIT 16777216.0 /* Q7.24 */
#define VIEWS 300
#define WIDTH 320 /* of all viewports, px */

/* A view of random opening, height and planes; every other one orthographic where asked for. */
static unsigned random_view(struct sheen_view *view, uint32_t *state, int orthographic)
{
    double near = exp(stage_uniform(state, log(0.02), log(8))), far = near * exp(stage_uniform(state, 0.02, 4));

    memset(view, 0, sizeof *view);
    view->fov = SHEEN_DEGREES(stage_uniform(state, 1, 150));
    view->z_near = SHEEN_Q24(near);
    view->z_far = SHEEN_Q24(fmin(far, 127));
    view->orthographic = orthographic ? SHEEN_Q24(stage_uniform(state, 0.1, 20)) : 0;
    return 8 + stage_random(state) % 473;
}

static double focal(const struct sheen_view *view, unsigned height)
{
    return height / 2.0 / tan(view->fov / 4294967296.0 * PI);
}

/* The definition's z16 before rounding, in the core's range. */
static double exact_depth(const struct sheen_view *view, double m)
{
    double near = view->z_near / UNIT, far = view->z_far / UNIT;

    if (view->orthographic != 0)
        return DEPTH_FAR + DEPTH_RANGE * (far - m) / (far - near);
    return DEPTH_FAR + DEPTH_RANGE * (1 / m - 1 / far) / (1 / near - 1 / far);
}

/* ---- model to eye ---- */

static void note_points(struct worst *worst, uint32_t *state)
{
    struct sheen_pose pose;
    struct transform t;
    struct sheen_mesh mesh = {.scale = (int32_t)(stage_random(state) >> (2 + stage_random(state) % 24)) + 1};

    sheen_pose_orbit(&pose, stage_random(state), stage_random(state), stage_random(state), 0);
    pose.scale = (int32_t)(stage_random(state) >> (8 + stage_random(state) % 16)) + 1;
    for (int k = 0; k < 3; k++) {
        mesh.offset[k] = (int32_t)stage_random(state) >> (3 + stage_random(state) % 16);
        pose.translation[k] = (int32_t)stage_random(state) >> (3 + stage_random(state) % 16);
    }
    if (sheen_transform_begin(&t, &mesh, &pose) != SHEEN_OK)
        return; /* beyond +-128 units: test_ranges */
    double scale = pose.scale / 65536., step = fmax(1, scale * mesh.scale / UNIT / 16);
    for (int i = 0; i < 50; i++) {
        int16_t raw[3];
        sheen_q24_t eye[3];
        for (int k = 0; k < 3; k++)
            raw[k] = (int16_t)(i < 8 ? (i >> k & 1) != 0 ? 32767 : -32768 : (int16_t)stage_random(state));
        sheen_transform_point(&t, raw, eye);
        for (int k = 0; k < 3; k++) {
            double exact = pose.translation[k];
            for (int j = 0; j < 3; j++)
                exact += scale * pose.rotation[3 * k + j] / 1073741824. *
                         (mesh.offset[j] + (double)mesh.scale * raw[j] / 32768);
            worst_note(worst, (eye[k] - exact) / step / (1 + scale / 4), "mesh scale %d, pose scale %d", mesh.scale,
                       pose.scale);
        }
    }
}

static void test_model_to_eye(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 1;

    (void)unused;
    for (int i = 0; i < 20000; i++)
        note_points(&worst, &state);
    worst_assert(&worst, 6, "eye coordinates");
    assert_true(worst.count > 100000);
}

/* Scales must be positive, and everything must stay within +-128 units of the eye. */
static void test_ranges(void **unused)
{
    struct sheen_mesh mesh = {.scale = 1 << 24};
    struct sheen_pose pose;
    struct transform t;

    (void)unused;
    sheen_pose_identity(&pose);
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_OK);
    mesh.scale = 0;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    mesh.scale = -1;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    mesh.scale = 1 << 24;
    pose.scale = 0;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = INT32_MIN;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = 1;
    mesh.scale = 65535; /* their product is below a raw step */
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = INT32_MAX;
    mesh.scale = INT32_MAX;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);

    sheen_pose_identity(&pose);
    mesh.scale = 1 << 24;
    pose.translation[2] = INT32_MAX - (2 << 24);
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_OK);
    pose.translation[2]++;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.translation[2] = -INT32_MAX + (2 << 24);
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_OK);
    pose.translation[2]--;
    assert_int_equal(sheen_transform_begin(&t, &mesh, &pose), SHEEN_ERR_ARGUMENT);
}

/* ---- eye to screen ---- */

struct screen_errors {
    struct worst screen, depth, weight;
};

static void note_projection(struct screen_errors *e, const struct projection *p, const struct sheen_view *view,
                            double f, const sheen_q24_t eye[3])
{
    struct vertex v;
    double m = -eye[2] / UNIT, per = view->orthographic != 0 ? view->orthographic / UNIT : m;

    sheen_project(p, eye, &v);
    if ((v.flags & (OUTSIDE_NEAR | OUTSIDE_FAR)) != 0)
        return;
    /* steps: depth / m, of which z16 is the upper part; unit: near far / (far - near) in raw steps */
    double unit = (double)view->z_near * view->z_far / ((double)view->z_far - view->z_near),
           steps = DEPTH_RANGE * unit / UNIT / m;
    double slack = view->orthographic != 0 ? 0.505 : 0.505 + steps * 0x1p-27 + steps / unit;
    worst_note(&e->depth, (v.z - exact_depth(view, m)) / slack, "m %.9g of %.9g..%.9g", m, view->z_near / UNIT,
               view->z_far / UNIT);
    if (view->orthographic == 0) {
        double one = ldexp(1, (int)p->weight_shift);
        uint32_t weight = ((uint32_t)v.z << p->weight_shift) + p->weight_offset;
        worst_note(&e->weight, (weight / one - steps) / (slack + 1 / one), "m %.9g of %.9g..%.9g", m,
                   view->z_near / UNIT, view->z_far / UNIT);
    }
    if ((v.flags & OUTSIDE) != 0)
        return;
    worst_note(&e->screen, v.x - 64 * f * eye[0] / UNIT / per, "x %d m %.9g focal %g", eye[0], per, f);
    worst_note(&e->screen, v.y + 64 * f * eye[1] / UNIT / per, "y %d m %.9g focal %g", eye[1], per, f);
}

static void note_views(struct screen_errors *e, int orthographic, uint32_t seed)
{
    uint32_t state = seed;

    for (int i = 0; i < VIEWS; i++) {
        struct sheen_view view;
        struct projection p;
        unsigned height = random_view(&view, &state, orthographic);
        double f = focal(&view, height);
        assert_int_equal(sheen_project_begin(&p, &view, WIDTH, height), SHEEN_OK);
        for (int k = 0; k < 1000; k++) {
            double m = k == 0 ? view.z_near : k == 1 ? view.z_far : stage_uniform(&state, view.z_near, view.z_far);
            double per = (orthographic ? view.orthographic : m) / f;
            sheen_q24_t eye[3] = {0, 0, -(sheen_q24_t)m};
            for (int j = 0; j < 2; j++)
                eye[j] = (sheen_q24_t)fmax(-INT32_MAX, fmin(INT32_MAX, per * stage_uniform(&state, -520, 520)));
            note_projection(e, &p, &view, f, eye);
        }
    }
}

static void test_perspective(void **unused)
{
    struct screen_errors e;

    (void)unused;
    memset(&e, 0, sizeof e);
    note_views(&e, 0, 2);
    worst_assert(&e.screen, 0.52, "screen coordinates, 1/64 px");
    worst_assert(&e.depth, 1, "z16 in tolerances");
    worst_assert(&e.weight, 1, "weights in tolerances");
}

static void test_orthographic(void **unused)
{
    struct screen_errors e;

    (void)unused;
    memset(&e, 0, sizeof e);
    note_views(&e, 1, 3);
    worst_assert(&e.screen, 0.52, "orthographic screen coordinates, 1/64 px");
    worst_assert(&e.depth, 1, "orthographic z16 in tolerances");
}

/* ---- flags ---- */

static unsigned flags_at(const struct projection *p, int32_t x, int32_t y, int32_t m, struct vertex *v)
{
    const sheen_q24_t eye[3] = {x, y, -m};

    sheen_project(p, eye, v);
    return v->flags & OUTSIDE;
}

static void test_flags_at_near_and_far(void **unused)
{
    uint32_t state = 4;
    struct vertex v;

    (void)unused;
    for (int i = 0; i < VIEWS; i++) {
        struct sheen_view view;
        struct projection p;
        unsigned height = random_view(&view, &state, i % 3 == 0);
        assert_int_equal(sheen_project_begin(&p, &view, WIDTH, height), SHEEN_OK);
        assert_int_equal(flags_at(&p, 0, 0, view.z_near, &v), 0);
        assert_true(abs(v.z - (DEPTH_FAR + DEPTH_RANGE)) <= 1);
        assert_int_equal(flags_at(&p, 0, 0, view.z_near - 1, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, 0, 0, -view.z_near, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, INT32_MAX, -INT32_MAX, 0, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, 0, 0, view.z_far, &v), 0);
        assert_int_equal(v.z, DEPTH_FAR);
        assert_int_equal(flags_at(&p, 0, 0, view.z_far + 1, &v), OUTSIDE_FAR);
        assert_int_equal(flags_at(&p, INT32_MAX, -INT32_MAX, INT32_MAX, &v), OUTSIDE_FAR);
    }
}

/* Planes as close to each other as they may be: depth stays in its range, and is far's at far. */
static void test_depth_of_thin_views(void **unused)
{
    uint32_t state = 7;
    int most = 0;

    (void)unused;
    for (int i = 0; i < 300000; i++) {
        sheen_q24_t far = (int32_t)(stage_random(&state) >> (1 + stage_random(&state) % 28)) | 2;
        int32_t span = (int32_t)(((int64_t)far + 32767) >> 15) + (int32_t)(stage_random(&state) % 3);
        struct sheen_view view = {.fov = SHEEN_DEGREES(40), .z_near = far - span, .z_far = far};
        struct projection p;
        struct vertex v;
        if (view.z_near <= 0)
            continue;
        assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 240), SHEEN_OK);
        for (int k = 0; k < 4; k++) {
            int32_t m = k == 0 ? far : k == 1 ? view.z_near : far - (int32_t)(stage_random(&state) % (uint32_t)span);
            assert_int_equal(flags_at(&p, 0, 0, m, &v), 0);
            assert_in_range(v.z, DEPTH_FAR, DEPTH_FAR + DEPTH_RANGE + 16);
            assert_true(k != 0 || v.z == DEPTH_FAR);
            most = v.z > most ? v.z : most;
        }
    }
    print_message("           z16 at most %d over far's range\n", most - DEPTH_FAR - DEPTH_RANGE);
}

/* The last coordinate along (dx, dy) that is inside lies at the guard band, the next one beyond it. */
static void check_guard(const struct projection *p, double f, int32_t m, int dx, int dy, unsigned expected)
{
    int32_t inside = 0, outside = INT32_MAX;
    struct vertex v;

    while (outside - inside > 1) {
        int32_t middle = inside + (outside - inside) / 2;
        if (flags_at(p, dx * middle, dy * middle, m, &v) == 0)
            inside = middle;
        else
            outside = middle;
    }
    if (inside == INT32_MAX - 1)
        return; /* the guard band is wider than the coordinates */
    assert_int_equal(flags_at(p, dx * inside, dy * inside, m, &v), 0);
    assert_int_equal(abs(dx != 0 ? v.x : v.y), GUARD_BAND);
    assert_true(64 * f * inside / m < GUARD_BAND + 0.52);
    assert_int_equal(flags_at(p, dx * outside, dy * outside, m, &v), expected);
    assert_true(64 * f * outside / m > GUARD_BAND + 0.48);
}

static void test_flags_at_the_guard_band(void **unused)
{
    uint32_t state = 5;

    (void)unused;
    for (int i = 0; i < VIEWS; i++) {
        struct sheen_view view;
        struct projection p;
        unsigned height = random_view(&view, &state, 0);
        double f = focal(&view, height);
        assert_int_equal(sheen_project_begin(&p, &view, WIDTH, height), SHEEN_OK);
        int32_t m = (int32_t)stage_uniform(&state, view.z_near, view.z_far);
        if (64 * f / m > 0.5)
            continue; /* a raw step of the eye would step over a coordinate */
        check_guard(&p, f, m, 1, 0, OUTSIDE_RIGHT);
        check_guard(&p, f, m, -1, 0, OUTSIDE_LEFT);
        check_guard(&p, f, m, 0, 1, OUTSIDE_TOP);
        check_guard(&p, f, m, 0, -1, OUTSIDE_BOTTOM);
    }
}

/* Whatever lies in the volume or beyond has a defined result, and the flags of far coordinates do not wrap round. */
static void test_any_eye_coordinates(void **unused)
{
    uint32_t state = 6;

    (void)unused;
    for (int i = 0; i < 200000; i++) {
        struct sheen_view view = {.fov = SHEEN_DEGREES(1) + stage_random(&state) % SHEEN_DEGREES(149)};
        struct projection p;
        struct vertex v;
        view.z_near = (int32_t)(stage_random(&state) >> (1 + stage_random(&state) % 31)) | 1;
        view.z_far = (int32_t)(stage_random(&state) >> (1 + stage_random(&state) % 31)) | 1;
        int height = 1 + (int)(stage_random(&state) % 640), least = min32(height, 2 * 255);
        if (sheen_project_begin(&p, &view, WIDTH, (unsigned)height) < 0)
            continue;
        sheen_q24_t eye[3];
        for (int k = 0; k < 3; k++)
            eye[k] = (int32_t)((int64_t)(int32_t)stage_random(&state) >> stage_random(&state) % 31);
        eye[1] = max32(eye[1], -INT32_MAX); /* what sheen_transform_begin promises */
        sheen_project(&p, eye, &v);
        if (eye[2] == INT32_MIN || -eye[2] < view.z_near || -eye[2] > view.z_far)
            assert_true(v.flags == OUTSIDE_NEAR || v.flags == OUTSIDE_FAR);
        else
            assert_true(((v.flags & OUTSIDE_RIGHT) == 0 || eye[0] > 0) &&
                        ((v.flags & OUTSIDE_LEFT) == 0 || eye[0] < 0) && ((v.flags & OUTSIDE_TOP) == 0 || eye[1] > 0) &&
                        ((v.flags & OUTSIDE_BOTTOM) == 0 || eye[1] < 0));
        if ((v.flags & OUTSIDE) == 0)
            assert_true(abs(v.x) <= GUARD_BAND && abs(v.y) <= GUARD_BAND);
        if ((v.flags & (OUTSIDE_NEAR | OUTSIDE_FAR)) == 0)
            assert_int_equal((v.flags & OFF_VIEW) != 0, abs(v.x) > 64 * WIDTH / 2 || abs(v.y) > 64 * least / 2);
    }
}

/* ---- views ---- */

static void test_views_out_of_range(void **unused)
{
    const struct sheen_view good = {.fov = SHEEN_DEGREES(40), .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(2)};
    struct sheen_view view = good;
    struct projection p;

    (void)unused;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_OK);
    view.fov = SHEEN_DEGREES(1);
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_OK);
    view.fov = SHEEN_DEGREES(150);
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_OK);
    view.fov = SHEEN_DEGREES(0.9);
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.fov = SHEEN_DEGREES(150.1);
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.fov = 1;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view = good;
    view.z_near = -1;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.z_near = view.z_far;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.z_near = view.z_far - (view.z_far >> 15);
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_OK);
    view.z_near++;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.z_near = 65534; /* far / 2^15 is a little under 2 raw steps, so one is too few */
    view.z_far = 65535;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
    view.z_near = 65533;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_OK);
    view = good;
    view.orthographic = -1;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 100), SHEEN_ERR_ARGUMENT);
}

/* Zero is a default, whatever the other fields are. */
static void test_defaults(void **unused)
{
    const struct sheen_view zero = {.fov = 0};
    const struct sheen_view said = {.fov = SHEEN_DEGREES(40), .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(16)};
    struct projection p, q;

    (void)unused;
    memset(&p, 0, sizeof p);
    memset(&q, 0, sizeof q);
    assert_int_equal(sheen_project_begin(&p, &zero, WIDTH, 240), SHEEN_OK);
    assert_int_equal(sheen_project_begin(&q, &said, WIDTH, 240), SHEEN_OK);
    assert_memory_equal(&p, &q, sizeof p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_model_to_eye),          cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_perspective),           cmocka_unit_test(test_orthographic),
        cmocka_unit_test(test_flags_at_near_and_far), cmocka_unit_test(test_flags_at_the_guard_band),
        cmocka_unit_test(test_depth_of_thin_views),   cmocka_unit_test(test_any_eye_coordinates),
        cmocka_unit_test(test_views_out_of_range),    cmocka_unit_test(test_defaults),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
