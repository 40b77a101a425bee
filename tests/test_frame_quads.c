/*
 * test_frame_quads.c - plane polygons of four corners that are drawn as quads, against the same polygons drawn as
 * triangles: they cover the same pixels, with the same colours within one step (flat: exactly), and with depths that
 * differ by less than depth changes to the next pixel. The tests also prove which polygons become quads.
 *
 * Bodies are convex, so that each pixel shows a single polygon that faces the eye.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core_picture.h"
#include "frame/frame.h"
#include "frame_stage.h"

#define PI 3.14159265358979323846
#define MOST_VERTICES 2200
#define MOST_TRIANGLES 4200
#define WIDTH 160
#define HEIGHT 120
#define ROUNDED 8 /* z16: how far a quad's plane may be from its triangles' planes, whatever the slope */

/* A solid of revolution. */
struct body {
    int16_t positions[3 * MOST_VERTICES], normals[3 * MOST_VERTICES], facing[3 * MOST_TRIANGLES];
    uint16_t polygons[MOST_TRIANGLES], indices[3 * MOST_TRIANGLES];
    uint8_t warp[MOST_TRIANGLES];
    uint32_t polygon_count;
    struct sheen_mesh mesh;
};

static void add_vertex(struct body *b, const double p[3], const double n[3])
{
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);

    for (int k = 0; k < 3; k++) {
        b->positions[3 * b->mesh.vertices + k] = (int16_t)lround(32767 * p[k]);
        b->normals[3 * b->mesh.vertices + k] = (int16_t)lround(32767 * n[k] / length);
    }
    b->mesh.vertices++;
}

/* Adds a polygon as a fan. Its normal is the cross product of its diagonals (of two sides for a triangle). */
static void add_polygon(struct body *b, const uint32_t *corner, uint32_t count)
{
    const int16_t *p[4];
    double d[2][3], n[3], length = 0;

    for (uint32_t k = 0; k < 4; k++)
        p[k] = b->positions + 3 * corner[k < count ? k : 0];
    for (int k = 0; k < 3; k++) {
        d[0][k] = p[2][k] - p[0][k];
        d[1][k] = p[3][k] - p[1][k];
    }
    for (int k = 0; k < 3; k++) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        n[k] = d[0][u] * d[1][v] - d[0][v] * d[1][u];
        length += n[k] * n[k];
    }
    for (int k = 0; k < 3; k++)
        b->facing[3 * b->polygon_count + (uint32_t)k] =
            (int16_t)(length > 0 ? lround(32767 * n[k] / sqrt(length)) : 32767 * (k == 0));
    for (uint32_t k = 2; k < count; k++) {
        uint16_t *index = b->indices + 3 * b->mesh.triangles;
        index[0] = (uint16_t)corner[0];
        index[1] = (uint16_t)corner[k - 1];
        index[2] = (uint16_t)corner[k];
        b->polygons[b->mesh.triangles++] = (uint16_t)b->polygon_count;
    }
    b->polygon_count++;
}

/* Completes the mesh when all vertices and polygons are there. */
static void finish_mesh(struct body *b)
{
    b->mesh.polygon_normals = b->facing;
    b->mesh.polygons = b->polygons;
    b->mesh.warp = b->warp;
    b->mesh.indices = b->indices;
    b->mesh.index_bytes = 2;
    b->mesh.scale = 1 << 24;
    sheen_mesh_warp(&b->mesh, b->polygon_count, b->warp);
}

enum profile {
    GLOBE, /* normals are linear over its quads */
    EGG,   /* normals are not linear over its quads */
    DRUM   /* normals are linear on its sides; an end is one polygon with as many corners as there are sides */
};

