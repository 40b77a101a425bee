/*
 * test_core_facing.c - polygons that are passed over do face away, in double precision, and pictures are the same
 * without the test.
 *
 * Corners are snapped to 1/64 px before areas are taken, so a triangle that faces away may look as if it faced the eye
 * where it is thinner than that: its area then has the wrong sign, but no more of it than snapping makes of its sides.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core_picture.h"
#include "frame/frame.h"
#include "frame_stage.h"

#define POLYGONS 60
#define UNIT 16777216.0 /* Q7.24 */

struct facing_case {
    int16_t positions[12 * POLYGONS], facing[3 * POLYGONS];
    uint16_t polygons[2 * POLYGONS], indices[6 * POLYGONS];
    uint8_t warp[POLYGONS];
    struct sheen_mesh mesh;
    struct sheen_pose pose;
    struct sheen_view view;
};

struct facing_count {
    long away, skipped, thin;
};

static int16_t clamped_raw(double x)
{
    return (int16_t)lround(fmax(-32768, fmin(32767, x)));
}

static void corner_of(const struct facing_case *c, int triangle, int k, double p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = c->positions[3 * c->indices[3 * triangle + k] + i];
}

static void cross_of(double p[3][3], double n[3])
{
    for (int i = 0; i < 3; i++) {
        int u = (i + 1) % 3, v = (i + 2) % 3;
        n[i] = (p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - (p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
    }
}

/* A quad about a random place: flat, warped, a sliver or a point; now and then its corners lie far from each other. */
static void random_polygon(struct facing_case *c, int number, uint32_t *state)
{
    double size = exp(stage_uniform(state, 0, log(40000))), thin = stage_random(state) % 3 == 0 ? 1e-3 : 1;
    double warped = stage_random(state) % 2 == 0 ? 0 : stage_uniform(state, 0, 0.3);
    double at[3], u[3], v[3], sum[3] = {0, 0, 0};

    for (int i = 0; i < 3; i++) {
        at[i] = stage_uniform(state, -32768, 32768);
        u[i] = stage_uniform(state, -1, 1) * size;
        v[i] = stage_uniform(state, -1, 1) * size * thin;
    }
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            c->positions[12 * number + 3 * k + i] =
                clamped_raw(at[i] + (k == 1 || k == 2 ? u[i] : 0) + (k >= 2 ? v[i] : 0) +
                            warped * size * stage_uniform(state, -1, 1));
    for (int t = 0; t < 2; t++) {
        double p[3][3], n[3];
        const int fan[3] = {0, t + 1, t + 2};
        int turned = (int)(stage_random(state) % 3); /* not every polygon is a fan */
        for (int k = 0; k < 3; k++)
            c->indices[6 * number + 3 * t + k] = (uint16_t)(4 * number + fan[(k + turned) % 3]);
        c->polygons[2 * number + t] = (uint16_t)number;
        for (int k = 0; k < 3; k++)
            corner_of(c, 2 * number + t, k, p[k]);
        cross_of(p, n);
        for (int i = 0; i < 3; i++)
            sum[i] += n[i];
    }
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int i = 0; i < 3; i++)
        c->facing[3 * number + i] = (int16_t)(length > 0 ? lround(32767 * sum[i] / length) : i == 0 ? 32767 : 0);
}

static void random_case(struct facing_case *c, uint32_t *state)
{
    memset(c, 0, sizeof *c);
    for (int p = 0; p < POLYGONS; p++)
        random_polygon(c, p, state);
    c->mesh = (struct sheen_mesh){.positions = c->positions,
                                  .polygon_normals = c->facing,
                                  .polygons = c->polygons,
                                  .warp = c->warp,
                                  .indices = c->indices,
                                  .index_bytes = 2,
                                  .vertices = 4 * POLYGONS,
                                  .triangles = 2 * POLYGONS,
                                  .scale = (int32_t)(UNIT * exp(stage_uniform(state, log(0.001), log(20))))};
    sheen_mesh_warp(&c->mesh, POLYGONS, c->warp);
    double reach = c->mesh.scale / UNIT, distance = fmin(100, reach * exp(stage_uniform(state, log(0.1), log(300))));
    sheen_pose_orbit(&c->pose, stage_random(state), stage_random(state), stage_random(state), SHEEN_Q24(distance));
    c->pose.scale = stage_random(state) % 2 == 0 ? 65536 : (int32_t)(65536 * stage_uniform(state, 0.2, 1.1));
    for (int k = 0; k < 3; k++)
        c->mesh.offset[k] = stage_random(state) % 2 == 0 ? 0 : (int32_t)(UNIT * reach * stage_uniform(state, -1, 1));
    if (stage_random(state) % 8 == 0) /* a mirror: what faces away is seen */
        for (int k = 0; k < 3; k++)
            c->pose.rotation[k] = -c->pose.rotation[k];
    if (stage_random(state) % 4 == 0) /* not quite a rotation */
        for (int k = 0; k < 9; k++)
            c->pose.rotation[k] += (int32_t)(stage_random(state) % 20001) - 10000;
    c->view = (struct sheen_view){.fov = SHEEN_DEGREES(60),
                                  .z_near = SHEEN_Q24(distance / 20),
                                  .z_far = SHEEN_Q24(fmin(127, distance * 1.2 + 3 * reach)),
                                  .orthographic = stage_random(state) % 4 == 0 ? SHEEN_Q24(distance) : 0};
}

/* A triangle's area on the screen, px^2, positive where it faces the eye, and the most that snapping takes from it. */
static double area_seen(const struct facing_case *c, int triangle, double *snapped)
{
    const double focal = 120 / tan(3.14159265358979323846 / 6);
    double s[3][2], sides = 0;

    for (int k = 0; k < 3; k++) {
        double p[3], eye[3];
        corner_of(c, triangle, k, p);
        for (int i = 0; i < 3; i++) {
            eye[i] = c->pose.translation[i] / UNIT;
            for (int j = 0; j < 3; j++)
                eye[i] += c->pose.scale / 65536. * c->pose.rotation[3 * i + j] / 1073741824. *
                          (c->mesh.offset[j] / UNIT + c->mesh.scale / UNIT * p[j] / 32768);
        }
        double m = c->view.orthographic != 0 ? c->view.orthographic / UNIT : -eye[2];
        s[k][0] = focal * eye[0] / m;
        s[k][1] = focal * eye[1] / m;
    }
    for (int k = 0; k < 3; k++)
        sides += hypot(s[k][0] - s[(k + 1) % 3][0], s[k][1] - s[(k + 1) % 3][1]);
    *snapped = (sides + 0.05) * 0.54 * sqrt(2) / 64 / 2;
    return ((s[1][0] - s[0][0]) * (s[2][1] - s[0][1]) - (s[1][1] - s[0][1]) * (s[2][0] - s[0][0])) / 2;
}

/* 1 if the eye is behind the triangle's plane, wherever its corners are on the screen, or if it has no area. */
static int faces_away(const struct facing_case *c, int triangle)
{
    double p[3][3], n[3], eye[3][3], volume = 0;

    for (int k = 0; k < 3; k++) {
        corner_of(c, triangle, k, p[k]);
        for (int i = 0; i < 3; i++) {
            eye[k][i] = c->pose.translation[i] / UNIT;
            for (int j = 0; j < 3; j++)
                eye[k][i] += c->pose.scale / 65536. * c->pose.rotation[3 * i + j] / 1073741824. *
                             (c->mesh.offset[j] / UNIT + c->mesh.scale / UNIT * p[k][j] / 32768);
        }
    }
    cross_of(p, n); /* exact */
    if (n[0] == 0 && n[1] == 0 && n[2] == 0)
        return 1;
    cross_of(eye, n);
    if (c->view.orthographic != 0)
        return n[2] <= 0;
    for (int i = 0; i < 3; i++)
        volume += n[i] * eye[0][i];
    return volume >= 0;
}

static void check_skipped(const struct facing_case *c, const struct viewpoint *viewpoint, struct facing_count *count)
{
    uint32_t faces = UINT32_MAX, next = 0;

    for (uint32_t t = 0; t < c->mesh.triangles; t++) {
        count->away += faces_away(c, (int)t);
        if (t == next && (next = sheen_next_facing(viewpoint, &c->mesh, t, &faces)) == t) {
            next++;
            continue;
        }
        count->skipped++;
        if (!faces_away(c, (int)t))
            print_message("triangle %u faces the eye\n", (unsigned)t);
        assert_true(faces_away(c, (int)t));
    }
}

static void skipped_faces_away(void **unused)
{
    static struct facing_case c;
    struct facing_count count = {0, 0, 0};
    uint32_t state = 1;
    int tested = 0;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        struct projection p;
        struct viewpoint viewpoint;
        random_case(&c, &state);
        if (sheen_project_begin(&p, &c.view, 320, 240) < 0)
            continue;
        sheen_viewpoint_begin(&viewpoint, &p, &c.mesh, &c.pose);
        if (viewpoint.margin_per_warp == 0)
            continue;
        tested++;
        check_skipped(&c, &viewpoint, &count);
    }
    print_message("           %d meshes: %ld of %ld that face away are passed over\n", tested, count.skipped,
                  count.away);
    assert_true(tested > 10000 && count.skipped > count.away / 3);
}

