/*
 * test_core_gradient.c - planes and second differences over triangles against double precision, at every covered pixel.
 *
 * Tolerances. A plane of 31 bits: 1 raw step, 1/2 a step for each pixel walked from corner 0 in x and in y, and of the
 * largest difference between corners 2^-29 (the reciprocal of the area) and 2^-exponent - 16 for each pixel walked. One
 * of 15 bits: of that difference 2^-15 (the seed), as much more as a needle's steps are larger, and 2^-exponent for
 * each pixel, and 2^(7 - exponent) of the differences' unit where corner 0 lies in its pixel. What Phong adds: L.N and
 * V.N over the root of N.N, 6 + 6 |Ni - Nj|^2 + 2^-18 (x^2 + |x y| + y^2) raw steps of Q0.15 over N.N, x and y walked
 * from corner 0, as much more as a needle's steps are larger.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "core_raster.h"
#include "frame_stage.h"
#include "shading/phong.h"

/* A quadric's value at a pixel, in closed form. */
static uint32_t quadric_at(const struct quadric *q, int32_t x, int32_t y)
{
    uint32_t ux = (uint32_t)x, uy = (uint32_t)y;

    return q->base + ux * q->dx + uy * q->dy + pairs(x) * q->dxx + ux * uy * q->dxy + pairs(y) * q->dyy;
}

#define WIDTH 640
#define HEIGHT 480
#define TRIANGLES 2500
#define ONE 1073741824.0 /* Q1.30 */

/* Corners clockwise, 1/64 px of the picture; barycentric coordinates of a pixel's centre. */
struct shape2 {
    int32_t x[3], y[3];
    double area;
};

/* Every size from a pixel to the picture; every fourth one a sliver of 1/64 to 1 px across. */
static int random_shape(struct shape2 *s, uint32_t *state, int i)
{
    double size = exp(stage_uniform(state, log(64), log(64 * 600)));
    double cx = stage_uniform(state, 0, WIDTH * 64), cy = stage_uniform(state, 0, HEIGHT * 64);

    for (int k = 0; k < 3; k++) {
        s->x[k] = (int32_t)fmin(WIDTH * 64, fmax(0, cx + stage_uniform(state, -size, size)));
        s->y[k] = (int32_t)fmin(HEIGHT * 64, fmax(0, cy + stage_uniform(state, -size, size)));
    }
    if (i % 4 == 0) {
        double t = stage_uniform(state, 0, 1);
        s->x[2] = (int32_t)(s->x[0] + t * (s->x[1] - s->x[0]) + stage_uniform(state, -32, 32));
        s->y[2] = (int32_t)(s->y[0] + t * (s->y[1] - s->y[0]) + stage_uniform(state, -32, 32));
    }
    s->area = (double)(s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) - (double)(s->y[1] - s->y[0]) * (s->x[2] - s->x[0]);
    if (s->area < 0) {
        int32_t x = s->x[1], y = s->y[1];
        s->x[1] = s->x[2];
        s->y[1] = s->y[2];
        s->x[2] = x;
        s->y[2] = y;
        s->area = -s->area;
    }
    return s->area > 0;
}

/* 1 where the centre of pixel (px, py) is inside. */
static int barycentric(const struct shape2 *s, int px, int py, double b[3])
{
    double x = px * 64 + 32, y = py * 64 + 32;

    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        b[k] = ((s->x[i] - x) * (s->y[j] - y) - (s->y[i] - y) * (s->x[j] - x)) / s->area;
    }
    return b[0] >= 0 && b[1] >= 0 && b[2] >= 0;
}

/* Calls at(ctx, px, py, b) for covered pixels: all of small triangles, every so many of large ones. */
static void each_pixel(const struct shape2 *s, void (*at)(void *, int, int, const double *), void *ctx)
{
    int x0 = WIDTH, x1 = 0, y0 = HEIGHT, y1 = 0, count = 0;

    for (int k = 0; k < 3; k++) {
        x0 = min32(x0, s->x[k] >> 6);
        x1 = max32(x1, s->x[k] >> 6);
        y0 = min32(y0, s->y[k] >> 6);
        y1 = max32(y1, s->y[k] >> 6);
    }
    int step = 1 + (x1 - x0) * (y1 - y0) / 20000;
    for (int y = y0; y <= y1; y++)
        for (int x = x0; x <= x1; x++) {
            double b[3];
            if (count++ % step == 0 && barycentric(s, x, y, b))
                at(ctx, x, y, b);
        }
}

