/*
 * test_core_clip.c - triangles that leave the view volume, against rays through pixels' centres in double precision.
 *
 * Tolerances: a pixel more than 1/8 px inside a triangle's part between near and far is covered by its pieces exactly
 * once, more than 1/8 px outside not at all, and any pixel at most once; a side that two triangles share is no side.
 * Corners of pieces: normals, given as a linear function of position, within 2 raw steps and what snapping moves them.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "../host-sim/command/shadings.h"
#include "exact_cover.h"
#include "frame/frame.h"
#include "frame_stage.h"

#define MOST 40
#define UNIT 16777216.0

struct clip_case {
    struct memory_target target;
    struct core_frame frame;
    struct sheen_view view;
    struct sheen_mesh mesh;
    int16_t position[3 * 4], normal[3 * 4];
    uint16_t index[6];
    struct sheen_material material;
    double eye[4][3];
    double focal;
    int width, height; /* px */
};

static void case_make(struct clip_case *c, int width, int height)
{
    memset(c, 0, sizeof *c);
    c->width = width;
    c->height = height;
    c->material.shine = &sheen_shine_8;
    c->material.base[0] = 255;
    c->material.diffuse = 65536;
    assert_int_equal(memory_target_init(&c->target, width, height, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &c->target.target,
                                        .max_vertices = 4,
                                        .max_triangles = MOST,
                                        .max_clipped = MOST,
                                        .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&c->frame, &config), SHEEN_OK);
}

static void case_free(struct clip_case *c)
{
    core_frame_free(&c->frame);
    memory_target_free(&c->target);
}

/* Draws the mesh with the identity pose: its vertices are eye coordinates. */
static int case_draw(struct clip_case *c, enum sheen_shading shading, int two_sided)
{
    static const struct sheen_light light = {.to = {1 << 29, 1 << 29, 1 << 30}, .intensity = 65536};
    struct sheen_object draw = {.mesh = &c->mesh,
                                .material = &c->material,
                                .lights = &light,
                                .light_count = 1,
                                .shader = sheen_shader_of(shading),
                                .two_sided = (uint8_t)two_sided};

    sheen_pose_identity(&draw.pose);
    c->focal = c->height / 2.0 / tan(c->view.fov / 4294967296.0 * 3.14159265358979323846);
    for (int i = 0; i < c->mesh.vertices; i++)
        for (int k = 0; k < 3; k++)
            c->eye[i][k] = (c->mesh.offset[k] + (double)c->mesh.scale * c->position[3 * i + k] / 32768) / UNIT;
    assert_int_equal(sheen_begin(c->frame.frame, &c->view), SHEEN_OK);
    return sheen_draw(c->frame.frame, &draw);
}

/* ---- rays ---- */

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/*
 * How far inside triangle t the centre of a pixel is, px on the picture, negative outside: the least distance to its
 * three sides (but the one before corner `but`, if any) and to where it meets near and far. As functions of the ray
 * (x, y, -1): the sides are planes through the eye, 1/m is (normal . ray) / (normal . corner).
 */
static double depth_inside(const struct clip_case *c, int t, int px, int py, int but)
{
    const double ray[3] = {(px + 0.5 - c->width / 2.0) / c->focal, (c->height / 2.0 - py - 0.5) / c->focal, -1};
    double line[5][4] = {{0}}, normal[3] = {0, 0, 0}, volume = 0, least = INFINITY;
    const double *p[3];

    for (int k = 0; k < 3; k++)
        p[k] = c->eye[c->index[3 * t + k]];
    for (int k = 0; k < 3; k++) {
        cross(p[(k + 1) % 3], p[(k + 2) % 3], line[k]);
        for (int i = 0; i < 3; i++)
            normal[i] += line[k][i];
    }
    for (int i = 0; i < 3; i++)
        volume += normal[i] * p[0][i];
    for (int i = 0; i < 3; i++) {
        line[3][i] = -normal[i] / volume;
        line[4][i] = normal[i] / volume;
    }
    line[3][3] = UNIT / c->view.z_near;
    line[4][3] = -UNIT / c->view.z_far;
    for (int k = 0; k < 5; k++) {
        double sign = k < 3 && volume < 0 ? -1 : 1, steep = hypot(line[k][0], line[k][1]) / c->focal;
        double value = sign * (line[k][0] * ray[0] + line[k][1] * ray[1] + line[k][2] * ray[2] + line[k][3]);
        if (k != but)
            least = fmin(least, steep > 0 ? value / steep : value > 0 ? INFINITY : -INFINITY);
    }
    return least;
}

