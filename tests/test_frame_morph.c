/*
 * test_frame_morph.c - a morph between two frames of a mesh must look like the mesh between them, which is computed
 * here.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 152
#define HEIGHT 120
#define MOST 400 /* the most vertices and polygons of any mesh of the stage */

/* A second frame of the stage's mesh, and the mesh between the two. */
static struct {
    struct sheen_mesh second, between;
    int16_t positions[2][3 * MOST], normals[2][3 * MOST], polygon_normals[2][3 * MOST], uvs[2 * MOST];
} made;

static unsigned picture[2][HEIGHT][WIDTH];

static const struct sheen_texture *const sphere = &sheen_matcap_clay;

enum shown {
    FLAT,
    GOURAUD,
    PHONG,
    SLERP,
    TEXTURED,
    TEXTURED_FLAT,
    MATCAP,
    MATCAP_VERTEX,
    SHOWN
};

static const struct sheen_shader *shader_of(enum shown shown)
{
    const struct sheen_shader *const shader[SHOWN] = {&sheen_flat,   &sheen_gouraud,      &sheen_phong,
                                                      &sheen_slerp,  &sheen_textured,     &sheen_textured_flat,
                                                      &sheen_matcap, &sheen_matcap_vertex};

    return shader[shown];
}

/* The vector turned by 50 degrees about z; positions are flattened too, so normals need not fit them. */
static void bend(const int16_t *from, int16_t *to, int is_position)
{
    const double c = 0.643, s = 0.766, flat = is_position ? 0.6 : 1;

    to[0] = (int16_t)lround(c * from[0] - s * from[1]);
    to[1] = (int16_t)lround(s * from[0] + c * from[1]);
    to[2] = (int16_t)lround(flat * from[2]);
}

static void mix(const int16_t *a, const int16_t *b, unsigned weight, int is_position, int16_t *to)
{
    double v[3], length = 0;

    for (int k = 0; k < 3; k++) {
        v[k] = ((32768.0 - weight) * a[k] + (double)weight * b[k]) / 32768;
        length += v[k] * v[k];
    }
    length = sqrt(length);
    for (int k = 0; k < 3; k++)
        to[k] = (int16_t)floor((is_position ? v[k] : v[k] / length * 32767) + 0.5);
}

static void make_frames(struct sheen_mesh *first, unsigned weight)
{
    const struct sheen_mesh *from = first;
    uint32_t polygons = from->polygons[from->triangles - 1] + 1u;

    assert_true(from->vertices <= MOST && polygons <= MOST);
    for (uint32_t i = 0; i < from->vertices; i++) {
        bend(from->positions + 3 * i, made.positions[0] + 3 * i, 1);
        bend(from->normals + 3 * i, made.normals[0] + 3 * i, 0);
        mix(from->positions + 3 * i, made.positions[0] + 3 * i, weight, 1, made.positions[1] + 3 * i);
        mix(from->normals + 3 * i, made.normals[0] + 3 * i, weight, 0, made.normals[1] + 3 * i);
        made.uvs[2 * i] = from->positions[3 * i];
        made.uvs[2 * i + 1] = from->positions[3 * i + 2];
    }
    for (uint32_t i = 0; i < polygons; i++) {
        bend(from->polygon_normals + 3 * i, made.polygon_normals[0] + 3 * i, 0);
        mix(from->polygon_normals + 3 * i, made.polygon_normals[0] + 3 * i, weight, 0, made.polygon_normals[1] + 3 * i);
    }
    first->warp = NULL; /* it would hold for one frame only */
    first->uvs = made.uvs;
    first->uv_bits = 15;
    made.second = made.between = *first;
    made.second.positions = made.positions[0];
    made.second.normals = made.normals[0];
    made.second.polygon_normals = made.polygon_normals[0];
    made.second.indices = NULL; /* a morph reads none of these three */
    made.second.polygons = NULL;
    made.second.uvs = NULL;
    made.between.positions = made.positions[1];
    made.between.normals = made.normals[1];
    made.between.polygon_normals = made.polygon_normals[1];
}

struct case_of {
    enum stage_mesh mesh;
    enum shown shown;
    unsigned weight, rows, workers;
    double z_near;
    int two_sided, ortho, affine, dither, transparency, facets; /* facets: without polygon normals */
};