/* As set-up makes them; 0 where the triangle is too flat. */
static int gradients_of(const struct shape2 *s, struct gradients *g)
{
    uint32_t all = 0;

    for (int i = 0; i < 2; i++) {
        const int32_t *at = i == 0 ? s->x : s->y;
        g->to1[i] = at[1] - at[0];
        g->to2[i] = at[2] - at[0];
        all |= magnitude32(g->to1[i]) | magnitude32(g->to2[i]);
    }
    g->bits = (uint16_t)(32 - clz32(all));
    g->area = (uint32_t)s->area;
    return sheen_gradients(g, s->x[0], s->y[0]);
}

/* ---- planes ---- */

struct plane_case {
    struct worst *worst;
    const struct shape2 *shape;
    const struct gradients *g;
    struct plane plane;
    int32_t value[3];
    unsigned up;
    int narrow;
    double largest; /* difference, raw steps with `up` more bits */
};

static double plane_slack(const struct gradients *g, double largest, double dx, double dy, int narrow)
{
    return 1 + (dx + dy) / 2 + (narrow ? ldexp(1, 16 + 7 - g->exponent) : 0) +
           largest * (narrow ? ldexp(1, g->stretch - 14) + (dx + dy) * ldexp(1, -g->exponent)
                             : 0x1p-29 + (dx + dy) * ldexp(1, -g->exponent - 16));
}

static void note_plane(void *ctx, int px, int py, const double *b)
{
    struct plane_case *c = ctx;
    double dx = abs(px - c->g->origin[0]) + 1, dy = abs(py - c->g->origin[1]) + 1;
    double exact = (b[0] * c->value[0] + b[1] * c->value[1] + b[2] * c->value[2]) * ldexp(1, (int)c->up);
    int32_t off = (int32_t)(plane_at(&c->plane, px, py) - (uint32_t)(int64_t)rint(exact)); /* modulo 2^32 */

    worst_note(c->worst, off / plane_slack(c->g, c->largest, dx, dy, c->narrow),
               "pixel %d %d, corner 0 at %d %d, exponent %d", px, py, c->shape->x[0], c->shape->y[0], c->g->exponent);
}

static void test_planes(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 1;
    int flat = 0;

    (void)unused;
    for (int i = 0; i < TRIANGLES; i++) {
        static const unsigned ups[] = {0, 1, 16};
        struct shape2 shape;
        struct gradients g;
        if (!random_shape(&shape, &state, i))
            continue;
        if (!gradients_of(&shape, &g)) {
            flat++;
            continue;
        }
        struct plane_case c = {.worst = &worst, .shape = &shape, .g = &g, .up = ups[i % 3]};
        for (int k = 0; k < 3; k++)
            c.value[k] = c.up == 16 ? (int32_t)(stage_random(&state) >> 17)
                                    : (int32_t)(stage_random(&state) >> (1 + stage_random(&state) % 20));
        for (int k = 1; k < 3; k++)
            c.largest = fmax(c.largest, fabs((double)c.value[k] - c.value[0]) * ldexp(1, (int)c.up));
        c.plane = sheen_gradient_plane(&g, c.value, c.up);
        each_pixel(&shape, note_plane, &c);
        c.narrow = !g.wide;
        for (int k = 0; k < 3; k++)
            c.value[k] = c.value[k] >> 16;
        c.largest = fmax(fabs((double)c.value[1] - c.value[0]), fabs((double)c.value[2] - c.value[0])) * 0x1p16;
        c.up = 16;
        sheen_plane(&c.plane, &g, (uint32_t)c.value[0] << 16, c.value[1] - c.value[0], c.value[2] - c.value[0], 16);
        each_pixel(&shape, note_plane, &c);
    }
    worst_assert(&worst, 1, "planes in tolerances");
    assert_true(flat < TRIANGLES / 50);
}