static void make_body(struct body *b, enum profile profile, uint32_t around, uint32_t along)
{
    memset(b, 0, sizeof *b);
    b->mesh.positions = b->positions;
    b->mesh.normals = b->normals;
    for (uint32_t j = 0; j <= along; j++)
        for (uint32_t i = 0; i < around; i++) {
            const double turn = 2 * PI * i / around, up = PI * (j / (double)along - .5), high = profile == EGG ? .6 : 1;
            double p[3] = {cos(turn) * cos(up), sin(up) * high, -sin(turn) * cos(up)};
            double n[3] = {p[0], p[1] / (high * high), p[2]};
            if (profile == DRUM) {
                p[0] = n[0] = cos(turn);
                p[2] = n[2] = -sin(turn);
                p[1] = 2. * j / along - 1;
                n[1] = 0;
            }
            for (int k = 0; k < 3; k++)
                p[k] *= profile == DRUM ? .7 : 1;
            add_vertex(b, p, n);
        }
    for (uint32_t j = 0; j < along; j++)
        for (uint32_t i = 0; i < around; i++) {
            const uint32_t here = j * around, next = (i + 1) % around;
            const uint32_t corner[4] = {here + i, here + next, here + around + next, here + around + i};
            if (profile != DRUM && j == 0)
                add_polygon(b, (const uint32_t[3]){corner[0], corner[2], corner[3]}, 3);
            else
                add_polygon(b, corner, profile != DRUM && j + 1 == along ? 3 : 4);
        }
    for (int end = 0; end < 2 && profile == DRUM; end++) {
        uint32_t corner[64];
        const uint32_t first = b->mesh.vertices;
        for (uint32_t i = 0; i < around; i++) {
            const double turn = 2 * PI * i / around * (end ? 1 : -1), n[3] = {0, end ? 1 : -1, 0};
            add_vertex(b, (const double[3]){.7 * cos(turn), .7 * n[1], -.7 * sin(turn)}, n);
            corner[i] = first + i;
        }
        add_polygon(b, corner, around);
    }
    finish_mesh(b);
}

/* ---- pictures ---- */

struct drawn {
    uint16_t depth[WIDTH * HEIGHT], pixel[WIDTH * HEIGHT];
    uint32_t listed, quads;
};

static void keep_depth(void *ctx, const struct sheen_canvas *canvas)
{
    struct drawn *to = ctx;

    for (int y = canvas->rect.y0; y < canvas->rect.y1; y++)
        for (int x = canvas->rect.x0; x < canvas->rect.x1; x++)
            to->depth[y * WIDTH + x] = canvas->depth[(y - canvas->rect.y0) * (int)canvas->pitch + x - canvas->rect.x0];
}

/* How a body is viewed and lit. */
struct look {
    struct sheen_view view;
    struct sheen_object object;
    struct sheen_material material;
    struct sheen_light light;
    struct sheen_shine shine;
    uint8_t rows, carried, pixel;
};

static void draw_body(const struct body *b, struct look *look, int whole, struct drawn *to)
{
    struct memory_target target;
    struct core_frame f;
    struct sheen_stats stats;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, (enum sheen_pixel)look->pixel), 0);
    const struct sheen_config config = {.target = &target.target,
                                        .band_rows = look->rows,
                                        .max_vertices = MOST_VERTICES,
                                        .max_triangles = MOST_TRIANGLES,
                                        .max_carried = look->carried,
                                        .max_clipped = 600,
                                        .clipper = &sheen_clipper,
                                        .quads = whole ? &sheen_quads : NULL};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    memset(to, 0, sizeof *to);
    look->view.ctx = to;
    look->view.overlay = keep_depth;
    look->object.mesh = &b->mesh;
    look->object.material = &look->material;
    look->object.lights = &look->light;
    look->object.light_count = 1;
    assert_int_equal(sheen_begin(f.frame, &look->view), SHEEN_OK);
    assert_int_equal(sheen_draw(f.frame, &look->object), SHEEN_OK);
    for (uint32_t e = 0; e < f.frame->entries; e++)
        to->quads += !is_cut(f.frame, e) && is_quad(f.frame->draw, f.frame->entry[e].triangle);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    sheen_frame_stats(f.frame, &stats);
    to->listed = stats.drawn;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        to->pixel[i] = (uint16_t)memory_target_pixel(&target, i % WIDTH, i / WIDTH);
    assert_int_equal(target.breaches, 0);
    core_frame_free(&f);
    memory_target_free(&target);
}