/* Draws a morph from `mesh`, or `mesh` itself if morph is NULL. */
static void draw(const struct case_of *c, const struct sheen_mesh *mesh, const struct sheen_morph *morph,
                 unsigned to[HEIGHT][WIDTH])
{
    const struct actor actor = {c->mesh, 1, SHEEN_FLAT, 0.1, -0.05, 2.4, 1.2, 35, 40};
    struct sheen_material material = stage.material[1];
    struct memory_target target;
    struct sheen_config config;
    struct sheen_object object;
    struct sheen_view view;
    struct core_frame f;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 2);
    config.band_rows = (uint16_t)c->rows;
    config.workers = (uint8_t)c->workers;
    config.max_clipped = 600;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    view.z_near = SHEEN_Q24(c->z_near);
    view.orthographic = c->ortho ? SHEEN_Q24(2.4) : 0;
    view.affine = (uint8_t)c->affine;
    view.dither = (uint8_t)c->dither;
    stage_draw(&stage, &actor, &object);
    material.texture = sphere;
    object.mesh = mesh;
    object.morph = morph;
    object.material = &material;
    object.shader = shader_of(c->shown);
    object.two_sided = (uint8_t)c->two_sided;
    object.stipple = &sheen_stipple;
    object.transparency = (uint8_t)c->transparency;
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
    for (unsigned band = 0; band < sheen_band_count(f.frame); band++)
        assert_int_equal(sheen_band(f.frame, band % c->workers, band), SHEEN_OK);
    assert_int_equal(sheen_finish(f.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(f.frame), SHEEN_OK);
    assert_int_equal(target.breaches, 0);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            to[y][x] = memory_target_pixel(&target, x, y);
    core_frame_free(&f);
    memory_target_free(&target);
}

/* How far apart two 565 values are, in steps of a channel. */
static int apart(unsigned a, unsigned b)
{
    const int r = abs((int)(a >> 11) - (int)(b >> 11)), g = abs((int)(a >> 5 & 63) - (int)(b >> 5 & 63)),
              blue = abs((int)(a & 31) - (int)(b & 31));

    return r > g ? (r > blue ? r : blue) : (g > blue ? g : blue);
}

/* Positions are the same bits. A normal may be off by a step of 2^-15, which shows in few pixels, by one step each. */
static void check(const struct case_of *c)
{
    struct sheen_mesh first = stage.mesh[c->mesh].mesh;
    const struct sheen_morph morph = {&made.second, &sheen_morpher, (uint16_t)c->weight};
    long covered = 0, differ = 0;

    make_frames(&first, c->weight);
    if (c->facets)
        first.polygon_normals = made.second.polygon_normals = made.between.polygon_normals = NULL;
    draw(c, &first, &morph, picture[0]);
    draw(c, &made.between, NULL, picture[1]);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const unsigned got = picture[0][y][x], expected = picture[1][y][x];
            covered += expected != picture[1][0][0];
            differ += got != expected;
            if (apart(got, expected) > 1)
                fail_msg("shading %d, weight %u, mesh %d, pixel (%d, %d): %04x in place of %04x", c->shown, c->weight,
                         c->mesh, x, y, got, expected);
        }
    if (covered < WIDTH * HEIGHT / 50 || differ * 200 > covered)
        fail_msg("shading %d, weight %u, mesh %d: %ld of %ld pixels differ", c->shown, c->weight, c->mesh, differ,
                 covered);
}

static void test_between(void **unused)
{
    static const unsigned weights[] = {1, 9000, 16384, 21845, 32767, 32768};
    const unsigned cases = SHOWN * 6;

    (void)unused;
    for (unsigned i = 0; i < cases; i++) {
        const struct case_of c = {.mesh = (enum stage_mesh)(i / 2 % STAGE_MESHES),
                                  .shown = (enum shown)(i % SHOWN),
                                  .weight = weights[i / SHOWN],
                                  .rows = i % 3 == 0 ? 120 : 16,
                                  .workers = 1 + i % 2,
                                  .z_near = i % 4 < 2 ? 1 : 1.4,
                                  .two_sided = i / 3 % 2,
                                  .ortho = i % 5 == 3,
                                  .affine = i % 5 == 4,
                                  .transparency = i % 7 == 3 ? 20 : 0};
        check(&c);
    }
}

/* Bands and workers must not change a bit. */
static void test_bands(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < SHOWN; i++) {
        struct case_of c = {STAGE_TORUS, (enum shown)i, 12345, 120, 1, 1.9, 1, 0, 0, 1, 0, 0};
        struct sheen_mesh first = stage.mesh[c.mesh].mesh;
        const struct sheen_morph morph = {&made.second, &sheen_morpher, (uint16_t)c.weight};
        make_frames(&first, c.weight);
        draw(&c, &first, &morph, picture[0]);
        c.rows = 7;
        c.workers = 3;
        draw(&c, &first, &morph, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
    }
}

