/*
 * test_reduce.c - --reduce: meshes with too many triangles become meshes that can be drawn and that keep shape,
 * normals, sharp edges and groups.
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

#include "host_mesh.h"
#include "quantise.h"

#define PI 3.14159265358979323846

/* A grid of rows x columns quadrilaterals, bent by `place`; its rows are divided into `groups` groups. */
static void make_grid(struct sheen_polygons *out, uint32_t rows, uint32_t columns, uint32_t groups,
                      void (*place)(double u, double v, double point[3]))
{
    size_t points = (size_t)(rows + 1) * columns, count = (size_t)rows * columns;

    assert_int_equal(sheen_polygons_alloc(out, points, count, 4 * count, groups, 0), 0);
    for (size_t i = 0; i < points; i++)
        place((double)(i / columns) / rows, (double)(i % columns) / columns, out->points[i]);
    for (uint32_t p = 0; p < count; p++) {
        uint32_t row = p / columns, column = p % columns, next = (column + 1) % columns, *corner = out->corners + 4 * p;
        corner[0] = row * columns + column;
        corner[1] = row * columns + next;
        corner[2] = (row + 1) * columns + next;
        corner[3] = (row + 1) * columns + column;
        out->groups[p] = (uint16_t)(row * groups / rows);
        out->first[p + 1] = 4 * (p + 1);
    }
}

static void on_sphere(double u, double v, double point[3])
{
    double across = sin(PI * u); /* exactly 0 at the poles, so that their points weld */

    across = u == 0 || u == 1 ? 0 : across;
    point[0] = 5 + 2 * across * cos(2 * PI * v);
    point[1] = -3 + 2 * cos(PI * u);
    point[2] = 2 * across * sin(2 * PI * v);
}

/* The 4 sides of a prism with a square section, as fine as the grid; its ends are open. */
static void on_prism(double u, double v, double point[3])
{
    double side = floor(4 * v), along = 1 - 2 * (4 * v - side);

    point[0] = side == 0 ? along : side == 1 ? -1 : side == 2 ? -along : 1;
    point[2] = side == 0 ? 1 : side == 1 ? along : side == 2 ? -1 : -along;
    point[1] = 3 - 6 * u;
}

static void reduce(struct sheen_host_mesh *mesh, const struct sheen_polygons *from, unsigned most, int by_group)
{
    const struct sheen_host_options options = {.reduce = most, .by_group = by_group, .use_crease = 1, .crease = 60};
    struct sheen_problem problem;

    if (sheen_host_mesh_build(mesh, from, &options, "grid", &problem) != 0)
        fail_msg("%s", problem.text);
}

static double volume_of(const struct sheen_host_mesh *mesh)
{
    double sum = 0;

    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *vertex = mesh->triangles[t].vertex;
        const double *a = mesh->vertices[vertex[0]].position, *b = mesh->vertices[vertex[1]].position,
                     *c = mesh->vertices[vertex[2]].position;
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum / 6;
}

/* Counts edges that do not run equally often in both directions: there the surface is torn. */
static size_t count_open_edges(const struct sheen_host_mesh *mesh)
{
    size_t count = 0, edges = 3 * mesh->triangle_count;
    uint32_t(*edge)[2] = malloc(edges * sizeof *edge);

    assert_non_null(edge);
    for (size_t e = 0; e < edges; e++) {
        for (size_t i = 0; i < 2; i++)
            edge[e][i] = mesh->vertices[mesh->triangles[e / 3].vertex[(e + i) % 3]].weld;
    }
    for (size_t e = 0; e < edges; e++) {
        int balance = 0;
        for (size_t f = 0; f < edges; f++) {
            balance += edge[f][0] == edge[e][0] && edge[f][1] == edge[e][1];
            balance -= edge[f][0] == edge[e][1] && edge[f][1] == edge[e][0];
        }
        count += balance != 0;
    }
    free(edge);
    return count;
}

static double get_error(const struct sheen_host_mesh *mesh)
{
    const char *at = mesh->notes.count ? strstr(mesh->notes.note[mesh->notes.count - 1].line.text, "at most ") : NULL;

    assert_non_null(at);
    return atof(at + 8) / 100;
}

