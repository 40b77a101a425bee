/*
 * test_core_transform.c - model to points before the eye to the screen against double precision, and the two forms of
 * the products that it takes against each other.
 *
 * Tolerances: points 6 raw steps of Q7.24, or of 2^-24 scale / 16 where the mesh is larger than 16 units;
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

/* The factor from x and y in the eye's space to those of a transformed point. */
static double shrunk(const struct projection *p)
{
    return p->focal.mantissa / 4294967296.0;
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

/* ---- model to points ---- */

static void note_points(struct worst *worst, const struct projection *p, uint32_t *state)
{
    const double factor[3] = {shrunk(p), -shrunk(p), -1};
    struct sheen_pose pose;
    struct transform t;
    struct sheen_mesh mesh = {.scale = (int32_t)(stage_random(state) >> (2 + stage_random(state) % 24)) + 1};

    sheen_pose_orbit(&pose, stage_random(state), stage_random(state), stage_random(state), 0);
    pose.scale = (int32_t)(stage_random(state) >> (8 + stage_random(state) % 16)) + 1;
    for (int k = 0; k < 3; k++) {
        mesh.offset[k] = (int32_t)stage_random(state) >> (3 + stage_random(state) % 16);
        pose.translation[k] = (int32_t)stage_random(state) >> (3 + stage_random(state) % 16);
    }
    if (sheen_transform_begin(&t, p, &mesh, &pose) != SHEEN_OK)
        return; /* beyond +-128 units: test_ranges */
    double scale = pose.scale / 65536., step = fmax(1, scale * mesh.scale / UNIT / 16);
    for (int i = 0; i < 50; i++) {
        int16_t raw[3];
        for (int k = 0; k < 3; k++)
            raw[k] = (int16_t)(i < 8 ? (i >> k & 1) != 0 ? 32767 : -32768 : (int16_t)stage_random(state));
        struct point point = sheen_transform_point(&t, raw);
        const int32_t found[3] = {point.x, point.y, point.m};
        for (int k = 0; k < 3; k++) {
            double exact = pose.translation[k];
            for (int j = 0; j < 3; j++)
                exact += scale * pose.rotation[3 * k + j] / 1073741824. *
                         (mesh.offset[j] + (double)mesh.scale * raw[j] / 32768);
            worst_note(worst, (ldexp(found[k], k < 2 ? -(int)t.fine : 0) - factor[k] * exact) / step / (1 + scale / 4),
                       "mesh scale %d, pose scale %d", mesh.scale, pose.scale);
        }
    }
}

static void test_model_to_points(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 1;
    struct sheen_view view;
    struct projection p;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        unsigned height = random_view(&view, &state, i % 2);
        assert_int_equal(sheen_project_begin(&p, &view, WIDTH, height), SHEEN_OK);
        note_points(&worst, &p, &state);
    }
    worst_assert(&worst, 6, "points");
    assert_true(worst.count > 100000);
}

/* Scales must be positive, and everything must stay within +-128 units of the eye. */
static void test_ranges(void **unused)
{
    struct sheen_mesh mesh = {.scale = 1 << 24};
    const struct sheen_view view = {.fov = 0};
    struct projection p;
    struct sheen_pose pose;
    struct transform t;

    (void)unused;
    assert_int_equal(sheen_project_begin(&p, &view, WIDTH, 240), SHEEN_OK);
    sheen_pose_identity(&pose);
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_OK);
    mesh.scale = 0;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    mesh.scale = -1;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    mesh.scale = 1 << 24;
    pose.scale = 0;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = INT32_MIN;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = 1;
    mesh.scale = 65535; /* their product is below a raw step */
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.scale = INT32_MAX;
    mesh.scale = INT32_MAX;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);

    sheen_pose_identity(&pose);
    mesh.scale = 1 << 24;
    pose.translation[2] = INT32_MAX - (2 << 24);
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_OK);
    pose.translation[2]++;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
    pose.translation[2] = -INT32_MAX + (2 << 24);
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_OK);
    pose.translation[2]--;
    assert_int_equal(sheen_transform_begin(&t, &p, &mesh, &pose), SHEEN_ERR_ARGUMENT);
}

/* ---- eye to screen ---- */

struct screen_errors {
    struct worst screen, depth, weight;
};

/* As many bits as x, y of up to `most` leave room for, as in sheen_transform_begin. */
static unsigned fine_for(const struct projection *p, double most)
{
    int fine = (int)clz32((uint32_t)fmin(most, INT32_MAX)) - 1;

    return (unsigned)min32(fine, 8 + p->focal.exponent + (int)clz32((uint32_t)p->far));
}

static int shift_for(const struct projection *p, unsigned fine)
{
    return 22 - p->focal.exponent + (int)fine;
}

