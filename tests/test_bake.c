/*
 * test_bake.c - baked headers hold, bit for bit, what a rendered file is drawn from; and the frames are the same.
 *
 * The headers were made by `sheen bake` while this was built (cli.cmake).
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../host-sim/command/shadings.h"
#include "baked_box.h"
#include "baked_crate.h"
#include "baked_crate_565.h"
#include "baked_egg.h"
#include "baked_egg_crease.h"
#include "baked_ramp.h"
#include "baked_ramp_near.h"
#include "baked_shine_1.h"
#include "baked_shine_127.h"
#include "baked_shine_24.h"
#include "baked_shine_7.h"
#include "baked_teapot.h"
#include "quantise.h"
#include "texels.h"

static void load(struct sheen_host_mesh *host, const char *name, const struct sheen_host_options *options)
{
    struct sheen_problem problem;

    if (sheen_host_mesh_load(host, name, options, &problem) != 0)
        fail_msg("%s", problem.text);
}

static void equal(const struct sheen_mesh *baked, const struct sheen_host_mesh *host, uint32_t part, int flat)
{
    struct sheen_quantised made;

    assert_int_equal(sheen_quantise(&made, host, part), 0);
    const struct sheen_mesh *mesh = &made.mesh;
    assert_int_equal(baked->vertices, mesh->vertices);
    assert_int_equal(baked->triangles, mesh->triangles);
    assert_int_equal(baked->index_bytes, mesh->index_bytes);
    assert_int_equal(baked->scale, mesh->scale);
    assert_memory_equal(baked->offset, mesh->offset, sizeof mesh->offset);
    assert_memory_equal(baked->positions, mesh->positions, 6u * mesh->vertices);
    assert_memory_equal(baked->normals, mesh->normals, 6u * mesh->vertices);
    assert_memory_equal(baked->indices, mesh->indices, 3u * mesh->triangles * mesh->index_bytes);
    assert_int_equal(baked->polygon_normals != NULL, flat);
    assert_int_equal(baked->polygons != NULL, flat && mesh->polygons != NULL);
    if (flat)
        assert_memory_equal(baked->polygon_normals, mesh->polygon_normals, 6u * made.polygon_count);
    assert_int_equal(baked->uvs != NULL, mesh->uvs != NULL);
    if (mesh->uvs) {
        assert_memory_equal(baked->uvs, mesh->uvs, 4u * mesh->vertices);
        assert_int_equal(baked->uv_bits, mesh->uv_bits);
        assert_memory_equal(baked->uv_offset, mesh->uv_offset, sizeof mesh->uv_offset);
    }
    if (baked->polygons)
        assert_memory_equal(baked->polygons, mesh->polygons, 2u * mesh->triangles);
    sheen_quantised_free(&made);
}

static void headers_are_the_files(void **state)
{
    struct sheen_host_mesh host;

    (void)state;
    load(&host, "builtin:teapot", &(struct sheen_host_options){.use_crease = 1, .crease = 60});
    equal(&baked_teapot, &host, SHEEN_ALL_PARTS, 1);
    sheen_host_mesh_free(&host);
    load(&host, "data/egg.obj", &(struct sheen_host_options){.use_crease = 1, .crease = 60});
    equal(&baked_egg, &host, SHEEN_ALL_PARTS, 1);
    sheen_host_mesh_free(&host);
    load(&host, "data/egg.obj",
         &(struct sheen_host_options){.average = 1, .use_crease = 1, .crease = 12.5, .equal = 1});
    equal(&smooth, &host, SHEEN_ALL_PARTS, 0);
    sheen_host_mesh_free(&host);
}

static void same_texture(const struct sheen_texture *baked, const struct sheen_picture *picture, unsigned colors,
                         int bilinear)
{
    struct sheen_texels made;

    assert_int_equal(sheen_texels_make(&made, picture, colors, bilinear), 0);
    const struct sheen_texture *texture = &made.texture;
    size_t texels = (size_t)1 << (texture->width_log2 + texture->height_log2);
    assert_int_equal(baked->bits, texture->bits);
    assert_int_equal(baked->width_log2, texture->width_log2);
    assert_int_equal(baked->height_log2, texture->height_log2);
    assert_int_equal(baked->clamp_u, texture->clamp_u);
    assert_int_equal(baked->bilinear, texture->bilinear);
    assert_int_equal(baked->keyed, texture->keyed);
    assert_memory_equal(baked->texels, texture->texels, texels * texture->bits / 8);
    assert_int_equal(baked->palette != NULL, colors != 0);
    if (colors)
        assert_memory_equal(baked->palette, texture->palette, 2 * made.colors);
    sheen_texels_free(&made);
}

static void textures(void **state)
{
    const struct sheen_texture_options whole = {.most = 256, .cutoff = -1}, small = {.most = 32, .cutoff = -1};
    struct sheen_host_options how = {.use_crease = 1, .crease = 60, .textures = &whole};
    struct sheen_host_mesh host;

    (void)state;
    load(&host, "data/crate.obj", &how);
    equal(&baked_crate, &host, 0, 1);
    same_texture(&baked_crate_texture, &host.picture[0], 16, 1);
    assert_int_equal(baked_crate_texture.bits, 4);
    sheen_host_mesh_free(&host);
    how.textures = &small;
    load(&host, "data/crate.obj", &how);
    equal(&crate_565, &host, 0, 1);
    same_texture(&crate_565_texture, &host.picture[0], 0, 0);
    assert_int_equal(crate_565_texture.width_log2, 5);
    sheen_host_mesh_free(&host);
}

/* Three materials, one of which has no faces: two meshes of 8-bit indices, with names and colours. */
static void groups(void **state)
{
    static const uint8_t red[3] = {255, 0, 0}, grey[3] = {51, 102, 153};
    struct sheen_host_mesh host;

    (void)state;
    assert_int_equal(sizeof baked_box_groups / sizeof baked_box_groups[0], 2);
    assert_string_equal(baked_box_groups[0].material, "red");
    assert_string_equal(baked_box_groups[1].material, "blue \"grey\"");
    assert_memory_equal(baked_box_groups[0].base, red, 3);
    assert_memory_equal(baked_box_groups[1].base, grey, 3);
    load(&host, "data/box.obj", &(struct sheen_host_options){.by_group = 1, .use_crease = 1, .crease = 60});
    uint32_t found = 0;
    for (uint32_t g = 0; g < host.part_count; g++) {
        if (found < 2 && strcmp(host.group[host.part[g].group].name, found ? "blue \"grey\"" : "red") == 0)
            equal(baked_box_groups[found++].mesh, &host, g, 1);
    }
    assert_int_equal(found, 2);
    assert_int_equal(baked_box_0.index_bytes, 1);
    sheen_host_mesh_free(&host);
}

