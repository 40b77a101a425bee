/*
 * test_reference.c - the reference against numbers worked out by hand and against laws that do not depend on its
 * formulas.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "reference/ref_vector.h"
#include "reference/reference.h"
#include "shapes.h"

#define NEAR(a, b, by) assert_true(fabs((a) - (b)) <= (by))

static const struct ref_mesh_options as_is = {.crease = -1};

static void build(struct ref_mesh *mesh, struct shape *shape, const struct ref_mesh_options *options)
{
    assert_int_equal(ref_mesh_build(mesh, &shape->polygons, options), 0);
}

static struct ref_picture render(const struct ref_scene *scene)
{
    struct ref_picture picture;

    assert_int_equal(ref_render(&picture, scene), 0);
    return picture;
}

static const struct ref_pixel *at(const struct ref_picture *picture, int x, int y)
{
    return &picture->pixels[y * picture->width + x];
}

/* A triangle with its right angle at (-1, -1), m = 2, fov 90: f = 120, so x_s = 160 + 60 x, y_s = 120 - 60 y. */
static void one_triangle_by_hand(void **state)
{
    struct shape s = {0};
    struct ref_mesh mesh;
    struct ref_scene scene;

    (void)state;
    shape_point(&s, -1, -1, 0);
    shape_point(&s, 1 - 1e-9, -1, 0); /* a little less than 1, so that no pixel centre lies on the hypotenuse */
    shape_point(&s, -1, 1 - 1e-9, 0);
    shape_polygon(&s, 3, (uint32_t[]){0, 1, 2});
    build(&mesh, &s, &as_is);
    ref_scene_default(&scene, &mesh);
    ref_scene_orbit(&scene, 0, 0, 0, 2);
    scene.fov = 90;
    scene.shading = REF_FLAT;
    memcpy(scene.light[0], (double[3]){0, 0, 7}, sizeof scene.light[0]);

    struct ref_picture picture = render(&scene);
    int covered = 0;
    for (int i = 0; i < 320 * 240; i++)
        covered += picture.pixels[i].covered;
    /*
     * Legs of 120 px from (100, 180) to (220, 180) and (100, 60). Row j of the 120 has its centre at j + 1/2 and
     * covers the centres with i + 1/2 < j + 1/2, so j pixels.
     */
    assert_int_equal(covered, 119 * 120 / 2);
    assert_true(at(&picture, 100, 61)->covered);
    assert_false(at(&picture, 100, 60)->covered);
    assert_true(at(&picture, 218, 179)->covered);
    assert_false(at(&picture, 219, 179)->covered);
    assert_false(at(&picture, 99, 170)->covered);
    /* L.N = R.V = 1: base * 0.7 + 0.3; 0xc8 -> 31 * .849 = 26.3, 0xa0 -> 63 * .739 = 46.6, 0x50 -> 31 * .520 = 16.1 */
    assert_int_equal(at(&picture, 120, 150)->value, 26 << 11 | 47 << 5 | 16);
    assert_int_equal(at(&picture, 0, 0)->value, 4); /* 31 * 32 / 255 = 3.9 */
    NEAR(at(&picture, 120, 150)->m, 2, 1e-12);
    ref_picture_free(&picture);

    /* Turned around, it is a back face: culled, or lit with its normal negated. */
    memcpy(scene.rotation, (double[9]){-1, 0, 0, 0, 1, 0, 0, 0, -1}, sizeof scene.rotation);
    picture = render(&scene);
    assert_int_equal(picture.piece_count, 0);
    ref_picture_free(&picture);
    scene.two_sided = true;
    picture = render(&scene);
    assert_int_equal(at(&picture, 319 - 120, 150)->value, 26 << 11 | 47 << 5 | 16);
    ref_picture_free(&picture);
    ref_mesh_free(&mesh);
    shape_free(&s);
}

static const double nowhere[3] = {0, 0, 0}; /* a place that does not matter, as there are no point lights */

