/*
 * test_dither.c - the one rounding: with dither and without it, every pixel is exactly what the formula in
 * core/pixel/rounding.h makes of the core's own unrounded colour.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "accuracy.h"
#include "test_dither_tap.h"

#define WIDTH 160
#define HEIGHT 120

struct format {
    enum sheen_pixel pixel;
    int levels;    /* 0: 565 */
    double top[3]; /* the level that 1.0 of red, green or blue stands for */
};
static const struct format formats[] = {
    {SHEEN_GREY2, 2, {0.2126, 0.7152, 0.0722}},
    {SHEEN_GREY16, 16, {15 * 0.2126, 15 * 0.7152, 15 * 0.0722}},
    {SHEEN_GREY256, 256, {255 * 0.2126, 255 * 0.7152, 255 * 0.0722}},
    {SHEEN_RGB565_BE, 0, {31, 63, 31}},
    {SHEEN_RGB565_LE, 0, {31, 63, 31}},
};
enum {
    FORMATS = sizeof formats / sizeof *formats
};

/* floor(level + threshold), limited to `top`; without dither the threshold is 1/2. */
static unsigned round_level(double level, double top, bool dither, int x, int y)
{
    double threshold = dither ? (ref_bayer8(x, y) + 0.5) / 64 : 0.5;

    return (unsigned)fmin(floor(level + threshold), top);
}

/* The value that the formula gives for a tapped colour, with `off` levels added to a grey. */
static unsigned formula(const struct format *f, const double level[3], double off, bool dither, int x, int y)
{
    double kept[3];

    for (int k = 0; k < 3; k++)
        kept[k] = fmin(level[k], f->top[k]);
    if (f->levels)
        return round_level(kept[0] + kept[1] + kept[2] + off, f->levels - 1, dither, x, y);
    return round_level(kept[0], 31, dither, x, y) << 11 | round_level(kept[1], 63, dither, x, y) << 5 |
           round_level(kept[2], 31, dither, x, y);
}

/*
 * The value must be exactly the formula's, except for a grey with a clamped channel: the core clamps to weights of 16
 * bits, each within 2^-17 of the real weight.
 */
static bool is_right(const struct format *f, const double level[3], bool dither, int x, int y, unsigned value)
{
    if (value == formula(f, level, 0, dither, x, y))
        return true;
    if (!f->levels || (level[0] < f->top[0] && level[1] < f->top[1] && level[2] < f->top[2]))
        return false;
    double off = 3 * f->levels / 131072.0;
    return value == formula(f, level, -off, dither, x, y) || value == formula(f, level, off, dither, x, y);
}

struct tally {
    /* px; over: brighter than 1; otherwise: px that the transposed dither matrix would change */
    long drawn, background, over, otherwise;
};

/* A pixel that nothing was drawn on must hold the background, any other pixel what the formula gives. */
static void compare_pixel(struct tally *tally, const struct ref_scene *scene, const struct format *f, int x, int y,
                          unsigned value)
{
    const struct tapped *pixel = &tapped[y][x];

    if (!pixel->seen) {
        tally->background++;
        assert_int_equal(value, ref_value(scene, scene->background, x, y, true));
        return;
    }
    tally->drawn++;
    tally->over += pixel->level[1] > f->top[1];
    tally->otherwise += value != formula(f, pixel->level, 0, scene->dither, y, x); /* the pattern on its side */
    if (!is_right(f, pixel->level, scene->dither, x, y, value))
        fail_msg("%d levels, shading %d, (%d, %d): %u from %.6f %.6f %.6f", f->levels, scene->shading, x, y, value,
                 pixel->level[0], pixel->level[1], pixel->level[2]);
}

static void compare(struct tally *tally, struct ref_scene *scene, const struct sheen_mesh *mesh, const struct format *f)
{
    struct memory_target target;

    scene->levels = f->levels;
    assert_int_equal(memory_target_init(&target, scene->width, scene->height, f->pixel), 0);
    tap_begin();
    assert_int_equal(core_draw_scene(&target.target, scene, mesh, 16), SHEEN_OK);
    for (int i = 0; i < scene->width * scene->height; i++) {
        int x = i % scene->width, y = i / scene->width;
        compare_pixel(tally, scene, f, x, y, memory_target_pixel(&target, x, y));
    }
    assert_int_equal(target.breaches, 0);
    memory_target_free(&target);
}

