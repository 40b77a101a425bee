/*
 * test_import_hostile.c - small mesh files of every format, truncated at every byte and with every byte changed: each
 * must give a sane mesh or an error of one line.
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
#include "test_import.h"

/* A tetrahedron in every format; the binary ones are small enough to be written by hand. */
static const char obj[] = "# t\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1e0\nvn 0 0 -1\nvt 0 0\n"
                          "usemtl m\nf 1/1/1 3/1/1 2/1/1\nf 1 2 -1\nf 1//1 4//1 3//1\nf 2 3 4\n";
static const char stl[] = "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\n"
                          "endloop\nendfacet\nfacet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 0 1\nendloop\nendfacet\nendsolid t\n";
static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                          "0 0 0\n0 1 0\n1 0 0\n0 0 1\n3 0 1 2\n4 0 2 3 1\n";
static const char ply_binary[] = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                                 "property float y\nproperty float z\nelement face 1\n"
                                 "property list uchar int vertex_indices\nend_header\n"
                                 "\0\0\0\0\0\0\0\0\0\0\0\0"
                                 "\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                                 "\0\0\0\0\0\0\x80\x3f\0\0\0\0"
                                 "\3\0\0\0\0\1\0\0\0\2\0\0"; /* the last byte is the literal's own zero */
static const char strips[] = "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\n"
                             "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                             "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
                             "7 0 1 2 -1 1 2 3\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n0 0 1 1 2 3\n";
static const char off[] = "# t\nCOFF\n4 3 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 1 1\n0 0 1 0 0 0 0\n"
                          "3 0 1 2 1 2 3\n4 0 1\n2 3 0.5 0.5 0.5 1\n3 1 2 3\n";
static const char gltf[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
    "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"buffers\":[{\"byteLength\":36,\"uri\":"
    "\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";

enum {
    LARGEST = 1024
};

struct sample {
    const char *name;
    const char *bytes;
    size_t count;
};

/* The result must be a mesh of sane numbers that can be quantised (returns 1), or a line that names the file. */
static int survives(const char *name, const char *bytes, size_t count)
{
    struct sheen_problem problem = {""};
    struct sheen_host_mesh mesh;
    struct sheen_quantised quantised;
    const char *path = import_file(name, bytes, count);

    if (sheen_host_mesh_load(&mesh, path, &import_plain, &problem) != 0) {
        if (strncmp(problem.text, path, strlen(path)) != 0 || strchr(problem.text, '\n'))
            fail_msg("'%s' is not one line that names %s", problem.text, path);
        return 0;
    }
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        const double *p = mesh.vertices[i].position, *n = mesh.vertices[i].normal;
        assert_true(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 1 + 1e-9);
        assert_true(fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-9);
    }
    assert_int_equal(sheen_quantise(&quantised, &mesh, SHEEN_ALL_PARTS), 0);
    assert_int_equal(sheen_mesh_check(&quantised.mesh, quantised.polygon_count), 0);
    sheen_quantised_free(&quantised);
    sheen_host_mesh_free(&mesh);
    return 1;
}

/* Binary STL: 80 arbitrary bytes, a count, and 50 bytes per facet: its normal, three corners, 2 spare bytes. */
static size_t binary_stl(char *out)
{
    static const float facets[2][12] = {{0, 0, -1, 0, 0, 0, 0, 1, 0, 1, 0, 0}, {0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};

    memset(out, 'x', 80);
    memcpy(out + 80, "\2\0\0\0", 4); /* little-endian like the floats, so this test needs a little-endian machine */
    for (size_t f = 0; f < 2; f++) {
        memcpy(out + 84 + 50 * f, facets[f], 48);
        memset(out + 84 + 50 * f + 48, 0, 2);
    }
    return 184;
}

/* The triangle of the .gltf above in chunks: a header of 12 bytes, JSON, and the 36 bytes of its buffer. */
static size_t binary_gltf(char *out)
{
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"buffers\":[{\"byteLength\":36}]}";
    static const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    uint32_t size = sizeof json - 1, padded = (size + 3) / 4 * 4, all = 12 + 8 + padded + 8 + 36, points_size = 36;

    memset(out, ' ', all);
    memcpy(out, "glTF\2\0\0", 8);
    memcpy(out + 8, &all, 4);
    memcpy(out + 12, &padded, 4);
    memcpy(out + 16, "JSON", 4);
    memcpy(out + 20, json, size);
    memcpy(out + 20 + padded, &points_size, 4);
    memcpy(out + 24 + padded, "BIN", 4);
    memcpy(out + 28 + padded, points, sizeof points);
    return all;
}

static void every_sample(void (*each)(const struct sample *sample))
{
    char stl_binary[184], glb[LARGEST];
    size_t stl_count = binary_stl(stl_binary), glb_count = binary_gltf(glb);
    const struct sample samples[] = {
        {"s.obj", obj, sizeof obj - 1},
        {"s.stl", stl, sizeof stl - 1},
        {"b.stl", stl_binary, stl_count},
        {"strips.ply", strips, sizeof strips - 1},
        {"s.off", off, sizeof off - 1},
        {"s.ply", ply, sizeof ply - 1},
        {"b.ply", ply_binary, sizeof ply_binary},
        {"s.gltf", gltf, sizeof gltf - 1},
        {"b.glb", glb, glb_count},
    };

    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        assert_true(samples[i].count <= LARGEST);
        each(&samples[i]);
    }
}

static void cut(const struct sample *sample)
{
    int meshes = 0;

    for (size_t count = 0; count < sample->count; count++)
        meshes += survives(sample->name, sample->bytes, count);
    printf("%s: %zu cuts, %d of them meshes\n", sample->name, sample->count, meshes);
    assert_true(meshes == 0 || !strstr(sample->name, ".gl")); /* both forms of glTF show where they end */
    if (!survives(sample->name, sample->bytes, sample->count))
        fail_msg("%s: whole, and no mesh", sample->name);
}

static void change(const struct sample *sample)
{
    static const unsigned char values[] = {0, ' ', '-', '9', 0x7f, 0xff};
    char bytes[LARGEST];
    int meshes = 0;

    memcpy(bytes, sample->bytes, sample->count);
    for (size_t i = 0; i < sample->count; i++) {
        bytes[i] = (char)values[i % sizeof values];
        meshes += survives(sample->name, bytes, sample->count);
        bytes[i] = sample->bytes[i];
    }
    printf("%s: %zu changes, %d of them meshes\n", sample->name, sample->count, meshes);
}

static void cut_at_every_byte(void **state)
{
    (void)state;
    every_sample(cut);
}

static void with_every_byte_changed(void **state)
{
    (void)state;
    every_sample(change);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_at_every_byte),
        cmocka_unit_test(with_every_byte_changed),
    };

    return cmocka_run_group_tests(tests, NULL, import_clean);
}
