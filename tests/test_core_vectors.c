/*
 * test_core_vectors.c - sines, unit vectors and polygon normals against double precision.
 *
 * Tolerances in raw steps of Q1.30: sine and cosine 2, a part of a unit vector 4 (both as sheen.h says), of a
 * polygon's normal 4, whatever its number of corners.
 */
#include <stdlib.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "sheen.h"

#define ONE 1073741824.0 /* Q1.30 */
#define TURN 4294967296.0
#define PI 3.14159265358979323846

static void test_sine_and_cosine(void **unused)
{
    struct worst sine = {0}, cosine = {0};

    (void)unused;
    for (uint64_t i = 0; i < UINT64_C(1) << 32; i += 2047) { /* an odd step: all low bits */
        sheen_angle_t angle = (sheen_angle_t)i;
        double exact = 2 * PI * (double)angle / TURN;
        worst_note(&sine, sheen_sin(angle) - sin(exact) * ONE, "%08x", angle);
        worst_note(&cosine, sheen_cos(angle) - cos(exact) * ONE, "%08x", angle);
    }
    worst_assert(&sine, 2, "sine");
    worst_assert(&cosine, 2, "cosine");
}

static void test_sine_at_quarters(void **unused)
{
    static const int32_t expected[4] = {0, 1 << 30, 0, -(1 << 30)};

    (void)unused;
    for (uint32_t quarter = 0; quarter < 4; quarter++) {
        assert_int_equal(sheen_sin(quarter << 30), expected[quarter]);
        assert_int_equal(sheen_cos(quarter << 30), expected[(quarter + 1) % 4]);
    }
}

static void note_unit(struct worst *worst, const int32_t v[3])
{
    double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
    sheen_q30_t unit[3];

    assert_int_equal(sheen_normalize(v, unit), SHEEN_OK);
    for (int k = 0; k < 3; k++)
        worst_note(worst, unit[k] - v[k] / length * ONE, "(%d, %d, %d)", v[0], v[1], v[2]);
}

static void test_normalize(void **unused)
{
    static const int32_t ends[] = {0, 1, -1, 3, 46341, 1 << 30, INT32_MAX, -INT32_MAX, INT32_MIN};
    const int count = (int)(sizeof ends / sizeof ends[0]);
    struct worst worst = {0};
    uint32_t state = 1;

    (void)unused;
    for (int i = 1; i < count * count * count; i++) {
        const int32_t v[3] = {ends[i % count], ends[i / count % count], ends[i / count / count]};
        note_unit(&worst, v);
    }
    for (int i = 0; i < 300000; i++) {
        unsigned length = stage_random(&state) % 31;
        int32_t v[3];
        for (int k = 0; k < 3; k++)
            v[k] = (int32_t)stage_random(&state) >> (length + (k > 0 ? stage_random(&state) % (32 - length) : 0));
        if (v[0] != 0)
            note_unit(&worst, v);
    }
    worst_assert(&worst, 4, "unit vector");
}

static void test_zero_has_no_direction(void **unused)
{
    const int32_t zero[3] = {0, 0, 0};
    sheen_q30_t unit[3] = {1, 2, 3};

    (void)unused;
    assert_int_equal(sheen_normalize(zero, unit), SHEEN_ERR_DEGENERATE);
    assert_int_equal(unit[0] * 100 + unit[1] * 10 + unit[2], 123);
}

/* ---- Newell ---- */

#define MOST 300

struct polygon {
    int32_t point[3 * MOST];
    uint32_t corner[MOST];
    unsigned count;
};

/* Newell's sum in long double, cyclic and from the first corner, as the lecture has it. */
static void newell(const struct polygon *p, double normal[3])
{
    long double sum[3] = {0, 0, 0}, length = 0;
    const int32_t *origin = p->point + 3 * p->corner[0];

    for (unsigned i = 0; i < p->count; i++) {
        const int32_t *a = p->point + 3 * p->corner[i], *b = p->point + 3 * p->corner[(i + 1) % p->count];
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            sum[k] += ((long double)a[u] - b[u]) * ((long double)a[v] - origin[v] + b[v] - origin[v]);
        }
    }
    for (int k = 0; k < 3; k++)
        length += sum[k] * sum[k];
    for (int k = 0; k < 3; k++)
        normal[k] = (double)(sum[k] / sqrtl(length));
}

/* A regular polygon of this radius, turned about all axes, its corners listed in a shuffled store. */
static void regular(struct polygon *p, unsigned count, double radius, uint32_t *state)
{
    struct sheen_pose pose;
    double turn = stage_uniform(state, 0, 2 * PI), offset[3];

    sheen_pose_orbit(&pose, stage_random(state), stage_random(state), stage_random(state), 0);
    for (int k = 0; k < 3; k++)
        offset[k] = stage_uniform(state, -0.5, 0.5) * radius;
    p->count = count;
    for (unsigned i = 0; i < count; i++) {
        double x = radius / 2 * cos(turn + 2 * PI * i / count), y = radius / 2 * sin(turn + 2 * PI * i / count);
        p->corner[i] = (i * 7 + 3) % count; /* count is no multiple of 7 */
        for (int k = 0; k < 3; k++)
            p->point[3 * p->corner[i] + (uint32_t)k] =
                (int32_t)lrint(offset[k] + (pose.rotation[3 * k] * x + pose.rotation[3 * k + 1] * y) / ONE);
    }
}