/* ---- the same frame ---- */

enum {
    SIZE = 96
};

static int store(void *ctx, struct sheen_rect rect, const void *pixels)
{
    const size_t row = 2u * (size_t)(rect.x1 - rect.x0);

    for (int y = rect.y0; y < rect.y1; y++)
        memcpy((uint16_t *)ctx + y * SIZE + rect.x0, (const char *)pixels + row * (size_t)(y - rect.y0), row);
    return 0;
}

static void draw(const struct sheen_mesh *mesh, enum sheen_shading shading, uint16_t *picture)
{
    struct sheen_target target = {.ctx = picture, .push = store, .width = SIZE, .height = SIZE};
    struct sheen_config config = {.target = &target, .max_vertices = mesh->vertices, .max_triangles = mesh->triangles};
    struct sheen_material material = {.base = {200, 160, 80},
                                      .highlight = {255, 255, 255},
                                      .ambient = SHEEN_Q16(.1),
                                      .diffuse = SHEEN_Q16(.6),
                                      .specular = SHEEN_Q16(.3),
                                      .shine = &sheen_shine_32};
    struct sheen_light light = {.to = {-SHEEN_Q30(.5), SHEEN_Q30(.7), SHEEN_Q30(.5)}, .intensity = SHEEN_Q16(1)};
    struct sheen_view view = {.fov = SHEEN_DEGREES(40), .z_near = SHEEN_Q24(1.95), .z_far = SHEEN_Q24(4.05)};
    struct sheen_object scene = {
        .mesh = mesh, .material = &material, .lights = &light, .light_count = 1, .shader = sheen_shader_of(shading)};
    struct sheen_frame *frame;
    size_t size = sheen_arena_size(&config);
    void *arena = malloc(size);

    assert_int_equal(sheen_init(&frame, arena, &size, &config), 0);
    sheen_pose_orbit(&scene.pose, SHEEN_DEGREES(30), SHEEN_DEGREES(20), 0, SHEEN_Q24(3));
    assert_int_equal(sheen_begin(frame, &view), 0);
    assert_int_equal(sheen_draw(frame, &scene), 0);
    assert_int_equal(sheen_end(frame), 0);
    free(arena);
}