/* A plane that recedes: halfway on the screen is not halfway in space. */
static void perspective_by_hand(void **state)
{
    struct ref_scene scene = {.shading = REF_GOURAUD};
    struct ref_piece piece = {
        .x = {0, 0, 100}, .y = {0, 100, 0}, .w = {1, 1, 0.25}, .lit = {{{0}, {2}}, {{0}, {2}}, {{1}, {0}}}};
    struct ref_lit lit;

    (void)state;
    /* Halfway from m = 1 to m = 4: t = .5 * .25 / (.5 * 1 + .5 * .25) = .2 */
    ref_shade(&scene, &piece, 50, 0, &lit);
    NEAR(lit.diffuse[0], 0.2, 1e-12);
    NEAR(lit.specular[0], 1.6, 1e-12);
    scene.affine = true;
    ref_shade(&scene, &piece, 50, 0, &lit);
    NEAR(lit.diffuse[0], 0.5, 1e-12);
}

/* R.V by the law of reflection, with the reflected ray worked out as a vector. */
static void light_by_hand(void **state)
{
    struct ref_scene scene;
    struct ref_lit lit;
    double n[3] = {0.6, 0, 0.8};

    (void)state;
    ref_scene_default(&scene, NULL);
    memcpy(scene.light[0], (double[3]){3, 0, 4}, sizeof scene.light[0]);
    scene.shininess = 1;
    ref_light(&scene, nowhere, n, &lit); /* a light along the normal reflects along it: R.V = .8 */
    NEAR(lit.diffuse[0], 0.7, 1e-12);
    NEAR(lit.specular[0], 0.24, 1e-12);
    memcpy(scene.light[0], (double[3]){-0.6, 0, -0.8}, sizeof scene.light[0]);
    ref_light(&scene, nowhere, n, &lit); /* from behind: only ambient light */
    NEAR(lit.diffuse[0], 0.1, 1e-12);
    NEAR(lit.specular[0], 0, 0);
    /* L.N < 0 and N.V < 0, so their product is positive: still no highlight. */
    memcpy(n, (double[3]){0, 0, -1}, sizeof n);
    memcpy(scene.light[0], (double[3]){0, 0, 1}, sizeof scene.light[0]);
    ref_light(&scene, nowhere, n, &lit);
    NEAR(lit.specular[0], 0, 0);
    /* From behind, N.V = 0, so R = -L and R.V = .8. L.N is .06, then .18: from 1/8 on the highlight is full. */
    memcpy(scene.light[0], (double[3]){0.6, 0, -0.8}, sizeof scene.light[0]);
    memcpy(n, (double[3]){0.1, sqrt(0.99), 0}, sizeof n);
    ref_light(&scene, nowhere, n, &lit);
    NEAR(lit.specular[0], 0.3 * 0.8 * 8 * 0.06, 1e-12);
    memcpy(n, (double[3]){0.3, sqrt(0.91), 0}, sizeof n);
    ref_light(&scene, nowhere, n, &lit);
    NEAR(lit.specular[0], 0.3 * 0.8, 1e-12);
    scene.light_count = 2; /* ambient counts once, the rest is summed */
    memcpy(scene.light[1], (double[3]){0, 0, -1}, sizeof scene.light[1]);
    memcpy(scene.light[0], (double[3]){0, 2, 0}, sizeof scene.light[0]);
    memcpy(n, (double[3]){0, 0.6, -0.8}, sizeof n);
    ref_light(&scene, nowhere, n, &lit);
    NEAR(lit.diffuse[0], 0.1 + 0.6 * 0.6 + 0.6 * 0.8, 1e-12);
}

