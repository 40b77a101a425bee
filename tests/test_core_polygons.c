/*
 * test_core_polygons.c - polygons to triangles: what must hold for every polygon, and what the reference does.
 *
 * Coordinates are integers and so are all judgements: 128 bits hold every sum. Plane polygons are
 * drawn in x and y and then put on an inclined plane by z = a x + b y, which keeps them exactly plane.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "reference/ref_split.h"
#include "sheen.h"
#include "simple_polygon.h"

#define MOST 64
#define GUARD 0xa5a5a5a5u

struct polygon {
    int32_t point[MOST][3];
    uint32_t corner[MOST];
    unsigned count;
    sheen_q30_t normal[3];
    uint32_t triangle[MOST][3]; /* count - 2 of them */
};

/* (b - a) x (c - a) . normal: twice the area seen along the normal, times 2^30. */
static int128 area(const struct polygon *p, uint32_t i, uint32_t j, uint32_t k)
{
    const int32_t *a = p->point[p->corner[i]], *b = p->point[p->corner[j]], *c = p->point[p->corner[k]];
    int128 sum = 0;

    for (int m = 0; m < 3; m++) {
        int u = (m + 1) % 3, v = (m + 2) % 3;
        int128 cross = (int128)(b[u] - a[u]) * (c[v] - a[v]) - (int128)(b[v] - a[v]) * (c[u] - a[u]);
        sum += cross * p->normal[m];
    }
    return sum;
}

/*
 * The polygon's boundary is the triangles' boundary: each of its edges once, and every diagonal once in either
 * direction. Their areas add up to that of the fan, which is the polygon's.
 */
static void check_triangles(const struct polygon *p)
{
    int8_t edges[MOST][MOST] = {{0}};
    int128 sum = 0, whole = 0;

    for (unsigned t = 0; t < p->count - 2; t++) {
        const uint32_t *corner = p->triangle[t];
        for (int k = 0; k < 3; k++) {
            uint32_t from = corner[k], to = corner[(k + 1) % 3];
            assert_true(from < p->count && to < p->count && from != to);
            edges[from][to]++;
            edges[to][from]--;
        }
        sum += area(p, corner[0], corner[1], corner[2]);
        whole += area(p, 0, t + 1, t + 2);
    }
    assert_true(sum == whole);
    for (unsigned i = 0; i < p->count; i++)
        for (unsigned j = 0; j < p->count; j++)
            assert_int_equal(edges[i][j], (j == (i + 1) % p->count) - (i == (j + 1) % p->count));
}

/* Normal and triangles; nothing beyond the scratch and the triangles is written. 0 where it has no area. */
static int triangulate(struct polygon *p)
{
    uint32_t scratch[SHEEN_TRIANGULATE_WORDS(MOST) + 1], *end = scratch + SHEEN_TRIANGULATE_WORDS(p->count);

    memset(p->triangle, GUARD & 255, sizeof p->triangle);
    memset(p->normal, 0, sizeof p->normal);
    *end = GUARD;
    int has_area = sheen_polygon_normal(p->point[0], p->corner, p->count, p->normal) == SHEEN_OK;
    int result = sheen_triangulate(p->point[0], p->corner, p->count, p->normal, scratch, p->triangle[0]);
    assert_int_equal(result, has_area ? SHEEN_OK : SHEEN_ERR_DEGENERATE);
    assert_true(*end == GUARD);
    for (unsigned t = has_area ? p->count - 2 : 0; t < MOST; t++)
        assert_true(p->triangle[t][0] == GUARD && p->triangle[t][2] == GUARD);
    if (has_area)
        check_triangles(p);
    return has_area;
}