static void random_look(struct look *look, uint32_t *state)
{
    const double near_eye = stage_random(state) % 4 == 0 ? 1.1 : 1.6, distance = near_eye + stage_uniform(state, 0, 2);

    memset(look, 0, sizeof *look);
    look->view = (struct sheen_view){.fov = SHEEN_DEGREES(50),
                                     .z_near = SHEEN_Q24(.2),
                                     .z_far = SHEEN_Q24(distance + 1.5),
                                     .dither = stage_random(state) % 3 == 0,
                                     .affine = stage_random(state) % 8 == 0,
                                     .orthographic = stage_random(state) % 6 == 0 ? SHEEN_Q24(2) : 0};
    look->material = (struct sheen_material){.base = {255, (uint8_t)stage_random(state), 90},
                                             .ambient = (sheen_q16_t)(stage_random(state) % 20000),
                                             .diffuse = (sheen_q16_t)(10000 + stage_random(state) % 60000),
                                             .specular = (sheen_q16_t)(stage_random(state) % 3 * 20000),
                                             .shine = &look->shine};
    assert_int_equal(sheen_shine_make(&look->shine, 1 + stage_random(state) % 64), SHEEN_OK);
    look->light = (struct sheen_light){.to = {(int32_t)(stage_random(state) % (1u << 30)) - (1 << 29),
                                              (int32_t)(stage_random(state) % (1u << 30)) - (1 << 29), 1 << 29},
                                       .intensity = 65536};
    look->rows = (uint8_t)(1 + stage_random(state) % HEIGHT);
    look->carried = (uint8_t)(stage_random(state) % 4 == 0 ? 1 : 80);
    look->pixel = stage_random(state) % 4 == 0 ? SHEEN_GREY256 : SHEEN_RGB565_BE;
    sheen_pose_orbit(&look->object.pose, stage_random(state), stage_random(state), stage_random(state),
                     SHEEN_Q24(distance));
}

static int apart(uint16_t a, uint16_t b, int is_565)
{
    if (!is_565)
        return abs(a - b);
    const int red = abs((a >> 11) - (b >> 11)), green = abs((a >> 5 & 63) - (b >> 5 & 63)),
              blue = abs((a & 31) - (b & 31));
    return red > green ? (red > blue ? red : blue) : green > blue ? green : blue;
}

/* How quads and triangles differ. */
struct difference {
    /* beyond: depths farther apart than depth changes over 1/8 px, which occurs at the limb */
    long pixels, colours, quads, beyond;
    int step;
};

/* The largest change of depth from pixel i to a neighbour. */
static int slope_at(const struct drawn *d, int i)
{
    const int neighbour[4] = {-1, 1, -WIDTH, WIDTH};
    int most = 0;

    for (int k = 0; k < 4; k++) {
        const int j = i + neighbour[k];
        if (j >= 0 && j < WIDTH * HEIGHT && d->depth[j] != DEPTH_FAR && abs(d->depth[j] - d->depth[i]) > most)
            most = abs(d->depth[j] - d->depth[i]);
    }
    return most;
}

static void compare_colours(const struct drawn *whole, const struct drawn *apiece, int is_565, struct difference *d)
{
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const int step = apart(whole->pixel[i], apiece->pixel[i], is_565);
        assert_int_equal(whole->depth[i] == DEPTH_FAR, apiece->depth[i] == DEPTH_FAR);
        d->pixels += whole->depth[i] != DEPTH_FAR;
        d->colours += step != 0;
        d->step = step > d->step ? step : d->step;
    }
    d->quads += whole->quads;
    assert_int_equal(apiece->quads, 0);
    assert_true(whole->listed <= apiece->listed);
}

static void compare(const struct drawn *whole, const struct drawn *apiece, int is_565, struct difference *d)
{
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const int depth = abs(whole->depth[i] - apiece->depth[i]), slope = depth > ROUNDED ? slope_at(apiece, i) : 0;
        assert_true(depth <= ROUNDED + slope);
        d->beyond += depth > ROUNDED + slope / 8;
    }
    compare_colours(whole, apiece, is_565, d);
}

