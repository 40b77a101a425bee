/*
 * test_flythrough.c - an eye flies through the teapot for 500 frames, with back faces and without.
 *
 * Coverage is compared with the same triangles in double precision, cut by the same planes but not snapped. A pixel may
 * be missing only if some point within 1/8 px of its centre is uncovered in the reference too; a crack between two
 * triangles that share an edge does not meet that condition. A pixel may be drawn only if a triangle is within 1/8 px.
 * A crack with another surface behind it shows in the colours, which are compared as well.
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
#include "loaded_mesh.h"
#include "shapes.h"

#define WIDTH 128
#define HEIGHT 96
#define FRAMES 500
#define REACH (1.0 / 8) /* px */
#define TURN 6.28318530717958647692

static struct loaded_mesh teapot;
static struct ref_mesh exact; /* the core's own corners, so that quantisation of the mesh adds no error */

/* Sums over the pixels of all frames. */
struct tally {
    long covered, differing, cracks, strays;
    int full;        /* frames in which every pixel is covered, because the eye is inside */
    double farthest; /* px, the largest distance of a drawn pixel from a triangle that does not cover it */
    long clipped;    /* triangles cut */
    /* compared: pixels whose colour is compared; far: those that are more than one step off */
    long compared, far;
};

static double position(const struct sheen_mesh *mesh, uint32_t vertex, int k)
{
    return (mesh->offset[k] + mesh->scale * (mesh->positions[3 * vertex + (uint32_t)k] / 32768.0)) / 16777216;
}

static uint32_t index_at(const struct sheen_mesh *mesh, uint32_t i)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[i] : ((const uint16_t *)mesh->indices)[i];
}

static int load_teapot(void **state)
{
    static const struct ref_mesh_options as_it_is = {.crease = -1};
    struct shape shape = {0};
    int status = loaded_mesh_make(&teapot, "builtin:teapot");
    const struct sheen_mesh *mesh = &teapot.quantised.mesh;
    uint32_t corners = 3u * mesh->triangles;

    (void)state;
    for (uint32_t v = 0; v < mesh->vertices && status == 0; v++)
        status = shape_point(&shape, position(mesh, v, 0), position(mesh, v, 1), position(mesh, v, 2));
    for (uint32_t t = 0; t < mesh->triangles && status == 0; t++) {
        const uint32_t corner[3] = {index_at(mesh, 3 * t), index_at(mesh, 3 * t + 1), index_at(mesh, 3 * t + 2)};
        status = shape_polygon(&shape, 3, corner);
    }
    shape.normals = calloc(corners, sizeof *shape.normals);
    if (shape.normals == NULL)
        status = -1;
    for (uint32_t c = 0; c < corners && status == 0; c++) {
        for (int k = 0; k < 3; k++)
            shape.normals[c][k] = mesh->normals[3 * index_at(mesh, c) + (uint32_t)k] / 32767.0;
    }
    shape.polygons.normals = (const double(*)[3])shape.normals;
    if (status == 0)
        status = ref_mesh_build(&exact, &shape.polygons, &as_it_is);
    shape_free(&shape);
    return status;
}

static int free_teapot(void **state)
{
    (void)state;
    loaded_mesh_free(&teapot);
    ref_mesh_free(&exact);
    return 0;
}

/* ---- the flight ---- */

/*
 * In the first 300 frames the eye winds through body, spout and handle and looks around. After that it flies straight
 * along the axis of spout and handle and down through the lid, so that edges lie in planes through the eye.
 */
static void place(struct ref_scene *scene, int frame)
{
    double t = frame * TURN / 300, along = (frame % 100) / 99.0;
    double eye[3] = {1.15 * sin(2 * t), 0.35 * sin(5 * t), 0.6 * sin(3 * t)};
    double yaw = 140 * sin(3 * t) + frame, pitch = 70 * sin(4 * t), roll = 40 * sin(t);

    if (frame >= 300) {
        bool down = frame >= 400;
        eye[0] = down ? 0 : 1.1 - 2.2 * along;
        eye[1] = down ? 0.7 - 1.3 * along : 0;
        eye[2] = 0;
        yaw = down ? 0 : frame % 2 ? 90 : -90;
        pitch = down ? (frame % 2 ? 90 : -90) : 0;
        roll = 0;
    }
    ref_scene_orbit(scene, yaw, pitch, roll, 1);
    for (int k = 0; k < 3; k++)
        scene->translation[k] = -(scene->rotation[3 * k] * eye[0] + scene->rotation[3 * k + 1] * eye[1] +
                                  scene->rotation[3 * k + 2] * eye[2]);
}

static void scene_of(struct ref_scene *scene, int frame, bool two_sided)
{
    static const double shininess[3] = {8, 32, 128};

    ref_scene_default(scene, &exact);
    scene->width = WIDTH;
    scene->height = HEIGHT;
    scene->fov = 70;
    scene->shading = (enum ref_shading)(frame % 4);
    scene->shininess = shininess[frame % 3];
    scene->ambient = 0.3; /* so that no covered pixel is as black as the background */
    scene->two_sided = two_sided;
    memset(scene->background, 0, sizeof scene->background);
    place(scene, frame);
    scene->near = 0.02;
    scene->far = 4;
}

/* ---- one frame against the reference ---- */

static double distance_of_all(const struct ref_picture *picture, double x, double y)
{
    double least = INFINITY;

    for (size_t i = 0; i < picture->piece_count; i++) {
        for (int side = 0; side < 3; side++)
            least = fmin(least, ref_side_distance(&picture->pieces[i], side, x, y));
    }
    return least;
}