/* The points in a shuffled store, the first corner anywhere, x and y on the plane z = a x + b y with axes swapped. */
static void place(struct polygon *p, int32_t (*at)[2], unsigned count, uint32_t *state)
{
    int32_t a = (int32_t)(stage_random(state) % 7) - 3, b = (int32_t)(stage_random(state) % 7) - 3;
    unsigned first = stage_random(state) % count, shift = stage_random(state) % count, z = stage_random(state) % 3;

    p->count = count;
    for (unsigned i = 0; i < count; i++) {
        const int32_t *from = at[(i + first) % count];
        p->corner[i] = (i + shift) % count;
        int32_t *to = p->point[p->corner[i]];
        to[z] = a * from[0] + b * from[1];
        to[(z + 1) % 3] = from[0];
        to[(z + 2) % 3] = from[1];
    }
}

static void check_fan(const struct polygon *p)
{
    for (uint32_t t = 0; t < p->count - 2; t++)
        assert_true(p->triangle[t][0] == 0 && p->triangle[t][1] == t + 1 && p->triangle[t][2] == t + 2);
}

/* As the reference does it in double precision. */
static int is_as_reference(const struct polygon *p)
{
    double position[MOST][3], normal[3];
    uint32_t triangle[MOST][3];

    for (unsigned i = 0; i < p->count; i++)
        for (int k = 0; k < 3; k++)
            position[i][k] = p->point[p->corner[i]][k];
    ref_newell((const double(*)[3])position, p->count, normal);
    return ref_split((const double(*)[3])position, p->count, normal, triangle) == p->count - 2 &&
           memcmp(triangle, p->triangle, (p->count - 2) * sizeof triangle[0]) == 0;
}

/* Area is all there once: no triangle clockwise, so, with the boundary right, none overlaps or lies outside. */
static void check_simple(const struct polygon *p)
{
    for (unsigned t = 0; t < p->count - 2; t++)
        assert_true(area(p, p->triangle[t][0], p->triangle[t][1], p->triangle[t][2]) >= 0);
}

static void test_simple_polygons(void **unused)
{
    static const uint32_t extents[] = {6, 9, 20, 1000, 1 << 26};
    uint32_t state = 1, polygons = 0, fans = 0, compared = 0, differ = 0;

    (void)unused;
    for (int round = 0; round < 20000; round++) {
        unsigned count = 3 + stage_random(&state) % 18;
        int32_t at[MOST][2];
        struct polygon p;

        if (!polygon_make_simple(at, count, extents[round % 5], &state))
            continue;
        place(&p, at, count, &state);
        assert_true(triangulate(&p));
        check_simple(&p);
        polygons++;
        fans += p.triangle[0][0] == 0 && p.triangle[0][1] == 1 && count > 3;
        /* On a slope the reference's rounding decides for three corners in line, as those of a small grid often are. */
        int is_level = (p.normal[0] != 0) + (p.normal[1] != 0) + (p.normal[2] != 0) == 1;
        compared += is_level || round % 5 >= 3;
        differ += (is_level || round % 5 >= 3) && !is_as_reference(&p);
    }
    print_message("           %u simple polygons, %u fans, %u compared\n", polygons, fans, compared);
    assert_true(polygons > 10000 && fans > 1000 && fans < polygons / 2 && compared > 4000);
    assert_int_equal(differ, 0);
}

/* Edges sorted by direction, each again the other way round: convex, and parallel edges make straight corners. */
static void test_convex_polygons_become_fans(void **unused)
{
    static const int32_t directions[][2] = {{1, 0}, {3, 1}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-4, 1}};
    uint32_t state = 2;

    (void)unused;
    for (int round = 0; round < 20000; round++) {
        int32_t at[MOST][2], edge[MOST / 2][2], scale = round % 2 != 0 ? 1 : 1 << 19;
        unsigned half = 0;
        for (unsigned d = 0; d < 9; d++)
            for (unsigned n = stage_random(&state) % 4; n > 0; n--, half++)
                for (int k = 0; k < 2; k++)
                    edge[half][k] = directions[d][k] * scale;
        if (half < 2 || polygon_side((int32_t[2]){0, 0}, edge[0], edge[half - 1]) == 0)
            continue;
        at[0][0] = at[0][1] = 0;
        for (unsigned i = 1; i < 2 * half; i++)
            for (int k = 0; k < 2; k++)
                at[i][k] = at[i - 1][k] + (i <= half ? 1 : -1) * edge[(i - 1) % half][k];
        if (stage_random(&state) % 2 != 0)
            polygon_reverse(at, 0, 2 * half - 1);
        struct polygon p;
        place(&p, at, 2 * half, &state);
        assert_true(triangulate(&p));
        check_fan(&p);
    }
}