/* Only slivers are refused, and none that is a 64th of a pixel or more across over its longest side. */
static void test_what_is_too_flat(void **unused)
{
    uint32_t state = 2;
    int refused = 0;

    (void)unused;
    for (int i = 0; i < 200000; i++) {
        struct shape2 shape;
        struct gradients g;
        if (!random_shape(&shape, &state, i % 8 == 0 ? 0 : i * 4))
            continue;
        double longest = 0;
        for (int k = 0; k < 3; k++)
            longest = fmax(longest, hypot(shape.x[(k + 1) % 3] - shape.x[k], shape.y[(k + 1) % 3] - shape.y[k]));
        int made = gradients_of(&shape, &g);
        refused += !made;
        if (!made)
            assert_true(shape.area / longest < 1); /* 1/64 px */
        else
            assert_in_range(g.exponent, 4, 24 + 15);
    }
    assert_true(refused > 10);
}

/* ---- ranges ---- */

/* Corners on the guard band's limits and needles between them: what triangle.h says of b1, b2 and exponent. */
static void test_range_of_gradients(void **unused)
{
    uint32_t state = 5;
    int lowest = 99, highest = 0;
    int32_t most = 0;

    (void)unused;
    for (int i = 0; i < 400000; i++) {
        struct shape2 shape;
        int32_t *x = shape.x, *y = shape.y;
        for (int k = 0; k < 3; k++) {
            x[k] = min32(65408, (int32_t)(stage_random(&state) % 80000) >> (i % 2 == 0 ? 0 : i / 2 % 17));
            y[k] = min32(65408, (int32_t)(stage_random(&state) % 80000) >> (i % 2 == 0 ? 0 : i / 2 % 17));
        }
        for (int32_t step = 1; i % 3 == 0 && step >= 0; step--) { /* a needle, 0 or 1/64 px beside the side 0 1 */
            x[2] = x[0] + (x[1] - x[0]) / 2 + (i / 3 % 2 == 0 ? step : 0);
            y[2] = y[0] + (y[1] - y[0]) / 2 + (i / 3 % 2 == 0 ? 0 : step);
        }
        int64_t area = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) - (int64_t)(y[1] - y[0]) * (x[2] - x[0]);
        struct gradients g;
        shape.area = (double)area;
        if (area <= 0 || !gradients_of(&shape, &g))
            continue;
        for (int k = 0; k < 2; k++)
            most = max32(most, max32(abs(g.b1[k]), abs(g.b2[k])));
        lowest = g.exponent < lowest ? g.exponent : lowest;
        highest = g.exponent > highest ? g.exponent : highest;
    }
    print_message("           exponent %d..%d, |b| at most %d\n", lowest, highest, most);
    assert_true(lowest == 4 && highest == 24);
    assert_true(most < 1 << 15);
}

/* The steepest that may come: needles across the guard bands, the smallest areas, and the largest values. */
static void test_steepest_slopes(void **unused)
{
    static const unsigned ups[3] = {0, 1, 16};
    static const int32_t last[3] = {INT32_MAX, INT32_MAX, 65535};
    uint32_t state = 7;
    double steepest = 0;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        int u = i % 3, values = i / 3 % 8;
        int32_t length = (int32_t)(stage_random(&state) % 65408) + 1, across = 1 + (int32_t)(stage_random(&state) % 64);
        struct shape2 shape = {{i % 2 == 0 ? 0 : 65408, 0, 0}, {0, 0, 0}, 0};
        struct gradients g;
        shape.x[1] = shape.x[0] + (i % 2 == 0 ? length : -length);
        shape.x[2] = shape.x[0] + (int32_t)(stage_random(&state) % 3) - 1;
        shape.y[2] = i % 2 == 0 ? across : -across;
        if (i % 4 == 3) { /* area 1 / 4096 px^2 */
            length = length % 40 + 1;
            shape = (struct shape2){{0, length, length + 1}, {0, length - 1, length}, 0};
        }
        shape.area = (double)(shape.x[1] - shape.x[0]) * (shape.y[2] - shape.y[0]) -
                     (double)(shape.y[1] - shape.y[0]) * (shape.x[2] - shape.x[0]);
        if (!gradients_of(&shape, &g))
            continue;
        const int32_t value[3] = {values & 1 ? last[u] : 0, values & 2 ? last[u] : 0, values & 4 ? last[u] : 0};
        long double scale = ldexpl(64, (int)ups[u]) / g.area, d[2];
        long double d1 = (long double)value[1] - value[0], d2 = (long double)value[2] - value[0];
        long double slack = 2 + ldexpl(last[u], (int)ups[u] - g.exponent - 16 + 1);
        struct slope s;
        sheen_slope(&g, value, ups[u], &s);
        d[0] = (d1 * g.to2[1] - d2 * g.to1[1]) * scale;
        d[1] = (d2 * g.to1[0] - d1 * g.to2[0]) * scale;
        slack += (fabsl(d[0]) + fabsl(d[1])) * 0x1p-28L;
        assert_true(fabsl((long double)s.dx - d[0]) <= slack && fabsl((long double)s.dy - d[1]) <= slack);
        long double exact = ldexpl(value[0], (int)ups[u]) + (d[0] * g.centre[0] + d[1] * g.centre[1]) / 64;
        assert_true(fabsl((long double)s.value - exact) <= 2 * slack + 2);
        steepest = fmax(steepest, fmax(fabs((double)d[0]), fabs((double)d[1])));
    }
    print_message("           steepest 2^%.1f\n", log2(steepest));
    assert_true(steepest <= 0x1p44 && steepest > 0x1p41);
}

