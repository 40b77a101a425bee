/*
 * test_core_averages.c - normals of polygons at the ends of the range, and their averages around vertices.
 *
 * Tolerance of an average, raw steps of Q1.30: a part of each unit normal is off by 4, so that of a sum of n by 4 n,
 * which its length divides; the normalisation adds 4.
 */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "reference/ref_split.h"
#include "sheen.h"

#define ONE 1073741824.0 /* Q1.30 */

/* ---- Newell where its sum exceeds 64 bits ---- */

/* The exact sum, cyclic. */
static void newell(const int32_t *points, unsigned count, int128 sum[3])
{
    for (int k = 0; k < 3; k++) {
        int u = (k + 1) % 3, v = (k + 2) % 3;
        sum[k] = 0;
        for (unsigned i = 0; i < count; i++) {
            const int32_t *a = points + 3 * i, *b = points + 3 * ((i + 1) % count);
            sum[k] += (int128)a[u] * b[v] - (int128)a[v] * b[u];
        }
    }
}

static const uint32_t in_order[32] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
                                      16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};

/* The outline returns the way it went, except for one step at a corner: large terms cancel to a few units. */
static void test_slivers_at_the_ends_of_the_range(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 5;

    (void)unused;
    for (int round = 0; round < 30000; round++) {
        unsigned half = 2 + stage_random(&state) % 14, count = 2 * half, steps = stage_random(&state) % 4;
        int32_t points[3 * 32];
        int128 sum[3];
        sheen_q30_t normal[3] = {7, 7, 7};

        for (unsigned i = 0; i < half; i++)
            for (unsigned k = 0; k < 3; k++)
                points[3 * i + k] = points[3 * (count - 1 - i) + k] = (int32_t)stage_random(&state) >> 3; /* +-2^28 */
        for (; steps > 0; steps--)
            points[stage_random(&state) % (3 * count)] += (int32_t)(stage_random(&state) % 3) - 1;
        newell(points, count, sum);
        int got = sheen_polygon_normal(points, in_order, count, normal);
        if (sum[0] == 0 && sum[1] == 0 && sum[2] == 0) {
            assert_int_equal(got, SHEEN_ERR_DEGENERATE);
            assert_true(normal[0] == 7 && normal[1] == 7 && normal[2] == 7);
            continue;
        }
        assert_int_equal(got, SHEEN_OK);
        double length = sqrt(pow((double)sum[0], 2) + pow((double)sum[1], 2) + pow((double)sum[2], 2));
        for (int k = 0; k < 3; k++)
            worst_note(&worst, normal[k] - (double)sum[k] / length * ONE, "round %d, %u corners", round, count);
    }
    worst_assert(&worst, 4, "slivers");
}

/* ---- lists ---- */

#define POINTS 24
#define POLYGONS 60
#define CORNERS (6 * POLYGONS)

struct soup {
    struct sheen_polygon_list list;
    int32_t points[3 * POINTS];
    uint32_t corners[CORNERS], sizes[POLYGONS], around[SHEEN_AROUND_WORDS(POINTS, CORNERS)];
    sheen_q30_t facing[3 * POLYGONS], vertex[3 * POINTS], corner[3 * CORNERS];
    double exact[POLYGONS][3];
};