/* Every corner off the plane by a little: as the reference, seen along the Newell normal. */
static void test_bent_polygons(void **unused)
{
    uint32_t state = 3, polygons = 0, differ = 0;

    (void)unused;
    for (int round = 0; round < 10000; round++) {
        unsigned count = 4 + stage_random(&state) % 16;
        int32_t at[MOST][2];
        struct polygon p;
        if (!polygon_make_simple(at, count, 1 << 24, &state))
            continue;
        place(&p, at, count, &state);
        for (unsigned i = 0; i < count; i++)
            for (int k = 0; k < 3; k++)
                p.point[i][k] += (int32_t)stage_random(&state) >> 12; /* +-2^19: 1/32 of the extent */
        assert_true(triangulate(&p));
        polygons++;
        differ += !is_as_reference(&p);
    }
    print_message("           %u bent polygons, %u unlike the reference\n", polygons, differ);
    assert_true(polygons > 5000);
    assert_int_equal(differ, 0);
}

/* An extent in which doubles are exact and three random points are seldom in line. */
#define SPARSE 20000

/* The reference has no rule of its own for an edge without length. */
static int lists_twice(const struct polygon *p)
{
    for (unsigned i = 0; i < p->count; i++)
        if (p->corner[i] == p->corner[(i + 1) % p->count])
            return 1;
    return 0;
}

/* Anything: crossing, doubled points, all in line, at the ends of the range, and seen along no normal of its own. */
static void test_every_polygon_is_cut(void **unused)
{
    static const uint32_t extents[] = {2, 3, 5, SPARSE, 1u << 29};
    uint32_t state = 4, flat = 0, compared = 0, differ = 0;

    (void)unused;
    for (int round = 0; round < 30000; round++) {
        struct polygon p = {.count = 3 + stage_random(&state) % 20};
        uint32_t extent = extents[round % 5];
        for (unsigned i = 0; i < p.count; i++) {
            p.corner[i] = stage_random(&state) % MOST;
            for (int k = 0; k < 3; k++)
                p.point[p.corner[i]][k] = (int32_t)(stage_random(&state) % (extent + 1)) - (int32_t)(extent / 2);
        }
        if (round % 3 == 0)
            for (unsigned i = 0; i < MOST; i++)
                p.point[i][2] = 0;
        if (!triangulate(&p)) {
            flat++;
            continue;
        }
        if (round % 3 == 0 && extent == SPARSE && !lists_twice(&p)) {
            compared++;
            differ += !is_as_reference(&p);
        }
        for (int k = 0; k < 3; k++)
            p.normal[k] = (int32_t)stage_random(&state) >> 1;
        uint32_t scratch[SHEEN_TRIANGULATE_WORDS(MOST)];
        assert_int_equal(sheen_triangulate(p.point[0], p.corner, p.count, p.normal, scratch, p.triangle[0]), SHEEN_OK);
        check_triangles(&p);
    }
    print_message("           %u without area, %u compared\n", flat, compared);
    assert_true(flat > 100 && compared > 1000);
    assert_int_equal(differ, 0);
}

struct literal {
    const char *name;
    unsigned count;
    int32_t at[14][2];
    uint32_t triangle[12][3];
    unsigned backwards; /* of them */
};

