/*
 * test_core_errors.c - what the public functions refuse, one wrong thing at a time, and that nothing is left of it.
 *
 * Memory, capacities and calls out of order are test_frame_limits.c's.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "../host-sim/command/shadings.h"
#include "frame_stage.h"
#include "sheen.h"

#define WIDTH 64
#define HEIGHT 48

/* ---- a draw ---- */

struct wrong {
    const char *what;
    void (*make)(struct sheen_object *draw, struct sheen_mesh *mesh, struct sheen_material *material,
                 struct sheen_light *light);
    int error;
    enum sheen_subject about;
};

#define WRONG(name, statement)                                                                                         \
    static void name(struct sheen_object *draw, struct sheen_mesh *mesh, struct sheen_material *material,              \
                     struct sheen_light *light)                                                                        \
    {                                                                                                                  \
        (void)draw;                                                                                                    \
        (void)mesh;                                                                                                    \
        (void)material;                                                                                                \
        (void)light;                                                                                                   \
        statement;                                                                                                     \
    }

WRONG(no_mesh, draw->mesh = NULL)
WRONG(no_material, draw->material = NULL)
WRONG(no_positions, mesh->positions = NULL)
WRONG(no_indices, mesh->indices = NULL)
WRONG(no_index_bytes, mesh->index_bytes = 0)
WRONG(wide_indices, mesh->index_bytes = 4)
WRONG(no_normals, mesh->normals = NULL)
WRONG(no_shader, draw->shader = NULL)
WRONG(no_shine, material->shine = NULL)
WRONG(unread_ramp, static const struct sheen_ramp ramp = {.span = 1}; material->ramp = &ramp)
WRONG(dim, material->ambient = -1)
WRONG(glaring, material->specular = (4 << 16) + 1)
WRONG(garbage, memset(material, 0xff, sizeof *material))
WRONG(five_lights, draw->light_count = 5)
WRONG(no_lights, draw->lights = NULL)
WRONG(zero_light, memset(light->to, 0, sizeof light->to))
WRONG(bright_light, light->intensity = 65537)
WRONG(dark_light, light->intensity = -1)
WRONG(flat_mesh, mesh->scale = 0)
WRONG(turned_over_pose, draw->pose.scale = -65536)
WRONG(huge_rotation, memset(draw->pose.rotation, 0x7f, sizeof draw->pose.rotation))
WRONG(stretched_rotation, draw->pose.rotation[0] += draw->pose.rotation[0] > 0 ? 1 << 23 : -(1 << 23))
WRONG(shrunken_rotation, for (int k = 0; k < 9; k++) draw->pose.rotation[k] -= draw->pose.rotation[k] / 1000)
WRONG(beyond_reach, draw->pose.translation[0] = INT32_MAX)
WRONG(beyond_reach_below, draw->pose.translation[2] = INT32_MIN)

