/*
 * test_grey.c - grey levels and ordered dithering against their definition in double precision.
 *
 * A pixel's level follows from its unrounded colour. The core's colour is off by a fraction of a 565 step, so a level
 * may differ only if the reference's unrounded level is that close to a threshold.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "accuracy.h"

#define COLOUR_ERROR (2.0 / 255) /* of the core's unrounded colour in highlights; elsewhere far smaller */

struct format {
    enum sheen_pixel pixel;
    int levels; /* 0: 565 */
};
static const struct format formats[4] = {
    {SHEEN_GREY2, 2}, {SHEEN_GREY16, 16}, {SHEEN_GREY256, 256}, {SHEEN_RGB565_BE, 0}};

/* The reference's value with `by` added to its colour. */
static uint16_t moved(const struct ref_scene *scene, const struct ref_pixel *p, int x, int y, double by)
{
    double color[3] = {p->color[0] + by, p->color[1] + by, p->color[2] + by};

    return ref_value(scene, color, x, y, !p->covered);
}

/* True if every channel of `value` lies between those of `low` and `high`. */
static bool between(int levels, unsigned value, unsigned low, unsigned high)
{
    if (levels)
        return value >= low && value <= high;
    return value >> 11 >= low >> 11 && value >> 11 <= high >> 11 && (value >> 5 & 63) >= (low >> 5 & 63) &&
           (value >> 5 & 63) <= (high >> 5 & 63) && (value & 31) >= (low & 31) && (value & 31) <= (high & 31);
}

/* The share of equal values; any other must be within the colour's error. Edges of the mesh are left out. */
static double equal_share(const struct ref_scene *scene, const struct sheen_mesh *mesh, enum sheen_pixel pixel)
{
    struct memory_target target;
    struct ref_picture picture;
    long equal = 0, compared = 0;

    assert_int_equal(memory_target_init(&target, scene->width, scene->height, pixel), 0);
    assert_int_equal(core_draw_scene(&target.target, scene, mesh, 16), SHEEN_OK);
    assert_int_equal(ref_render(&picture, scene), 0);
    for (int y = 1; y < scene->height - 1; y++) {
        for (int x = 1; x < scene->width - 1; x++) {
            const struct ref_pixel *p = &picture.pixels[y * scene->width + x];
            bool inside = true;
            for (int k = 0; k < 9; k++) {
                const struct ref_pixel *q = p + (k / 3 - 1) * scene->width + k % 3 - 1;
                inside &= q->covered == p->covered && fabs(q->m - p->m) < 0.02 * p->m + 1e-9 &&
                          (scene->shading != REF_FLAT || q->polygon == p->polygon);
            }
            if (!inside)
                continue;
            unsigned value = memory_target_pixel(&target, x, y);
            compared++;
            equal += value == p->value;
            if (!between(scene->levels, value, moved(scene, p, x, y, -COLOUR_ERROR),
                         moved(scene, p, x, y, COLOUR_ERROR)))
                fail_msg("%d levels, (%d, %d): %u, by its definition %u", scene->levels, x, y, value, p->value);
        }
    }
    assert_true(compared > scene->width * scene->height / 2);
    ref_picture_free(&picture);
    memory_target_free(&target);
    return (double)equal / (double)compared;
}

static void shaded_pictures(void **state)
{
    struct accuracy_mesh sphere;

    (void)state;
    for (int k = 0; k < 4 * 2 * 4; k++) {
        assert_int_equal(accuracy_mesh_make(&sphere, 0, k / 8 == REF_FLAT), 0);
        const struct format *format = &formats[k % 4];
        struct ref_scene scene;
        accuracy_view(&scene, &sphere.reference, k % 3);
        scene.levels = format->levels;
        scene.dither = k / 4 % 2;
        scene.shading = (enum ref_shading)(k / 8);
        double share = equal_share(&scene, sphere.mesh, format->pixel);
        print_message("  %3d levels %-6s shading %d: %.2f %% equal\n", format->levels,
                      scene.dither ? "dither" : "plain", k / 8, 100 * share);
        accuracy_mesh_free(&sphere);
        assert_true(share >= 0.96);
    }
}

/* A patch of one colour: levels must be as defined pixel by pixel, and their mean over 8x8 blocks the colour. */
static void constant_patches(void **state)
{
    struct shape shape;
    struct ref_mesh reference;
    struct core_mesh mesh;
    static const struct ref_mesh_options as_is = {.crease = -1};

    (void)state;
    assert_int_equal(shape_screen(&shape), 0);
    assert_int_equal(ref_mesh_build(&reference, &shape.polygons, &as_is), 0);
    assert_int_equal(core_mesh_make(&mesh, &reference), 0);
    for (int k = 0; k < 3 * 64; k++) {
        int levels = formats[k % 3].levels;
        struct memory_target target;
        struct ref_scene scene;
        ref_scene_default(&scene, &reference);
        ref_scene_orbit(&scene, 0, 0, 0, 2);
        scene.fov = 60;
        scene.width = 64;
        scene.height = 48;
        scene.levels = levels;
        scene.dither = true;
        scene.shading = REF_FLAT;
        scene.light_count = 0;
        scene.ambient = 1;
        for (int c = 0; c < 3; c++)
            scene.base[c] = (3 + 4 * (k / 3)) / 255.0;
        assert_int_equal(memory_target_init(&target, 64, 48, formats[k % 3].pixel), 0);
        assert_int_equal(core_draw_scene(&target.target, &scene, &mesh.mesh, 16), SHEEN_OK);
        double sum = 0;
        for (int i = 0; i < 64; i++) {
            unsigned value = memory_target_pixel(&target, 16 + i % 8, 8 + i / 8);
            sum += value / (levels - 1.0);
            assert_int_equal(value, memory_target_pixel(&target, 24 + i % 8, 32 + i / 8)); /* the pattern repeats */
            double near = (levels - 1) * scene.base[0] + (ref_bayer8(i % 8, i / 8) + 0.5) / 64;
            if (fabs(near - round(near)) > 1e-3) /* the core rounds its colour in 16 bits */
                assert_int_equal(value, ref_value(&scene, scene.base, 16 + i % 8, 8 + i / 8, false));
        }
        assert_true(fabs(sum / 64 - scene.base[0]) <= (levels == 2 ? 2.0 : 0.5) / 255);
        memory_target_free(&target);
    }
    core_mesh_free(&mesh);
    ref_mesh_free(&reference);
    shape_free(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shaded_pictures), cmocka_unit_test(constant_patches)};

    return cmocka_run_group_tests_name("grey", tests, NULL, NULL);
}