static bool covered(const struct ref_picture *picture, double x, double y)
{
    for (size_t i = 0; i < picture->piece_count; i++) {
        if (ref_inside(&picture->pieces[i], x, y))
            return true;
    }
    return false;
}

/* True if nothing within REACH of the point is uncovered, sampled on 8 circles of 32 points. */
static bool well_inside(const struct ref_picture *picture, double x, double y)
{
    for (int i = 0; i < 8 * 32; i++) {
        double r = REACH * (1 + i / 32) / 8, turn = TURN * (i % 32) / 32;
        if (!covered(picture, x + r * cos(turn), y + r * sin(turn)))
            return false;
    }
    return true;
}

static void compare_coverage(struct tally *tally, const uint16_t *values, const struct ref_picture *picture)
{
    long count = 0;

    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double x = i % WIDTH + 0.5, y = i / WIDTH + 0.5;
        bool inside = picture->pixels[i].covered;
        count += inside;
        if ((values[i] != 0) == inside)
            continue;
        tally->differing++;
        if (inside) {
            tally->cracks += well_inside(picture, x, y);
        } else {
            double off = distance_of_all(picture, x, y);
            tally->farthest = fmax(tally->farthest, off);
            tally->strays += off > REACH;
        }
    }
    tally->covered += count;
    tally->full += count == WIDTH * HEIGHT;
}

/* ---- frames ---- */

static void draw(struct tally *tally, uint16_t *values, const struct sheen_mesh *mesh, const struct ref_scene *scene)
{
    struct memory_target target;
    struct core_stats stats;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    assert_int_equal(core_draw_scene_way(&target.target, scene, mesh, 16, 0, &stats), SHEEN_OK);
    assert_int_equal(target.breaches, 0);
    tally->clipped += stats.frame.clipped;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        values[i] = (uint16_t)memory_target_pixel(&target, i % WIDTH, i / WIDTH);
    memory_target_free(&target);
}

static void fly(struct tally *tally, const struct sheen_mesh *mesh, int frame, bool two_sided)
{
    static uint16_t values[WIDTH * HEIGHT];
    struct ref_score score = {0};
    struct ref_picture picture;
    struct ref_scene scene;

    scene_of(&scene, frame, two_sided);
    assert_int_equal(ref_render(&picture, &scene), 0);
    draw(tally, values, mesh, &scene);
    compare_coverage(tally, values, &picture);
    if (scene.shading != REF_FLAT) { /* not flat: the core uses the polygons' normals, the reference the triangles' */
        assert_int_equal(ref_compare(&score, &scene, &picture, values), 0);
        tally->compared += score.compared;
        tally->far += score.compared - score.within_one;
    }
    ref_picture_free(&picture);
}

static void fly_all(bool two_sided)
{
    struct tally tally = {0};

    for (int frame = 0; frame < FRAMES; frame++) {
        struct tally before = tally;
        fly(&tally, &teapot.quantised.mesh, frame, two_sided);
        if (tally.cracks > before.cracks || tally.strays > before.strays)
            print_message("    frame %d: %ld cracks, %ld pixels outside\n", frame, tally.cracks - before.cracks,
                          tally.strays - before.strays);
    }
    print_message("    %s: %ld triangles cut, %d frames filled; %ld pixels covered, %ld differ at their edges, up to "
                  "%.4f px off;\n    %ld of %ld colours more than a step off\n",
                  two_sided ? "two-sided" : "front faces", tally.clipped, tally.full, tally.covered, tally.differing,
                  tally.farthest, tally.far, tally.compared);
    assert_int_equal(tally.cracks, 0);
    assert_int_equal(tally.strays, 0);
    assert_true(tally.clipped > 5000);
    assert_true(tally.covered > FRAMES * WIDTH * HEIGHT / 10);
    assert_true(!two_sided || tally.full > FRAMES / 10);
    assert_true(tally.compared > tally.covered / 5);
    assert_true(tally.far <= tally.compared / 50000); /* where surfaces cross, closer than 16 bits of depth can tell */
}

static void seen_from_both_sides(void **state)
{
    (void)state;
    fly_all(true);
}

static void seen_from_the_front(void **state)
{
    (void)state;
    fly_all(false);
}

/*
 * Proves that the comparison detects faults: leaving out every 50th triangle must leave holes, and a mesh moved by
 * 1/256 unit must reach too far.
 */
static void faults_are_seen(void **state)
{
    struct sheen_mesh mesh = teapot.quantised.mesh;
    size_t count = 3u * mesh.triangles;
    uint16_t *indices = malloc(count * sizeof *indices);
    struct tally tally = {0};

    (void)state;
    assert_non_null(indices);
    for (uint32_t i = 0; i < count; i++)
        indices[i] = (uint16_t)index_at(&mesh, i / 3 % 50 == 0 ? i - i % 3 : i);
    mesh.indices = indices;
    mesh.index_bytes = 2;
    for (int frame = 0; frame < FRAMES; frame += 25)
        fly(&tally, &mesh, frame, true);
    assert_true(tally.cracks > 100);
    assert_int_equal(tally.strays, 0);
    free(indices);
    mesh = teapot.quantised.mesh;
    mesh.offset[1] += 1 << 16;
    for (int frame = 0; frame < FRAMES; frame += 25)
        fly(&tally, &mesh, frame, false);
    assert_true(tally.strays > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seen_from_both_sides),
        cmocka_unit_test(seen_from_the_front),
        cmocka_unit_test(faults_are_seen),
    };

    return cmocka_run_group_tests_name("flythrough", tests, load_teapot, free_teapot);
}
