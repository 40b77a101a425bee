/*
 * test_core_angles.c - the interior angles of polygons, against exact products in long double, and what they are
 * for: averages that do not hang on how a polygon was cut.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "sheen.h"
#include "simple_polygon.h"

#define TURN 4294967296.0
#define COUNT 12 /* corners of a polygon, at most */

static const uint32_t in_order[COUNT] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

static long double length(long double x, long double y, long double z)
{
    return sqrtl(x * x + y * y + z * z);
}

/* The angle of three points at the middle one, raw steps, from products without rounding (below 2^61). */
static double angle_at(const int32_t *before, const int32_t *here, const int32_t *after)
{
    int64_t u[3], v[3];

    for (int k = 0; k < 3; k++) {
        u[k] = (int64_t)before[k] - here[k];
        v[k] = (int64_t)after[k] - here[k];
    }
    long double cross = length((long double)(u[1] * v[2] - u[2] * v[1]), (long double)(u[2] * v[0] - u[0] * v[2]),
                               (long double)(u[0] * v[1] - u[1] * v[0]));
    long double dot = (long double)(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
    return (double)(atan2l(cross, dot) / acosl(-1) * (TURN / 2));
}

/* A part of a point: over all sizes, at the ends of the range, or zero. */
static int32_t any_part(uint32_t *state)
{
    uint32_t how = stage_random(state) % 8;
    int32_t value = (int32_t)stage_random(state) >> (3 + (how < 5 ? stage_random(state) % 28 : 0));

    return how == 5 ? 0 : how == 6 ? (value < 0 ? -(1 << 28) : 1 << 28) : value;
}

/* Triangles of every shape: edges from 1 to 2^29 long, needles, straight corners, two points at one place. */
static void test_angles_of_triangles(void **unused)
{
    static const uint32_t three = 3;
    struct worst worst = {0};
    uint32_t state = 9, zero = 0;

    (void)unused;
    for (int round = 0; round < 1000000; round++) {
        int32_t p[9];
        sheen_angle_t got[3];
        sheen_q30_t normal[3] = {0, 0, 0};
        const struct sheen_polygon_list list = {p, in_order, &three, 3, 3, 1};

        for (int i = 0; i < 9; i++)
            p[i] = any_part(&state);
        if (round % 4 == 0) /* the third point beside the line of the others, within it and beyond */
            for (int k = 0; k < 3; k++)
                p[6 + k] =
                    (int32_t)((p[k] * (int64_t)(round % 7) + p[3 + k] * (7 - (int64_t)(round % 7))) / 8) + round % 3;
        (void)sheen_polygon_normal(p, in_order, 3, normal); /* zero for some */
        sheen_corner_angles(&list, normal, got);
        for (int i = 0; i < 3; i++) {
            worst_note(&worst, got[i] - angle_at(p + 3 * ((i + 2) % 3), p + 3 * i, p + 3 * ((i + 1) % 3)),
                       "round %d, corner %d", round, i);
            zero += memcmp(p + 3 * i, p + 3 * ((i + 1) % 3), 3 * sizeof *p) == 0;
        }
    }
    worst_assert(&worst, SHEEN_ANGLE_ROUNDING, "angles");
    assert_true(zero > 0);
}

/* The corners of a quad in a plane, the second one turning right: its angle is beyond half a turn. */
static void test_a_corner_that_turns_right(void **unused)
{
    static const int32_t points[] = {0, 0, 0, 4, 1, 0, 8, 0, 0, 4, 8, 0};
    static const uint32_t four = 4;
    const struct sheen_polygon_list list = {points, in_order, &four, 4, 4, 1};
    sheen_q30_t normal[3];
    sheen_angle_t got[4];

    (void)unused;
    sheen_polygon_normals(&list, normal);
    sheen_corner_angles(&list, normal, got);
    assert_true(got[1] > 0x80000000u && got[0] < 0x80000000u && got[2] < 0x80000000u && got[3] < 0x80000000u);
    assert_true(fabs(got[1] - (TURN - angle_at(points, points + 3, points + 6))) <= SHEEN_ANGLE_ROUNDING);
}

/* However it is cut: at each corner the triangles' angles add up to the polygon's. */
static void test_cutting_changes_no_sum(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 10, right = 0;

    (void)unused;
    for (int round = 0; round < 20000; round++) {
        uint32_t count = 4 + stage_random(&state) % (COUNT - 3), triangles[3 * COUNT], scratch[3 * COUNT];
        uint32_t threes[COUNT];
        int32_t flat[COUNT][2], points[3 * COUNT];
        sheen_q30_t normal[3], facing[3 * COUNT];
        sheen_angle_t whole[COUNT], part[3 * COUNT], sum[COUNT] = {0};

        if (!polygon_make_simple(flat, count, 1u << 27, &state))
            continue;
        for (unsigned i = 0; i < count; i++) {
            memcpy(points + 3 * i, flat[i], sizeof flat[i]);
            points[3 * i + 2] = flat[i][0] + flat[i][1]; /* x, y to a plane that is askew, exactly */
        }
        const struct sheen_polygon_list one = {points, in_order, &count, count, count, 1};
        const struct sheen_polygon_list cut = {points, triangles, threes, count, 3 * (count - 2), count - 2};
        for (unsigned t = 0; t < count - 2; t++)
            threes[t] = 3;
        sheen_polygon_normals(&one, normal);
        assert_int_equal(sheen_triangulate(points, in_order, count, normal, scratch, triangles), SHEEN_OK);
        sheen_corner_angles(&one, normal, whole);
        sheen_polygon_normals(&cut, facing);
        sheen_corner_angles(&cut, facing, part);
        for (unsigned c = 0; c < 3 * (count - 2); c++)
            sum[triangles[c]] += part[c];
        for (unsigned i = 0; i < count; i++) {
            right += whole[i] > 0x80000000u;
            worst_note(&worst, (int32_t)(sum[i] - whole[i]) / (double)(count - 1), "round %d, corner %u of %u", round,
                       i, count);
        }
    }
    worst_assert(&worst, SHEEN_ANGLE_ROUNDING, "sums of angles, a triangle");
    assert_true(right > 1000);
}

/* A cube's corners, its sides cut into triangles one way or the other: weighted they are its diagonals. */
static void test_cubes_however_they_are_cut(void **unused)
{
    static const int32_t points[] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                                     -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    static const uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                                         {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    static const uint32_t threes[12] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
    static const int order[2][6] = {{0, 1, 2, 0, 2, 3}, {1, 2, 3, 1, 3, 0}};
    struct worst worst = {0};
    int uneven = 0;

    (void)unused;
    for (unsigned cuts = 0; cuts < 64; cuts++) {
        uint32_t corners[36], around[SHEEN_AROUND_WORDS(8, 36)];
        sheen_q30_t facing[36], unit[24], equal[24];
        sheen_angle_t angles[36];
        const struct sheen_polygon_list list = {points, corners, threes, 8, 36, 12};

        for (unsigned c = 0; c < 36; c++)
            corners[c] = sides[c / 6][order[cuts >> c / 6 & 1][c % 6]];
        assert_int_equal(sheen_polygons_around(&list, around), SHEEN_OK);
        sheen_polygon_normals(&list, facing);
        sheen_corner_angles(&list, facing, angles);
        sheen_vertex_normals(&list, around, facing, angles, unit);
        sheen_vertex_normals(&list, around, facing, NULL, equal);
        for (int i = 0; i < 24; i++) {
            worst_note(&worst, unit[i] - points[i] * SHEEN_Q30(0.57735026919), "cuts %u, part %d", cuts, i);
            uneven |= abs(equal[i] - points[i] * SHEEN_Q30(0.57735026919)) > 1 << 24;
        }
    }
    worst_assert(&worst, 30, "corners of cubes");
    assert_true(uneven); /* which equal weights do not make */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_angles_of_triangles),
        cmocka_unit_test(test_a_corner_that_turns_right),
        cmocka_unit_test(test_cutting_changes_no_sum),
        cmocka_unit_test(test_cubes_however_they_are_cut),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
