/*
 * test_core_pose.c - orbits, compositions and look-at against double precision.
 *
 * Tolerances in raw steps: an entry of an orbit's rotation 6 of Q1.30 (5.8 seen in 6 x 10^6 poses); rows of a look-at
 * orthonormal within 16 of Q1.30, its target on the axis within 3 of Q7.24 and 2^-27 of the distance; compositions
 * 1 of Q1.30 and 1 of Q7.24 a unit of scale.
 */
#include "test_core_worst.h"

#include "frame_stage.h"
#include "sheen.h"

#define ONE 1073741824.0 /* Q1.30 */
#define TURN 4294967296.0
#define PI 3.14159265358979323846

static void product(const double a[9], const double b[9], double out[9])
{
    for (int i = 0; i < 9; i++)
        out[i] = a[i / 3 * 3] * b[i % 3] + a[i / 3 * 3 + 1] * b[3 + i % 3] + a[i / 3 * 3 + 2] * b[6 + i % 3];
}

/* Rz(roll) Rx(pitch) Ry(yaw), each counter-clockwise seen from its positive axis. */
static void test_orbit(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 4;

    (void)unused;
    for (int i = 0; i < 50000; i++) {
        sheen_angle_t angle[3];
        double c[3], s[3], xy[9], exact[9];
        for (int k = 0; k < 3; k++) {
            angle[k] = (i & 1) != 0 ? stage_random(&state) : (stage_random(&state) & 7u) << 29;
            c[k] = cos(2 * PI * angle[k] / TURN);
            s[k] = sin(2 * PI * angle[k] / TURN);
        }
        const double y[9] = {c[0], 0, s[0], 0, 1, 0, -s[0], 0, c[0]};
        const double x[9] = {1, 0, 0, 0, c[1], -s[1], 0, s[1], c[1]};
        const double z[9] = {c[2], -s[2], 0, s[2], c[2], 0, 0, 0, 1};
        product(x, y, xy);
        product(z, xy, exact);
        struct sheen_pose pose;
        sheen_pose_orbit(&pose, angle[0], angle[1], angle[2], SHEEN_Q24(3.25));
        for (int k = 0; k < 9; k++)
            worst_note(&worst, pose.rotation[k] - exact[k] * ONE, "entry %d of yaw %08x pitch %08x roll %08x", k,
                       angle[0], angle[1], angle[2]);
        assert_int_equal(pose.scale, 1 << 16);
        assert_true(pose.translation[0] == 0 && pose.translation[1] == 0);
        assert_int_equal(pose.translation[2], -SHEEN_Q24(3.25));
    }
    worst_assert(&worst, 6, "orbit");
}

static double dot(const sheen_q30_t *a, const sheen_q30_t *b)
{
    return ((double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2]) / ONE;
}

/* The eye comes to the origin, the target onto the axis before it, up into the upper half; rows stay unit vectors. */
static void test_look_at(void **unused)
{
    struct worst rows = {0}, place = {0};
    uint32_t state = 5;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        sheen_q24_t eye[3], target[3];
        int32_t up[3];
        for (int k = 0; k < 3; k++) {
            eye[k] = (int32_t)stage_random(&state) >> (2 + i % 9);
            target[k] = (int32_t)stage_random(&state) >> (2 + i % 9);
            up[k] = (int32_t)stage_random(&state) >> (i % 20);
        }
        if (i % 4 == 0) /* nearly along the view */
            for (int k = 0; k < 3; k++)
                up[k] = (eye[k] - target[k]) / 2 + up[k] / (1 << 15);
        struct sheen_pose pose;
        int error = sheen_pose_look_at(&pose, eye, target, up);
        if (error == SHEEN_ERR_DEGENERATE && i % 4 == 0)
            continue;
        assert_int_equal(error, SHEEN_OK);
        assert_int_equal(pose.scale, 1 << 16);
        double away[3], seen[3], length = 0;
        for (int k = 0; k < 3; k++) {
            const sheen_q30_t *row = pose.rotation + 3 * k;
            worst_note(&rows, dot(row, row) - ONE, "length of row %d, case %d", k, i);
            worst_note(&rows, dot(row, pose.rotation + (3 * k + 3) % 9), "angle of row %d, case %d", k, i);
            away[k] = (double)target[k] - eye[k];
            length += away[k] * away[k];
        }
        length = sqrt(length);
        for (int k = 0; k < 3; k++) { /* units of 2^-24 */
            const sheen_q30_t *row = pose.rotation + 3 * k;
            seen[k] = (row[0] * (double)target[0] + row[1] * (double)target[1] + row[2] * (double)target[2]) / ONE +
                      pose.translation[k];
            worst_note(&place, (seen[k] + (k == 2 ? length : 0)) / (1 + length * 0x1p-27), "case %d", i);
        }
        assert_true(
            pose.rotation[3] * (double)up[0] + pose.rotation[4] * (double)up[1] + pose.rotation[5] * (double)up[2] > 0);
    }
    worst_assert(&rows, 16, "look-at: rows orthonormal");
    worst_assert(&place, 3, "look-at: target straight ahead");
}

