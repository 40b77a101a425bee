/*
 * test_core_garbage.c - whole frames of random bytes, each field within the range that sheen.h gives or refused.
 *
 * Nothing is compared: every call returns 0 or a code of enum sheen_error, the target's contract is kept, and the
 * sanitizers (preset asan) see no signed number wrap and no byte out of place.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "../host-sim/command/shadings.h"
#include "frame_stage.h"
#include "sheen.h"

#define SCENES 4000
#define VERTICES 40
#define TRIANGLES 60

struct garbage {
    uint32_t state;
    int16_t positions[3 * VERTICES], normals[3 * VERTICES], polygon_normals[3 * TRIANGLES];
    uint16_t polygons[TRIANGLES], wide[3 * TRIANGLES];
    uint8_t narrow[3 * TRIANGLES];
    struct sheen_mesh mesh;
    struct sheen_material material;
    struct sheen_texture texture;
    struct sheen_shine shine;
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_object draw;
    long drawn, refused;
};

static uint32_t below(struct garbage *g, uint32_t limit)
{
    return stage_random(&g->state) % limit;
}

/* Any number, of any length, either sign. */
static int32_t any(struct garbage *g)
{
    static const int32_t ends[] = {0, 1, -1, INT32_MAX, INT32_MIN, -INT32_MAX, 1 << 24, 1 << 30, 1 << 16};
    uint32_t bits = stage_random(&g->state);

    return below(g, 16) == 0 ? ends[below(g, sizeof ends / sizeof ends[0])] : (int32_t)bits >> below(g, 31);
}

static int32_t positive(struct garbage *g)
{
    return (int32_t)(stage_random(&g->state) >> (1 + below(g, 31))) | 1;
}

/* Unit vectors, as the mesh's contract has it, with the ends of the range among them; or any 16 bits. */
static void fill_normals(struct garbage *g, int16_t *to, int count, int unit)
{
    for (int i = 0; i < count; i++) {
        double n[3] = {stage_uniform(&g->state, -1, 1), stage_uniform(&g->state, -1, 1),
                       stage_uniform(&g->state, -1, 1)};
        double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        uint32_t axis = below(g, 20);
        for (uint32_t k = 0; k < 3; k++) {
            to[3 * i + (int)k] = (int16_t)(unit ? lrint(n[k] / length * 32767) : (long)(int16_t)any(g));
            if (axis < 6)
                to[3 * i + (int)k] = (int16_t)(axis / 2 != k ? 0 : axis % 2 != 0 ? 32767 : -32767);
        }
    }
}

static void fill_mesh(struct garbage *g, int unit)
{
    struct sheen_mesh *m = &g->mesh;
    uint32_t spread = below(g, 16);

    *m = (struct sheen_mesh){.positions = g->positions,
                             .normals = g->normals,
                             .vertices = (uint16_t)(1 + below(g, VERTICES)),
                             .triangles = (uint16_t)(1 + below(g, TRIANGLES)),
                             .index_bytes = (uint8_t)(1 + below(g, 2)),
                             .scale = below(g, 4) == 0 ? positive(g) : 1 << (20 + below(g, 8))};
    for (int i = 0; i < 3 * VERTICES; i++)
        g->positions[i] = (int16_t)((int16_t)stage_random(&g->state) >> (below(g, 3) == 0 ? spread : 0));
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        g->wide[i] = (uint16_t)below(g, m->vertices);
        g->narrow[i] = (uint8_t)below(g, m->vertices);
    }
    for (int i = 0; i < TRIANGLES; i++)
        g->polygons[i] = (uint16_t)below(g, TRIANGLES);
    m->indices = m->index_bytes == 1 ? (const void *)g->narrow : g->wide;
    m->polygon_normals = below(g, 2) != 0 ? g->polygon_normals : NULL;
    m->polygons = below(g, 2) != 0 ? g->polygons : NULL;
    fill_normals(g, g->normals, VERTICES, unit);
    fill_normals(g, g->polygon_normals, TRIANGLES, unit);
    for (int k = 0; k < 3; k++)
        m->offset[k] = below(g, 3) == 0 ? any(g) : 0;
    assert_int_equal(sheen_mesh_check(m, TRIANGLES), SHEEN_OK);
}

static void fill_look(struct garbage *g)
{
    struct sheen_material *m = &g->material;
    const int32_t most = (4 << 16) + 1;

    *m = (struct sheen_material){.ambient = (int32_t)below(g, (uint32_t)most),
                                 .diffuse = (int32_t)below(g, (uint32_t)most),
                                 .specular = (int32_t)below(g, (uint32_t)most),
                                 .shine = &g->shine};
    for (int k = 0; k < 3; k++) {
        m->base[k] = (uint8_t)any(g);
        m->highlight[k] = (uint8_t)any(g);
    }
    assert_int_equal(sheen_shine_make(&g->shine, 1 + below(g, 128)), SHEEN_OK);
    for (int i = 0; i < SHEEN_MAX_LIGHTS; i++)
        g->lights[i] = (struct sheen_light){.to = {any(g), any(g), any(g)},
                                            .intensity = (int32_t)below(g, 65537),
                                            .no_highlight = (uint8_t)below(g, 2)};
}

