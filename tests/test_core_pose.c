/*
 * test_core_pose.c - orbits, compositions and look-at against double precision.
 *
 * Tolerances in raw steps: an entry of an orbit's rotation 6 of Q1.30 (5.8 seen in 6 x 10^6 poses); rows of a look-at,
 * of a composition and of a repaired pose orthonormal within 16 of Q1.30; a look-at's target on the axis within 3 of
 * Q7.24 and 2^-27 of the distance, its axis within 6 of Q1.30; compositions 12 of Q1.30 and 0.51 of Q7.24.
 */
#include <string.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "math/fixed.h"
#include "math/pose.h"

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

static void note_rows(struct worst *worst, const struct sheen_pose *pose, int number)
{
    for (int k = 0; k < 3; k++) {
        const sheen_q30_t *row = pose->rotation + 3 * k;
        worst_note(worst, dot(row, row) - ONE, "length of row %d, case %d", k, number);
        worst_note(worst, dot(row, pose->rotation + (3 * k + 3) % 9), "angle of row %d, case %d", k, number);
    }
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
        note_rows(&rows, &pose, i);
        for (int k = 0; k < 3; k++) {
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

/* However near each other eye and target are, and wherever, the axis is the line between them. */
static void test_look_at_any_distance(void **unused)
{
    struct worst axis = {0};
    uint32_t state = 7;
    int most = 0;

    (void)unused;
    for (int i = 0; i < 200000; i++) {
        sheen_q24_t eye[3], target[3];
        int32_t up[3];
        double away[3], length = 0;
        for (int k = 0; k < 3; k++) {
            eye[k] = (int32_t)stage_random(&state) >> (i % 3 == 0 ? 1 : i % 32);
            int64_t there = eye[k] + (int64_t)((int32_t)stage_random(&state) >> (i / 32 % 32)) * (1 + i % 2);
            target[k] = (int32_t)(there > INT32_MAX ? INT32_MAX : there < INT32_MIN ? INT32_MIN : there);
            up[k] = (int32_t)stage_random(&state);
            away[k] = (double)eye[k] - target[k];
            length += away[k] * away[k];
        }
        struct sheen_pose pose;
        int error = sheen_pose_look_at(&pose, eye, target, up);
        if (error == SHEEN_ERR_ARGUMENT)
            continue; /* more than 128 units from the origin */
        assert_int_equal(error, length == 0 ? SHEEN_ERR_DEGENERATE : SHEEN_OK);
        for (int k = 0; k < 3 && error == SHEEN_OK; k++)
            worst_note(&axis, pose.rotation[6 + k] - away[k] / sqrt(length) * ONE, "case %d, distance %g", i, length);
        most += error == SHEEN_OK;
    }
    worst_assert(&axis, 6, "look-at: the axis");
    assert_true(most > 100000);
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

/* ---- repair ---- */

/* Rows of any length, up to 60 degrees from right angles to each other, some mirrored. */
static void test_orthonormalize(void **unused)
{
    struct worst rows = {0}, third = {0};
    uint32_t state = 8;

    (void)unused;
    for (int i = 0; i < 50000; i++) {
        struct sheen_pose pose, was;
        double length = 0;
        sheen_pose_orbit(&pose, stage_random(&state), stage_random(&state), stage_random(&state), SHEEN_Q24(3));
        was = pose;
        for (int k = 0; k < 9; k++) {
            int32_t off = (int32_t)stage_random(&state) >> (3 + i % 28);
            was.rotation[k] = asr32(pose.rotation[k], i / 3 % (k > 2 ? 6 : 30)) + (k == i % 9 ? 0 : off / 8);
            was.rotation[k] *= k < 3 && i % 2 != 0 ? -1 : 1;
        }
        pose = was;
        assert_int_equal(sheen_pose_orthonormalize(&pose), SHEEN_OK);
        assert_true(pose.scale == was.scale && memcmp(pose.translation, was.translation, sizeof was.translation) == 0);
        note_rows(&rows, &pose, i);
        for (int k = 6; k < 9; k++)
            length += (double)was.rotation[k] * was.rotation[k];
        for (int k = 6; k < 9; k++)
            worst_note(&third, pose.rotation[k] - was.rotation[k] / sqrt(length) * ONE, "case %d", i);
        assert_true(sheen_is_rotation(pose.rotation, 1 << 20));
        assert_true(dot(pose.rotation + 3, was.rotation + 3) > 0);
    }
    worst_assert(&rows, 16, "repaired rows");
    worst_assert(&third, 6, "the third row's direction");
}

static void test_orthonormalize_keeps_the_hand(void **unused)
{
    struct sheen_pose pose = {.rotation = {-(1 << 30), 5, 9, 0, 1 << 30, 0, 0, 0, 1 << 30}, .scale = 3};

    (void)unused;
    assert_int_equal(sheen_pose_orthonormalize(&pose), SHEEN_OK);
    assert_true(pose.rotation[0] == -(1 << 30) && pose.rotation[4] == 1 << 30 && pose.rotation[8] == 1 << 30);
    pose.rotation[5] = pose.rotation[8];
    pose.rotation[4] = 0;
    assert_int_equal(sheen_pose_orthonormalize(&pose), SHEEN_ERR_DEGENERATE);
    pose.rotation[5] = 0;
    assert_int_equal(sheen_pose_orthonormalize(&pose), SHEEN_ERR_DEGENERATE);
    assert_true(pose.rotation[0] == -(1 << 30) && pose.rotation[8] == 1 << 30 && pose.scale == 3);
}

/* ---- compositions ---- */

/* Small turns one after another, as of an object that a hand turns: every one is taken, the last as the first. */
static void test_compositions_do_not_drift(void **unused)
{
    static const double turn[2][3] = {{6.1, 3.3, 1.7}, {0.01, -0.02, 0.013}};

    (void)unused;
    for (int i = 0; i < 2; i++) {
        struct sheen_pose step, all;
        struct worst rows = {0};
        sheen_pose_orbit(&step, SHEEN_DEGREES(turn[i][0]), SHEEN_DEGREES(turn[i][1]), SHEEN_DEGREES(turn[i][2]), 0);
        sheen_pose_identity(&all);
        for (int k = 0; k < 2000000; k++) {
            assert_int_equal(sheen_pose_compose(&step, &all, &all), SHEEN_OK);
            if (k % 1000 == 0)
                note_rows(&rows, &all, k);
        }
        worst_assert(&rows, 16, "rows after 2 million turns");
    }
}

/* With rotations by quarter turns everything is a whole number: translations round to nearest, halves up. */
static void test_compose_rounds_once(void **unused)
{
    uint32_t state = 9;

    (void)unused;
    for (int i = 0; i < 200000; i++) {
        struct sheen_pose outer, inner, both;
        sheen_pose_identity(&inner);
        sheen_pose_identity(&outer);
        for (int k = 0; k < 3; k++) { /* rows 1, 2, 0 */
            outer.rotation[3 * k + k] = 0;
            outer.rotation[3 * k + (k + 1) % 3] = 1 << 30;
            inner.translation[k] = (int32_t)stage_random(&state) >> (i % 32);
        }
        outer.scale = i % 4 == 0 ? 1 << (i / 4 % 17) : (int32_t)(1 + stage_random(&state) % (1u << (1 + i % 18)));
        if (sheen_pose_compose(&outer, &inner, &both) != SHEEN_OK)
            continue; /* beyond +-128 units */
        for (int k = 0; k < 3; k++)
            assert_int_equal(both.translation[k],
                             asr64((int64_t)inner.translation[(k + 1) % 3] * outer.scale + (1 << 15), 16));
    }
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
            worst_note(&translation, both.translation[k] - moved, "%d, case %d", k, i);
        }
    }
    worst_assert(&rotation, 12, "composed rotation");
    worst_assert(&translation, 0.51, "composed translation");
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
    sheen_pose_identity(&small);
    small.rotation[4] += 1 << 20; /* no rotation: its second row is too long */
    assert_int_equal(sheen_pose_compose(&big, &small, &out), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_pose_compose(&small, &big, &out), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_pose_orthonormalize(&small), SHEEN_OK);
    assert_int_equal(sheen_pose_compose(&small, &big, &out), SHEEN_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit),
        cmocka_unit_test(test_look_at),
        cmocka_unit_test(test_look_at_any_distance),
        cmocka_unit_test(test_look_at_errors),
        cmocka_unit_test(test_orthonormalize),
        cmocka_unit_test(test_orthonormalize_keeps_the_hand),
        cmocka_unit_test(test_compositions_do_not_drift),
        cmocka_unit_test(test_compose_rounds_once),
        cmocka_unit_test(test_compose),
        cmocka_unit_test(test_compose_errors),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
