/*
 * test_coverage.c - the rows of pixels that the core covers, against exact edge functions.
 *
 * Corners snapped to 1/64 px go through the core's triangle set-up and edge stepping. The spans that result must hold
 * exactly the pixels whose centres the fill rule covers, for random triangles, for all triangles on a lattice, and for
 * fans and grids, in which every pixel must be drawn once.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core_raster.h"
#include "exact_cover.h"
#include "frame_stage.h"

static struct core_raster raster;

static void fail_at(const struct cover_triangle *t, struct sheen_rect r, int x, int y, bool expected)
{
    fail_msg("(%d, %d) of rows %d..%d, columns %d..%d is %s by (%d, %d) (%d, %d) (%d, %d) in 1/64 px", x, y, r.y0,
             r.y1 - 1, r.x0, r.x1 - 1, expected ? "missed, though covered" : "drawn, though not covered", t->x[0],
             t->y[0], t->x[1], t->y[1], t->x[2], t->y[2]);
}

static void check_pixel(const struct cover_triangle *t, struct sheen_rect r, int x, int y, bool drawn)
{
    if (x >= r.x0 && x < r.x1 && cover_inside(t, x, y) != drawn)
        fail_at(t, r, x, y, !drawn);
}

/* The first and last columns that the triangle's edges reach on the scanline, with a pixel to spare on both sides. */
static void reach_of_row(const struct cover_triangle *t, int y, int *low, int *high)
{
    double centre = 64 * y + 32, least = 1e9, most = -1e9;

    for (int k = 0; k < 3; k++) {
        double ax = t->x[k], ay = t->y[k], bx = t->x[(k + 1) % 3], by = t->y[(k + 1) % 3];
        if ((ay < centre && by < centre) || (ay > centre && by > centre))
            continue;
        double at[2] = {ax, bx};
        if (ay != by)
            at[0] = at[1] = ax + (bx - ax) * (centre - ay) / (by - ay);
        for (int i = 0; i < 2; i++) {
            least = at[i] < least ? at[i] : least;
            most = at[i] > most ? at[i] : most;
        }
    }
    *low = (int)(least / 64) - 2;
    *high = (int)(most / 64) + 2;
}

/*
 * A row of a triangle is one run of pixels, so checking the two ends of a span and the pixels next to them decides the
 * whole row. An empty row is checked pixel by pixel.
 */
static void check_row(const struct cover_triangle *t, struct sheen_rect r, int y, struct span span)
{
    if (span.x0 < span.x1) {
        check_pixel(t, r, span.x0, y, true);
        check_pixel(t, r, span.x1 - 1, y, true);
        check_pixel(t, r, span.x0 - 1, y, false);
        check_pixel(t, r, span.x1, y, false);
        return;
    }
    int low, high;
    reach_of_row(t, y, &low, &high);
    for (int x = low < r.x0 ? r.x0 : low; x < (high > r.x1 ? r.x1 : high); x++)
        check_pixel(t, r, x, y, false);
}

/* Checks every row of the rectangle, also those above and below the rows that the core returns. */
static long check_triangle(const struct cover_triangle *t, struct sheen_rect r)
{
    struct span spans[480];
    int first;
    int rows = core_raster_spans(&raster, t, r, spans, &first);
    long pixels = 0;

    for (int i = 0; i < rows; i++) {
        if (spans[i].x0 < spans[i].x1 && (spans[i].x0 < r.x0 || spans[i].x1 > r.x1))
            fail_msg("a span reaches out of the rectangle");
    }
    for (int y = r.y0; y < r.y1; y++) {
        struct span none = {r.x0, r.x0}, span = y >= first && y < first + rows ? spans[y - first] : none;
        check_row(t, r, y, span);
        pixels += span.x0 < span.x1 ? span.x1 - span.x0 : 0;
    }
    return pixels;
}

/* The same, checking every pixel; for small rectangles. */
static void check_every_pixel(const struct cover_triangle *t, struct sheen_rect r)
{
    struct span spans[480];
    int first;
    int rows = core_raster_spans(&raster, t, r, spans, &first);

    for (int y = r.y0; y < r.y1; y++) {
        for (int x = r.x0; x < r.x1; x++) {
            bool drawn = y >= first && y < first + rows && x >= spans[y - first].x0 && x < spans[y - first].x1;
            check_pixel(t, r, x, y, drawn);
        }
    }
}