/* ---- what Phong needs ---- */

struct phong_case {
    struct worst *cosine;
    struct core_raster *raster;
    struct core_setup setup;
    struct gradients g;
    double n[3][3]; /* corner normals times weight */
    double apart;   /* the largest |Ni - Nj|^2 */
};

/* v.N over |N| of the walks against that of the interpolated normal; Q0.15 steps. */
static void note_cosine(struct phong_case *c, double dot, double square, double walked, const int32_t v[3],
                        const double n[3], const char *which)
{
    double exact = 0, length = 0, slack = (6 + walked + 6 * c->apart) * fmax(1, ldexp(1, c->g.stretch));

    for (int i = 0; i < 3; i++) {
        exact += n[i] * v[i] / ONE;
        length += n[i] * n[i];
    }
    double off = dot / sqrt(square / 2 * ONE) - exact / sqrt(length);
    worst_note(c->cosine, off * 32768 * length / slack, "%s, stretch %d, N.N %.3f", which, c->g.stretch, length);
}

static void note_phong(void *ctx, int px, int py, const double *b)
{
    struct phong_case *c = ctx;
    const struct lighting *l = &c->raster->draw.light;
    const struct phong_setup *phong = (const struct phong_setup *)(const void *)&c->setup;
    double n[3], d = quadric_at(&phong->square, px - phong->x, py - phong->y);

    for (int i = 0; i < 3; i++)
        n[i] = b[0] * c->n[0][i] + b[1] * c->n[1][i] + b[2] * c->n[2][i];
    double dx = px - phong->x, dy = py - phong->y, walked = ldexp(dx * dx + fabs(dx * dy) + dy * dy, -18);
    note_cosine(c, (int32_t)plane_at(&phong->light, px, py), d, walked, l->to[0], n, "L.N");
    note_cosine(c, (int32_t)plane_at(&phong->view, px, py), d, walked, l->view, n, "V.N");
}