static const struct literal literals[] = {
    /* Edges 1-2 and 3-0 cross; the lobe at 2 and 3 is the larger one, the other is seen from behind. */
    {"bow-tie", 4, {{0, 0}, {2, 0}, {-3, 5}, {5, 5}}, {{1, 2, 3}, {0, 1, 3}}, 1},
    {"arrow head", 4, {{0, 0}, {10, 0}, {2, 2}, {0, 10}}, {{0, 1, 2}, {0, 2, 3}}, 0},
    {"arrow head, from its tip", 4, {{10, 0}, {2, 2}, {0, 10}, {0, 0}}, {{3, 0, 1}, {1, 2, 3}}, 0},
    /* It turns left everywhere, twice around, and has no second ear: 1 is the first corner then. */
    {"star of five points, in one line",
     5,
     {{0, 100}, {-59, -81}, {95, 31}, {-95, 31}, {59, -81}},
     {{4, 0, 1}, {1, 2, 3}, {1, 3, 4}},
     1},
    /* A square with a square hole, joined by a cut that is listed both ways. */
    {"keyhole",
     10,
     {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 6}, {0, 9}},
     {{2, 3, 4}, {2, 4, 5}, {1, 2, 5}, {1, 5, 6}, {0, 1, 6}, {0, 6, 7}, {9, 0, 7}, {7, 8, 9}},
     0},
    /* Ears are not looked for beyond the point that is shared: one triangle too many, one taken away again. */
    {"squares that share a corner",
     8,
     {{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}},
     {{7, 0, 1}, {7, 1, 2}, {2, 3, 4}, {7, 2, 4}, {7, 4, 5}, {5, 6, 7}},
     1},
    {"spike of no width",
     6,
     {{0, 0}, {4, 0}, {4, 4}, {9, 9}, {4, 4}, {0, 4}},
     {{5, 0, 1}, {5, 1, 2}, {5, 2, 3}, {3, 4, 5}},
     1},
};

static void test_known_polygons(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof literals / sizeof literals[0]; i++) {
        const struct literal *l = &literals[i];
        struct polygon p = {.count = l->count};
        unsigned backwards = 0;
        for (uint32_t c = 0; c < l->count; c++) {
            p.corner[c] = c;
            p.point[c][0] = l->at[c][0];
            p.point[c][1] = l->at[c][1];
        }
        assert_true(triangulate(&p));
        for (unsigned t = 0; t < l->count - 2; t++)
            backwards += area(&p, p.triangle[t][0], p.triangle[t][1], p.triangle[t][2]) < 0;
        if (memcmp(p.triangle, l->triangle, (l->count - 2) * sizeof l->triangle[0]) != 0 || backwards != l->backwards)
            fail_msg("%s: first triangle %u %u %u, %u backwards", l->name, p.triangle[0][0], p.triangle[0][1],
                     p.triangle[0][2], backwards);
        /* Only the sign of what is seen along the normal counts, down to the last bit: any length will do. */
        uint32_t scratch[SHEEN_TRIANGULATE_WORDS(MOST)];
        const sheen_q30_t shortest[3] = {0, 0, p.normal[2] > 0 ? 1 : -1};
        memset(p.triangle, 0, sizeof p.triangle);
        assert_int_equal(sheen_triangulate(p.point[0], p.corner, p.count, shortest, scratch, p.triangle[0]), SHEEN_OK);
        assert_memory_equal(p.triangle, l->triangle, (l->count - 2) * sizeof l->triangle[0]);
    }
}

static void test_bow_tie_of_equal_lobes_has_no_area(void **unused)
{
    struct polygon p = {.count = 4, .point = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, .corner = {0, 1, 2, 3}};

    (void)unused;
    assert_false(triangulate(&p));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_simple_polygons), cmocka_unit_test(test_convex_polygons_become_fans),
        cmocka_unit_test(test_bent_polygons),   cmocka_unit_test(test_every_polygon_is_cut),
        cmocka_unit_test(test_known_polygons),  cmocka_unit_test(test_bow_tie_of_equal_lobes_has_no_area),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