static void test_look_at_errors(void **unused)
{
    const sheen_q24_t here[3] = {SHEEN_Q24(1), 0, 0}, there[3] = {0, 0, 0};
    const sheen_q24_t far[3] = {INT32_MAX, INT32_MAX, INT32_MAX};
    const int32_t up[3] = {0, 1, 0}, along[3] = {-5, 0, 0}, zero[3] = {0, 0, 0};
    struct sheen_pose pose = {.scale = 77};

    (void)unused;
    assert_int_equal(sheen_pose_look_at(&pose, here, there, along), SHEEN_ERR_DEGENERATE);
    assert_int_equal(sheen_pose_look_at(&pose, here, there, zero), SHEEN_ERR_DEGENERATE);
    assert_int_equal(sheen_pose_look_at(&pose, here, here, up), SHEEN_ERR_DEGENERATE);
    assert_int_equal(sheen_pose_look_at(&pose, far, there, up), SHEEN_ERR_ARGUMENT);
    assert_int_equal(pose.scale, 77);
    assert_int_equal(sheen_pose_look_at(&pose, here, there, up), SHEEN_OK);
}

/* A point moved by inner and then by outer is where the composition takes it. */
static void test_compose(void **unused)
{
    struct worst rotation = {0}, translation = {0};
    uint32_t state = 6;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        struct sheen_pose outer, inner, both;
        sheen_pose_orbit(&outer, stage_random(&state), stage_random(&state), stage_random(&state), SHEEN_Q24(3));
        sheen_pose_orbit(&inner, stage_random(&state), stage_random(&state), stage_random(&state), SHEEN_Q24(-2));
        outer.scale = (sheen_q16_t)(1 + stage_random(&state) % (4 << 16));
        inner.scale = (sheen_q16_t)(65536 + stage_random(&state) % (4 << 16));
        for (int k = 0; k < 3; k++)
            inner.translation[k] += (int32_t)stage_random(&state) >> 8;
        assert_int_equal(sheen_pose_compose(&outer, &inner, &both), SHEEN_OK);
        assert_int_equal(both.scale, (sheen_q16_t)floor((double)outer.scale * inner.scale / 65536 + 0.5));
        for (int k = 0; k < 3; k++) {
            const sheen_q30_t *row = outer.rotation + 3 * k;
            double moved = 0;
            for (int j = 0; j < 3; j++) {
                const sheen_q30_t column[3] = {inner.rotation[j], inner.rotation[3 + j], inner.rotation[6 + j]};
                worst_note(&rotation, both.rotation[3 * k + j] - dot(row, column), "entry %d, case %d", 3 * k + j, i);
                moved += row[j] / ONE * inner.translation[j];
            }
            moved = moved * outer.scale / 65536 + outer.translation[k];
            worst_note(&translation, (both.translation[k] - moved) / (1 + outer.scale / 65536.), "%d, case %d", k, i);
        }
    }
    worst_assert(&rotation, 1, "composed rotation");
    worst_assert(&translation, 1, "composed translation");
}

static void test_compose_errors(void **unused)
{
    struct sheen_pose big, small, out = {.scale = 77};

    (void)unused;
    sheen_pose_identity(&big);
    sheen_pose_identity(&small);
    big.scale = INT32_MAX;
    small.scale = 2 << 16;
    assert_int_equal(sheen_pose_compose(&big, &small, &out), SHEEN_ERR_ARGUMENT);
    small.scale = 1; /* 2^-16: the product rounds to 1/2 or more of a step */
    assert_int_equal(sheen_pose_compose(&big, &small, &big), SHEEN_OK); /* out may be outer */
    assert_int_equal(big.scale, 32768);
    big.scale = 100;
    assert_int_equal(sheen_pose_compose(&big, &small, &out), SHEEN_ERR_ARGUMENT); /* scale 0 */
    sheen_pose_identity(&big);
    sheen_pose_identity(&small);
    big.translation[1] = SHEEN_Q24(100);
    small.translation[1] = SHEEN_Q24(27);
    assert_int_equal(sheen_pose_compose(&big, &small, &out), SHEEN_OK);
    assert_int_equal(out.translation[1], SHEEN_Q24(127));
    small.translation[1] = SHEEN_Q24(28);
    assert_int_equal(sheen_pose_compose(&big, &small, &out), SHEEN_ERR_ARGUMENT);
    assert_int_equal(out.translation[1], SHEEN_Q24(127));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit),   cmocka_unit_test(test_look_at),        cmocka_unit_test(test_look_at_errors),
        cmocka_unit_test(test_compose), cmocka_unit_test(test_compose_errors),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