static const struct wrong wrongs[] = {
    {"no mesh", no_mesh, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"no material", no_material, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MATERIAL},
    {"no positions", no_positions, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"no indices", no_indices, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"indices of no size", no_index_bytes, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"indices of 4 bytes", wide_indices, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"no normals", no_normals, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_NORMALS},
    {"no shader", no_shader, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_SHADER},
    {"a highlight without a table", no_shine, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_SHINE},
    {"a ramp that nothing reads", unread_ramp, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_RAMP},
    {"ambient light below 0", dim, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MATERIAL},
    {"a highlight above 4", glaring, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MATERIAL},
    {"a material of ones", garbage, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MATERIAL},
    {"five lights", five_lights, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_LIGHTS},
    {"no lights", no_lights, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_LIGHTS},
    {"a light from nowhere", zero_light, SHEEN_ERR_DEGENERATE, SHEEN_ABOUT_LIGHTS},
    {"a light above 1", bright_light, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_LIGHTS},
    {"a light below 0", dark_light, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_LIGHTS},
    {"a mesh of no size", flat_mesh, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_MESH},
    {"a pose of negative size", turned_over_pose, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
    {"a rotation of large numbers", huge_rotation, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
    {"a rotation that stretches", stretched_rotation, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
    {"a rotation that shrinks", shrunken_rotation, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
    {"beyond 128 units", beyond_reach, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
    {"behind -128 units", beyond_reach_below, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE},
};

/* Two frames with the same good draw, one of them with bad ones before and after it: the same picture and counts. */
static void test_draws(void **unused)
{
    static struct stage stage;
    const struct actor actor = {STAGE_BALL, 0, SHEEN_PHONG, 0, 0, 3, 1, 20, 30};
    struct memory_target good, bad;
    struct sheen_stats stats[2];

    (void)unused;
    assert_int_equal(stage_make(&stage), 0);
    assert_int_equal(memory_target_init(&good, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    assert_int_equal(memory_target_init(&bad, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    for (int i = 0; i < 2; i++) {
        struct sheen_config config;
        struct core_frame f;
        struct sheen_view view;
        struct sheen_object draw;
        stage_config(&config, i == 0 ? &good : &bad, 2);
        stage_view(&view);
        assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
        for (size_t k = 0; k < 2 * sizeof wrongs / sizeof wrongs[0]; k++) {
            const struct wrong *wrong = &wrongs[k / 2];
            stage_draw(&stage, &actor, &draw);
            if (k == sizeof wrongs / sizeof wrongs[0])
                assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_OK);
            struct sheen_mesh mesh = *draw.mesh;
            struct sheen_material material = *draw.material;
            struct sheen_light light = draw.lights[0];
            draw.mesh = &mesh;
            draw.material = &material;
            draw.lights = &light;
            wrong->make(&draw, &mesh, &material, &light);
            int error = i == 0 ? wrong->error : sheen_draw(f.frame, &draw);
            enum sheen_subject about = i == 0 ? wrong->about : sheen_frame_about(f.frame, NULL);
            if (error != wrong->error || about != wrong->about)
                fail_msg("%s: %d (%s), about %s", wrong->what, error, sheen_strerror(error), sheen_subject_name(about));
        }
        assert_int_equal(sheen_end(f.frame), SHEEN_OK);
        sheen_frame_stats(f.frame, &stats[i]);
        core_frame_free(&f);
    }
    assert_memory_equal(good.memory, bad.memory, HEIGHT * good.row_bytes);
    assert_memory_equal(&stats[0], &stats[1], sizeof stats[0]);
    assert_true(stats[0].drawn > 10);
    memory_target_free(&good);
    memory_target_free(&bad);
    stage_free(&stage);
}

/* Rows may be off by 1/1024, as far as products of many rotations drift. */
static void test_rotations_may_drift_a_little(void **unused)
{
    static struct stage stage;
    const struct actor actor = {STAGE_BALL, 0, SHEEN_PHONG, 0, 0, 3, 1, 0, 0};
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;
    struct sheen_object draw;

    (void)unused;
    assert_int_equal(stage_make(&stage), 0);
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    stage_config(&config, &target, 2);
    stage_view(&view);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    stage_draw(&stage, &actor, &draw);
    for (int k = 0; k < 9; k++)
        draw.pose.rotation[k] = k % 4 == 0 ? (1 << 30) + (1 << 19) - (1 << 12) : k == 1 ? 1 << 19 : 0;
    assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_OK);
    draw.pose.rotation[0] += 1 << 19;
    assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    core_frame_free(&f);
    memory_target_free(&target);
    stage_free(&stage);
}

/* ---- views ---- */

/* A viewport has to lie on the target, on its alignment or its edge. */
static void test_viewports(void **unused)
{
    static const struct {
        struct sheen_rect viewport;
        int error;
    } cases[] = {
        {{0, 0, 0, 0}, SHEEN_OK},
        {{8, 4, 8, 20}, SHEEN_OK}, /* empty: all of the target */
        {{8, 4, 24, 20}, SHEEN_OK},
        {{8, 4, WIDTH, HEIGHT}, SHEEN_OK},
        {{4, 4, 24, 20}, SHEEN_ERR_ARGUMENT},
        {{8, 2, 24, 20}, SHEEN_ERR_ARGUMENT},
        {{8, 4, 28, 20}, SHEEN_ERR_ARGUMENT},
        {{8, 4, 24, 22}, SHEEN_ERR_ARGUMENT},
        {{-8, 4, 24, 20}, SHEEN_ERR_ARGUMENT},
        {{8, -4, 24, 20}, SHEEN_ERR_ARGUMENT},
        {{8, 4, WIDTH + 8, 20}, SHEEN_ERR_ARGUMENT},
        {{8, 4, 24, HEIGHT + 4}, SHEEN_ERR_ARGUMENT},
    };
    struct memory_target target;
    struct core_frame f;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    target.target.align_x = 8;
    target.target.align_y = 4;
    const struct sheen_config config = {
        .target = &target.target, .band_rows = 5, .max_vertices = 1, .max_triangles = 1};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct sheen_view view;
        stage_view(&view);
        view.viewport = cases[i].viewport;
        if (sheen_begin(f.frame, &view) != cases[i].error)
            fail_msg("viewport %zu", i);
        if (cases[i].error == SHEEN_OK) {
            int rows = i < 2 ? HEIGHT : view.viewport.y1 - view.viewport.y0;
            assert_int_equal(sheen_band_count(f.frame), (rows + 7) / 8); /* 5 rows go up to 8 */
            assert_int_equal(sheen_end(f.frame), SHEEN_OK);
        }
    }
    assert_int_equal(target.breaches, 0);
    core_frame_free(&f);
    memory_target_free(&target);
}

/* Each field of a view, wrong by itself, is what the error is about; at its ends it is right. */
static void test_views(void **unused)
{
    static const struct {
        struct sheen_view view;
        enum sheen_subject about;
    } cases[] = {
        {{.fov = 0}, SHEEN_ABOUT_NOTHING},
        {{.fov = SHEEN_DEGREES(1)}, SHEEN_ABOUT_NOTHING},
        {{.fov = SHEEN_DEGREES(150)}, SHEEN_ABOUT_NOTHING},
        {{.fov = SHEEN_DEGREES(0.98)}, SHEEN_ABOUT_FOV},
        {{.fov = SHEEN_DEGREES(150.1)}, SHEEN_ABOUT_FOV},
        {{.fov = 1}, SHEEN_ABOUT_FOV},
        {{.z_near = SHEEN_Q24(2), .z_far = SHEEN_Q24(2)}, SHEEN_ABOUT_DEPTHS},
        {{.z_near = SHEEN_Q24(3), .z_far = SHEEN_Q24(2)}, SHEEN_ABOUT_DEPTHS},
        {{.z_near = -1}, SHEEN_ABOUT_DEPTHS},
        {{.z_near = SHEEN_Q24(16)}, SHEEN_ABOUT_DEPTHS},
        {{.orthographic = -1}, SHEEN_ABOUT_DEPTHS},
        {{.pose.scale = -1}, SHEEN_ABOUT_VIEW_POSE},
        {{.viewport = {0, 0, WIDTH + 1, 1}}, SHEEN_ABOUT_VIEWPORT},
    };
    struct memory_target target;
    struct core_frame f;

    (void)unused;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &target.target, .max_vertices = 1, .max_triangles = 1};
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        enum sheen_subject about = cases[i].about;
        int error = about ? SHEEN_ERR_ARGUMENT : SHEEN_OK;
        if (sheen_begin(f.frame, &cases[i].view) != error || (error && sheen_frame_about(f.frame, NULL) != about))
            fail_msg("view %zu: about %s", i, sheen_subject_name(sheen_frame_about(f.frame, NULL)));
        if (!error)
            assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    }
    core_frame_free(&f);
    memory_target_free(&target);
}

/* ---- meshes ---- */

static void test_meshes(void **unused)
{
    static const int16_t positions[9], normals[9];
    static const uint8_t narrow[6] = {0, 1, 2, 2, 1, 0}, far_off[6] = {0, 1, 2, 2, 3, 0};
    static const uint16_t wide[6] = {0, 1, 2, 2, 1, 0}, polygons[2] = {0, 4};
    const struct sheen_mesh good = {.positions = positions,
                                    .normals = normals,
                                    .indices = narrow,
                                    .index_bytes = 1,
                                    .vertices = 3,
                                    .triangles = 2,
                                    .scale = 1};
    struct sheen_mesh m = good;

    (void)unused;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_OK);
    assert_int_equal(sheen_mesh_check(NULL, 0), SHEEN_ERR_ARGUMENT);
    m.indices = wide;
    m.index_bytes = 2;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_OK);
    m.index_bytes = 3;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_ERR_ARGUMENT);
    m.index_bytes = 0;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_ERR_ARGUMENT);
    m = good;
    m.indices = far_off;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_ERR_ARGUMENT);
    m.vertices = 4;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_OK);
    m.triangles = 1;
    m.vertices = 3;
    assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_OK); /* the wrong index is beyond the last triangle */
    for (int i = 0; i < 5; i++) {
        m = good;
        m.positions = i == 0 ? NULL : m.positions;
        m.indices = i == 1 ? NULL : m.indices;
        m.vertices = i == 2 ? 0 : m.vertices;
        m.triangles = i == 3 ? 0 : m.triangles;
        m.scale = i == 4 ? -1 : m.scale;
        assert_int_equal(sheen_mesh_check(&m, 0), SHEEN_ERR_ARGUMENT);
    }
    m = good;
    m.polygon_normals = normals;
    assert_int_equal(sheen_mesh_check(&m, 2), SHEEN_OK);
    assert_int_equal(sheen_mesh_check(&m, 1), SHEEN_ERR_ARGUMENT);
    m.polygons = polygons;
    assert_int_equal(sheen_mesh_check(&m, 5), SHEEN_OK);
    assert_int_equal(sheen_mesh_check(&m, 4), SHEEN_ERR_ARGUMENT);
}

static void test_error_texts(void **unused)
{
    (void)unused;
    for (int i = SHEEN_ERR_UNSUPPORTED; i <= SHEEN_OK; i++)
        for (int k = i - 1; k >= SHEEN_ERR_UNSUPPORTED - 1; k--)
            assert_string_not_equal(sheen_strerror(i), sheen_strerror(k)); /* the last is unknown */
    assert_string_equal(sheen_strerror(1), sheen_strerror(SHEEN_ERR_UNSUPPORTED - 1));
    assert_true(strlen(sheen_strerror(INT32_MIN)) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_draws),     cmocka_unit_test(test_rotations_may_drift_a_little),
        cmocka_unit_test(test_viewports), cmocka_unit_test(test_views),
        cmocka_unit_test(test_meshes),    cmocka_unit_test(test_error_texts),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