/* Corner normals within `spread` of one direction; weights as setup.c makes them of z16. */
static void random_corners(struct core_raster *r, struct phong_case *c, int16_t normals[9], uint32_t *state,
                           double spread)
{
    double centre[3], weight[3], most = 0;

    for (int i = 0; i < 3; i++)
        centre[i] = stage_uniform(state, -1, 1);
    for (int k = 0; k < 3; k++) {
        const struct screen *p = &r->screen;
        double n[3], length = 0;
        r->vertex[k].z = (uint16_t)(20000 + stage_random(state) % 45000);
        weight[k] = ((uint32_t)r->vertex[k].z << p->weight_shift) + p->weight_offset;
        most = fmax(most, weight[k]);
        for (int i = 0; i < 3; i++) {
            n[i] = centre[i] + spread * stage_uniform(state, -1, 1);
            length += n[i] * n[i];
        }
        for (int i = 0; i < 3; i++)
            normals[3 * k + i] = (int16_t)lrint(n[i] / sqrt(length) * 32767);
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            c->n[k][i] = normals[3 * k + i] / 32767. * (r->screen.flat_weight ? 1 : weight[k] / most);
}

static void note_triangle(struct core_raster *r, struct phong_case *c, uint32_t *state, int i)
{
    int16_t normals[9];
    struct shape2 shape;
    struct span spans[HEIGHT];

    if (!random_shape(&shape, state, i) || !gradients_of(&shape, &c->g))
        return;
    for (int k = 0; k < 3; k++) { /* clockwise is what set-up orders corners to: corner 0 stays the first */
        r->vertex[k].x = (int16_t)(shape.x[k] - WIDTH * 32);
        r->vertex[k].y = (int16_t)(shape.y[k] - HEIGHT * 32);
    }
    random_corners(r, c, normals, state, i % 3 == 0 ? 0.05 : i % 3 == 1 ? 0.3 : 1);
    for (int k = 0; k < 9; k++) /* a back face: set-up takes them negated */
        normals[k] = (int16_t)-normals[k];
    r->mesh.normals = normals;
    for (int k = 0; k < 3; k++) {
        double apart = 0;
        for (int j = 0; j < 3; j++)
            apart += pow((normals[3 * k + j] - normals[3 * ((k + 1) % 3) + j]) / 32767., 2);
        c->apart = fmax(c->apart, apart);
        sheen_keep_cosines(&r->draw, normals + 3 * k, r->vertex[k].kept);
    }
    if (core_raster_set_up(r, r->screen.viewport, spans, &c->setup) == 0 || c->setup.s.way != SHEEN_WAY_PHONG_ROOT)
        return;
    each_pixel(&shape, note_phong, c);
}

static void note_light(struct core_raster *r, uint32_t *state)
{
    struct sheen_light light = {.intensity = 65536};
    struct sheen_pose pose;

    for (int k = 0; k < 3; k++)
        light.to[k] = (int32_t)stage_random(state);
    sheen_pose_orbit(&pose, stage_random(state), stage_random(state), stage_random(state), 0);
    assert_int_equal(sheen_light_begin(&r->draw.light, &light, 1, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
}

static void test_phong_set_up(void **unused)
{
    struct worst cosine = {0};
    static struct core_raster r;
    uint32_t state = 3;

    (void)unused;
    core_raster_begin(&r, WIDTH, HEIGHT);
    r.draw.shader = &sheen_phong;
    r.draw.forced = 1 + SHEEN_WAY_PHONG_ROOT; /* the others take nodes in their place */
    const struct sheen_view view = {.fov = SHEEN_DEGREES(40), .z_near = SHEEN_Q24(1), .z_far = SHEEN_Q24(10)};
    struct projection projection;
    assert_int_equal(sheen_project_begin(&projection, &view, WIDTH, HEIGHT), SHEEN_OK);
    r.screen.weight_shift = (uint8_t)projection.weight_shift;
    r.screen.weight_offset = projection.weight_offset;
    for (int i = 0; i < TRIANGLES; i++) {
        struct phong_case c = {.cosine = &cosine, .raster = &r};
        r.screen.flat_weight = i % 2 == 0;
        note_light(&r, &state);
        note_triangle(&r, &c, &state, i);
    }
    worst_assert(&cosine, 1, "L.N and V.N in tolerances");
}

/* ---- excesses ---- */

/* At the ends of its range a cosine's excess is what 64 bits make of it. */
static void test_cosine_excess(void **unused)
{
    static const int32_t ends[] = {-32767, -32766, 0, 1, 32767};

    (void)unused;
    for (int32_t h = 0; h <= 22400; h += 7)
        for (int32_t lean = -32768; lean <= 32768; lean += 4096)
            for (int i = 0; i < 25; i++) {
                const int64_t first = ends[i / 5], second = ends[i % 5], e = h + (3 * (int64_t)h * h >> 20);
                const int64_t exact = e * (first + second) + lean * (first - second);
                assert_int_equal(sheen_cosine_excess(ends[i / 5], ends[i % 5], h, lean), (int32_t)asr64(exact, 17));
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_planes),           cmocka_unit_test(test_cosine_excess),
        cmocka_unit_test(test_what_is_too_flat), cmocka_unit_test(test_range_of_gradients),
        cmocka_unit_test(test_steepest_slopes),  cmocka_unit_test(test_phong_set_up),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