/* ---- the margin ---- */

#define CORNER 56756.0   /* raw units: the farthest that a corner can be from the origin */
#define ROUNDED 196608.0 /* what the margin holds for n times the eye's error */

/* The exact eye, in the viewpoint's steps: the rotation's inverse, not its transpose, times minus the origin. */
static void exact_eye(const struct facing_case *c, const struct viewpoint *viewpoint, double eye[3])
{
    const double scale = (double)c->pose.scale * c->mesh.scale / 65536;
    double r[3][3], volume = 0;

    for (int i = 0; i < 9; i++)
        r[i / 3][i % 3] = c->pose.rotation[i] / 1073741824.;
    for (int i = 0; i < 3; i++)
        volume += r[0][i] * (r[1][(i + 1) % 3] * r[2][(i + 2) % 3] - r[1][(i + 2) % 3] * r[2][(i + 1) % 3]);
    for (int i = 0; i < 3; i++) {
        eye[i] = 0;
        for (int j = 0; j < 3; j++) {
            const double *a = r[(j + 1) % 3], *b = r[(j + 2) % 3];
            eye[i] -= (a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]) * c->pose.translation[j];
        }
        eye[i] *= ldexp(32768, -(int)viewpoint->shift) / volume / scale;
    }
}

/* The eye just short of what takes a shift more, along an axis or all of them; the rotation off by nearly 2^-16. */
static void edge_case(struct facing_case *c, uint32_t *state)
{
    const int axis = (int)(stage_random(state) % 4), upright = stage_random(state) % 2 == 0;
    const double far = ldexp(16384, 1 + (int)(stage_random(state) % 13)),
                 lean = (double)((int)(stage_random(state) % 3) - 1) * stage_uniform(state, 8000, 8190);
    double eye[3];

    random_case(c, state);
    c->view.orthographic = 0;
    c->pose.scale = 65536;
    c->mesh.scale = (int32_t)stage_uniform(state, 65536, stage_random(state) % 2 == 0 ? 66000 : 1e7);
    sheen_pose_identity(&c->pose);
    if (!upright)
        sheen_pose_orbit(&c->pose, stage_random(state), stage_random(state), stage_random(state), 0);
    for (int k = 0; k < 3; k++) {
        c->mesh.offset[k] = 0;
        eye[k] = axis == 3 || axis == k ? far - stage_uniform(state, 0, 4) : stage_uniform(state, 0, far / 16384);
        eye[k] *= stage_random(state) % 2 == 0 ? -1 : 1;
    }
    for (int i = 0; i < 3; i++) {
        const int32_t *row = c->pose.rotation + 3 * i;
        const double sum = ((double)row[0] + row[1] + row[2]) / 1073741824;
        double at = 0;
        for (int j = 0; j < 3; j++) {
            c->pose.rotation[3 * i + j] += (int32_t)lround(lean * sum);
            at -= c->pose.rotation[3 * i + j] / 1073741824. * eye[j] * c->mesh.scale / 32768;
        }
        c->pose.translation[i] = (int32_t)lround(fmax(-2e9, fmin(2e9, at)));
    }
}