/* The reduced sphere is closed, as round as the note says, and smooth: normals at corners are those of the sphere. */
static void a_sphere_stays_round(void **state)
{
    static const unsigned sizes[] = {60000, 5000, 600};
    struct sheen_polygons sphere;

    (void)state;
    make_grid(&sphere, 180, 360, 1, on_sphere);
    for (size_t i = 0; i < 3; i++) {
        struct sheen_host_mesh mesh;
        reduce(&mesh, &sphere, sizes[i], 0);
        double volume = volume_of(&mesh), off = get_error(&mesh), worst = 1, nearest = 1;
        for (size_t v = 0; v < mesh.vertex_count; v++) {
            const double *p = mesh.vertices[v].position, *n = mesh.vertices[v].normal;
            worst = fmin(worst, p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
            nearest = fmin(nearest, sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
        }
        printf("%u: %zu triangles, volume %.4f, off by %g; normals %g off, points %g\n", sizes[i], mesh.triangle_count,
               volume, off, acos(fmin(worst, 1)), 1 - nearest);
        assert_true(mesh.triangle_count <= sizes[i] && mesh.triangle_count > sizes[i] * 9 / 10);
        assert_true(mesh.notes.note[0].kind == SHEEN_NOTE_DONE);
        assert_true(off < 5.0 / sizes[i] + 1e-4 && fabs(volume - 4 * PI / 3) < 100.0 / sizes[i] + 0.002);
        assert_true(acos(fmin(worst, 1)) < 0.06 && nearest > 0.99);
        if (mesh.triangle_count < 6000)
            assert_int_equal(count_open_edges(&mesh), 0);
        sheen_host_mesh_free(&mesh);
    }
    sheen_polygons_free(&sphere);
}

/* The seam between two groups does not tear: over both groups, every edge has its counterpart. */
static void groups_stay_joined(void **state)
{
    struct sheen_polygons sphere;
    struct sheen_host_mesh mesh;
    size_t corners[2] = {0, 0};

    (void)state;
    make_grid(&sphere, 180, 360, 2, on_sphere);
    reduce(&mesh, &sphere, 3000, 1);
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        uint32_t group = mesh.polygons[mesh.triangles[t].polygon].group;
        assert_true(group < 2);
        for (int k = 0; k < 3; k++) {
            const struct sheen_host_vertex *vertex = &mesh.vertices[mesh.triangles[t].vertex[k]];
            assert_int_equal(vertex->group, group);
            assert_true(group == 0 ? vertex->position[1] > -0.01 : vertex->position[1] < 0.01);
            corners[group]++;
        }
    }
    assert_true(mesh.triangle_count <= 3000 && corners[0] > 3000 && corners[1] > 3000);
    assert_int_equal(count_open_edges(&mesh), 0);
    sheen_host_mesh_free(&mesh);
    sheen_polygons_free(&sphere);
}

/* Counts sharp sides of triangles; an edge between two triangles counts twice. */
static unsigned count_sharp(const struct sheen_host_mesh *mesh)
{
    struct sheen_quantised quantised;
    unsigned count = 0;

    assert_int_equal(sheen_quantise(&quantised, mesh, SHEEN_ALL_PARTS), 0);
    for (uint32_t t = 0; t < quantised.mesh.triangles; t++) {
        for (int k = 0; k < 3; k++)
            count += quantised.edges[t].sharp >> k & 1;
    }
    sheen_quantised_free(&quantised);
    return count;
}

/* The crease is kept: the prism has four sharp edges, each counted twice, and borders at its open ends. */
static void sharp_edges_stay_sharp(void **state)
{
    struct sheen_polygons prism;
    struct sheen_host_mesh mesh;

    (void)state;
    make_grid(&prism, 8, 16, 1, on_prism);
    reduce(&mesh, &prism, 256, 0);
    assert_int_equal(mesh.triangle_count, 256);
    assert_int_equal(count_sharp(&mesh), 2 * 4 * 8 + 2 * 16);
    sheen_host_mesh_free(&mesh);
    reduce(&mesh, &prism, 8, 0);
    assert_int_equal(mesh.triangle_count, 8);
    assert_int_equal(count_sharp(&mesh), 2 * 4 + 2 * 4);
    sheen_host_mesh_free(&mesh);
    sheen_polygons_free(&prism);
}

/*
 * Flat sides need few triangles, and their corners keep the normals of their sides. The simplifier folds a few
 * triangles over there, fewer than 1 in 20; their normals stay parallel to the side's, and culling removes them.
 */
static void edges_stay_edges(void **state)
{
    struct sheen_polygons prism;
    struct sheen_host_mesh mesh;
    size_t folds = 0;

    (void)state;
    make_grid(&prism, 200, 200, 1, on_prism);
    reduce(&mesh, &prism, 800, 0);
    assert_true(mesh.triangle_count <= 800 && get_error(&mesh) < 0.001);
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const double *side = mesh.polygons[mesh.triangles[t].polygon].normal;
        double worst = 1;
        for (int k = 0; k < 3; k++) {
            const double *n = mesh.vertices[mesh.triangles[t].vertex[k]].normal;
            worst = fmin(worst, n[0] * side[0] + n[1] * side[1] + n[2] * side[2]);
        }
        folds += worst < -0.9999;
        assert_true(worst > 0.9999 || worst < -0.9999);
    }
    printf("%zu of %zu triangles are folded over\n", folds, mesh.triangle_count);
    assert_true(folds * 20 < mesh.triangle_count);
    sheen_host_mesh_free(&mesh);
    sheen_polygons_free(&prism);
}

