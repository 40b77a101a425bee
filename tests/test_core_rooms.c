/*
 * test_core_rooms.c - each shading's room without a frame: light at the corners, set-up, rows, against its definition
 * in double precision, within a step of 565.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core_raster.h"
#include "frame_stage.h"
#include "test_core_worst.h"

#define WIDTH 160
#define HEIGHT 120
#define TRIANGLES 400
#define AMBIENT 0.1
#define DIFFUSE 0.8

struct scene {
    double x[3], y[3];   /* px */
    double normal[3][3]; /* unit, as the core has them */
    double light[3];     /* unit */
    int16_t normals[3][3];
};

typedef double intensity_at(const struct scene *s, double x, double y);

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void coordinates(const struct scene *s, double x, double y, double b[3])
{
    double area = 0;

    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        b[k] = (s->x[i] - x) * (s->y[j] - y) - (s->x[j] - x) * (s->y[i] - y);
        area += b[k];
    }
    for (int k = 0; k < 3; k++)
        b[k] /= area;
}

static double of_gouraud(const struct scene *s, double x, double y)
{
    double b[3], sum = 0;

    coordinates(s, x, y, b);
    for (int k = 0; k < 3; k++)
        sum += b[k] * fmax(0, dot(s->normal[k], s->light));
    return sum;
}

static double of_phong(const struct scene *s, double x, double y)
{
    double b[3], n[3];

    coordinates(s, x, y, b);
    for (int i = 0; i < 3; i++)
        n[i] = b[0] * s->normal[0][i] + b[1] * s->normal[1][i] + b[2] * s->normal[2][i];
    return fmax(0, dot(n, s->light) / sqrt(dot(n, n)));
}

/* Along the great arc from a to b. */
static void slerp(const double a[3], const double b[3], double t, double out[3])
{
    double angle = acos(fmin(1, dot(a, b))), from = 1 - t, to = t;

    if (angle > 1e-6) {
        from = sin((1 - t) * angle) / sin(angle);
        to = sin(t * angle) / sin(angle);
    }
    for (int i = 0; i < 3; i++)
        out[i] = from * a[i] + to * b[i];
}

/* Lecture, "Phong Shading by spherical interpolation": along the edges, then along the scan line. */
static double of_slerp(const struct scene *s, double x, double y)
{
    double at[2] = {0, 0}, normal[2][3], n[3];
    int found = 0;

    for (int k = 0; k < 3 && found < 2; k++) {
        int j = (k + 1) % 3;
        if ((s->y[k] <= y) == (s->y[j] <= y))
            continue;
        double t = (y - s->y[k]) / (s->y[j] - s->y[k]);
        at[found] = s->x[k] + t * (s->x[j] - s->x[k]);
        slerp(s->normal[k], s->normal[j], t, normal[found++]);
    }
    slerp(normal[0], normal[1], (x - at[0]) / (at[1] - at[0]), n);
    return fmax(0, dot(n, s->light));
}

static double of_flat(const struct scene *s, double x, double y)
{
    (void)x, (void)y;
    return fmax(0, dot(s->normal[0], s->light)); /* the polygon's normal */
}

static void random_unit(uint32_t *state, const double near[3], double spread, double unit[3])
{
    for (int i = 0; i < 3; i++)
        unit[i] = near[i] + stage_uniform(state, -spread, spread);
    double length = sqrt(dot(unit, unit));
    for (int i = 0; i < 3; i++)
        unit[i] /= length;
}

/* Corners on 1/64 px, counterclockwise as they are seen; 0 where they span little. */
static int random_scene(struct scene *s, struct core_raster *r, uint32_t *state, double spread)
{
    static const double ahead[3] = {0, 0, 1};
    double middle[3];

    random_unit(state, ahead, 0.4, middle);
    for (int k = 0; k < 3; k++) {
        s->x[k] = floor(stage_uniform(state, 0, WIDTH) * 64) / 64;
        s->y[k] = floor(stage_uniform(state, 0, HEIGHT) * 64) / 64;
        random_unit(state, middle, spread, s->normal[k]);
        for (int i = 0; i < 3; i++) {
            s->normals[k][i] = (int16_t)lrint(s->normal[k][i] * 32767);
            s->normal[k][i] = s->normals[k][i] / 32767.0;
        }
        r->vertex[k].x = (int16_t)lrint(64 * (s->x[k] - WIDTH / 2.0));
        r->vertex[k].y = (int16_t)lrint(64 * (s->y[k] - HEIGHT / 2.0));
        r->vertex[k].z = 20000;
        r->vertex[k].flags = 0;
    }
    return twice_area(&r->vertex[0], &r->vertex[1], &r->vertex[2]) < -64 * 64 * 200;
}