/* Scene 0..3 of a view: with one light or four, linear on the screen or in space. */
static void set_scene(struct ref_scene *scene, const struct accuracy_mesh *mesh, int view, int number)
{
    accuracy_view(scene, &mesh->reference, view);
    if (number & 1)
        accuracy_more_lights(scene);
    scene->affine = number >> 1;
    scene->width = WIDTH;
    scene->height = HEIGHT;
}

/* Every shape, view, shading and format. */
static void shaded_pictures(void **state)
{
    (void)state;
    for (int k = 0; k < ACCURACY_SHAPES * 4; k++) {
        struct accuracy_mesh mesh;
        struct tally tally = {0, 0, 0, 0};
        assert_int_equal(accuracy_mesh_make(&mesh, k / 4, true), 0);
        for (int i = 0; i < ACCURACY_VIEWS * FORMATS * 4; i++) {
            struct ref_scene scene;
            set_scene(&scene, &mesh, i / 4 % ACCURACY_VIEWS, i % 4);
            scene.shading = (enum ref_shading)(k % 4);
            scene.dither = true;
            compare(&tally, &scene, mesh.mesh, &formats[i / 4 / ACCURACY_VIEWS]);
        }
        print_message(
            "  %-10s shading %d: %ld px drawn, all by the formula; %ld brighter than 1; by the pattern on its "
            "side %ld would differ\n",
            mesh.name, k % 4, tally.drawn, tally.over, tally.otherwise);
        accuracy_mesh_free(&mesh);
        assert_true(tally.drawn > 100000 && tally.background > 100000);
        assert_true(tally.otherwise > tally.drawn / 20); /* otherwise the comparison would prove nothing */
    }
}

/* The largest step between two 565 values. */
static int steps_apart(unsigned a, unsigned b)
{
    int red = abs((int)(a >> 11) - (int)(b >> 11)), green = abs((int)(a >> 5 & 63) - (int)(b >> 5 & 63));
    int blue = abs((int)(a & 31) - (int)(b & 31));

    return red > green ? (red > blue ? red : blue) : green > blue ? green : blue;
}

/*
 * The number of pixels of a plain picture that differ from the dithered picture's colours rounded at 1/2; they may
 * differ by one step. *fast: px that the plain picture drew without a tap.
 */
static long compare_plain(struct ref_scene *scene, const struct sheen_mesh *mesh, const struct format *f, long *fast)
{
    static struct tapped dithered[TAP_HEIGHT][TAP_WIDTH];
    struct memory_target target;
    long other = 0;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, f->pixel), 0);
    for (int plain = 0; plain < 2; plain++) {
        memcpy(dithered, tapped, sizeof dithered);
        tap_begin();
        scene->dither = !plain;
        assert_int_equal(core_draw_scene(&target.target, scene, mesh, 16), SHEEN_OK);
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        int x = i % WIDTH, y = i / WIDTH;
        if (!dithered[y][x].seen)
            continue;
        *fast += !tapped[y][x].seen;
        unsigned value = memory_target_pixel(&target, x, y), rounded = formula(f, dithered[y][x].level, 0, false, x, y);
        assert_true(steps_apart(value, rounded) <= 1);
        other += value != rounded;
    }
    memory_target_free(&target);
    return other;
}

/*
 * Without dither, 565 has loops of its own that do not call the tap: they look up finished pixels for 1,024
 * intensities, which moves a step of green by at most 1/10 of a level.
 */
static void plain_pictures(void **state)
{
    (void)state;
    for (int shading = 0; shading < 4; shading++) {
        long fast = 0, other = 0;
        for (int k = 0; k < ACCURACY_SHAPES * ACCURACY_VIEWS * 4 * 2; k++) {
            struct accuracy_mesh mesh;
            struct ref_scene scene;
            assert_int_equal(accuracy_mesh_make(&mesh, k / 8 / ACCURACY_VIEWS, true), 0);
            set_scene(&scene, &mesh, k / 8 % ACCURACY_VIEWS, k / 2 % 4);
            scene.shading = (enum ref_shading)shading;
            other += compare_plain(&scene, mesh.mesh, &formats[k % 2 ? 3 : 4], &fast);
            accuracy_mesh_free(&mesh);
        }
        print_message("  565 without dither, shading %d: %ld px by loops of their own, %ld differ\n", shading, fast,
                      other);
        assert_true((shading == REF_SLERP || fast > 100000) && other <= fast / 50); /* slerp has no loop of its own */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shaded_pictures), cmocka_unit_test(plain_pictures)};

    return cmocka_run_group_tests_name("dither", tests, NULL, NULL);
}