static void margin_covers_the_eye(void **unused)
{
    static struct facing_case c;
    uint32_t state = 3;
    double needed = -100, error = 0;
    int tested = 0;

    (void)unused;
    for (int i = 0; i < 30000; i++) {
        struct projection p = {.orthographic = 0};
        struct viewpoint viewpoint;
        double eye[3], square = 0, off = 0;
        edge_case(&c, &state);
        sheen_viewpoint_begin(&viewpoint, &p, &c.mesh, &c.pose);
        if (viewpoint.margin_per_warp == 0)
            continue;
        tested++;
        exact_eye(&c, &viewpoint, eye);
        for (int k = 0; k < 3; k++) {
            square += eye[k] * eye[k];
            off += (eye[k] - viewpoint.eye[k]) * (eye[k] - viewpoint.eye[k]);
        }
        needed = fmax(needed, sqrt(square) + ldexp(CORNER, -(int)viewpoint.shift) - viewpoint.margin_per_warp / 32.);
        error = fmax(error, sqrt(off) * 32768);
    }
    print_message("           %d eyes: %.2f steps of distance left, errors of up to %.0f of %.0f\n", tested, -needed,
                  error, ROUNDED);
    assert_true(tested > 10000 && needed <= 0 && error <= ROUNDED);
}