static void as_their_triangles(void **unused)
{
    static const struct sheen_shader *const shaders[] = {&sheen_flat, &sheen_gouraud, &sheen_phong, &sheen_slerp};
    static struct body body;
    static struct drawn whole, apiece;
    struct difference d[4] = {{0}};
    uint32_t state = 5;

    (void)unused;
    for (int i = 0; i < 900; i++) {
        struct look look;
        make_body(&body, (enum profile)(i % 3), 4 + stage_random(&state) % 56, 2 + stage_random(&state) % 28);
        random_look(&look, &state);
        look.object.shader = shaders[i / 3 % 4];
        draw_body(&body, &look, 1, &whole);
        draw_body(&body, &look, 0, &apiece);
        compare(&whole, &apiece, look.pixel != SHEEN_GREY256, &d[i / 3 % 4]);
        assert_true(i / 3 % 4 == 0 || !look.view.affine || whole.quads == 0);
    }
    for (int k = 0; k < 4; k++) {
        print_message("  shading %d: %ld quads, %ld pixels, %ld of another colour, by %d at the most; %ld depths by "
                      "more than 1/8 px\n",
                      k, d[k].quads, d[k].pixels, d[k].colours, d[k].step, d[k].beyond);
        assert_true(d[k].quads > 1000 && d[k].beyond < d[k].pixels / 1000);
        assert_true(k == 0 ? d[k].colours == 0 : d[k].step <= 1 && d[k].colours < d[k].pixels / 25);
    }
}

/* Far away, with near planes so close to the eye that 1/m has only a few steps there: the colours must still agree. */
static void where_depth_is_coarse(void **unused)
{
    static const struct sheen_shader *const shaders[] = {&sheen_phong, &sheen_slerp};
    static const double near[] = {.02, .01, .005, .0025};
    static struct body body;
    static struct drawn whole, apiece;
    struct look look;
    uint32_t state = 5;
    long quads = 0;

    (void)unused;
    make_body(&body, GLOBE, 60, 30);
    for (int i = 0; i < 8; i++) {
        struct difference d = {0};
        random_look(&look, &state);
        look.view = (struct sheen_view){.z_near = SHEEN_Q24(near[i / 2]), .z_far = SHEEN_Q24(100)};
        assert_int_equal(sheen_shine_make(&look.shine, 8), SHEEN_OK);
        look.object.shader = shaders[i % 2];
        look.object.pose.scale = SHEEN_Q16(24);
        look.object.pose.translation[2] = SHEEN_Q24(-72);
        draw_body(&body, &look, 1, &whole);
        draw_body(&body, &look, 0, &apiece);
        compare_colours(&whole, &apiece, look.pixel != SHEEN_GREY256, &d);
        print_message("  near %.4f, shading %d: %ld quads, %ld of %ld pixels of another colour, by %d at the most\n",
                      near[i / 2], i % 2, d.quads, d.colours, d.pixels, d.step);
        assert_true(d.step <= 1 && d.colours < d.pixels / 25);
        quads += d.quads;
    }
    assert_true(quads > 1000);
}

/* ---- which polygons ---- */

static uint32_t of_warp(const struct body *b, unsigned least, unsigned most)
{
    uint32_t count = 0;

    for (uint32_t p = 0; p < b->polygon_count; p++)
        count += b->warp[p] >= least && b->warp[p] <= most;
    return count;
}

static uint32_t linear(const struct body *b)
{
    return of_warp(b, 1, SHEEN_WARP_PLANE - 1);
}

static void linear_normals_are_told(void **unused)
{
    static struct body body;

    (void)unused;
    make_body(&body, GLOBE, 48, 24);
    assert_int_equal(linear(&body), body.polygon_count);
    make_body(&body, DRUM, 24, 6);
    assert_int_equal(linear(&body), body.polygon_count);
    make_body(&body, EGG, 48, 24);
    assert_in_range(of_warp(&body, SHEEN_WARP_PLANE, SHEEN_WARP_PLANE), 22 * 48 - 100, 22 * 48);
    make_body(&body, GLOBE, 48, 24); /* one normal is tilted: the four quads about it */
    body.normals[3 * (12 * 48 + 7) + 1] = (int16_t)(body.normals[3 * (12 * 48 + 7) + 1] + 60);
    sheen_mesh_warp(&body.mesh, body.polygon_count, body.warp);
    assert_int_equal(of_warp(&body, SHEEN_WARP_PLANE, SHEEN_WARP_PLANE), 4);
    body.mesh.normals = NULL;
    sheen_mesh_warp(&body.mesh, body.polygon_count, body.warp);
    assert_int_equal(of_warp(&body, 1, 1), body.polygon_count);
}