static void fill_draw(struct garbage *g)
{
    struct sheen_object *d = &g->draw;

    *d = (struct sheen_object){.mesh = &g->mesh,
                               .material = &g->material,
                               .lights = g->lights,
                               .light_count = (uint8_t)below(g, SHEEN_MAX_LIGHTS + 1),
                               .shader = sheen_shader_of(below(g, SHEEN_ALL_SHADINGS)),
                               .two_sided = (uint8_t)below(g, 2)};
    g->texture = sheen_matcap_jade;
    g->texture.bilinear = (uint8_t)below(g, 2);
    g->texture.clamp_u = (uint8_t)(below(g, 8) != 0);
    g->material.texture = below(g, 16) != 0 ? &g->texture : NULL;
    sheen_pose_orbit(&d->pose, stage_random(&g->state), stage_random(&g->state), stage_random(&g->state), 0);
    d->pose.scale = below(g, 4) == 0 ? positive(g) : 1 << (12 + below(g, 7));
    for (int k = 0; k < 3; k++)
        d->pose.translation[k] = below(g, 8) == 0 ? any(g) : any(g) / 32;
}

static void fill_view(struct garbage *g, struct sheen_view *view, const struct sheen_target *t)
{
    *view = (struct sheen_view){.fov = SHEEN_DEGREES(1) + below(g, SHEEN_DEGREES(149)),
                                .z_near = positive(g),
                                .z_far = positive(g),
                                .orthographic = below(g, 3) == 0 ? positive(g) : 0,
                                .affine = (uint8_t)below(g, 2),
                                .dither = (uint8_t)below(g, 2),
                                .background = {(uint8_t)any(g), (uint8_t)any(g), (uint8_t)any(g)}};
    if (view->z_near > view->z_far) {
        sheen_q24_t near = view->z_far;
        view->z_far = view->z_near;
        view->z_near = near;
    }
    if (below(g, 2) == 0) /* a scene is more often there than not */
        view->z_near = (view->z_near >> 8) | 1;
    if (below(g, 3) == 0)
        view->viewport = (struct sheen_rect){(int16_t)below(g, t->width), (int16_t)below(g, t->height),
                                             (int16_t)below(g, t->width + 8u), (int16_t)below(g, t->height + 8u)};
}

static int expected_code(int code)
{
    return code <= 0 && code >= SHEEN_ERR_UNSUPPORTED;
}

/* A few frames of one target and configuration, of several draws each. */
static void scene(struct garbage *g, int unit)
{
    static const uint8_t pixel[] = {SHEEN_RGB565_BE, SHEEN_RGB565_LE, SHEEN_GREY2, SHEEN_GREY16, SHEEN_GREY256};
    struct memory_target target;
    struct core_frame frame;
    uint8_t kind = pixel[below(g, 5)];

    assert_int_equal(memory_target_init(&target, 1 + (int)below(g, 100), 1 + (int)below(g, 80), (enum sheen_pixel)kind),
                     0);
    target.target.align_x = (uint8_t)(kind == SHEEN_GREY2 ? 8 : kind == SHEEN_GREY16 ? 2 : 1 << below(g, 4));
    target.target.align_y = (uint8_t)(1 << below(g, 4));
    target.delayed = below(g, 2) != 0;
    const struct sheen_config config = {.target = &target.target,
                                        .band_rows = (uint16_t)below(g, 40),
                                        .buffers = (uint8_t)below(g, 3),
                                        .workers = (uint8_t)below(g, 5),
                                        .max_vertices = (uint16_t)(VERTICES + below(g, VERTICES)),
                                        .max_triangles = (uint16_t)(1 + below(g, 3 * TRIANGLES)),
                                        .max_draws = (uint16_t)below(g, 4),
                                        .max_clipped = (uint16_t)below(g, TRIANGLES),
                                        .clipper = &sheen_clipper,
                                        .max_carried = (uint16_t)below(g, 6)};
    assert_int_equal(core_frame_make(&frame, &config), SHEEN_OK);
    for (int i = 0; i < 3; i++) {
        struct sheen_view view;
        fill_view(g, &view, &target.target);
        int code = sheen_begin(frame.frame, &view);
        assert_true(expected_code(code));
        if (code < 0)
            continue;
        fill_mesh(g, unit);
        fill_look(g);
        for (int k = 0; k < 3; k++) {
            fill_draw(g);
            if (!unit && g->draw.shader == &sheen_slerp)
                g->draw.shader = &sheen_phong; /* great arcs are for unit vectors */
            code = sheen_draw(frame.frame, &g->draw);
            assert_true(expected_code(code));
            *(code == 0 ? &g->drawn : &g->refused) += 1;
        }
        assert_int_equal(sheen_mark(frame.frame, (struct sheen_rect){(int16_t)any(g), (int16_t)any(g), (int16_t)any(g),
                                                                     (int16_t)any(g)}),
                         SHEEN_OK);
        assert_int_equal(sheen_end(frame.frame), SHEEN_OK);
    }
    assert_int_equal(sheen_wait(frame.frame), SHEEN_OK);
    if (target.breaches != 0)
        fail_msg("the target's contract: %s", target.first_breach);
    core_frame_free(&frame);
    memory_target_free(&target);
}

static void scenes(uint32_t seed, int unit)
{
    static struct garbage g;

    memset(&g, 0, sizeof g);
    g.state = seed;
    for (int i = 0; i < SCENES; i++)
        scene(&g, unit);
    print_message("           %ld draws, %ld refused\n", g.drawn, g.refused);
    assert_true(g.drawn > SCENES && g.refused > SCENES / 10);
}

static void test_anything_in_range(void **unused)
{
    (void)unused;
    scenes(1, 1);
}

/* Normals that are no unit vectors give wrong light, but do no other harm. */
static void test_normals_of_any_length(void **unused)
{
    (void)unused;
    scenes(2, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_anything_in_range),
        cmocka_unit_test(test_normals_of_any_length),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
