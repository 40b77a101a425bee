/*
 * test_turned.c - the picture turned by 90 degrees, by rolling mesh and light. With Gouraud and Phong over triangles
 * the colours must not depend on orientation; with slerp they do (lecture, "Orientation Dependence").
 *
 * The core's unrounded colours are compared pixel by pixel, away from edges. With slerp they must change by what
 * slerp's definition in double precision changes by.
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

#define SIZE 240 /* px */

/* A picture by the core and by the reference, unrounded. */
struct both {
    double core[SIZE][SIZE][3];
    struct ref_picture reference;
    uint16_t value[SIZE][SIZE]; /* 565, without dither */
};

static double clamp01(double c)
{
    return fmin(fmax(c, 0), 1);
}

static void draw(struct both *to, struct ref_scene *scene, const struct sheen_mesh *mesh)
{
    static const double top[3] = {31, 63, 31};
    struct memory_target target;

    assert_int_equal(memory_target_init(&target, SIZE, SIZE, SHEEN_RGB565_BE), 0);
    for (int dither = 0; dither < 2; dither++) {
        tap_begin();
        scene->dither = dither; /* without dither, pixels may be drawn by ways without a tap */
        assert_int_equal(core_draw_scene(&target.target, scene, mesh, 16), SHEEN_OK);
        for (int i = 0; i < SIZE * SIZE && !dither; i++)
            to->value[i / SIZE][i % SIZE] = (uint16_t)memory_target_pixel(&target, i % SIZE, i / SIZE);
    }
    for (int i = 0; i < SIZE * SIZE * 3; i++)
        to->core[i / 3 / SIZE][i / 3 % SIZE][i % 3] =
            clamp01(tapped[i / 3 / SIZE][i / 3 % SIZE].level[i % 3] / top[i % 3]);
    assert_int_equal(ref_render(&to->reference, scene), 0);
    memory_target_free(&target);
}

/* True if 3x3 pixels show the mesh without a jump in depth: neither outline nor fold. */
static bool away_from_edges(const struct ref_picture *picture, int x, int y)
{
    const struct ref_pixel *p = &picture->pixels[y * SIZE + x];

    if (x < 1 || y < 1 || x > SIZE - 2 || y > SIZE - 2)
        return false;
    for (int k = 0; k < 9; k++) {
        const struct ref_pixel *q = p + (k / 3 - 1) * SIZE + k % 3 - 1;
        if (!q->covered || fabs(q->m - p->m) > 0.02 * p->m)
            return false;
    }
    return true;
}

/* What turning changes, in 1/255: in the core, in the definition; and how far the two are apart. */
struct change {
    double core, core_mean, reference, apart;
    long compared, equal; /* px; equal: the same 565 value */
    int steps;            /* the largest difference in 565 steps */
};

static int steps_between(unsigned a, unsigned b)
{
    int r = abs((int)(a >> 11) - (int)(b >> 11)), g = abs((int)(a >> 5 & 63) - (int)(b >> 5 & 63));
    int c = abs((int)(a & 31) - (int)(b & 31));

    return r > g ? (r > c ? r : c) : g > c ? g : c;
}

/* Turned counter-clockwise, pixel (x, y) becomes (y, SIZE - 1 - x). */
static void compare(struct change *c, const struct both *a, const struct both *b)
{
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE, y = i / SIZE, tx = y, ty = SIZE - 1 - x;
        if (!away_from_edges(&a->reference, x, y) || !away_from_edges(&b->reference, tx, ty))
            continue;
        int steps = steps_between(a->value[y][x], b->value[ty][tx]);
        c->steps = steps > c->steps ? steps : c->steps;
        c->equal += steps == 0;
        c->compared++;
        for (int k = 0; k < 3; k++) {
            double core = 255 * (b->core[ty][tx][k] - a->core[y][x][k]);
            double reference = 255 * (clamp01(b->reference.pixels[ty * SIZE + tx].color[k]) -
                                      clamp01(a->reference.pixels[y * SIZE + x].color[k]));
            c->core = fmax(c->core, fabs(core));
            c->core_mean += fabs(core);
            c->reference = fmax(c->reference, fabs(reference));
            c->apart = fmax(c->apart, fabs(core - reference));
        }
    }
}

/* All views of a mesh, with one light and four, linear in space and on the screen. */
static struct change turn_mesh(const struct accuracy_mesh *mesh, enum ref_shading shading)
{
    static const double yaw_pitch[3][2] = {{30, 20}, {75, -35}, {200, 60}};
    static struct both straight, turned;
    struct change change = {.compared = 0};

    for (int i = 0; i < 12; i++) {
        struct ref_scene scene;
        accuracy_view(&scene, &mesh->reference, i % 3);
        if (i / 6)
            accuracy_more_lights(&scene);
        scene.affine = i / 3 % 2;
        scene.width = scene.height = SIZE;
        scene.shading = shading;
        double distance = -scene.translation[2];
        ref_scene_orbit(&scene, yaw_pitch[i % 3][0], yaw_pitch[i % 3][1], 0, distance);
        draw(&straight, &scene, mesh->mesh);
        ref_scene_orbit(&scene, yaw_pitch[i % 3][0], yaw_pitch[i % 3][1], 90, distance);
        for (int k = 0; k < scene.light_count; k++) {
            double x = scene.light[k][0];
            scene.light[k][0] = -scene.light[k][1];
            scene.light[k][1] = x;
        }
        draw(&turned, &scene, mesh->mesh);
        compare(&change, &straight, &turned);
        ref_picture_free(&straight.reference);
        ref_picture_free(&turned.reference);
    }
    change.core_mean /= 3.0 * (double)change.compared;
    return change;
}

/* Gouraud and Phong change by rounding only, their definition not at all. */
static void assert_rounding_alone(const struct change *c)
{
    assert_true(c->reference < 1e-6);
    assert_true(c->core <= 1.0 && c->core_mean <= 0.01);
    assert_true(c->steps <= 1 && (double)c->equal >= 0.995 * (double)c->compared);
}

static void turned_by_90_degrees(void **state)
{
    static const char *const name[] = {"flat", "gouraud", "phong", "slerp"};
    double most = 0;

    (void)state;
    for (int k = 0; k < ACCURACY_SHAPES * 3; k++) {
        struct accuracy_mesh mesh;
        enum ref_shading shading = (enum ref_shading)(REF_GOURAUD + k % 3);
        assert_int_equal(accuracy_mesh_make(&mesh, k / 3, false), 0);
        struct change c = turn_mesh(&mesh, shading);
        print_message("  %-10s %-7s changes by %7.3f/255 at most, %.4f in the mean, by its definition by %7.3f, never "
                      "more than %.3f off that; 565: %6.2f %% equal, the others %d steps at most\n",
                      mesh.name, name[shading], c.core, c.core_mean, c.reference, c.apart,
                      100.0 * (double)c.equal / (double)c.compared, c.steps);
        accuracy_mesh_free(&mesh);
        assert_true(c.compared > 100000);
        if (shading != REF_SLERP)
            assert_rounding_alone(&c);
        else
            assert_true(c.apart <= 4); /* because both pictures are within 2/255 of their definition */
        most = fmax(most, c.reference);
    }
    assert_true(most > 50); /* slerp's dependence is obvious where normals are far apart */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(turned_by_90_degrees)};

    return cmocka_run_group_tests_name("turned", tests, NULL, NULL);
}