/* ---- random triangles ---- */

enum kind {
    SMALL,
    SLIVER,
    LARGE,
    HUGE_OUT,
    KINDS
};

static int32_t uniform(uint32_t *seed, int32_t low, int32_t high)
{
    return low + (int32_t)(stage_random(seed) % (uint32_t)(high - low));
}

static struct cover_triangle random_triangle(uint32_t *seed, enum kind kind)
{
    struct cover_triangle t;
    int32_t x = uniform(seed, 0, 640 * 64), y = uniform(seed, 0, 480 * 64);
    int32_t size = kind == SMALL ? 64 * uniform(seed, 1, 40) : 64 * uniform(seed, 40, 500);

    for (int k = 0; k < 3; k++) {
        if (kind == HUGE_OUT) {
            t.x[k] = 320 * 64 + uniform(seed, -36000, 36001);
            t.y[k] = 240 * 64 + uniform(seed, -36000, 36001);
        } else {
            t.x[k] = x + uniform(seed, -size, size + 1);
            t.y[k] = y + uniform(seed, -size, size + 1);
        }
    }
    if (kind == SLIVER) { /* the third corner is within 2 px of the line through the other two */
        double at = uniform(seed, -100, 200) / 100.0;
        t.x[2] = t.x[0] + (int32_t)(at * (t.x[1] - t.x[0])) + uniform(seed, -128, 129);
        t.y[2] = t.y[0] + (int32_t)(at * (t.y[1] - t.y[0])) + uniform(seed, -128, 129);
    }
    if (stage_random(seed) % 8 == 0)
        t.y[1] = t.y[0]; /* horizontal sides */
    if (stage_random(seed) % 8 == 0)
        t.x[2] = t.x[0];
    for (int k = 0; k < 3; k++) {
        if (stage_random(seed) % 8 == 0) { /* on a pixel centre */
            t.x[k] = (t.x[k] & ~63) + 32;
            t.y[k] = (t.y[k] & ~63) + 32;
        }
        t.x[k] = t.x[k] < 320 * 64 - 32704 ? 320 * 64 - 32704 : t.x[k] > 320 * 64 + 32704 ? 320 * 64 + 32704 : t.x[k];
        t.y[k] = t.y[k] < 240 * 64 - 32704 ? 240 * 64 - 32704 : t.y[k] > 240 * 64 + 32704 ? 240 * 64 + 32704 : t.y[k];
    }
    return t;
}

/* Random triangles clipped to the whole picture or to a band of it; in a band, edges start between their ends. */
static void random_triangles(void **state)
{
    static const int share[KINDS] = {600000, 250000, 100000, 50000}; /* 10^6 */
    uint32_t seed = 20240229;
    long triangles = 0, pixels = 0;

    (void)state;
    core_raster_begin(&raster, 640, 480);
    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < share[kind]; i++) {
            struct cover_triangle t = random_triangle(&seed, (enum kind)kind);
            struct sheen_rect r = {0, 0, 640, 480};
            if (stage_random(&seed) % 2) {
                r.y0 = (int16_t)uniform(&seed, 0, 464);
                r.y1 = (int16_t)(r.y0 + uniform(&seed, 1, 17));
                r.x0 = (int16_t)uniform(&seed, 0, 320);
                r.x1 = (int16_t)uniform(&seed, r.x0 + 1, 641);
            }
            pixels += check_triangle(&t, r);
            triangles++;
        }
    }
    print_message("  %ld triangles, %ld pixels, 0 wrong\n", triangles, pixels);
    assert_int_equal(triangles, 1000000);
    assert_true(pixels > 10000000);
}

/* ---- all triangles on a lattice ---- */

static void all_on_a_lattice(void **state)
{
    static const int32_t phase[4][2] = {{0, 0}, {1, 63}, {16, 9}, {31, 33}}; /* 1/64 px */
    struct sheen_rect r = {99, 69, 106, 76};
    long triangles = 0;

    (void)state;
    core_raster_begin(&raster, 240, 160);
    for (int p = 0; p < 4; p++) {
        for (int i = 0; i < 81 * 81 * 81; i++) {
            int node[3] = {i / 81 / 81, i / 81 % 81, i % 81};
            struct cover_triangle t;
            if (node[0] == node[1] || node[1] == node[2] || node[2] == node[0])
                continue;
            for (int k = 0; k < 3; k++) { /* 9 x 9 nodes, half a pixel apart */
                t.x[k] = 100 * 64 + phase[p][0] + 32 * (node[k] % 9);
                t.y[k] = 70 * 64 + phase[p][1] + 32 * (node[k] / 9);
            }
            check_every_pixel(&t, r);
            triangles++;
        }
    }
    print_message("  %ld triangles, 0 wrong pixels\n", triangles);
    assert_int_equal(triangles, 4 * 81 * 80 * 79);
}