/* The normal of a fine sphere is its position, and Phong must find that at every pixel. */
static void phong_on_a_sphere(void **state)
{
    struct shape s;
    struct ref_mesh mesh;
    struct ref_scene scene;
    double worst = 0;

    (void)state;
    assert_int_equal(shape_sphere(&s, 60, 120), 0);
    build(&mesh, &s, &as_is);
    ref_scene_default(&scene, &mesh);
    struct ref_picture picture = render(&scene);
    double f = 120 / tan(20 * acos(-1) / 180);
    for (int i = 0; i < 320 * 240; i++) {
        if (!picture.pixels[i].covered)
            continue;
        /* The ray (x, y, -1) m through the pixel meets the unit sphere around (0, 0, -3). */
        double x = (i % 320 + 0.5 - 160) / f, y = (120 - i / 320 - 0.5) / f, a = x * x + y * y + 1;
        double root = 9 - 8 * a;
        if (root < 0.05)
            continue; /* there the polygons' silhouette is not the sphere's */
        double m = (3 - sqrt(root)) / a, n[3] = {x * m, y * m, 3 - m};
        struct ref_lit lit;
        ref_normalize(n);
        ref_light(&scene, nowhere, n, &lit);
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs(picture.pixels[i].color[k] - scene.base[k] * lit.diffuse[k] - lit.specular[k]));
        NEAR(picture.pixels[i].m, m, 0.01);
    }
    assert_true(worst > 0 && worst < 0.01); /* facets of 3 degrees lie up to 0.4 degrees off */
    ref_picture_free(&picture);
    ref_mesh_free(&mesh);
    shape_free(&s);
}

/* Against Rodrigues' rotation about a x b by t times the angle. */
static void slerp_is_a_rotation(void **state)
{
    double a[3] = {0.36, 0.48, 0.8}, b[3] = {-0.6, 0.8, 0}, axis[3], out[3], side[3];

    (void)state;
    ref_cross(a, b, axis);
    ref_normalize(axis);
    ref_cross(axis, a, side);
    double angle = acos(ref_dot(a, b));
    for (double t = 0; t <= 1; t += 0.125) {
        ref_slerp(a, b, t, out);
        for (int k = 0; k < 3; k++)
            NEAR(out[k], cos(t * angle) * a[k] + sin(t * angle) * side[k], 1e-12);
    }
    ref_slerp(a, a, 0.3, out);
    assert_memory_equal(out, a, sizeof a);
    double opposite[3] = {-a[0], -a[1], -a[2]};
    ref_slerp(a, opposite, 0.49, out);
    assert_memory_equal(out, a, sizeof a);
    ref_slerp(a, opposite, 0.5, out);
    assert_memory_equal(out, opposite, sizeof a);
}

/* Along an edge at the end of a scanline, and along the row, slerp follows its own definition. */
static void slerp_by_hand(void **state)
{
    struct ref_scene scene;
    struct ref_lit lit;
    double r = sqrt(0.5);
    struct ref_piece piece = {
        .x = {0, 0, 8}, .y = {0, 8, 8}, .w = {1, 1, 1}, .normal = {{0, 0, 1}, {1, 0, 0}, {1, 0, 0}}};

    (void)state;
    ref_scene_default(&scene, NULL);
    memcpy(scene.light[0], (double[3]){0, 0, 1}, sizeof scene.light[0]);
    scene.shading = REF_SLERP;
    scene.ambient = 0;
    scene.diffuse = 1;
    /* Row y = 4 crosses both slanted edges halfway, so there are 45 degrees at both ends and in between. */
    ref_shade(&scene, &piece, 0, 4, &lit);
    NEAR(lit.diffuse[0], r, 1e-12);
    ref_shade(&scene, &piece, 2.5, 4, &lit);
    NEAR(lit.diffuse[0], r, 1e-12);
    piece.w[1] = piece.w[2] = 0.25; /* the parameter in space is .2, which is 18 degrees */
    ref_shade(&scene, &piece, 2.5, 4, &lit);
    NEAR(lit.diffuse[0], cos(18 * acos(-1) / 180), 1e-12);
    scene.affine = true;
    ref_shade(&scene, &piece, 2.5, 4, &lit);
    NEAR(lit.diffuse[0], r, 1e-12);
}

