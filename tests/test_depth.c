/*
 * test_depth.c - the depths of pixels against exact planes, in steps of z16 (16-bit depth).
 *
 * Each depth must lie within a bound of the plane through the triangle's corners. Truncation of z16 accounts for 1
 * step, gradients of 15 bits for up to one more, although the depths of a triangle here differ by up to the whole range
 * of z16. The thinnest needles have a much larger bound because the core gives them one constant depth. Where two
 * surfaces intersect at a shallow angle, a pixel may show the wrong surface only if the planes are less than both
 * bounds apart.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core_raster.h"
#include "frame_stage.h"

#define WIDTH 320
#define HEIGHT 240
#define TRIANGLES 4000
#define PAIRS 400
#define BEHIND 3 /* steps of z16 for two surfaces, 1 1/2 each */

static struct core_raster raster;
static uint16_t depth[WIDTH * HEIGHT], other[WIDTH * HEIGHT];

/* A triangle: its corners in 1/64 px from the picture's centre, and z16 at each corner. */
struct slab {
    int32_t x[3], y[3], z[3];
};

static double area_of(const struct slab *s)
{
    return (double)(s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) - (double)(s->y[1] - s->y[0]) * (s->x[2] - s->x[0]);
}

/* The plane's z16 at the centre of a pixel. */
static double exact_at(const struct slab *s, int px, int py)
{
    double x = 64 * px + 32 - 32 * WIDTH, y = 64 * py + 32 - 32 * HEIGHT, sum = 0;

    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        sum += s->z[k] * ((s->x[i] - x) * (s->y[j] - y) - (s->y[i] - y) * (s->x[j] - x));
    }
    return sum / area_of(s);
}

static void draw(const struct slab *s, uint16_t *to)
{
    for (int k = 0; k < 3; k++) {
        bool off = abs(s->x[k]) > 32 * WIDTH || abs(s->y[k]) > 32 * HEIGHT;
        raster.vertex[k] = (struct vertex){.x = (int16_t)s->x[k],
                                           .y = (int16_t)s->y[k],
                                           .z = (uint16_t)s->z[k],
                                           .flags = (uint16_t)(off ? OFF_VIEW : 0)};
    }
    core_raster_depths(&raster, to);
}

/* The largest distance of a drawn depth from the plane, in steps. */
static double worst_of(const struct slab *s)
{
    double worst = 0;

    memset(depth, 0, sizeof depth);
    draw(s, depth);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            if (depth[y * WIDTH + x] != 0)
                worst = fmax(worst, fabs(depth[y * WIDTH + x] - exact_at(s, x, y)));
        }
    }
    return worst;
}

/* Corners within `size` of a place within `reach` of the centre (1/64 px); depths within `steep` of one depth. */
static void random_slab(struct slab *s, uint32_t *state, double size, double reach, double steep)
{
    double cx = stage_uniform(state, -reach, reach), cy = stage_uniform(state, -reach, reach);
    double cz = stage_uniform(state, 1000, 65000);

    for (int k = 0; k < 3; k++) {
        s->x[k] = (int32_t)fmax(-32704, fmin(32704, cx + stage_uniform(state, -size, size)));
        s->y[k] = (int32_t)fmax(-32704, fmin(32704, cy + stage_uniform(state, -size, size)));
        s->z[k] = (int32_t)fmax(1, fmin(65535, cz + stage_uniform(state, -steep, steep)));
    }
}

/* Moves corner 2 to within `across` (1/64 px) of the line between the other two. */
static void make_needle(struct slab *s, uint32_t *state, double across)
{
    double t = stage_uniform(state, 0, 1);

    s->x[2] = (int32_t)(s->x[0] + t * (s->x[1] - s->x[0]) + stage_uniform(state, -across, across));
    s->y[2] = (int32_t)(s->y[0] + t * (s->y[1] - s->y[0]) + stage_uniform(state, -across, across));
}

/* Twice the area over the square of the longest side. */
static double fatness(const struct slab *s)
{
    double longest = 1;

    for (int k = 0; k < 3; k++) {
        double dx = s->x[(k + 1) % 3] - s->x[k], dy = s->y[(k + 1) % 3] - s->y[k];
        longest = fmax(longest, dx * dx + dy * dy);
    }
    return fabs(area_of(s)) / longest;
}

