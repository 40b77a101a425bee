/*
 * test_core_flight.c - an eye that flies through the walls of a closed mesh, 500 frames.
 *
 * Seen from inside, a closed mesh fills the picture: every pixel shows it, none the background. Exact. Inside means
 * farther from every face than the corners of the near plane reach, so that only faces cut by planes are cut.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "../host-sim/command/shadings.h"
#include "frame_stage.h"
#include "shapes.h"

#define WIDTH 160
#define HEIGHT 120
#define FRAMES 500
#define PI 3.14159265358979323846
#define NEAR 0.04
#define FOV 70.0

/* A mesh, both as it is and turned inside out, and a frame to draw it in. */
struct flight {
    struct ref_mesh source;
    struct core_mesh mesh;
    uint16_t *inverted;
    struct memory_target target;
    struct core_frame frame;
    struct sheen_material material;
    double reach; /* from the eye to a corner of the near plane */
};

static void flight_begin(struct flight *f, int (*make)(struct shape *))
{
    struct shape shape;

    memset(f, 0, sizeof *f);
    memset(&shape, 0, sizeof shape);
    assert_int_equal(make(&shape), 0);
    const struct ref_mesh_options options = {.crease = -1};
    assert_int_equal(ref_mesh_build(&f->source, &shape.polygons, &options), 0);
    shape_free(&shape);
    assert_int_equal(core_mesh_make(&f->mesh, &f->source), 0);
    size_t corners = 3u * f->mesh.mesh.triangles;
    f->inverted = malloc(corners * sizeof *f->inverted);
    assert_non_null(f->inverted);
    for (size_t i = 0; i < corners; i++)
        f->inverted[i] = f->mesh.indices[i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1];
    f->material = (struct sheen_material){.base = {255, 255, 255}, .ambient = SHEEN_Q16(1)};
    assert_int_equal(memory_target_init(&f->target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &f->target.target,
                                        .max_vertices = f->mesh.mesh.vertices,
                                        .max_triangles = 2000,
                                        .max_clipped = 1000,
                                        .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&f->frame, &config), SHEEN_OK);
    double up = tan(FOV / 360 * PI), aside = up * WIDTH / HEIGHT;
    f->reach = NEAR * sqrt(1 + up * up + aside * aside) + 0.001;
}

static void flight_end(struct flight *f)
{
    core_frame_free(&f->frame);
    memory_target_free(&f->target);
    free(f->inverted);
    core_mesh_free(&f->mesh);
    ref_mesh_free(&f->source);
}

/* How deep a point lies inside the mesh, which is convex: the least distance to a face's plane, negative outside. */
static double depth_inside(const struct flight *f, const double eye[3])
{
    const struct sheen_mesh *m = &f->mesh.mesh;
    double least = INFINITY;

    for (uint32_t t = 0; t < m->triangles; t++) {
        double p[3][3], n[3], length = 0, inside = 0;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                p[k][i] = m->offset[i] / 16777216. +
                          m->scale / 16777216. * m->positions[3 * f->mesh.indices[3 * t + (uint32_t)k] + i] / 32768;
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            n[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
            length += n[i] * n[i];
            inside += n[i] * (p[0][i] - eye[i]);
        }
        if (length > 0)
            least = fmin(least, inside / sqrt(length));
    }
    return least;
}

/* The eye's place and where it looks, for frame i: to and fro through the walls, turning all the while. */
static void fly(int i, double eye[3], sheen_q24_t at[3], sheen_q24_t target[3])
{
    double t = i * 2 * PI / FRAMES, away = 1.15 * sin(3 * t);

    eye[0] = away * cos(5 * t);
    eye[1] = away * 0.6 * sin(7 * t);
    eye[2] = away * sin(5 * t);
    for (int k = 0; k < 3; k++) {
        at[k] = SHEEN_Q24(eye[k]);
        target[k] = SHEEN_Q24(eye[k] + (k == 0 ? cos(11 * t) : k == 1 ? 0.8 * sin(4 * t) : sin(11 * t)));
    }
}

/* Pixels that show the background. */
static int draw_frame(struct flight *f, int i, int one_sided, enum sheen_shading shading, double *depth)
{
    static const int32_t up[3] = {0, 1 << 30, 0};
    static const struct sheen_light light = {.to = {1 << 29, 1 << 30, 1 << 29}, .intensity = 65536};
    const struct sheen_view view = {.fov = SHEEN_DEGREES(FOV), .z_near = SHEEN_Q24(NEAR), .z_far = SHEEN_Q24(5)};
    struct sheen_mesh mesh = f->mesh.mesh;
    struct sheen_object draw = {.mesh = &mesh,
                                .material = &f->material,
                                .lights = &light,
                                .light_count = 1,
                                .shader = sheen_shader_of(shading),
                                .two_sided = !one_sided};
    double eye[3];
    sheen_q24_t at[3], target[3];
    int background = 0;

    mesh.warp = NULL; /* of what faces outwards */
    if (one_sided)
        mesh.indices = f->inverted;
    fly(i, eye, at, target);
    *depth = depth_inside(f, eye);
    assert_int_equal(sheen_pose_look_at(&draw.pose, at, target, up), SHEEN_OK);
    assert_int_equal(sheen_begin(f->frame.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(f->frame.frame, &draw), SHEEN_OK);
    assert_int_equal(sheen_end(f->frame.frame), SHEEN_OK);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            background += memory_target_pixel(&f->target, x, y) == 0;
    return background;
}

static void fly_through(int (*make)(struct shape *))
{
    static struct flight f;
    int inside = 0, outside = 0, open = 0;

    flight_begin(&f, make);
    for (int i = 0; i < FRAMES; i++)
        for (int one_sided = 0; one_sided < 2; one_sided++) {
            double depth;
            int background = draw_frame(&f, i, one_sided, (enum sheen_shading)((i + one_sided) % 3), &depth);
            if (depth <= f.reach) {
                outside += depth < 0;
                continue;
            }
            inside++;
            if (background > 0 && open++ == 0)
                print_message("           frame %d, %s-sided: %d holes, %g deep inside\n", i, one_sided ? "one" : "two",
                              background, depth);
        }
    print_message("           %d frames inside, %d outside\n", inside, outside);
    assert_int_equal(open, 0);
    assert_true(inside > 300 && outside > 50);
    flight_end(&f);
}

static int make_sphere(struct shape *shape)
{
    return shape_sphere(shape, 8, 12);
}

static int make_barrel(struct shape *shape)
{
    return shape_barrel(shape, 6, 14);
}

static void test_through_an_octahedron(void **unused)
{
    (void)unused;
    fly_through(shape_octahedron);
}

static void test_through_a_sphere(void **unused)
{
    (void)unused;
    fly_through(make_sphere);
}

static void test_through_a_barrel(void **unused)
{
    (void)unused;
    fly_through(make_barrel);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_through_an_octahedron),
        cmocka_unit_test(test_through_a_sphere),
        cmocka_unit_test(test_through_a_barrel),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