static void too_many_are_refused(void **state)
{
    struct sheen_polygons sphere;
    struct sheen_host_mesh mesh;
    struct sheen_problem problem;

    (void)state;
    make_grid(&sphere, 180, 360, 1, on_sphere);
    assert_int_equal(sheen_host_mesh_build(&mesh, &sphere, &(struct sheen_host_options){0}, "grid", &problem),
                     SHEEN_ERR_CAPACITY);
    assert_non_null(strstr(problem.text, "--reduce 20000"));
    sheen_polygons_free(&sphere);
}

/* Few enough triangles, but each has vertices of its own: cannot be drawn, and is reduced only if asked for. */
static void too_many_vertices_are_refused(void **state)
{
    struct sheen_polygons sphere;
    struct sheen_host_mesh mesh;
    struct sheen_problem problem;

    (void)state;
    make_grid(&sphere, 100, 300, 1, on_sphere);
    for (unsigned reduce = 0; reduce <= SHEEN_HOST_MESH_MAX; reduce += SHEEN_HOST_MESH_MAX) {
        const struct sheen_host_options options = {.use_crease = 1, .crease = 0, .reduce = reduce};
        assert_int_equal(sheen_host_mesh_build(&mesh, &sphere, &options, "grid", &problem), SHEEN_ERR_CAPACITY);
        assert_non_null(strstr(problem.text, "vertices (by position and normal), at most 65535 can be drawn; --normals "
                                             "average --crease 180 makes it about 29702, --reduce"));
    }
    const struct sheen_host_options options = {.use_crease = 1, .crease = 0, .reduce = 10000};
    assert_int_equal(sheen_host_mesh_build(&mesh, &sphere, &options, "grid", &problem), 0);
    assert_true(mesh.triangle_count <= 10000 && mesh.vertex_count <= 30000);
    sheen_host_mesh_free(&mesh);
    sheen_polygons_free(&sphere);
}

/* A mesh that is small enough stays as it is, bit by bit. */
static void small_ones_stay(void **state)
{
    struct sheen_host_mesh plain, asked;
    struct sheen_problem problem;

    (void)state;
    assert_int_equal(sheen_host_mesh_load(&plain, "data/egg.obj", &(struct sheen_host_options){0}, &problem), 0);
    struct sheen_host_options options = {.reduce = (unsigned)plain.triangle_count};
    assert_int_equal(sheen_host_mesh_load(&asked, "data/egg.obj", &options, &problem), 0);
    assert_int_equal(asked.vertex_count, plain.vertex_count);
    assert_memory_equal(asked.vertices, plain.vertices, plain.vertex_count * sizeof *plain.vertices);
    assert_int_equal(asked.notes.count, 0);
    sheen_host_mesh_free(&asked);
    options.reduce--;
    assert_int_equal(sheen_host_mesh_load(&asked, "data/egg.obj", &options, &problem), 0);
    assert_true(asked.triangle_count < plain.triangle_count && asked.notes.count == 1);
    sheen_host_mesh_free(&asked);
    sheen_host_mesh_free(&plain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_stays_round),   cmocka_unit_test(groups_stay_joined),
        cmocka_unit_test(sharp_edges_stay_sharp), cmocka_unit_test(edges_stay_edges),
        cmocka_unit_test(too_many_are_refused),   cmocka_unit_test(too_many_vertices_are_refused),
        cmocka_unit_test(small_ones_stay),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