/* x, y: of the eye's, y down, raw steps. */
static void note_projection(struct screen_errors *e, const struct projection *p, const struct sheen_view *view,
                            double f, double x, double y, int32_t raw_m)
{
    unsigned fine = fine_for(p, 2 + fmax(fabs(x), fabs(y)) * shrunk(p));
    double one = ldexp(shrunk(p), (int)fine);
    const struct point point = {(int32_t)lround(x * one), (int32_t)lround(y * one), raw_m};
    struct vertex v;
    double m = point.m / UNIT, per = view->orthographic != 0 ? view->orthographic / UNIT : m;

    sheen_project(p, shift_for(p, fine), &point, &v);
    if ((v.flags & (OUTSIDE_NEAR | OUTSIDE_FAR)) != 0)
        return;
    /* steps: depth / m, of which z16 is the upper part; unit: near far / (far - near) in raw steps */
    double unit = (double)view->z_near * view->z_far / ((double)view->z_far - view->z_near),
           steps = DEPTH_RANGE * unit / UNIT / m;
    double slack = view->orthographic != 0 ? 0.505 : 0.505 + steps * 0x1p-27 + steps / unit;
    worst_note(&e->depth, (v.z - exact_depth(view, m)) / slack, "m %.9g of %.9g..%.9g", m, view->z_near / UNIT,
               view->z_far / UNIT);
    if (view->orthographic == 0) {
        double shifted = ldexp(1, (int)p->weight_shift);
        uint32_t weight = ((uint32_t)v.z << p->weight_shift) + p->weight_offset;
        worst_note(&e->weight, (weight / shifted - steps) / (slack + 1 / shifted), "m %.9g of %.9g..%.9g", m,
                   view->z_near / UNIT, view->z_far / UNIT);
    }
    if ((v.flags & OUTSIDE) != 0)
        return;
    f /= one;
    worst_note(&e->screen, v.x - 64 * f * point.x / UNIT / per, "x %d m %.9g focal %g", point.x, per, f);
    worst_note(&e->screen, v.y - 64 * f * point.y / UNIT / per, "y %d m %.9g focal %g", point.y, per, f);
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
            double x = per * stage_uniform(&state, -520, 520), y = per * stage_uniform(&state, -520, 520);
            note_projection(e, &p, &view, f, fmax(-INT32_MAX, fmin(INT32_MAX, x)), fmax(-INT32_MAX, fmin(INT32_MAX, y)),
                            (int32_t)m);
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

static unsigned flags_at(const struct projection *p, unsigned fine, int32_t x, int32_t y, int32_t m, struct vertex *v)
{
    const struct point point = {x, y, m};

    sheen_project(p, shift_for(p, fine), &point, v);
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
        assert_int_equal(flags_at(&p, 0, 0, 0, view.z_near, &v), 0);
        assert_true(abs(v.z - (DEPTH_FAR + DEPTH_RANGE)) <= 1);
        assert_int_equal(flags_at(&p, 0, 0, 0, view.z_near - 1, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, 0, 0, 0, -view.z_near, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, 0, INT32_MAX, -INT32_MAX, 0, &v), OUTSIDE_NEAR);
        assert_int_equal(flags_at(&p, 0, 0, 0, view.z_far, &v), 0);
        assert_int_equal(v.z, DEPTH_FAR);
        assert_int_equal(flags_at(&p, 0, 0, 0, view.z_far + 1, &v), OUTSIDE_FAR);
        assert_int_equal(flags_at(&p, 0, INT32_MAX, -INT32_MAX, INT32_MAX, &v), OUTSIDE_FAR);
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
            assert_int_equal(flags_at(&p, 0, 0, 0, m, &v), 0);
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
    unsigned fine = fine_for(p, 520.0 * m / f * shrunk(p));
    int32_t inside = 0, outside = INT32_MAX;
    struct vertex v;

    while (outside - inside > 1) {
        int32_t middle = inside + (outside - inside) / 2;
        if (flags_at(p, fine, dx * middle, dy * middle, m, &v) == 0)
            inside = middle;
        else
            outside = middle;
    }
    f /= ldexp(shrunk(p), (int)fine);
    if (inside == INT32_MAX - 1)
        return; /* the guard band is wider than the coordinates */
    assert_int_equal(flags_at(p, fine, dx * inside, dy * inside, m, &v), 0);
    assert_int_equal(abs(dx != 0 ? v.x : v.y), GUARD_BAND);
    assert_true(64 * f * inside / m < GUARD_BAND + 0.52);
    assert_int_equal(flags_at(p, fine, dx * outside, dy * outside, m, &v), expected);
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
        check_guard(&p, f, m, 0, -1, OUTSIDE_TOP);
        check_guard(&p, f, m, 0, 1, OUTSIDE_BOTTOM);
    }
}