/* The largest angle, in radians, between normals at the corners of the two triangles that start at `first`. */
static double widest(const struct body *b, uint32_t first)
{
    const uint16_t *index = b->indices + 3 * first, corner[4] = {index[0], index[1], index[2], index[5]};
    double most = 0;

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < i; k++) {
            double square = 0;
            for (int c = 0; c < 3; c++) {
                const double off = (b->normals[3 * corner[i] + c] - b->normals[3 * corner[k] + c]) / 32768.;
                square += off * off;
            }
            most = fmax(most, 2 * asin(sqrt(square) / 2));
        }
    return most;
}

/* The angle whose chord is that of `degrees`, divided by sqrt(5). */
static double over_root_5(double degrees)
{
    return 2 * asin(sin(degrees * PI / 360) / sqrt(5));
}

/* For bodies of any fineness, warp gives the range of the angle between the normals. */
static void warp_tells_the_angle(void **unused)
{
    static const double degrees[SHEEN_WARP_PLANE - 1] = {0, 13, 14, 18, 20, 25.92, 30, 34};
    static struct body body;
    uint32_t seen[SHEEN_WARP_PLANE] = {0};

    (void)unused;
    for (uint32_t i = 0; i < 60; i++) {
        make_body(&body, i % 3 == 2 ? DRUM : GLOBE, 5 + i, i % 3 == 0 ? 5 + i / 2 : 28);
        for (uint32_t t = 0; t + 1 < body.mesh.triangles; t++) {
            const uint8_t warp = body.warp[body.polygons[t]];
            if (body.polygons[t] != body.polygons[t + 1] || (t > 0 && body.polygons[t] == body.polygons[t - 1]) ||
                (t + 2 < body.mesh.triangles && body.polygons[t] == body.polygons[t + 2]))
                continue;
            assert_in_range(warp, 1, SHEEN_WARP_PLANE - 1);
            const double angle = widest(&body, t);
            assert_true(angle <= (warp == SHEEN_WARP_PLANE - 1 ? PI : over_root_5(degrees[warp])));
            assert_true(angle >= over_root_5(degrees[warp - 1]) - .0002);
            seen[warp]++;
        }
    }
    for (unsigned warp = 1; warp < SHEEN_WARP_PLANE; warp++)
        assert_true(seen[warp] > 100);
}

/* Objects that are two-sided or morphed, and meshes without polygons or warp, are drawn as triangles. */
static void others_are_not(void **unused)
{
    static struct body body;
    static struct drawn drawn;
    const struct sheen_morph morph = {&body.mesh, &sheen_morpher, 100};
    struct look look;
    uint32_t state = 77;

    (void)unused;
    make_body(&body, GLOBE, 24, 12);
    for (int i = 0; i < 5; i++) {
        do
            random_look(&look, &state);
        while (look.view.affine);
        look.object.shader = &sheen_flat;
        look.object.two_sided = i == 1;
        look.object.morph = i == 2 ? &morph : NULL;
        body.mesh.polygons = i == 3 ? NULL : body.polygons;
        body.mesh.polygon_normals = i == 3 ? NULL : body.facing;
        body.mesh.warp = i == 4 ? NULL : body.warp;
        draw_body(&body, &look, 1, &drawn);
        assert_int_equal(drawn.quads > 0, i == 0);
    }
}

/* ---- single ones ---- */

/*
 * A polygon in front of an eye that is not turned: raw positions and normals, polygon normal, the view's depths
 * (Q7.24).
 */
struct single {
    int16_t position[18], normal[18], facing[3];
    uint32_t corners;
    int32_t near, far, distance;
};