#define SURE 0.125 /* px */

/* Times that a pixel should be covered; -1 where it lies too close to a side to tell. */
static int expected_at(const struct clip_case *c, int px, int py)
{
    double one = depth_inside(c, 0, px, py, -1);

    if (c->mesh.triangles == 1)
        return one > SURE ? 1 : one < -SURE ? 0 : -1;
    double other = depth_inside(c, 1, px, py, -1); /* triangles 0 1 2 and 0 3 1: the shared side is before 2 and 3 */
    if (fabs(one) > SURE && fabs(other) > SURE)
        return (one > 0) + (other > 0);
    if (depth_inside(c, 0, px, py, 2) > SURE && depth_inside(c, 1, px, py, 1) > SURE)
        return 1;
    return -1;
}

/* Times that listed triangles cover a pixel. */
static int covered_at(const struct sheen_frame *f, int px, int py)
{
    int times = 0;

    for (uint32_t e = 0; e < f->entries; e++) {
        struct corners corners;
        struct cover_triangle t;
        sheen_entry_corners(f, f->draw, e, &corners);
        for (int k = 0; k < 3; k++) {
            t.x[k] = target_x(f, corners.v[k]->x);
            t.y[k] = target_y(f, corners.v[k]->y);
        }
        times += cover_inside(&t, px, py);
    }
    return times;
}

struct clip_count {
    long sure, cut, wrong;
    uint32_t most; /* pieces */
};

/* Compares every so many pixels of the picture; says what was wrong first. */
static void compare(const struct clip_case *c, struct clip_count *count, int most, int number)
{
    const int step = 1 + c->width / 64;
    const struct sheen_frame *f = c->frame.frame;

    count->cut += f->pieces > 0;
    count->most = f->pieces > count->most ? f->pieces : count->most;
    assert_true(f->pieces <= MOST_PIECES * c->mesh.triangles);
    for (int y = number % step; y < c->height; y += step)
        for (int x = 0; x < c->width; x += step) {
            int expected = expected_at(c, x, y), covered = covered_at(f, x, y);
            count->sure += expected > 0;
            if (covered <= most && (expected < 0 || covered == expected))
                continue;
            if (count->wrong++ == 0)
                print_message("           case %d, pixel %d %d: covered %d times, %d expected, near %d\n", number, x, y,
                              covered, expected, c->view.z_near);
        }
}

/* ---- what is left of the mesh covers what it should ---- */

static void random_view(struct clip_case *c, uint32_t *state, double nearest)
{
    double near = exp(stage_uniform(state, log(nearest), log(2)));

    c->view = (struct sheen_view){.fov = SHEEN_DEGREES(stage_uniform(state, 20, 100)),
                                  .z_near = SHEEN_Q24(near),
                                  .z_far = SHEEN_Q24(near + stage_uniform(state, 0.5, 6))};
}

/* One triangle, or two that share an edge, with corners all round the eye. */
static void random_mesh(struct clip_case *c, uint32_t *state, int triangles)
{
    static const uint16_t index[6] = {0, 1, 2, 0, 3, 1};

    memcpy(c->index, index, sizeof index);
    for (int i = 0; i < 12; i++) {
        double most = i % 3 == 2 ? 32767 : 24000;
        c->position[i] = (int16_t)(stage_uniform(state, -most, most) / (i % 3 != 2 && *state % 3 == 0 ? 20 : 1));
    }
    c->mesh = (struct sheen_mesh){.positions = c->position,
                                  .normals = c->normal,
                                  .indices = c->index,
                                  .index_bytes = 2,
                                  .vertices = 4,
                                  .triangles = (uint16_t)triangles,
                                  .scale = SHEEN_Q24(4),
                                  .offset = {0, 0, SHEEN_Q24(-2)}};
}

