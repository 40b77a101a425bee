/*
 * test_snapping.c - coverage against the real triangles, before their corners were snapped.
 *
 * Snapping to 1/64 px may add or remove a pixel only if its centre lies within 1/8 px of an edge. Every pixel of every
 * picture is checked, for whole meshes and for each triangle drawn alone.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../host-sim/command/shadings.h"
#include "accuracy.h"
#include "reference/ref_vector.h"

#define REACH (1.0 / 8) /* px */

static bool near_edge(const struct ref_piece *pieces, size_t count, double x, double y)
{
    for (size_t i = 0; i < count; i++) {
        for (int side = 0; side < 3; side++) {
            if (ref_side_distance(&pieces[i], side, x, y) <= REACH)
                return true;
        }
    }
    return false;
}

/* White on black with ambient light only, so that a pixel is not black exactly if it is covered. */
static void plain_scene(struct ref_scene *scene, const struct ref_mesh *mesh, int view)
{
    accuracy_view(scene, mesh, view);
    scene->shading = REF_FLAT;
    scene->ambient = 1;
    scene->diffuse = scene->specular = 0;
    for (int k = 0; k < 3; k++) {
        scene->base[k] = 1;
        scene->background[k] = 0;
    }
}

/* The number of pixels that differ; each must be near an edge. */
static long check(const struct memory_target *target, const struct ref_scene *scene, const struct ref_piece *pieces,
                  size_t count, const char *what)
{
    long differing = 0;

    for (int y = 0; y < scene->height; y++) {
        for (int x = 0; x < scene->width; x++) {
            bool drawn = memory_target_pixel(target, x, y) != 0, covered = false;
            for (size_t i = 0; i < count && !covered; i++)
                covered = ref_inside(&pieces[i], x + 0.5, y + 0.5);
            if (drawn == covered)
                continue;
            differing++;
            if (!near_edge(pieces, count, x + 0.5, y + 0.5))
                fail_msg("%s: (%d, %d) is %s, and no edge within 1/8 px", what, x, y, drawn ? "drawn" : "missed");
        }
    }
    return differing;
}

static void whole_meshes(void **state)
{
    long differing = 0, covered = 0;

    (void)state;
    for (int index = 0; index < ACCURACY_SHAPES; index++) {
        struct accuracy_mesh mesh;
        assert_int_equal(accuracy_mesh_make(&mesh, index, true), 0);
        for (int k = 0; k < 2 * ACCURACY_VIEWS; k++) {
            struct ref_scene scene;
            struct ref_picture picture;
            struct memory_target target;
            plain_scene(&scene, &mesh.reference, k / 2);
            scene.width = k % 2 ? 240 : 320;
            assert_int_equal(memory_target_init(&target, scene.width, scene.height, SHEEN_RGB565_BE), 0);
            assert_int_equal(core_draw_scene(&target.target, &scene, mesh.mesh, 16), SHEEN_OK);
            assert_int_equal(ref_render(&picture, &scene), 0);
            differing += check(&target, &scene, picture.pieces, picture.piece_count, mesh.name);
            for (int i = 0; i < scene.width * scene.height; i++)
                covered += picture.pixels[i].covered;
            ref_picture_free(&picture);
            memory_target_free(&target);
        }
        accuracy_mesh_free(&mesh);
    }
    print_message("  %ld of %ld covered pixels differ, all within 1/8 px of an edge\n", differing, covered);
    assert_true(covered > 100000);
}

/* Draws a frame with a single triangle of the mesh. */
static void draw_triangle(struct core_frame *f, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                          const struct sheen_material *material, uint32_t triangle)
{
    struct sheen_mesh one = *mesh;
    struct sheen_view view;
    struct sheen_object draw = {.mesh = &one, .material = material, .shader = &sheen_flat};

    one.indices = (const uint16_t *)mesh->indices + 3 * triangle;
    one.polygons = mesh->polygons + triangle;
    one.triangles = 1;
    core_view(&view, scene);
    core_pose(&draw.pose, scene);
    assert_int_equal(sheen_begin(f->frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(f->frame, &draw), SHEEN_OK);
    assert_int_equal(sheen_end(f->frame), SHEEN_OK);
}

static long triangles_of(const struct accuracy_mesh *mesh, int view, long *differing)
{
    struct ref_scene scene;
    struct ref_picture picture = {.width = 160, .height = 120};
    struct memory_target target;
    struct core_frame f;
    struct sheen_material material;
    struct core_tables tables;
    size_t piece = 0;

    plain_scene(&scene, &mesh->reference, view);
    scene.width = picture.width;
    scene.height = picture.height;
    assert_int_equal(memory_target_init(&target, scene.width, scene.height, SHEEN_RGB565_BE), 0);
    assert_int_equal(ref_project(&picture, &scene), 0);
    assert_int_equal(core_material(&material, &tables, &scene), SHEEN_OK);
    struct sheen_config config = {.target = &target.target,
                                  .max_vertices = mesh->mesh->vertices,
                                  .max_triangles = 8,
                                  .max_clipped = 8,
                                  .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    for (uint32_t t = 0; t < mesh->mesh->triangles; t++) {
        size_t first = piece; /* the triangle's pieces; a back face has none */
        while (piece < picture.piece_count && picture.pieces[piece].triangle == t)
            piece++;
        draw_triangle(&f, &scene, mesh->mesh, &material, t);
        *differing += check(&target, &scene, picture.pieces + first, piece - first, mesh->name);
    }
    assert_int_equal(piece, picture.piece_count);
    core_frame_free(&f);
    ref_picture_free(&picture);
    memory_target_free(&target);
    return mesh->mesh->triangles;
}

static void each_triangle_alone(void **state)
{
    long triangles = 0, differing = 0;

    (void)state;
    for (int index = 0; index < ACCURACY_SHAPES; index++) {
        struct accuracy_mesh mesh;
        assert_int_equal(accuracy_mesh_make(&mesh, index, index == 0), 0);
        for (int view = 0; view < ACCURACY_VIEWS; view++)
            triangles += triangles_of(&mesh, view, &differing);
        accuracy_mesh_free(&mesh);
    }
    print_message("  %ld triangles, %ld pixels differ, all within 1/8 px of an edge\n", triangles, differing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_meshes), cmocka_unit_test(each_triangle_alone)};

    return cmocka_run_group_tests_name("snapping", tests, NULL, NULL);
}