static void begin(struct core_raster *r, struct scene *s, const struct sheen_shader *shader)
{
    const struct sheen_light light = {.to = {19661, 26214, 56754}, .no_highlight = 1};
    struct sheen_pose pose;
    double length = 0;

    core_raster_begin(r, WIDTH, HEIGHT);
    sheen_pose_orbit(&pose, 0, 0, 0, 0);
    r->material = (struct sheen_material){
        .base = {200, 160, 90}, .ambient = (sheen_q16_t)(AMBIENT * 65536), .diffuse = (sheen_q16_t)(DIFFUSE * 65536)};
    assert_int_equal(sheen_light_begin(&r->draw.light, &light, 1, pose.rotation, NULL), SHEEN_OK);
    sheen_colour_begin(&r->draw.colour, &r->format, &r->material, r->draw.light.diffuse_sum,
                       r->draw.light.specular_sum);
    sheen_loop_begin(&r->draw.loop, &r->draw.power, &r->draw.colour, &r->format, 0);
    r->draw.is_565 = 1;
    r->format.swap = 0; /* this machine's order */
    r->draw.shader = shader;
    for (int i = 0; i < 3; i++)
        length += (double)light.to[i] * light.to[i];
    for (int i = 0; i < 3; i++)
        s->light[i] = light.to[i] / sqrt(length);
}

/* Steps that a pixel is off its definition, half a step for the rounding not counted. */
static double steps_off(uint16_t pixel, double intensity)
{
    static const double base[3] = {200 / 255.0, 160 / 255.0, 90 / 255.0}, top[3] = {31, 63, 31};
    const double level[3] = {pixel >> 11, pixel >> 5 & 63, pixel & 31};
    double most = 0;

    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(level[k] - (AMBIENT + DIFFUSE * intensity) * base[k] * top[k]));
    return fmax(0, most - 0.5);
}

/* Every pixel of random triangles, corner normals within `spread`. */
static void check_room(const struct sheen_shader *shader, intensity_at *intensity, double spread, double allowed)
{
    static uint16_t depth[WIDTH * HEIGHT], pixels[WIDTH * HEIGHT];
    struct worst worst = {0};
    struct core_raster r;
    struct scene s;
    uint32_t state = 3;

    begin(&r, &s, shader);
    for (int i = 0; i < TRIANGLES; i++) {
        if (!random_scene(&s, &r, &state, spread))
            continue;
        r.mesh.normals = &s.normals[0][0];
        r.mesh.polygon_normals = s.normals[0];
        for (int k = 0; k < 3 && shader->light != NULL; k++)
            shader->light(&r.draw, s.normals[k], r.vertex[k].kept);
        memset(depth, 0, sizeof depth);
        core_raster_draw(&r, depth, pixels);
        for (int at = 0; at < WIDTH * HEIGHT; at++)
            if (depth[at] != 0)
                worst_note(&worst, steps_off(pixels[at], intensity(&s, at % WIDTH + 0.5, at / WIDTH + 0.5)),
                           "triangle %d, pixel %d %d", i, at % WIDTH, at / WIDTH);
    }
    worst_assert(&worst, allowed, "steps of 565 beside the rounding");
}

static void flat_room(void **unused)
{
    (void)unused;
    check_room(&sheen_flat, of_flat, 0.5, 0.01);
}

static void gouraud_room(void **unused)
{
    (void)unused;
    check_room(&sheen_gouraud, of_gouraud, 0.5, 0.1);
}

static void phong_room(void **unused)
{
    (void)unused;
    check_room(&sheen_phong, of_phong, 0.1, 0.1);
    check_room(&sheen_phong, of_phong, 0.5, 0.1);
}

static void slerp_room(void **unused)
{
    (void)unused;
    check_room(&sheen_slerp, of_slerp, 0.05, 0.1);
    check_room(&sheen_slerp, of_slerp, 0.5, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(flat_room), cmocka_unit_test(gouraud_room),
                                       cmocka_unit_test(phong_room), cmocka_unit_test(slerp_room)};

    return cmocka_run_group_tests_name("rooms", tests, NULL, NULL);
}
