/*
 * test_import.c - mesh files: what becomes one vertex, a face, a normal or a material, against numbers worked out by
 * hand.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "test_import.h"

static void equal3(const double a[3], double x, double y, double z)
{
    if (fabs(a[0] - x) > 1e-6 || fabs(a[1] - y) > 1e-6 || fabs(a[2] - z) > 1e-6)
        fail_msg("%g %g %g, not %g %g %g", a[0], a[1], a[2], x, y, z);
}

/* A cube of quads, some with points of their own and signed zeros. */
static const char cube[] = "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nv 1 -1 -1\nv -1 -1 -1\nv -1 1 -1\nv 1 1 -1\n"
                           "f 1 2 3 4\nf 5 6 7 8\nf 2 5 8 3\nf 6 1 4 7\nf 4 3 8 7\nf 6 5 2 1\n";

static void a_cube(void **state)
{
    struct sheen_host_mesh mesh;

    (void)state;
    import_mesh(&mesh, "cube.obj", cube, &import_plain);
    assert_int_equal(mesh.vertex_count, 8);
    assert_int_equal(mesh.polygon_count, 6);
    assert_int_equal(mesh.triangle_count, 12);
    for (size_t i = 0; i < 8; i++) { /* the average normal points along the diagonal, and so does the position */
        const struct sheen_host_vertex *v = &mesh.vertices[i];
        equal3(v->position, v->normal[0], v->normal[1], v->normal[2]);
    }
    sheen_host_mesh_free(&mesh);
}

static void bit_equal_positions_are_one_vertex(void **state)
{
    struct sheen_host_mesh mesh;

    (void)state;
    /* Two triangles at the edge (0,0,0) (0,1,0), each with its own points; 1 + 1e-9 is 1 as a 32-bit float. */
    import_mesh(&mesh, "weld.obj",
                "v 0 0 -0\nv 1 0 0\nv 0 1 0\no other\nv -0 -0 0\nv 0 1.000000001 0\nv -1 0 0\nf 1 2 3\nf 4 5 6\n",
                &import_plain);
    assert_int_equal(mesh.vertex_count, 4);
    sheen_host_mesh_free(&mesh);
    /* Points that are one step of a float apart stay two vertices. */
    import_mesh(&mesh, "apart.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1.0000002 0\nv -1 0 0\nf 1 2 3\nf 1 4 5\n",
                &import_plain);
    assert_int_equal(mesh.vertex_count, 5);
    sheen_host_mesh_free(&mesh);
}

static void points_and_lines_and_flat_faces_are_left_out(void **state)
{
    struct sheen_host_mesh mesh;

    (void)state;
    /* The face 1 4 5 has no area; its far point still counts for the fit, the lone point 6 does not. */
    import_mesh(&mesh, "mixed.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 99 0 0\np 6\nl 1 6\nf 1 2 3\nf 1 4 5\n", &import_plain);
    assert_int_equal(mesh.polygon_count, 1);
    assert_int_equal(mesh.vertex_count, 3);
    equal3(mesh.center, 1.5, 0.5, 0);
    assert_true(fabs(mesh.radius - sqrt(1.5 * 1.5 + 0.25)) < 1e-12);
    sheen_host_mesh_free(&mesh);
}

/* A tiny triangle beside a normal one keeps its area and normal, down to the smallest double above 0. */
static void faces_of_hardly_any_extent(void **state)
{
    static const char *const sizes[] = {"1e-30", "1e-299", "1e-301", "2.3e-308", "1e-310", "4.95e-324"};
    struct sheen_host_mesh mesh;
    char text[200];

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        snprintf(text, sizeof text, "v 0 0 0\nv 1 0 0\nv 0 0 1\nv %s 0 0\nv 0 %s 0\nf 1 2 3\nf 1 4 5\n", sizes[i],
                 sizes[i]);
        import_mesh(&mesh, "small.obj", text, &import_plain);
        assert_int_equal(mesh.polygon_count, 2);
        equal3(mesh.polygons[0].normal, 0, -1, 0);
        equal3(mesh.polygons[1].normal, 0, 0, 1);
        sheen_host_mesh_free(&mesh);
    }
}

