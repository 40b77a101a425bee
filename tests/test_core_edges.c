/*
 * test_core_edges.c - which edges are sharp: none at exactly the crease angle, however the normals were rounded, and
 * all where it is exceeded by more than rounding.
 */
#include <string.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "sheen.h"

#define ONE 1073741824.0 /* Q1.30 */
#define HALF_TURN 3.14159265358979323846
#define ROUNDS 20000

/* Two triangles side by side; what counts are the normals of their polygons. */
static const int16_t positions[12] = {0, 0, 0, 100, 0, 0, 0, 100, 0, 100, 100, 0};
static const uint8_t indices[6] = {0, 1, 2, 2, 1, 3};

static int is_sharp(const int16_t normals[6], sheen_q30_t crease)
{
    const struct sheen_mesh mesh = {.positions = positions,
                                    .polygon_normals = normals,
                                    .indices = indices,
                                    .index_bytes = 1,
                                    .vertices = 4,
                                    .triangles = 2,
                                    .scale = 1 << 24};
    uint32_t scratch[SHEEN_EDGES_WORDS(4, 2)];
    struct sheen_triangle_edges edges[2];

    sheen_mesh_edges(&mesh, crease, scratch, edges);
    assert_int_equal(edges[0].across[1], 1);
    assert_int_equal(edges[1].across[0], 0);
    assert_int_equal(edges[0].sharp >> 1 & 1, edges[1].sharp & 1);
    return edges[1].sharp & 1;
}

static void random_unit(double v[3], uint32_t *state)
{
    double square;

    do {
        square = 0;
        for (int k = 0; k < 3; k++) {
            v[k] = stage_uniform(state, -1, 1);
            square += v[k] * v[k];
        }
    } while (square > 1 || square < 0.01);
    for (int k = 0; k < 3; k++)
        v[k] /= sqrt(square);
}

/* Unit vectors `angle` apart, in any direction. */
static void random_pair(double a[3], double b[3], double angle, uint32_t *state)
{
    double across[3], along = 0, square = 0;

    random_unit(a, state);
    do {
        random_unit(across, state);
        along = a[0] * across[0] + a[1] * across[1] + a[2] * across[2];
    } while (fabs(along) > 0.9);
    for (int k = 0; k < 3; k++) {
        across[k] -= along * a[k];
        square += across[k] * across[k];
    }
    for (int k = 0; k < 3; k++)
        b[k] = cos(angle) * a[k] + sin(angle) * across[k] / sqrt(square);
}

static void round_nearest(const double v[3], int16_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int16_t)lround(32767 * v[k]);
}

/* The neighbour whose direction is nearest, as importers choose it: it may be longer or shorter by over a step. */
static void round_direction(const double v[3], int16_t out[3])
{
    double best = -2;

    for (int corner = 0; corner < 8; corner++) {
        double q[3], along = 0, square = 0;
        for (int k = 0; k < 3; k++) {
            q[k] = fmin(floor(32767 * v[k]) + (corner >> k & 1), 32767);
            along += q[k] * v[k];
            square += q[k] * q[k];
        }
        if (along / sqrt(square) <= best)
            continue;
        best = along / sqrt(square);
        for (int k = 0; k < 3; k++)
            out[k] = (int16_t)q[k];
    }
}

static const double degrees[] = {0, 1, 5, 12, 20, 30, 36, 45, 60, 72, 90, 120, 150, 179, 180};

/* crease: its cosine exceeds that of the angle by `more`. Returns how many of ROUNDS edges are sharp. */
static int count_sharp(double angle, double more, void (*rounded)(const double *, int16_t *), uint32_t *state)
{
    int sharp = 0;

    for (int i = 0; i < ROUNDS; i++) {
        double a[3], b[3];
        int16_t normals[6];
        random_pair(a, b, angle, state);
        rounded(a, normals);
        rounded(b, normals + 3);
        sharp += is_sharp(normals, (sheen_q30_t)lround(ONE * cos(angle) + more));
    }
    return sharp;
}

static void edges_at_the_crease_are_not_sharp(void **unused)
{
    uint32_t state = 1;

    (void)unused;
    for (size_t i = 0; i < sizeof degrees / sizeof degrees[0]; i++) {
        const double angle = degrees[i] / 180 * HALF_TURN;
        int nearest = count_sharp(angle, 0, round_nearest, &state),
            direction = count_sharp(angle, 0, round_direction, &state);
        if (nearest + direction > 0)
            fail_msg("at %g degrees %d and %d of %d edges are sharp", degrees[i], nearest, direction, ROUNDS);
    }
}

/* 65,536 of slack and 56,757 of rounding. */
static void edges_beyond_the_crease_are_sharp(void **unused)
{
    uint32_t state = 2;

    (void)unused;
    for (size_t i = 0; i < sizeof degrees / sizeof degrees[0]; i++) {
        const double angle = degrees[i] / 180 * HALF_TURN;
        if (ONE * cos(angle) + 122300 > ONE)
            continue;
        assert_int_equal(count_sharp(angle, 122300, round_nearest, &state), ROUNDS);
        assert_int_equal(count_sharp(angle, 122300, round_direction, &state), ROUNDS);
    }
}

/* What has the largest errors: components near half a step, all to the same side. */
static void halves_are_within_the_slack(void **unused)
{
    uint32_t state = 3;

    (void)unused;
    for (int i = 0; i < ROUNDS; i++) {
        int16_t normals[6];
        double a[3], b[3], angle = stage_uniform(&state, 0, HALF_TURN), square = 0, cosine = 0;
        random_pair(a, b, angle, &state);
        for (int k = 0; k < 3; k++) {
            a[k] = floor(32767 * a[k]) + 0.499;
            b[k] = floor(32767 * b[k]) + 0.499;
        }
        for (int k = 0; k < 3; k++) {
            cosine += a[k] * b[k];
            normals[k] = (int16_t)lround(a[k]);
            normals[3 + k] = (int16_t)lround(b[k]);
        }
        square = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
        assert_int_equal(is_sharp(normals, (sheen_q30_t)lround(fmin(fmax(cosine / sqrt(square), -1), 1) * ONE)), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_at_the_crease_are_not_sharp),
                                       cmocka_unit_test(edges_beyond_the_crease_are_sharp),
                                       cmocka_unit_test(halves_are_within_the_slack)};

    return cmocka_run_group_tests_name("core_edges", tests, NULL, NULL);
}