static void make_single(struct body *b, struct look *look, const struct single *s, const struct sheen_shader *shader)
{
    memset(b, 0, sizeof *b);
    b->mesh.positions = b->positions;
    memcpy(b->positions, s->position, sizeof s->position);
    memcpy(b->normals, s->normal, sizeof s->normal);
    b->mesh.vertices = (uint16_t)s->corners;
    add_polygon(b, (const uint32_t[6]){0, 1, 2, 3, 4, 5}, s->corners);
    memcpy(b->facing, s->facing, sizeof s->facing);
    b->mesh.normals = b->normals;
    finish_mesh(b);
    memset(look, 0, sizeof *look);
    look->view = (struct sheen_view){.fov = SHEEN_DEGREES(50), .z_near = s->near, .z_far = s->far};
    look->material = (struct sheen_material){.base = {255, 200, 90}, .ambient = 9000, .diffuse = 50000};
    look->light = (struct sheen_light){.to = {1 << 29, 1 << 29, 1 << 29}, .intensity = 65536};
    look->object.shader = shader;
    look->object.pose.translation[2] = -s->distance;
    look->rows = HEIGHT;
    look->carried = 80;
}

/* Its diagonal is horizontal: one triangle ends there and the other begins, and a band may end there too. */
static const struct single level = {.position = {-5900, 0, 0, 0, -4400, 14700, 5900, 0, 0, 0, 4400, -14700},
                                    .normal = {0, 31393, 9397, 0, 31393, 9397, 0, 31393, 9397, 0, 31393, 9397},
                                    .facing = {0, 31393, 9397},
                                    .corners = 4,
                                    .near = SHEEN_Q24(.2),
                                    .far = SHEEN_Q24(8),
                                    .distance = SHEEN_Q24(2)};

static void bands_along_a_diagonal(void **unused)
{
    static struct body body;
    static struct drawn once, bands;
    struct look look;

    (void)unused;
    make_single(&body, &look, &level, &sheen_flat);
    draw_body(&body, &look, 1, &once);
    assert_int_equal(once.quads, 1);
    for (int rows = 1; rows < HEIGHT; rows++) {
        look.rows = (uint8_t)rows;
        draw_body(&body, &look, 1, &bands);
        assert_memory_equal(bands.pixel, once.pixel, sizeof once.pixel);
        assert_memory_equal(bands.depth, once.depth, sizeof once.depth);
    }
}

/* Seen nearly edge-on: the plane through three snapped corners leaves the range of depths. */
static const struct single edge_on = {.position = {-5140, 4522, 15246, -14236, 17676, -13288, -8922, 2130, -19360, 551,
                                                   -13744, 4068, 658, -11972, 9974, -2400, -2062, 16254},
                                      .normal = {-30231, -11945, 4134, -30232, -11943, 4128, -30231, -11946, 4127,
                                                 -30230, -11949, 4131, -30230, -11949, 4132, -30230, -11946, 4134},
                                      .facing = {-30231, -11946, 4130},
                                      .corners = 6,
                                      .near = 3954577,
                                      .far = 52298187,
                                      .distance = 20400249};

/* With a depth bias that clamps some corners to the far plane's depth. */
static const struct single held = {
    .position = {16671, -2555, 16203, 7141, 16842, 2772, 2454, -8781, 2743, 4859, -10337, 5507},
    .normal = {-19500, 1669, 26280, -23642, 9672, 20523, -25495, -768, 20569, -24468, -1422, 21748},
    .facing = {-23298, 4235, 22649},
    .corners = 4,
    .near = 3171425,
    .far = 60928261,
    .distance = 32283096};

static void depths_do_not_wrap(void **unused)
{
    static struct body body;
    static struct drawn whole, apiece;
    struct difference d = {0};
    struct look look;

    (void)unused;
    for (int i = 0; i < 2; i++) {
        make_single(&body, &look, i == 0 ? &edge_on : &held, &sheen_flat);
        look.object.depth_bias = i == 0 ? 0 : -3918;
        assert_in_range(body.warp[0], 1, SHEEN_WARP_PLANE - 1);
        draw_body(&body, &look, 1, &whole);
        draw_body(&body, &look, 0, &apiece);
        compare(&whole, &apiece, 1, &d);
    }
    assert_true(d.pixels > 200 && d.colours == 0);
}

/* Corner 3 is nearer than the others, by more than the weights computed from them can represent. */
static const struct single nearest = {
    .position = {-4013, 4427, -7955, 507, -501, -1272, 16, 866, 743, -4698, 6007, -6228},
    .normal = {-27295, -17444, 4935, -26847, -17932, 5598, -26895, -17797, 5797, -27363, -17287, 5107},
    .facing = {-27111, -17609, 5348},
    .corners = 4,
    .near = SHEEN_Q24(.2),
    .far = 676493285,
    .distance = 6547959};