static void one_triangle(int width, int height, int cases, long least)
{
    struct clip_count count = {0};
    struct clip_case c;
    uint32_t state = 1;

    case_make(&c, width, height);
    for (int i = 0; i < cases; i++) {
        random_view(&c, &state, 0.05);
        c.view.affine = i % 2; /* then two triangles are left of what the near plane leaves four corners of */
        random_mesh(&c, &state, 1);
        assert_int_equal(case_draw(&c, SHEEN_FLAT, 1), SHEEN_OK);
        compare(&c, &count, 1, i);
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
    }
    print_message("           %ld pixels inside, %ld triangles cut, into %u pieces at the most\n", count.sure,
                  count.cut, count.most);
    assert_int_equal(count.wrong, 0);
    assert_true(count.sure > least && count.cut > cases / 3);
    case_free(&c);
}

static void test_one_triangle(void **unused)
{
    (void)unused;
    one_triangle(48, 32, 1500, 50000);
}

/* The largest picture: what the guard band cuts off lies outside it. */
static void test_one_triangle_on_640x480(void **unused)
{
    (void)unused;
    one_triangle(640, 480, 600, 50000);
}

/* Both seen from the front: they meet in the shared edge and nowhere else, so no pixel twice, none left out. */
static void test_two_triangles_that_share_an_edge(void **unused)
{
    struct clip_count count = {0};
    struct clip_case c;
    uint32_t state = 2;
    int both = 0;

    (void)unused;
    case_make(&c, 48, 32);
    for (int i = 0; i < 3000; i++) {
        random_view(&c, &state, 0.05);
        random_mesh(&c, &state, 2);
        assert_int_equal(case_draw(&c, SHEEN_FLAT, 0), SHEEN_OK);
        int fronts = c.frame.frame->count.front == 2;
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
        if (!fronts)
            continue;
        both++;
        assert_int_equal(case_draw(&c, SHEEN_FLAT, 0), SHEEN_OK);
        compare(&c, &count, 1, i);
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
    }
    print_message("           %ld pixels inside, %d pairs, %ld of them cut\n", count.sure, both, count.cut);
    assert_int_equal(count.wrong, 0);
    assert_true(both > 50 && count.cut > 40);
    case_free(&c);
}

/*
 * A near plane so close that a raw step of the eye is pixels wide, and triangles that pass close by the eye: coarse,
 * but corners stay in the guard band, between near and far, and on the sides of the axis where the triangle is.
 */
static long out_of_place(const struct clip_case *c, const struct vertex *v)
{
    int side[4] = {0, 0, 0, 0}; /* right, left, up, down: where the triangle's corners are */

    for (int k = 0; k < 3; k++)
        for (int s = 0; s < 4; s++)
            side[s] |= (s % 2 == 0 ? 1 : -1) * c->eye[k][s / 2] > -1 / UNIT;
    return abs(v->x) > GUARD_BAND || abs(v->y) > GUARD_BAND || v->z < DEPTH_FAR || (v->x > 64 && !side[0]) ||
           (v->x < -64 && !side[1]) || (v->y < -64 && !side[2]) || (v->y > 64 && !side[3]);
}