/* The worst of many triangles. With `across` 0, triangles thinner than an eighth of their length are skipped. */
static void check_slabs(const char *what, double size, double reach, double across, double bound)
{
    uint32_t state = 1;
    double worst = 0;

    for (int i = 0; i < TRIANGLES; i++) {
        struct slab s;
        random_slab(&s, &state, stage_uniform(&state, 64, size), reach, exp(stage_uniform(&state, 0, log(60000))));
        if (across > 0)
            make_needle(&s, &state, across);
        if (across > 0 ? area_of(&s) != 0 : fatness(&s) > 0.125)
            worst = fmax(worst, worst_of(&s));
    }
    print_message("  depth of %-32s off by %.2f steps of z16 at most (bound %.0f)\n", what, worst, bound);
    assert_true(worst > 0 && worst <= bound);
}

static void planes(void **unused)
{
    (void)unused;
    check_slabs("triangles to 8 px", 4 * 64, 100 * 64, 0, 3);
    check_slabs("triangles to 64 px", 32 * 64, 80 * 64, 0, 3);
    check_slabs("triangles to the picture's size", 110 * 64, 10 * 64, 0, 3);
    check_slabs("triangles beyond the picture", 500 * 64, 200 * 64, 0, 3);
}

static void needles(void **unused)
{
    (void)unused;
    check_slabs("needles of 1 px", 110 * 64, 10 * 64, 64, 2);
    check_slabs("needles of 1/8 px", 110 * 64, 10 * 64, 8, 2);
    check_slabs("needles of 1/32 px", 110 * 64, 10 * 64, 2, 2300);
    check_slabs("needles beyond the picture", 500 * 64, 200 * 64, 16, 2);
}

/*
 * Another triangle whose corners lie within `angle` steps of the first one's plane. False if a depth is out of range or
 * the triangle is too thin.
 */
static bool tilted(const struct slab *a, struct slab *b, uint32_t *state, double angle)
{
    random_slab(b, state, 110 * 64, 10 * 64, 1);
    for (int k = 0; k < 3; k++) {
        int px = (b->x[k] + 32 * WIDTH) >> 6, py = (b->y[k] + 32 * HEIGHT) >> 6;
        b->z[k] = (int32_t)(exact_at(a, px, py) + stage_uniform(state, -angle, angle));
        if (b->z[k] < 1 || b->z[k] > 65535)
            return false;
    }
    return fatness(b) > 0.125;
}

/*
 * Counts the pixels that both triangles cover and those of them that show the surface behind. Returns how far behind
 * that surface lies at most.
 */
static double wrong_side(uint32_t *state, double angle, long *wrong, long *pixels)
{
    struct slab a, b;
    double worst = 0;

    do
        random_slab(&a, state, 110 * 64, 10 * 64, 20000);
    while (fatness(&a) < 0.125 || !tilted(&a, &b, state, angle));
    memset(depth, 0, sizeof depth);
    memset(other, 0, sizeof other);
    draw(&a, depth);
    draw(&b, other);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double apart = exact_at(&b, i % WIDTH, i / WIDTH) - exact_at(&a, i % WIDTH, i / WIDTH);
        bool both = depth[i] != 0 && other[i] != 0;
        *pixels += both;
        if (!both || (other[i] > depth[i]) == (apart > 0))
            continue;
        ++*wrong;
        worst = fmax(worst, fabs(apart));
    }
    return worst;
}

static void intersections(void **unused)
{
    static const double angles[] = {10, 100, 1000};
    uint32_t state = 1;

    (void)unused;
    for (int k = 0; k < 3; k++) {
        double worst = 0;
        long wrong = 0, pixels = 0;
        for (int i = 0; i < PAIRS; i++)
            worst = fmax(worst, wrong_side(&state, angles[k], &wrong, &pixels));
        print_message("  surfaces to %4.0f steps apart: %.3f %% of their pixels show the wrong one, "
                      "%.2f steps behind at most (bound %d)\n",
                      angles[k], 100.0 * (double)wrong / (double)pixels, worst, BEHIND);
        assert_true(worst <= BEHIND);
    }
}

static int begin(void **unused)
{
    (void)unused;
    core_raster_begin(&raster, WIDTH, HEIGHT);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(planes), cmocka_unit_test(needles),
                                       cmocka_unit_test(intersections)};

    return cmocka_run_group_tests_name("depth", tests, begin, NULL);
}