/* Three unit vectors at right angles to each other. */
static void random_axes(double axis[3][3], uint32_t *state)
{
    const double turn = stage_uniform(state, 0, 2 * PI), up = stage_uniform(state, -1, 1), roll = sqrt(1 - up * up),
                 spin = stage_uniform(state, 0, 2 * PI);
    const double n[3] = {roll * cos(turn), roll * sin(turn), up}, e[3] = {-sin(turn), cos(turn), 0};
    const double f[3] = {n[1] * e[2] - n[2] * e[1], n[2] * e[0] - n[0] * e[2], n[0] * e[1] - n[1] * e[0]};

    for (int k = 0; k < 3; k++) {
        axis[0][k] = cos(spin) * e[k] + sin(spin) * f[k];
        axis[1][k] = cos(spin) * f[k] - sin(spin) * e[k];
        axis[2][k] = n[k];
    }
}

/* A bent parallelogram, or nearly one, that may reach up to the eye. */
static void random_single(struct single *s, uint32_t *state)
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double size = exp(stage_uniform(state, log(800), log(20000))), thin = exp(stage_uniform(state, log(.1), 0)),
                 bend = stage_uniform(state, 0, .1), skew = stage_uniform(state, -1, 1);
    const double distance = stage_uniform(state, .3, 2.5);
    double axis[3][3], centre[3], away = 0;

    memset(s, 0, sizeof *s);
    s->corners = 4;
    random_axes(axis, state);
    for (int k = 0; k < 3; k++) {
        centre[k] = stage_uniform(state, -9000, 9000);
        away += axis[2][k] * (centre[k] / 32768 - (k == 2 ? distance : 0));
    }
    for (int k = 0; k < 3; k++) {
        axis[0][k] = away > 0 ? -axis[0][k] : axis[0][k];
        axis[2][k] = away > 0 ? -axis[2][k] : axis[2][k];
        s->facing[k] = (int16_t)lround(32767 * axis[2][k]);
    }
    for (int i = 0; i < 4; i++) {
        const double x = at[i][0] + skew * at[i][1] + stage_uniform(state, -.1, .1), y = at[i][1] * thin;
        double n[3], length = 0;
        for (int k = 0; k < 3; k++) {
            const double p = centre[k] + size * (x * axis[0][k] + y * axis[1][k]);
            s->position[3 * i + k] = (int16_t)lround(fmax(-32767, fmin(32767, p)));
            n[k] = axis[2][k] + bend * (x * axis[0][k] + y * axis[1][k]);
            length += n[k] * n[k];
        }
        for (int k = 0; k < 3; k++)
            s->normal[3 * i + k] = (int16_t)lround(32767 * n[k] / sqrt(length));
    }
    s->near = SHEEN_Q24(.2);
    s->distance = (int32_t)(distance * (1 << 24));
    s->far = s->distance + (int32_t)(stage_uniform(state, .3, 100) * (1 << 24));
}