static void test_near_planes_of_a_few_raw_steps(void **unused)
{
    struct clip_case c;
    uint32_t state = 3;
    long corners = 0, wrong = 0;

    (void)unused;
    case_make(&c, 48, 32);
    for (int i = 0; i < 50000; i++) {
        random_view(&c, &state, 0.05);
        c.view.z_near = 1 + (int32_t)(stage_random(&state) >> (12 + stage_random(&state) % 20));
        random_mesh(&c, &state, 1);
        c.mesh.scale = 1 << (15 + i % 15);
        for (int k = 0; k < 3; k++) {
            double share = stage_uniform(&state, 0, 1);
            c.mesh.offset[k] = i % 2 == 0 ? 0 : (int32_t)(stage_random(&state) % 200) - 100;
            if (i % 4 != 0) /* up to rounding, the plane goes through the mesh's origin */
                c.position[6 + k] = (int16_t)(-share * c.position[k] - (1 - share) * c.position[3 + k]);
        }
        assert_int_equal(case_draw(&c, SHEEN_FLAT, 1), SHEEN_OK);
        const struct sheen_frame *f = c.frame.frame;
        for (uint32_t e = 0; e < f->entries; e++) {
            struct corners listed;
            sheen_entry_corners(f, f->draw, e, &listed);
            for (int k = 0; k < 3; k++, corners++)
                wrong += out_of_place(&c, listed.v[k]);
        }
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
    }
    print_message("           %ld corners\n", corners);
    assert_true(corners > 10000);
    assert_int_equal(wrong, 0);
    case_free(&c);
}

/* ---- corners of pieces ---- */

/* Normals 20000 * (x, y, z) / 4 at eye (x, y, z): at any corner of a piece they must say where it lies. */
static void note_corner(const struct clip_case *c, struct worst *worst, const struct vertex *v, const int16_t n[3])
{
    double near = c->view.z_near / UNIT, far = c->view.z_far / UNIT, per = 20000 / 4.;
    double w = (v->z - DEPTH_FAR) / (double)DEPTH_RANGE * (1 / near - 1 / far) + 1 / far, m = 1 / w;
    double step = (1 / near - 1 / far) / DEPTH_RANGE * m * m * per; /* of z16, in raw steps of a normal */
    double x = v->x / 64. / c->focal * m * per, y = -v->y / 64. / c->focal * m * per;

    assert_in_range(v->z, DEPTH_FAR, DEPTH_FAR + DEPTH_RANGE);
    assert_true(abs(v->x) <= GUARD_BAND && abs(v->y) <= GUARD_BAND);
    worst_note(worst, (n[2] + m * per) / (2 + step), "z, m %g", m);
    double snap = m / c->focal / 64 * per, wide = step * 511 / c->focal;
    worst_note(worst, (n[0] - x) / (2 + snap + wide), "x at %g px, m %g", v->x / 64., m);
    worst_note(worst, (n[1] - y) / (2 + snap + wide), "y at %g px, m %g", v->y / 64., m);
}

static void test_attributes_of_pieces(void **unused)
{
    struct worst worst = {0};
    struct clip_case c;
    uint32_t state = 4;

    (void)unused;
    case_make(&c, 48, 32);
    for (int i = 0; i < 20000; i++) {
        random_view(&c, &state, 0.2);
        random_mesh(&c, &state, 1);
        for (int k = 0; k < 12; k++)
            c.normal[k] = (int16_t)lrint(20000 / 4. * (c.position[k] / 8192. - (k % 3 == 2 ? 2 : 0)));
        assert_int_equal(case_draw(&c, i % 2 != 0 ? SHEEN_PHONG : SHEEN_GOURAUD, 1), SHEEN_OK);
        const struct sheen_frame *f = c.frame.frame;
        for (uint32_t p = 0; p < f->pieces; p++)
            for (int k = 0; k < 3; k++) {
                const struct vertex *v = &f->piece[p].corner[k];
                assert_true((v->flags & LIT) != 0 && (i % 2 != 0 || (v->kept[0] <= 32768 && v->kept[1] <= 32768)));
                note_corner(&c, &worst, v, f->piece[p].normal[k]);
            }
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
    }
    worst_assert(&worst, 1, "normals of pieces in tolerances");
    case_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_triangle),
        cmocka_unit_test(test_one_triangle_on_640x480),
        cmocka_unit_test(test_two_triangles_that_share_an_edge),
        cmocka_unit_test(test_near_planes_of_a_few_raw_steps),
        cmocka_unit_test(test_attributes_of_pieces),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