/* Whatever lies in the volume or beyond has a defined result, and the flags of far coordinates do not wrap round. */
static void test_any_point(void **unused)
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
        int32_t any[3];
        for (int k = 0; k < 3; k++)
            any[k] = (int32_t)((int64_t)(int32_t)stage_random(&state) >> stage_random(&state) % 31);
        const struct point point = {any[0], any[1], any[2]};
        sheen_project(&p, shift_for(&p, stage_random(&state) % (1 + fine_for(&p, 1))), &point, &v);
        if (point.m < view.z_near || point.m > view.z_far)
            assert_int_equal(v.flags, point.m < view.z_near ? OUTSIDE_NEAR : OUTSIDE_FAR);
        else
            assert_true(
                ((v.flags & OUTSIDE_RIGHT) == 0 || point.x > 0) && ((v.flags & OUTSIDE_LEFT) == 0 || point.x < 0) &&
                ((v.flags & OUTSIDE_TOP) == 0 || point.y < 0) && ((v.flags & OUTSIDE_BOTTOM) == 0 || point.y > 0));
        if ((v.flags & OUTSIDE) == 0)
            assert_true(abs(v.x) <= GUARD_BAND && abs(v.y) <= GUARD_BAND);
        if ((v.flags & (OUTSIDE_NEAR | OUTSIDE_FAR)) == 0)
            assert_int_equal((v.flags & OFF_VIEW) != 0, abs(v.x) > 64 * WIDTH / 2 || abs(v.y) > 64 * least / 2);
    }
}

/* ---- both forms of the products ---- */

/* A random number of random length, or one at an end of its range. */
static uint32_t any_length(uint32_t *state)
{
    uint32_t choice = stage_random(state) % 40, word = stage_random(state) >> choice % 32;

    return choice == 0 ? 0 : choice == 1 ? UINT32_MAX : choice == 2 ? 1u << 31 : choice == 3 ? INT32_MAX : word;
}

static void test_wide_and_halves(void **unused)
{
    uint32_t state = 8;

    (void)unused;
    for (int i = 0; i < 3000000; i++) {
        uint32_t n = any_length(&state) & 0xffffu, v = any_length(&state);
        int32_t s = (int32_t)((stage_random(&state) & 1) != 0 ? v : 0u - v);
        assert_int_equal(wide_share(n, v), halves_share(n, v));
        assert_int_equal(wide_part((int16_t)n, s), halves_part((int16_t)n, s));
        assert_int_equal(wide_share(n, v), (uint64_t)n * v >> 16);
        assert_int_equal(wide_signed_share(n, s), halves_signed_share(n, s));
        assert_int_equal(wide_signed_share(n, s), asr64((int64_t)n * s, 17));
        const int32_t h = (int32_t)any_length(&state);
        assert_int_equal(wide_high(h, s), halves_high(h, s));
        const int32_t c = max32(-(1 << 30), min32(h, 1 << 30)), d = max32(-(1 << 30), min32(s, 1 << 30));
        assert_int_equal(wide_cosines(c, d), halves_cosines(c, d));
        assert_int_equal(sheen_mul_round(h, s, 1 + n % 32), mul_round(h, s, 1 + n % 32));
    }
    for (int i = 0; i < 3000000; i++) {
        const double most = 0x1p29 * 1.0009; /* rows are as long, if they are rotated by what sheen_is_rotation takes */
        struct wide_row wide;
        struct halves_row halves;
        double row[3] = {stage_uniform(&state, -1, 1), stage_uniform(&state, -1, 1), stage_uniform(&state, -1, 1)};
        double length = sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
        int32_t p[3], m[3];
        for (int k = 0; k < 3; k++) {
            double part = i % 8 == 0 ? (k == i / 8 % 3 ? most : 0) : most * row[k] / length;
            m[k] = (int32_t)fmax(1 - 0x1p29, fmin(part, 0x1p29 - 1));
            p[k] = i % 5 == 0   ? (m[k] < 0 ? -32768 : 32767)
                   : i % 5 == 1 ? (m[k] < 0 ? 32767 : -32768)
                                : (int16_t)stage_random(&state);
            wide_row_set(&wide, k, m[k]);
            halves_row_set(&halves, k, m[k]);
        }
        int64_t sum = (int64_t)m[0] * p[0] + (int64_t)m[1] * p[1] + (int64_t)m[2] * p[2];
        assert_int_equal(wide_row_times(&wide, p[0], p[1], p[2]), asr64(sum, 14));
        assert_int_equal(halves_row_times(&halves, p[0], p[1], p[2]), asr64(sum, 14));
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
        cmocka_unit_test(test_model_to_points),       cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_perspective),           cmocka_unit_test(test_orthographic),
        cmocka_unit_test(test_flags_at_near_and_far), cmocka_unit_test(test_flags_at_the_guard_band),
        cmocka_unit_test(test_depth_of_thin_views),   cmocka_unit_test(test_any_point),
        cmocka_unit_test(test_views_out_of_range),    cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_wide_and_halves),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