static void the_same_pixels(void **state)
{
    static uint16_t baked[SIZE * SIZE], from_file[SIZE * SIZE];
    struct sheen_host_mesh host;
    struct sheen_quantised made;

    (void)state;
    load(&host, "data/egg.obj", &(struct sheen_host_options){.use_crease = 1, .crease = 60});
    assert_int_equal(sheen_quantise(&made, &host, SHEEN_ALL_PARTS), 0);
    for (int shading = SHEEN_FLAT; shading <= SHEEN_PHONG; shading++) {
        memset(baked, 0x5a, sizeof baked);
        draw(&baked_egg, (enum sheen_shading)shading, baked);
        draw(&made.mesh, (enum sheen_shading)shading, from_file);
        assert_memory_equal(baked, from_file, sizeof baked);
    }
    sheen_quantised_free(&made);
    sheen_host_mesh_free(&host);
}

static void power_tables(void **state)
{
    static const struct sheen_shine *const baked[] = {&baked_shine_1, &baked_shine_7, &baked_shine_24,
                                                      &baked_shine_127};
    static const unsigned n[] = {1, 7, 24, 127};

    (void)state;
    for (int i = 0; i < 4; i++) {
        struct sheen_shine made;
        assert_int_equal(sheen_shine_make(&made, n[i]), SHEEN_OK);
        assert_memory_equal(made.power, baked[i]->power, sizeof made.power);
        assert_int_equal(made.shininess, baked[i]->shininess);
        assert_int_equal(made.shift, baked[i]->shift);
    }
}

/* gamma is the core's own table; of another exponent, as near as that to 2.2, it is the same to a step. */
static void ramps(void **state)
{
    struct sheen_ramp made;

    (void)state;
    assert_int_equal(sheen_ramp_make_gamma(&made, 6554, 45875), SHEEN_OK);
    assert_memory_equal(made.value, baked_ramp.value, sizeof made.value);
    assert_int_equal(made.low, baked_ramp.low);
    assert_int_equal(made.span, baked_ramp.span);
    assert_int_equal(made.steep, baked_ramp.steep);
    assert_ptr_equal(baked_ramp.reader, &sheen_ramp_reader);
    assert_int_equal(sheen_ramp_make_gamma(&made, 98304, 16384), SHEEN_OK);
    assert_true(made.low < 0);
    for (int i = 0; i <= SHEEN_RAMP_STEPS; i++)
        assert_in_range(made.value[i] + 1 - baked_ramp_near.value[i], 0, 2);
    assert_in_range(made.low + 2 - baked_ramp_near.low, 0, 4);
    assert_in_range(made.span + 2 - baked_ramp_near.span, 0, 4);
    assert_int_equal(made.steep, baked_ramp_near.steep);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(power_tables), cmocka_unit_test(ramps),    cmocka_unit_test(headers_are_the_files),
        cmocka_unit_test(groups),       cmocka_unit_test(textures), cmocka_unit_test(the_same_pixels),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