/* ---- pictures ---- */

#define WIDTH 320
#define HEIGHT 240

/* of[triangle]: 1 if a draw lists it, 2 if as half of a quad. With warp and without, only thin triangles may differ. */
static void listed(const struct facing_case *c, struct core_frame *f, int with, uint8_t *of)
{
    static const struct sheen_material material = {.base = {255, 255, 255}, .diffuse = 1 << 16};
    struct sheen_mesh mesh = c->mesh;
    const struct sheen_object object = {.mesh = &mesh, .material = &material, .shader = &sheen_flat, .pose = c->pose};

    mesh.warp = with ? c->warp : NULL;
    memset(of, 0, 2 * POLYGONS);
    assert_int_equal(sheen_begin(f->frame, &c->view), SHEEN_OK);
    if (sheen_draw(f->frame, &object) == SHEEN_OK)
        for (uint32_t e = 0; e < f->frame->entries; e++) {
            struct corners corners;
            sheen_entry_corners(f->frame, f->frame->draw, e, &corners);
            const int quad = corners.v[3] != NULL; /* one of its triangles may cover no pixel's centre */
            of[corners.triangle] = of[corners.triangle + quad] = quad ? 2 : 1;
        }
    (void)sheen_finish(f->frame);
}

static void nothing_seen_is_skipped(void **unused)
{
    static struct facing_case c;
    struct memory_target target;
    struct core_frame f;
    uint32_t state = 2;
    long same = 0, thin = 0;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &target.target,
                                        .max_vertices = 4 * POLYGONS,
                                        .max_triangles = 4000,
                                        .max_clipped = 2000,
                                        .clipper = &sheen_clipper,
                                        .quads = &sheen_quads};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    for (int i = 0; i < 6000; i++) {
        uint8_t with[2 * POLYGONS], without[2 * POLYGONS];
        random_case(&c, &state);
        listed(&c, &f, 1, with);
        listed(&c, &f, 0, without);
        for (int t = 0; t < 2 * POLYGONS; t++) {
            double snapped;
            same += with[t] && without[t];
            if (with[t] == without[t] || with[t] == 2)
                continue;
            assert_true(without[t] && faces_away(&c, t) && fabs(area_seen(&c, t, &snapped)) <= snapped);
            thin++;
        }
    }
    print_message("           %ld triangles listed, %ld more only where snapping turned them over\n", same, thin);
    assert_true(same > 50000 && thin < same / 100);
    core_frame_free(&f);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(skipped_faces_away), cmocka_unit_test(margin_covers_the_eye),
                                       cmocka_unit_test(nothing_seen_is_skipped)};

    return cmocka_run_group_tests_name("core_facing", tests, NULL, NULL);
}