/* A scene mirrored in x gives the mirrored picture. */
static void mirrored_scene(void **state)
{
    struct shape torus, half[2] = {{.point_room = 0}, {.point_room = 0}};
    struct ref_mesh mesh, sides[2];
    struct ref_scene scene[2];

    (void)state;
    assert_int_equal(shape_torus(&torus, 0.75, 0.33, 24, 16), 0);
    build(&mesh, &torus, &as_is);
    for (int side = 0; side < 2; side++) {
        for (size_t c = 0; c < mesh.corner_count; c++) {
            const double *p = mesh.position[c];
            shape_point(&half[side], side ? -p[0] : p[0], p[1], p[2]);
        }
        for (size_t t = 0; t < mesh.triangle_count; t++) {
            const uint32_t *c = mesh.triangles[t].corner;
            shape_polygon(&half[side], 3, (uint32_t[]){c[0], c[side ? 2 : 1], c[side ? 1 : 2]});
        }
        build(&sides[side], &half[side], &as_is);
        ref_scene_default(&scene[side], &sides[side]);
        ref_scene_orbit(&scene[side], side ? -37 : 37, 23, side ? -11 : 11, 3);
    }
    scene[1].light[0][0] = -scene[0].light[0][0];
    for (int shading = REF_FLAT; shading <= REF_SLERP; shading++) {
        scene[0].shading = scene[1].shading = (enum ref_shading)shading;
        struct ref_picture right = render(&scene[0]), left = render(&scene[1]);
        int covered = 0;
        for (int i = 0; i < 320 * 240; i++) {
            const struct ref_pixel *p = at(&right, i % 320, i / 320), *q = at(&left, 319 - i % 320, i / 320);
            assert_int_equal(p->covered, q->covered);
            NEAR(p->color[1], q->color[1], 1e-9);
            covered += p->covered;
        }
        assert_true(covered > 10000);
        ref_picture_free(&right);
        ref_picture_free(&left);
    }
    for (int side = 0; side < 2; side++) {
        ref_mesh_free(&sides[side]);
        shape_free(&half[side]);
    }
    ref_mesh_free(&mesh);
    shape_free(&torus);
}

/* Cutting changes nothing in what is left: a near plane through the mesh against one in front of it. */
static void near_plane(void **state)
{
    struct shape s;
    struct ref_mesh mesh;
    struct ref_scene scene;

    (void)state;
    assert_int_equal(shape_sphere(&s, 8, 12), 0);
    build(&mesh, &s, &as_is);
    ref_scene_default(&scene, &mesh);
    scene.two_sided = true;
    scene.near = 2.3;
    struct ref_picture cut = render(&scene);
    scene.near = 1.9;
    struct ref_picture whole = render(&scene);
    int same = 0, opened = 0;
    for (int i = 0; i < 320 * 240; i++) {
        const struct ref_pixel *p = &cut.pixels[i], *q = &whole.pixels[i];
        if (q->covered && q->m > 2.3001) {
            assert_true(p->covered && p->triangle == q->triangle);
            NEAR(p->color[1], q->color[1], 1e-9);
            same++;
        } else if (p->covered) {
            assert_true(p->m >= 2.2999);
            opened += p->back;
        }
    }
    assert_true(same > 3000 && opened > 3000);
    ref_picture_free(&cut);
    ref_picture_free(&whole);
    ref_mesh_free(&mesh);
    shape_free(&s);
}

static void shared_edges_once(void **state)
{
    /* A fan around (8, 8), whose rays pass through pixel centres. */
    static const double rim[8][2] = {{16, 8}, {16, 16}, {8, 16}, {0, 16}, {0, 8}, {0, 0}, {8, 0}, {16, 0}};

    (void)state;
    for (double shift = 0; shift < 1; shift += 0.25) {
        for (int y = 0; y < 16; y++) {
            for (int x = 0; x < 16; x++) {
                int times = 0;
                for (int k = 0; k < 8; k++) {
                    struct ref_piece p = {.x = {8 + shift, rim[k][0] + shift, rim[(k + 1) % 8][0] + shift},
                                          .y = {8 + shift, rim[k][1] + shift, rim[(k + 1) % 8][1] + shift}};
                    times += ref_inside(&p, x + 0.5, y + 0.5);
                }
                bool inside = x + 0.5 >= shift && y + 0.5 >= shift;
                assert_int_equal(times, inside);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_triangle_by_hand), cmocka_unit_test(perspective_by_hand),
        cmocka_unit_test(light_by_hand),        cmocka_unit_test(phong_on_a_sphere),
        cmocka_unit_test(slerp_is_a_rotation),  cmocka_unit_test(slerp_by_hand),
        cmocka_unit_test(mirrored_scene),       cmocka_unit_test(near_plane),
        cmocka_unit_test(shared_edges_once),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