static const char roof[] = "v -1 0 0\nv 1 0 0\nv -1 1 -1\nv 1 1 -1\nv -1 1 1\nv 1 1 1\n";

static void normals_of_the_file_and_without(void **state)
{
    struct sheen_host_mesh mesh;
    char text[400];

    (void)state;
    /* Two faces that meet at the x axis, seen from below. The first has one vn of length 2 and one that is zero. */
    strcpy(text, roof);
    strcat(text, "vn 0 0 2\nvn 0 0 0\nf 1//1 2//1 6//2 5//2\nf 2 1 3 4\n");
    import_mesh(&mesh, "vn.obj", text, &import_plain);
    assert_int_equal(mesh.vertex_count, 8);
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        const struct sheen_host_vertex *v = &mesh.vertices[i];
        if (v->normal[2] == 1)
            assert_true(v->position[1] < 0); /* in the first face, at the axis: the file's vn */
        else if (v->position[1] < 0)
            equal3(v->normal, 0, -1, 0); /* in the second face, at the axis: the average */
        else
            assert_true(fabs(fabs(v->normal[2]) - sqrt(0.5)) < 1e-8); /* elsewhere: the normal of its own face */
    }
    sheen_host_mesh_free(&mesh);
    import_mesh(&mesh, "vn.obj", text, &(struct sheen_host_options){.average = 1});
    assert_int_equal(mesh.vertex_count, 6);
    sheen_host_mesh_free(&mesh);
}

/*
 * Averages weighted by the angles at point 1, or equally. The upward face lists point 1 once; the face towards +x
 * consists of two triangles and lists it twice.
 */
static void a_corner_counts_for_each_listing(void **state)
{
    static const char text[] = "v 0 0 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 -1 1\nf 1 3 2\nf 1 2 5\nf 1 5 4\n";
    struct sheen_host_mesh mesh;

    (void)state;
    import_mesh(&mesh, "twice.obj", text, &(struct sheen_host_options){.equal = 1});
    const double *n = mesh.vertices[mesh.corners[0]].normal;
    equal3(n, 2 / sqrt(5), fabs(n[1]), 0); /* listed 2 to 1, it leans towards +x */
    sheen_host_mesh_free(&mesh);
    import_mesh(&mesh, "twice.obj", text, &import_plain);
    n = mesh.vertices[mesh.corners[0]].normal;
    equal3(n, 1 / sqrt(2), fabs(n[1]), 0); /* 90 degrees in both */
    sheen_host_mesh_free(&mesh);
}

/* (x, y, z) becomes (x, z, -y) before the fit, because of the format or if asked for. */
static void up_is_turned(void **state)
{
    static const char obj[] = "v 0 0 0\nv 1 0 0\nv 0 0 4\nf 1 2 3\n";
    static const char stl[] = "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 4\n"
                              "endloop\nendfacet\nendsolid t\n";
    struct sheen_host_mesh mesh;

    (void)state;
    for (int up = SHEEN_UP_FORMAT; up <= SHEEN_UP_Z; up++) {
        for (int is_stl = 0; is_stl < 2; is_stl++) {
            import_mesh(&mesh, is_stl ? "t.stl" : "t.obj", is_stl ? stl : obj, &(struct sheen_host_options){.up = up});
            if (up == SHEEN_UP_Z || (up == SHEEN_UP_FORMAT && is_stl)) {
                equal3(mesh.center, 0.5, 2, 0);
                equal3(mesh.polygons[0].normal, 0, 0, 1);
            } else {
                equal3(mesh.center, 0.5, 0, 2);
                equal3(mesh.polygons[0].normal, 0, -1, 0);
            }
            sheen_host_mesh_free(&mesh);
        }
    }
}