static void note_polygon(struct worst *worst, const struct polygon *p)
{
    double exact[3];
    sheen_q30_t normal[3];

    newell(p, exact);
    assert_int_equal(sheen_polygon_normal(p->point, p->corner, p->count, normal), SHEEN_OK);
    for (int k = 0; k < 3; k++)
        worst_note(worst, normal[k] - exact[k] * ONE, "%u corners, first (%d, %d, %d)", p->count,
                   p->point[3 * p->corner[0]], p->point[3 * p->corner[0] + 1], p->point[3 * p->corner[0] + 2]);
}

static void test_polygons_of_every_size(void **unused)
{
    static const unsigned counts[] = {3, 4, 5, 6, 8, 9, 10, 12, 20, 100, 300};
    struct worst few = {0}, many = {0};
    uint32_t state = 2;

    (void)unused;
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++)
        for (double radius = 5; radius <= 1 << 28; radius *= 1.7) {
            struct polygon p;
            regular(&p, counts[c], radius, &state);
            note_polygon(counts[c] <= 8 ? &few : &many, &p);
        }
    worst_assert(&few, 4, "up to 8 corners");
    worst_assert(&many, 4, "more corners");
}

/* Corners at the ends of the range that sheen.h gives, so that differences are 2^29 and terms largest. */
static void test_polygons_at_the_ends_of_the_range(void **unused)
{
    struct worst few = {0}, many = {0};
    const int32_t end = 1 << 28;
    uint32_t state = 3;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        struct polygon p = {.count = i % 2 != 0 ? 8 : 3 + stage_random(&state) % (MOST - 3)};
        double exact[3];
        for (unsigned k = 0; k < p.count; k++) {
            p.corner[k] = k;
            for (unsigned j = 0; j < 3; j++)
                p.point[3 * k + j] = (stage_random(&state) & 256) != 0 ? end : -end;
        }
        newell(&p, exact);
        if (isnan(exact[0]) || p.count < 3)
            continue; /* no area */
        note_polygon(p.count <= 8 ? &few : &many, &p);
    }
    worst_assert(&few, 4, "up to 8 corners, +-2^28");
    worst_assert(&many, 4, "more corners, +-2^28");
}

/* A square wound round and round, its corners at the ends of the range: every term has the same sign. */
static void test_polygons_that_wind_many_times(void **unused)
{
    const int32_t end = 1 << 28;
    struct polygon p;

    (void)unused;
    for (uint32_t axis = 0; axis < 3; axis++)
        for (p.count = 4; p.count <= MOST; p.count += 4) {
            sheen_q30_t normal[3];
            for (uint32_t k = 0; k < p.count; k++) {
                p.corner[k] = k;
                p.point[3 * k + axis] = end;
                p.point[3 * k + (axis + 1) % 3] = k % 4 == 1 || k % 4 == 2 ? end : -end;
                p.point[3 * k + (axis + 2) % 3] = k % 4 >= 2 ? end : -end;
            }
            assert_int_equal(sheen_polygon_normal(p.point, p.corner, p.count, normal), SHEEN_OK);
            for (uint32_t k = 0; k < 3; k++)
                assert_true(abs(normal[k] - (k == axis ? 1 << 30 : 0)) <= 4);
        }
}

static void test_orientation_and_collinear_corners(void **unused)
{
    /* an L, its first three corners on one line; seen from +z counter-clockwise */
    static const int32_t points[] = {0, 0, 5, 10, 0, 5, 20, 0, 5, 20, 10, 5, 10, 10, 5, 10, 30, 5, 0, 30, 5};
    static const uint32_t forth[] = {0, 1, 2, 3, 4, 5, 6}, back[] = {6, 5, 4, 3, 2, 1, 0};
    static const uint32_t triangle[] = {0, 2, 3}, line[] = {0, 1, 2}, twice[] = {0, 2, 3, 0, 3, 2};
    sheen_q30_t normal[3] = {7, 7, 7};

    (void)unused;
    assert_int_equal(sheen_polygon_normal(points, line, 3, normal), SHEEN_ERR_DEGENERATE);
    assert_int_equal(sheen_polygon_normal(points, twice, 6, normal), SHEEN_ERR_DEGENERATE);
    assert_true(normal[0] == 7 && normal[1] == 7 && normal[2] == 7);
    assert_int_equal(sheen_polygon_normal(points, forth, 7, normal), SHEEN_OK);
    assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == 1 << 30);
    assert_int_equal(sheen_polygon_normal(points, triangle, 3, normal), SHEEN_OK);
    assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == 1 << 30);
    assert_int_equal(sheen_polygon_normal(points, back, 7, normal), SHEEN_OK);
    assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == -(1 << 30));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sine_and_cosine),
        cmocka_unit_test(test_sine_at_quarters),
        cmocka_unit_test(test_normalize),
        cmocka_unit_test(test_zero_has_no_direction),
        cmocka_unit_test(test_polygons_of_every_size),
        cmocka_unit_test(test_polygons_at_the_ends_of_the_range),
        cmocka_unit_test(test_polygons_that_wind_many_times),
        cmocka_unit_test(test_orientation_and_collinear_corners),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
