/*
 * test_import_reference.c - the importer's meshes against those of the reference, which shares no code with it:
 * positions, normals and triangles, for built-in meshes, files and random polygons; and the quantiser's error.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "quantise.h"
#include "reference/reference.h"

static double apart(const double a[3], const double b[3])
{
    return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

/* Positions are doubles; normals are the core's, 4 raw steps of Q1.30 per part, from points rounded to 28 bits. */
#define POSITION_OFF 1e-9
#define NORMAL_OFF 1e-7

/* Triangle by triangle, as both keep the polygons' order; the reference also keeps polygons without area. */
static void compare(const struct sheen_host_mesh *mesh, const struct ref_mesh *ref, const char *name)
{
    if (mesh->triangle_count != ref->triangle_count)
        fail_msg("%s: %zu triangles, the reference has %zu", name, mesh->triangle_count, ref->triangle_count);
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const struct sheen_host_triangle *ours = &mesh->triangles[t];
        const struct ref_triangle *theirs = &ref->triangles[t];
        double face = apart(mesh->polygons[ours->polygon].normal, ref->polygon_normal[theirs->polygon]);

        if (face > NORMAL_OFF)
            fail_msg("%s: triangle %zu, its polygon's normal: %g apart", name, t, face);
        for (int k = 0; k < 3; k++) {
            const struct sheen_host_vertex *v = &mesh->vertices[ours->vertex[k]];
            double position = apart(v->position, ref->position[theirs->corner[k]]);
            double normal = apart(v->normal, ref->normal[theirs->corner[k]]);
            if (position > POSITION_OFF || normal > NORMAL_OFF)
                fail_msg("%s: triangle %zu, corner %d: position %g, normal %g apart", name, t, k, position, normal);
        }
    }
}

static void check(const struct sheen_polygons *polygons, const struct sheen_host_options *options, const char *name)
{
    struct ref_polygons view = {.points = (const double(*)[3])polygons->points,
                                .point_count = polygons->point_count,
                                .first = polygons->first,
                                .polygon_count = polygons->polygon_count,
                                .corners = polygons->corners,
                                .normals = (const double(*)[3])polygons->normals};
    struct ref_mesh_options how = {.fit = true,
                                   .average_normals = options->average,
                                   .crease = options->use_crease ? options->crease : -1,
                                   .equal_weights = options->equal};
    struct sheen_problem problem;
    struct sheen_host_mesh mesh;
    struct ref_mesh ref;

    if (sheen_host_mesh_build(&mesh, polygons, options, name, &problem) != 0)
        fail_msg("%s", problem.text);
    assert_int_equal(ref_mesh_build(&ref, &view, &how), 0);
    compare(&mesh, &ref, name);
    ref_mesh_free(&ref);
    sheen_host_mesh_free(&mesh);
}

static void meshes_in_every_way(void **state)
{
    static const char *const names[] = {"builtin:teapot", "builtin:sphere", "builtin:torus", "data/egg.obj",
                                        "builtin:cube"};
    static const struct sheen_host_options ways[] = {{0},
                                                     {.average = 1},
                                                     {.use_crease = 1, .crease = 30},
                                                     {.average = 1, .use_crease = 1, .crease = 12},
                                                     {.average = 1, .equal = 1},
                                                     {.use_crease = 1, .crease = 60, .equal = 1}};
    struct sheen_polygons polygons;
    struct sheen_problem problem;

    (void)state;
    for (size_t i = 0; i < 5; i++) {
        if (sheen_polygons_load(&polygons, names[i], NULL, &problem) != 0)
            fail_msg("%s", problem.text);
        for (size_t w = 0; w < sizeof ways / sizeof ways[0]; w++)
            check(&polygons, &ways[w], names[i]);
        sheen_polygons_free(&polygons);
    }
}

/*
 * A model of half a metre at surveyors' coordinates, where doubles are 1e-9 apart and floats .5. The torus lists points
 * twice where it closes, and these must still be welded, although the offset is no round number.
 */
static void far_from_the_origin(void **state)
{
    static const double at[3] = {500000.1, 4649776.3, 0.7};
    struct sheen_polygons polygons;
    struct sheen_problem problem;
    struct sheen_host_mesh near, far;

    (void)state;
    assert_int_equal(sheen_polygons_load(&polygons, "builtin:torus", NULL, &problem), 0);
    assert_int_equal(sheen_host_mesh_build(&near, &polygons, &(struct sheen_host_options){0}, "near", &problem), 0);
    for (size_t p = 0; p < polygons.point_count; p++) {
        for (int k = 0; k < 3; k++)
            polygons.points[p][k] = polygons.points[p][k] / 4 + at[k];
    }
    check(&polygons, &(struct sheen_host_options){0}, "far");
    assert_int_equal(sheen_host_mesh_build(&far, &polygons, &(struct sheen_host_options){0}, "far", &problem), 0);
    assert_int_equal(far.vertex_count, near.vertex_count);
    for (size_t v = 0; v < far.vertex_count; v++)
        assert_true(apart(far.vertices[v].position, near.vertices[v].position) < 1e-8);
    sheen_host_mesh_free(&near);
    sheen_host_mesh_free(&far);
    sheen_polygons_free(&polygons);
}