/* ---- shared edges ---- */

static uint8_t times[480][640];

static void count_pixels(const struct cover_triangle *t, int width, int height)
{
    struct span spans[480];
    struct sheen_rect r = {0, 0, (int16_t)width, (int16_t)height};
    int first;
    int rows = core_raster_spans(&raster, t, r, spans, &first);

    for (int i = 0; i < rows; i++) {
        for (int x = spans[i].x0; x < spans[i].x1; x++)
            times[first + i][x]++;
    }
}

static void assert_once(int width, int height, const char *what)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            if (times[y][x] != 1)
                fail_msg("%s: (%d, %d) drawn %d times", what, x, y, times[y][x]);
        }
    }
}

/* Fans around a random point, with their rim outside the picture: each pixel must be drawn once. */
static void fans(void **state)
{
    static const int32_t rim[12][2] = {{-100, -100}, {20, -130}, {77, -90}, {170, -100}, {200, 13},  {180, 64},
                                       {170, 170},   {90, 200},  {63, 170}, {-110, 180}, {-90, 101}, {-120, 50}};
    uint32_t seed = 7;

    (void)state;
    core_raster_begin(&raster, 64, 64);
    for (int i = 0; i < 20000; i++) {
        int32_t x = uniform(&seed, 0, 64 * 64), y = uniform(&seed, 0, 64 * 64);
        if (i % 4 == 0) { /* on a pixel centre, where the edges then meet */
            x = (x & ~63) + 32;
            y = (y & ~63) + 32;
        }
        memset(times, 0, sizeof times);
        for (int k = 0; k < 12; k++) {
            const int32_t *a = rim[k], *b = rim[(k + 1) % 12];
            struct cover_triangle t = {{x, 64 * a[0], 64 * b[0]}, {y, 64 * a[1], 64 * b[1]}};
            count_pixels(&t, 64, 64);
        }
        assert_once(64, 64, "fan");
    }
}

/* Grids whose nodes are shaken by up to a quarter of the pitch, which keeps every cell convex. */
static void grids(void **state)
{
    enum {
        NODES = 34
    };
    static int32_t at[NODES][NODES][2];
    uint32_t seed = 11;

    (void)state;
    core_raster_begin(&raster, 96, 96);
    for (int i = 0; i < 3000; i++) {
        int32_t pitch = uniform(&seed, 64 * 4, 64 * 40), shake = pitch / 4;
        int cells = 96 * 64 / pitch + 3;
        for (int n = 0; n <= cells; n++) {
            for (int m = 0; m <= cells; m++) {
                at[n][m][0] = (m - 1) * pitch + uniform(&seed, -shake, shake + 1);
                at[n][m][1] = (n - 1) * pitch + uniform(&seed, -shake, shake + 1);
            }
        }
        memset(times, 0, sizeof times);
        for (int n = 0; n < cells; n++) {
            for (int m = 0; m < cells; m++) {
                const int32_t *a = at[n][m], *b = at[n][m + 1], *c = at[n + 1][m], *d = at[n + 1][m + 1];
                int other = (int)(stage_random(&seed) % 2); /* which diagonal */
                struct cover_triangle t = {{a[0], b[0], other ? c[0] : d[0]}, {a[1], b[1], other ? c[1] : d[1]}};
                struct cover_triangle u = {{d[0], c[0], other ? b[0] : a[0]}, {d[1], c[1], other ? b[1] : a[1]}};
                count_pixels(&t, 96, 96);
                count_pixels(&u, 96, 96);
            }
        }
        assert_once(96, 96, "grid");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_triangles),
        cmocka_unit_test(all_on_a_lattice),
        cmocka_unit_test(fans),
        cmocka_unit_test(grids),
    };

    return cmocka_run_group_tests_name("coverage", tests, NULL, NULL);
}