/* At weight 0 the picture is the mesh's own. */
static void test_none(void **unused)
{
    (void)unused;
    for (unsigned i = 0; i < SHOWN; i++) {
        const struct case_of c = {STAGE_TORUS, (enum shown)i, 0, 16, 1, 1.9, 1, 0, 0, 0, 0, 0};
        struct sheen_mesh first = stage.mesh[c.mesh].mesh;
        const struct sheen_morph morph = {&made.second, &sheen_morpher, 0};
        make_frames(&first, 0);
        draw(&c, &first, &morph, picture[0]);
        draw(&c, &first, NULL, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
    }
}

/* Halfway between opposite normals the mix is zero; the first frame's normals are then used. */
static void test_opposite(void **unused)
{
    const struct case_of c = {STAGE_CUBE, GOURAUD, 16384, 16, 1, 1, 0, 0, 0, 0, 0, 0};
    struct sheen_mesh first = stage.mesh[c.mesh].mesh;
    const struct sheen_morph morph = {&made.second, &sheen_morpher, 16384};

    (void)unused;
    make_frames(&first, 0);
    made.second = first;
    for (uint32_t i = 0; i < 3u * first.vertices; i++)
        made.normals[0][i] = (int16_t)-first.normals[i];
    made.second.normals = made.normals[0];
    for (unsigned i = GOURAUD; i <= SLERP; i++) {
        struct case_of one = c;
        one.shown = (enum shown)i;
        draw(&one, &first, &morph, picture[0]);
        draw(&one, &first, NULL, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
    }
}

/*
 * Opposite normals within a triangle: the mix must not make them longer than a mesh's. If they were more than 2.0
 * apart, the square of their distance would wrap and they would count as alike.
 */
static void test_opposite_corners(void **unused)
{
    static const int16_t exact[3] = {16517, 18870, 21090}; /* 32767 long */
    const struct case_of c = {STAGE_TORUS, PHONG, 16384, 16, 1, 1, 0, 0, 0, 0, 0, 0};
    struct sheen_mesh first = stage.mesh[c.mesh].mesh;
    const struct sheen_morph morph = {&made.second, &sheen_morpher, 16384};

    (void)unused;
    make_frames(&first, 0);
    for (uint32_t i = 0; i < 3u * first.vertices; i++)
        made.normals[0][i] = (int16_t)(i / 3 % 2 != 0 ? -exact[i % 3] : exact[i % 3]);
    first.normals = made.normals[0];
    made.second = first;
    for (unsigned i = PHONG; i <= SLERP; i++) {
        struct case_of one = c;
        one.shown = (enum shown)i;
        draw(&one, &first, &morph, picture[0]);
        draw(&one, &first, NULL, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
    }
}

/* Without polygon normals, the normals of each triangle of the morphed mesh are used; here it is the second frame. */
static void test_facets(void **unused)
{
    const struct case_of c = {STAGE_TORUS, FLAT, 32768, 16, 1, 1, 0, 0, 0, 0, 0, 1};

    (void)unused;
    check(&c);
}

static void test_refused(void **unused)
{
    struct sheen_mesh first = stage.mesh[STAGE_CUBE].mesh;
    struct sheen_morph morph = {&made.second, &sheen_morpher, 32768};
    const struct actor actor = {STAGE_CUBE, 1, SHEEN_GOURAUD, 0, 0, 3, 1, 0, 0};
    struct memory_target target;
    struct sheen_config config;
    struct sheen_object object;
    struct sheen_view view;
    struct core_frame f;

    (void)unused;
    make_frames(&first, 0);
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 2);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    stage_draw(&stage, &actor, &object);
    object.mesh = &first;
    object.morph = &morph;
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    for (int i = 0; i < 11; i++) {
        struct sheen_mesh second = made.second;
        morph = (struct sheen_morph){&second, &sheen_morpher, 32768};
        second.vertices = (uint16_t)(second.vertices - (i == 0));
        second.triangles = (uint16_t)(second.triangles + (i == 1));
        second.scale += i == 2;
        for (int k = 0; k < 3; k++)
            second.offset[k] -= i == 3 + k;
        second.positions = i == 6 ? NULL : second.positions;
        second.normals = i == 7 ? NULL : second.normals;
        second.polygon_normals = i == 8 ? NULL : second.polygon_normals;
        morph.mesh = i == 9 ? NULL : &second;
        morph.morpher = i == 10 ? NULL : &sheen_morpher;
        assert_int_equal(sheen_draw(f.frame, &object), SHEEN_ERR_ARGUMENT);
        assert_int_equal(sheen_frame_about(f.frame, NULL), SHEEN_ABOUT_MORPH);
    }
    morph = (struct sheen_morph){&made.second, &sheen_morpher, 32769};
    assert_int_equal(sheen_draw(f.frame, &object), SHEEN_ERR_ARGUMENT);
    assert_string_equal(sheen_subject_name(sheen_frame_about(f.frame, NULL)), "morph");
    morph.weight = 32768;
    assert_int_equal(sheen_draw(f.frame, &object), SHEEN_OK);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    core_frame_free(&f);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_between),
                                       cmocka_unit_test(test_bands),
                                       cmocka_unit_test(test_none),
                                       cmocka_unit_test(test_opposite),
                                       cmocka_unit_test(test_opposite_corners),
                                       cmocka_unit_test(test_facets),
                                       cmocka_unit_test(test_refused)};

    return cmocka_run_group_tests(tests, make_stage, free_stage);
}