/* The points of built-in meshes are floats, whatever the compiler makes of a conversion to float and back. */
static void points_are_floats(void **state)
{
    static const char *const names[] = {"builtin:teapot", "builtin:teapot-fine", "builtin:sphere", "builtin:torus",
                                        "builtin:cube"};
    struct sheen_polygons polygons;
    struct sheen_problem problem;

    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        assert_int_equal(sheen_polygons_load(&polygons, names[i], NULL, &problem), 0);
        for (size_t p = 0; p < polygons.point_count; p++) {
            for (int k = 0; k < 3; k++) {
                volatile float nearest = (float)polygons.points[p][k];
                if (polygons.points[p][k] != (double)nearest || (nearest == 0 && signbit(nearest)))
                    fail_msg("%s, point %zu: %a is no 32-bit float", names[i], p, polygons.points[p][k]);
            }
        }
        sheen_polygons_free(&polygons);
    }
}

/* xorshift, so that every machine gets the same polygons. */
static uint32_t seed = 2463534242u;
static double noise(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return seed / 4294967296.0;
}

/* A polygon around the origin in a random plane, slightly bent; its corners go in and out, so that most are concave. */
static void random_polygon(double (*points)[3], unsigned count)
{
    double a[3], b[3];

    for (int k = 0; k < 3; k++) {
        a[k] = noise() - 0.5;
        b[k] = noise() - 0.5;
    }
    for (unsigned i = 0; i < count; i++) {
        double angle = 2 * acos(-1.0) * (i + 0.8 * noise()) / count, r = 0.2 + noise();
        for (int k = 0; k < 3; k++)
            points[i][k] = (float)(r * cos(angle) * a[k] + r * sin(angle) * b[k] + 0.002 * noise());
    }
}

static void random_polygons(void **state)
{
    (void)state;
    for (unsigned n = 0; n < 3000; n++) {
        unsigned count = 3 + n % 14;
        struct sheen_polygons polygons;

        assert_int_equal(sheen_polygons_alloc(&polygons, count, 1, count, 1, 0), 0);
        random_polygon(polygons.points, count);
        for (uint32_t c = 0; c < count; c++)
            polygons.corners[c] = c;
        polygons.first[1] = count;
        check(&polygons, &(struct sheen_host_options){0}, "a random polygon");
        sheen_polygons_free(&polygons);
    }
}

static void quantised_error(void **state)
{
    double worst = 0, mean = 0;
    unsigned count = 0;

    (void)state;
    for (unsigned n = 0; n < 100000; n++) {
        double v[3] = {noise() - 0.5, noise() - 0.5, noise() - 0.5},
               length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        int16_t q[3];

        if (length < 0.01)
            continue;
        for (int k = 0; k < 3; k++)
            v[k] /= length;
        sheen_quantise_unit(v, q);
        double c[3] = {v[1] * q[2] - v[2] * q[1], v[2] * q[0] - v[0] * q[2], v[0] * q[1] - v[1] * q[0]};
        double angle =
            sqrt((c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / (double)(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]));
        worst = fmax(worst, angle);
        mean += angle;
        count++;
    }
    printf("normals: at most %.3g rad off, %.3g in the mean\n", worst, mean / count);
    assert_true(worst < 2.4e-5 && mean / count < 1.0e-5);
}

static void quantised_mesh(void **state)
{
    struct sheen_host_mesh host;
    struct sheen_quantised quantised;
    struct sheen_problem problem;

    (void)state;
    assert_int_equal(sheen_host_mesh_load(&host, "builtin:teapot", &(struct sheen_host_options){0}, &problem), 0);
    assert_int_equal(sheen_quantise(&quantised, &host, SHEEN_ALL_PARTS), 0);
    assert_int_equal(sheen_mesh_check(&quantised.mesh, quantised.polygon_count), 0);
    assert_int_equal(quantised.mesh.vertices, host.vertex_count);
    assert_int_equal(quantised.mesh.triangles, host.triangle_count);
    double scale = quantised.mesh.scale / 16777216.0 / 32768;
    for (size_t i = 0; i < host.vertex_count; i++) {
        for (int k = 0; k < 3; k++)
            assert_true(fabs(quantised.positions[3 * i + (size_t)k] * scale - host.vertices[i].position[k]) <
                        1 / 65500.0);
    }
    sheen_quantised_free(&quantised);
    sheen_host_mesh_free(&host);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes_in_every_way), cmocka_unit_test(points_are_floats),
        cmocka_unit_test(far_from_the_origin), cmocka_unit_test(random_polygons),
        cmocka_unit_test(quantised_error),     cmocka_unit_test(quantised_mesh),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
