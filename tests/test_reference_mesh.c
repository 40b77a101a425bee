/*
 * test_reference_mesh.c - the reference's normals, polygons and pixels against numbers worked out by hand.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "reference/ref_split.h"
#include "reference/ref_vector.h"
#include "reference/reference.h"
#include "shapes.h"

#define NEAR(a, b, by) assert_true(fabs((a) - (b)) <= (by))

static const struct ref_mesh_options as_is = {.crease = -1};

static void build(struct ref_mesh *mesh, struct shape *shape, const struct ref_mesh_options *options)
{
    assert_int_equal(ref_mesh_build(mesh, &shape->polygons, options), 0);
}

static void normals_by_hand(void **state)
{
    struct shape s;
    struct ref_mesh mesh;
    struct ref_mesh_options options = {.crease = 50};

    (void)state;
    assert_int_equal(shape_cube(&s), 0);
    build(&mesh, &s, &as_is);
    assert_int_equal(mesh.triangle_count, 12);
    for (size_t c = 0; c < mesh.corner_count; c++) {
        for (int k = 0; k < 3; k++)
            NEAR(mesh.normal[c][k], mesh.position[c][k] / sqrt(3), 1e-12); /* the average of three faces */
    }
    ref_mesh_free(&mesh);
    build(&mesh, &s, &options);
    for (size_t c = 0; c < mesh.corner_count; c++)
        NEAR(ref_dot(mesh.normal[c], mesh.polygon_normal[c / 4]), 1, 1e-12); /* 90 degrees is a crease */
    ref_mesh_free(&mesh);
    options = (struct ref_mesh_options){.fit = true, .crease = -1};
    for (size_t p = 0; p < s.polygons.point_count; p++)
        s.points[p][0] += 100;
    build(&mesh, &s, &options);
    for (size_t c = 0; c < mesh.corner_count; c++)
        NEAR(ref_length(mesh.position[c]), 1, 1e-12);
    ref_mesh_free(&mesh);
    shape_free(&s);
}

/* Cuts a polygon in the plane z = 0 and returns the number of triangles, whose areas must add up to the polygon's. */
static size_t split(const double (*points)[3], size_t count, uint32_t (*out)[3])
{
    double normal[3], whole = 0, sum = 0;

    ref_newell(points, count, normal);
    NEAR(fabs(normal[2]), 1, 1e-12);
    for (size_t i = 0; i < count; i++) {
        const double *a = points[i], *b = points[(i + 1) % count];
        whole += (a[0] * b[1] - b[0] * a[1]) * normal[2];
    }
    size_t made = ref_split(points, count, normal, out);
    for (size_t t = 0; t < made; t++) {
        const double *a = points[out[t][0]], *b = points[out[t][1]], *c = points[out[t][2]];
        double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) * normal[2];
        assert_true(area >= 0);
        sum += area;
    }
    NEAR(sum, whole, 1e-12);
    return made;
}

static void polygons_by_hand(void **state)
{
    static const double straight[5][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    static const double arrow[4][3] = {{0, 0, 0}, {2, -2, 0}, {0, 4, 0}, {-2, -2, 0}};
    static const double comb[8][3] = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0},
                                      {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    uint32_t out[8][3];

    (void)state;
    assert_int_equal(split(straight, 5, out), 3);
    assert_memory_equal(out, ((uint32_t[3][3]){{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}), sizeof(uint32_t[3][3]));
    assert_int_equal(split(arrow, 4, out), 2); /* corner 0 is the notch; the first ear is at 1 */
    assert_memory_equal(out, ((uint32_t[2][3]){{0, 1, 2}, {0, 2, 3}}), sizeof(uint32_t[2][3]));
    assert_int_equal(split(comb, 8, out), 6);
}

static void pixels_by_hand(void **state)
{
    static const int row0[8] = {0, 32, 8, 40, 2, 34, 10, 42}, column0[8] = {0, 48, 12, 60, 3, 51, 15, 63};
    struct ref_scene scene = {.levels = 2, .dither = true};
    bool seen[64] = {false};

    (void)state;
    for (int i = 0; i < 64; i++)
        seen[ref_bayer8(i % 8, i / 8)] = true;
    for (int i = 0; i < 64; i++)
        assert_true(seen[i]);
    for (int i = 0; i < 8; i++) {
        assert_int_equal(ref_bayer8(i, 0), row0[i]);
        assert_int_equal(ref_bayer8(0, i), column0[i]);
    }
    assert_int_equal(ref_565((double[3]){0.5 / 31, 0.49 / 63, 2}), 1 << 11 | 0 << 5 | 31);
    /* 40 % grey: the thresholds above 60 % light a pixel, so 38.4 of 64 stay dark. */
    int lit = 0;
    for (int i = 0; i < 64; i++)
        lit += ref_value(&scene, (double[3]){0.4, 0.4, 0.4}, i % 8, i / 8, false);
    assert_true(lit == 25 || lit == 26);
    assert_int_equal(ref_value(&scene, (double[3]){0.4, 0.4, 0.4}, 7, 7, true), 0);
    scene = (struct ref_scene){.levels = 16};
    assert_int_equal(ref_value(&scene, (double[3]){1, 0, 0}, 0, 0, false), 3);  /* 15 * .2126 = 3.19 */
    assert_int_equal(ref_value(&scene, (double[3]){0, 2, 0}, 0, 0, false), 11); /* clamped to 1 first: 15 * .7152 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_by_hand),
        cmocka_unit_test(polygons_by_hand),
        cmocka_unit_test(pixels_by_hand),
    };

    return cmocka_run_group_tests_name("reference_mesh", tests, NULL, NULL);
}
