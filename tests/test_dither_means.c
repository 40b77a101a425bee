/*
 * test_dither_means.c - a dithered patch of one colour has that colour as its mean.
 *
 * 256 colours per format and shading are compared block by block (8x8 px) with the wanted colour.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "accuracy.h"

#define WIDTH 160
#define HEIGHT 120

struct format {
    const char *name;
    enum sheen_pixel pixel;
    int levels;   /* 0: 565 */
    double limit; /* of a mean's deviation, in 1/255 */
};
static const struct format formats[] = {
    {"2 levels", SHEEN_GREY2, 2, 2},
    {"16 levels", SHEEN_GREY16, 16, 0.5},
    {"256 levels", SHEEN_GREY256, 256, 0.5},
    {"565", SHEEN_RGB565_BE, 0, 0.5},
};
enum {
    FORMATS = sizeof formats / sizeof *formats
};

/* One of 256 colours; red, green and blue change at different rates. */
static void patch_colour(double base[3], int number)
{
    for (int k = 0; k < 3; k++)
        base[k] = number * (2 * k + 1) % 256 / 255.0;
}

/* The largest deviation of an 8x8 block's mean from the wanted colour, in 1/255. */
static double worst_mean(const struct memory_target *target, const struct ref_scene *scene, const struct format *f)
{
    double wanted[3], worst = 0;

    for (int k = 0; k < 3; k++)
        wanted[k] = scene->base[k];
    if (f->levels)
        wanted[0] = 0.2126 * scene->base[0] + 0.7152 * scene->base[1] + 0.0722 * scene->base[2];
    for (int block = 0; block < (WIDTH / 8) * (HEIGHT / 8); block++) {
        double sum[3] = {0, 0, 0};
        for (int i = 0; i < 64; i++) {
            unsigned value =
                memory_target_pixel(target, block % (WIDTH / 8) * 8 + i % 8, block / (WIDTH / 8) * 8 + i / 8);
            sum[0] += f->levels ? value / (f->levels - 1.0) : (value >> 11) / 31.0;
            sum[1] += (value >> 5 & 63) / 63.0;
            sum[2] += (value & 31) / 31.0;
        }
        for (int k = 0; k < (f->levels ? 1 : 3); k++)
            worst = fmax(worst, 255 * fabs(sum[k] / 64 - wanted[k]));
    }
    return worst;
}

/* The largest deviation of all 256 patches. */
static double worst_patch(const struct sheen_mesh *mesh, const struct ref_mesh *reference, const struct format *f,
                          enum ref_shading shading)
{
    double worst = 0;

    for (int number = 0; number < 256; number++) {
        struct memory_target target;
        struct ref_scene scene;
        ref_scene_default(&scene, reference);
        ref_scene_orbit(&scene, 0, 0, 0, 2);
        scene.fov = 60; /* the mesh fills the picture */
        scene.width = WIDTH;
        scene.height = HEIGHT;
        scene.levels = f->levels;
        scene.dither = true;
        scene.shading = shading;
        scene.ambient = 1; /* the colour does not depend on normals */
        scene.light_count = 0;
        patch_colour(scene.base, number);
        assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, f->pixel), 0);
        assert_int_equal(core_draw_scene(&target.target, &scene, mesh, 16), SHEEN_OK);
        worst = fmax(worst, worst_mean(&target, &scene, f));
        memory_target_free(&target);
    }
    return worst;
}

static void constant_patches(void **state)
{
    static const struct ref_mesh_options as_is = {.crease = -1};
    struct shape shape;
    struct ref_mesh reference;
    struct core_mesh mesh;

    (void)state;
    assert_int_equal(shape_screen(&shape), 0);
    assert_int_equal(ref_mesh_build(&reference, &shape.polygons, &as_is), 0);
    assert_int_equal(core_mesh_make(&mesh, &reference), 0);
    for (int k = 0; k < 4 * FORMATS; k++) {
        const struct format *f = &formats[k / 4];
        double worst = worst_patch(&mesh.mesh, &reference, f, (enum ref_shading)(k % 4));
        print_message("  %-10s shading %d: means of 8x8 px within %.4f/255\n", f->name, k % 4, worst);
        assert_true(worst <= f->limit);
    }
    core_mesh_free(&mesh);
    ref_mesh_free(&reference);
    shape_free(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(constant_patches)};

    return cmocka_run_group_tests_name("dither_means", tests, NULL, NULL);
}