/* Polygons of 3 to 6 random corners, a point at times listed twice; all of it a function of the state. */
static void make_soup(struct soup *s, uint32_t *state)
{
    uint32_t c = 0;

    for (unsigned i = 0; i < 3 * POINTS; i++)
        s->points[i] = (int32_t)stage_random(state) >> 3;
    for (unsigned p = 0; p < POLYGONS; p++) {
        s->sizes[p] = 3 + stage_random(state) % 4;
        for (unsigned i = 0; i < s->sizes[p]; i++)
            s->corners[c++] = stage_random(state) % POINTS;
    }
    s->list = (struct sheen_polygon_list){s->points, s->corners, s->sizes, POINTS, c, POLYGONS};
    assert_int_equal(sheen_polygons_around(&s->list, s->around), SHEEN_OK);
    sheen_polygon_normals(&s->list, s->facing);
    sheen_vertex_normals(&s->list, s->around, s->facing, NULL, s->vertex);
    for (unsigned p = 0, first = 0; p < POLYGONS; first += s->sizes[p++]) {
        double position[6][3];
        for (unsigned i = 0; i < s->sizes[p]; i++)
            for (unsigned k = 0; k < 3; k++)
                position[i][k] = s->points[3 * s->corners[first + i] + k];
        ref_newell((const double(*)[3])position, s->sizes[p], s->exact[p]);
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* One average against double precision, its polygons found anew. 0 where one lies too near the crease to tell. */
static int note_average(struct worst *worst, const struct soup *s, uint32_t v, int own, double crease,
                        const uint32_t *weights, const sheen_q30_t *got)
{
    double sum[3] = {0, 0, 0}, all = 0, around = 0;
    unsigned n = 0;

    for (unsigned p = 0, c = 0; p < POLYGONS; p++)
        for (uint32_t end = c + s->sizes[p]; c < end; c++) {
            around += weights && s->corners[c] == v ? weights[c] : 0;
            double cosine = own < 0 ? 1 : dot(s->exact[own], s->exact[p]);
            if (s->corners[c] != v || (cosine < crease - 1e-6 && (int)p != own))
                continue;
            if (cosine < crease + 1e-6 && (int)p != own)
                return 0;
            double weight = weights ? weights[c] : 1;
            for (int k = 0; k < 3; k++)
                sum[k] += s->exact[p][k] * weight;
            all += weight;
            n++;
        }
    double length = sqrt(dot(sum, sum));
    if (n == 0 || length <= 1e-6 * all)
        return 0;
    /* Weights of a sum beyond 2^32 lose bits. */
    double cut = 2 * n * fmax(around, 4294967296.0) / 4294967296.0 * (weights != NULL);
    for (int k = 0; k < 3; k++)
        worst_note(worst, (got[k] - sum[k] / length * ONE) / (4 + (4 * 1.7321 * all + cut * ONE) / length),
                   "vertex %u of %u", v, n);
    return 1;
}

/* Weights: none, the corners' angles, and any 32 bits. */
static void averages_of_random_polygons(int with)
{
    static struct soup s;
    static uint32_t numbers[CORNERS];
    struct worst vertices = {0}, corners = {0};
    uint32_t state = 6, left_out = 0, all = 0;
    const uint32_t *weights = with ? numbers : NULL;

    for (int round = 0; round < 150; round++) {
        make_soup(&s, &state);
        sheen_corner_angles(&s.list, s.facing, numbers);
        for (unsigned c = 0; with > 1 && c < CORNERS; c++)
            numbers[c] = stage_random(&state) >> stage_random(&state) % 2;
        sheen_vertex_normals(&s.list, s.around, s.facing, weights, s.vertex);
        for (uint32_t v = 0; v < POINTS; v++)
            note_average(&vertices, &s, v, -1, -2, weights, s.vertex + 3 * v);
        sheen_q30_t crease = (int32_t)stage_random(&state) >> 1;
        sheen_corner_normals(&s.list, s.around, s.facing, weights, crease, s.corner);
        for (unsigned p = 0, c = 0; p < POLYGONS; p++)
            for (uint32_t end = c + s.sizes[p]; c < end; c++, all++)
                left_out += dot(s.exact[p], s.exact[p]) == 0 ||
                            !note_average(&corners, &s, s.corners[c], (int)p, crease / ONE, weights, s.corner + 3 * c);
    }
    worst_assert(&vertices, 1, "vertex normals, parts of what is allowed");
    worst_assert(&corners, 1, "corner normals, parts of what is allowed");
    assert_true(left_out * 10 < all); /* most of them triangles with two corners at one point */
}

static void test_averages_of_random_polygons(void **unused)
{
    (void)unused;
    for (int with = 0; with < 3; with++)
        averages_of_random_polygons(with);
}

/* A crease of 180 degrees leaves out nothing: each corner has its vertex's normal, to the bit. */
static void test_all_within_is_the_vertex_normal(void **unused)
{
    static struct soup s;
    uint32_t state = 7;

    (void)unused;
    make_soup(&s, &state);
    sheen_corner_normals(&s.list, s.around, s.facing, NULL, SHEEN_Q30(-1.0), s.corner);
    for (unsigned p = 0, c = 0; p < POLYGONS; p++)
        for (uint32_t end = c + s.sizes[p]; c < end; c++)
            if (dot(s.exact[p], s.exact[p]) > 0)
                assert_memory_equal(s.corner + 3 * c, s.vertex + 3 * s.corners[c], 3 * sizeof(sheen_q30_t));
}

/* Neighbouring faces of a rhombic dodecahedron, here three around (1, 1, 1), meet at exactly 60 degrees. */
static void test_a_crease_includes_its_own_angle(void **unused)
{
    static const int32_t points[] = {1, 1, 1, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 1, -1, 1, -1, 1, -1, 1, 1};
    static const uint32_t corners[] = {1, 4, 2, 0, 2, 6, 3, 0, 3, 5, 1, 0}, sizes[] = {4, 4, 4};
    const struct sheen_polygon_list list = {points, corners, sizes, 7, 12, 3};
    uint32_t around[SHEEN_AROUND_WORDS(7, 12)];
    sheen_q30_t facing[9], normal[36];

    (void)unused;
    assert_int_equal(sheen_polygons_around(&list, around), SHEEN_OK);
    sheen_polygon_normals(&list, facing);
    for (uint32_t turns = 0; turns < 2; turns++) { /* by the cosine, and by the angle */
        sheen_corner_normals(&list, around, facing, NULL, turns ? sheen_cos(SHEEN_DEGREES(60)) : SHEEN_Q30(0.5),
                             normal);
        for (int c = 3; c < 12; c += 4)
            for (int k = 0; k < 3; k++)
                assert_true(abs(normal[3 * c + k] - SHEEN_Q30(0.57735026919)) <= 6);
    }
    sheen_corner_normals(&list, around, facing, NULL, sheen_cos(SHEEN_DEGREES(59.999)), normal);
    for (int c = 0; c < 12; c++)
        assert_memory_equal(normal + 3 * c, facing + 3 * (c / 4), 3 * sizeof *normal);
    sheen_corner_normals(&list, around, facing, NULL, INT32_MAX, normal); /* beyond 1.0: its own always counts */
    assert_memory_equal(normal + 33, facing + 6, 3 * sizeof *normal);
}

/* A triangle seen from both sides, one without area on its first edge, and a point that nothing lists. */
static void test_sums_of_zero(void **unused)
{
    static const int32_t points[] = {0, 0, 0, 9, 0, 0, 0, 9, 3, 18, 0, 0, 5, 5, 5};
    static const uint32_t corners[] = {0, 1, 2, 2, 1, 0, 0, 1, 3}, sizes[] = {3, 3, 3};
    const struct sheen_polygon_list list = {points, corners, sizes, 5, 9, 3};
    uint32_t around[SHEEN_AROUND_WORDS(5, 9)];
    sheen_q30_t facing[9], vertex[15], normal[27], zero[15] = {0};

    (void)unused;
    assert_int_equal(sheen_polygons_around(&list, around), SHEEN_OK);
    sheen_polygon_normals(&list, facing);
    assert_memory_equal(facing + 6, zero, 3 * sizeof *zero);
    sheen_vertex_normals(&list, around, facing, NULL, vertex);
    assert_memory_equal(vertex, zero, sizeof vertex);
    sheen_corner_normals(&list, around, facing, NULL, SHEEN_Q30(-1.0), normal);
    for (int c = 0; c < 9; c++)
        assert_memory_equal(normal + 3 * c, facing + 3 * (c / 3), 3 * sizeof *normal);
}

/* The same with normals that are rounded: what is left of the sum is below its rounding. */
static void test_sides_of_random_triangles_cancel(void **unused)
{
    static const uint32_t corners[] = {0, 1, 2, 2, 1, 0}, sizes[] = {3, 3};
    uint32_t state = 8, around[SHEEN_AROUND_WORDS(3, 6)], rounded = 0;

    (void)unused;
    for (int round = 0; round < 1000; round++) {
        int32_t points[9];
        const struct sheen_polygon_list list = {points, corners, sizes, 3, 6, 2};
        sheen_q30_t facing[6], vertex[9];

        for (int i = 0; i < 9; i++)
            points[i] = (int32_t)stage_random(&state) >> 4;
        assert_int_equal(sheen_polygons_around(&list, around), SHEEN_OK);
        sheen_polygon_normals(&list, facing);
        sheen_vertex_normals(&list, around, facing, NULL, vertex);
        for (int k = 0; k < 3; k++)
            rounded += facing[k] + facing[3 + k] != 0;
        for (int i = 0; i < 9; i++)
            assert_int_equal(vertex[i], 0);
    }
    assert_true(rounded > 0);
}

/* As many triangles as a mesh has, all on three points and seen from both sides: in no time, and as few would be. */
static void test_many_polygons_at_a_point(void **unused)
{
    enum {
        COUNT = 65535
    };
    static uint32_t corners[3 * COUNT], sizes[COUNT], around[SHEEN_AROUND_WORDS(3, 3 * COUNT)];
    static sheen_q30_t facing[3 * COUNT], normal[9 * COUNT];
    static sheen_angle_t angles[3 * COUNT];
    static const int32_t points[] = {0, 0, 0, 9000, 0, 500, 0, 9000, -700};
    const struct sheen_polygon_list list = {points, corners, sizes, 3, 3 * COUNT, COUNT};
    clock_t start = clock();

    (void)unused;
    for (uint32_t p = 0; p < COUNT; p++) {
        sizes[p] = 3;
        for (uint32_t k = 0; k < 3; k++)
            corners[3 * p + k] = (p / 2 + (p % 2 ? 2 - k : k)) % 3;
    }
    assert_int_equal(sheen_polygons_around(&list, around), SHEEN_OK);
    sheen_polygon_normals(&list, facing);
    sheen_corner_angles(&list, facing, angles);
    for (int with = 0; with < 2; with++) {
        sheen_corner_normals(&list, around, facing, with ? angles : NULL, SHEEN_Q30(.5), normal);
        for (uint32_t i = 0; i < 9 * COUNT; i++)
            assert_true(abs(normal[i] - facing[i / 9 * 3 + i % 3]) <= 8);
    }
    assert_true(clock() - start < 20 * CLOCKS_PER_SEC); /* each with each takes minutes */
}

static void test_lists_are_checked(void **unused)
{
    static const int32_t points[] = {0, 0, 0, 9, 0, 0, 0, 9, 0, 9, 9, 0};
    static const uint32_t once[] = {0, 1, 2, 2, 1, 3, 3}, beyond[] = {0, 1, 2, 2, 1, 3, 4};
    static const uint32_t sizes[] = {3, 4}, small[] = {2, 5}, few[] = {3, 3}, many[] = {3, 5},
                          wraps[] = {8, UINT32_MAX};
    static const struct {
        const uint32_t *corners, *sizes;
        int result;
    } expect[] = {{once, sizes, SHEEN_OK},           {beyond, sizes, SHEEN_ERR_ARGUMENT},
                  {once, small, SHEEN_ERR_ARGUMENT}, {once, few, SHEEN_ERR_ARGUMENT},
                  {once, many, SHEEN_ERR_ARGUMENT},  {once, wraps, SHEEN_ERR_ARGUMENT}};
    /* begins of the points' lists, then the lists, of polygons and of corners: point 3 is listed twice by polygon 1 */
    static const uint32_t lists[] = {0, 1, 3, 5, 7, 0, 0, 1, 0, 1, 1, 1, 0, 1, 4, 2, 3, 5, 6};
    uint32_t around[SHEEN_AROUND_WORDS(4, 7)];

    (void)unused;
    for (size_t i = sizeof expect / sizeof expect[0]; i-- > 0;) {
        const struct sheen_polygon_list list = {points, expect[i].corners, expect[i].sizes, 4, 7, 2};
        assert_int_equal(sheen_polygons_around(&list, around), expect[i].result);
    }
    assert_memory_equal(around, lists, sizeof lists);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slivers_at_the_ends_of_the_range),
        cmocka_unit_test(test_averages_of_random_polygons),
        cmocka_unit_test(test_all_within_is_the_vertex_normal),
        cmocka_unit_test(test_a_crease_includes_its_own_angle),
        cmocka_unit_test(test_sums_of_zero),
        cmocka_unit_test(test_sides_of_random_triangles_cancel),
        cmocka_unit_test(test_many_polygons_at_a_point),
        cmocka_unit_test(test_lists_are_checked),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