static void an_average_of_zero_is_the_faces_own(void **state)
{
    struct sheen_host_mesh mesh;

    (void)state;
    import_mesh(&mesh, "both.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n", &import_plain);
    assert_int_equal(mesh.vertex_count, 6);
    for (size_t c = 0; c < 6; c++)
        equal3(mesh.vertices[mesh.corners[c]].normal, 0, 0, c < 3 ? 1 : -1);
    sheen_host_mesh_free(&mesh);
}

static void a_crease_parts_faces(void **state)
{
    static const struct {
        double crease;
        size_t vertices;
    } expect[] = {{0, 24}, {89, 24}, {90, 8}, {180, 8}};
    struct sheen_host_mesh mesh;

    (void)state;
    for (size_t i = 0; i < 4; i++) {
        import_mesh(&mesh, "cube.obj", cube, &(struct sheen_host_options){.use_crease = 1, .crease = expect[i].crease});
        assert_int_equal(mesh.vertex_count, expect[i].vertices);
        sheen_host_mesh_free(&mesh);
    }
}

/* The same tetrahedron as STL and PLY. The facet normals of the STL are nonsense and must not matter. */
static void other_formats(void **state)
{
    static const char stl[] =
        "solid t\n"
        "facet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
        "facet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
        "facet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
        "facet normal 0 1 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
        "endsolid t\n";
    static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                              "0 0 0\n0 1 0\n1 0 0\n0 0 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 2 1 3\n";
    struct sheen_host_mesh a, b;

    (void)state;
    import_mesh(&a, "t.stl", stl, &(struct sheen_host_options){.up = SHEEN_UP_Y});
    import_mesh(&b, "t.ply", ply, &import_plain);
    assert_int_equal(a.vertex_count, 4);
    assert_int_equal(b.vertex_count, 4);
    assert_int_equal(a.triangle_count, 4);
    for (size_t c = 0; c < 12; c++) {
        const struct sheen_host_vertex *v = &a.vertices[a.corners[c]], *w = &b.vertices[b.corners[c]];
        equal3(v->position, w->position[0], w->position[1], w->position[2]);
        equal3(v->normal, w->normal[0], w->normal[1], w->normal[2]);
    }
    sheen_host_mesh_free(&a);
    sheen_host_mesh_free(&b);
}

/* A triangle in the plane z = 0. One node moves and scales it by (2, 1, 1), another mirrors it in x. */
static void nodes_of_gltf(void **state)
{
    static const char text[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0, 2]}],"
        "\"nodes\": [{\"children\": [1], \"translation\": [5, 0, 0]}, {\"mesh\": 0, \"scale\": [2, 1, 1]},"
        "{\"mesh\": 0, \"scale\": [-1, 1, 1]}],"
        "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],"
        "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\","
        "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}],"
        "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],"
        "\"buffers\": [{\"byteLength\": 36, \"uri\": \"data:application/octet-stream;base64,"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";
    struct sheen_host_mesh mesh;

    (void)state;
    import_mesh(&mesh, "nodes.gltf", text, &import_plain);
    assert_int_equal(mesh.polygon_count, 2);
    equal3(mesh.center, 3, 0.5, 0); /* x from -1 to 5 + 2 */
    for (size_t p = 0; p < 2; p++)  /* the mirrored one too, because the order of its corners is reversed */
        equal3(mesh.polygons[p].normal, 0, 0, 1);
    sheen_host_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube),
        cmocka_unit_test(bit_equal_positions_are_one_vertex),
        cmocka_unit_test(points_and_lines_and_flat_faces_are_left_out),
        cmocka_unit_test(faces_of_hardly_any_extent),
        cmocka_unit_test(normals_of_the_file_and_without),
        cmocka_unit_test(a_corner_counts_for_each_listing),
        cmocka_unit_test(up_is_turned),
        cmocka_unit_test(an_average_of_zero_is_the_faces_own),
        cmocka_unit_test(a_crease_parts_faces),
        cmocka_unit_test(other_formats),
        cmocka_unit_test(nodes_of_gltf),
    };

    return cmocka_run_group_tests(tests, NULL, import_clean);
}