/* Gouraud from black to white in perspectives of all strengths: light and weight stay in their ranges at corner 3. */
static void single_ones(void **unused)
{
    static struct body body;
    static struct drawn whole, apiece;
    struct difference d = {0};
    struct look steep;
    uint32_t state = 9;

    (void)unused;
    make_single(&body, &steep, &nearest, &sheen_gouraud);
    steep.light = (struct sheen_light){.to = {21671046, -41965152, 90390446}, .intensity = 65536};
    steep.material.ambient = 0;
    steep.material.diffuse = 21280;
    draw_body(&body, &steep, 1, &whole);
    draw_body(&body, &steep, 0, &apiece);
    compare_colours(&whole, &apiece, 1, &d);
    assert_true(d.quads == 1 && d.pixels > 50 && d.step <= 1);
    for (int i = 0; i < 12000; i++) {
        struct single s;
        struct look look;
        double light[3][3], along = 0;
        random_single(&s, &state);
        make_single(&body, &look, &s, &sheen_gouraud);
        look.material.ambient = (sheen_q16_t)(stage_random(&state) % 4 * 6000);
        look.material.diffuse = (sheen_q16_t)exp(stage_uniform(&state, log(1000), log(60000)));
        random_axes(light, &state); /* the light falls on the front or grazes it */
        for (int k = 0; k < 3; k++)
            along += light[0][k] * s.facing[k] / 32767;
        for (int k = 0; k < 3; k++)
            look.light.to[k] = (int32_t)((1 << 28) * (light[0][k] + (i % 2 ? 1 : .1 - along) * s.facing[k] / 32767));
        look.object.depth_bias = (int16_t)(i % 4 == 0 ? (int32_t)(stage_random(&state) % 8192) - 4096 : 0);
        draw_body(&body, &look, 1, &whole);
        if (whole.quads == 0)
            continue;
        draw_body(&body, &look, 0, &apiece);
        compare_colours(&whole, &apiece, 1, &d);
    }
    print_message("  %ld quads, %ld pixels, %ld of another colour, by %d at the most\n", d.quads, d.pixels, d.colours,
                  d.step);
    assert_true(d.quads > 1000 && d.step <= 1 && d.colours < d.pixels / 50);
}

/*
 * If light is taken as linear, the value extrapolated to corner 3 stays within [low, high], however far the light
 * computed there differs from it.
 */
static void light_stays(void **unused)
{
    static struct draw draw;
    long taken = 0;
    uint32_t state = 11;

    (void)unused;
    draw.light.count = 1;
    for (int i = 0; i < 500000; i++) {
        struct vertex v[4];
        const struct vertex *const at[4] = {&v[0], &v[1], &v[2], &v[3]};
        struct quad q = {.v = at};
        const uint32_t spread = 1u << (4 + stage_random(&state) % 12), bright = stage_random(&state) % 2;
        draw.colour.low = (int32_t)(stage_random(&state) % 200);
        draw.colour.high = (int32_t)(32768 - stage_random(&state) % 200);
        draw.colour.diffuse_tolerance = stage_random(&state) % 4096;
        memset(v, 0, sizeof v);
        for (int k = 0; k < 4; k++) {
            const uint32_t kept = stage_random(&state) % spread;
            v[k].kept[0] = (uint16_t)(bright ? 32768 - kept : kept);
        }
        q.area[0] = (int32_t)(1 + stage_random(&state) % (1u << (stage_random(&state) % 30)));
        for (int k = 1; k < 3; k++)
            q.area[k] = (int32_t)(q.area[0] * stage_uniform(&state, 0, 2));
        if (!sheen_lit_linearly(&draw, &q))
            continue;
        const double made = v[0].kept[0] + ((double)(v[1].kept[0] - v[0].kept[0]) * q.area[1] +
                                            (double)(v[2].kept[0] - v[0].kept[0]) * q.area[2]) /
                                               q.area[0];
        assert_true(made >= draw.colour.low - 24 && made <= draw.colour.high + 24); /* 24: areas are cut to 13 bits */
        taken++;
    }
    assert_true(taken > 25000);
}

/* Corner 1 lies on the line from 0 to 2, so the normals at 0, 1 and 3 say nothing about the one at corner 2. */
static void corners_in_line(void **unused)
{
    static struct body body;
    struct single s = level;
    struct look look;

    (void)unused;
    memcpy(s.position + 3, (const int16_t[3]){0, 0, 0}, 3 * sizeof *s.position);
    make_single(&body, &look, &s, &sheen_phong);
    assert_int_equal(body.warp[0], SHEEN_WARP_PLANE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_their_triangles),
                                       cmocka_unit_test(where_depth_is_coarse),
                                       cmocka_unit_test(linear_normals_are_told),
                                       cmocka_unit_test(warp_tells_the_angle),
                                       cmocka_unit_test(others_are_not),
                                       cmocka_unit_test(bands_along_a_diagonal),
                                       cmocka_unit_test(depths_do_not_wrap),
                                       cmocka_unit_test(corners_in_line),
                                       cmocka_unit_test(single_ones),
                                       cmocka_unit_test(light_stays)};

    return cmocka_run_group_tests_name("frame_quads", tests, NULL, NULL);
}
