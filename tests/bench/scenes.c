/*
 * scenes.c - sets up and draws the frames that are measured.
 */
#include "scenes.h"

#define MAX_EDGES 1000 /* those of the teapot, and one for each 64 triangles */

static const struct sheen_light lights[2] = {
    {.to = {SHEEN_Q30(0.3916), SHEEN_Q30(0.4895), SHEEN_Q30(0.7791)}, .intensity = 65536},
    {.to = {SHEEN_Q30(-0.9), SHEEN_Q30(0.1), SHEEN_Q30(0.3)}, .intensity = 32768}, /* from the side */
};

static int throw_away(void *ctx, struct sheen_rect rect, const void *pixels)
{
    (void)ctx;
    (void)rect;
    (void)pixels;
    return SHEEN_OK;
}

void bench_config(struct bench *bench, const struct bench_scene *scene, enum sheen_shading shading, int band_rows)
{
    bench->scene = scene;
    bench->shading = (uint8_t)shading;
    bench->dither = bench->transparency = bench->fogged = bench->morphed = 0;
    bench->edges = NULL;
    bench->texture = BENCH_PLAIN;
    bench->target = (struct sheen_target){
        .push = throw_away, .width = scene->width, .height = BENCH_HEIGHT, .pixel = SHEEN_RGB565_BE};
    bench->config = (struct sheen_config){.target = &bench->target,
                                          .quads = &sheen_quads,
                                          .band_rows = (uint16_t)band_rows,
                                          .buffers = 1,
                                          .max_vertices = scene->mesh.vertices,
                                          .max_used = scene->max_used,
                                          .max_triangles = scene->max_triangles,
                                          .max_draws = 1};
}

static const struct sheen_texture nearest = {
    .texels = bench_texels, .width_log2 = BENCH_TEXELS_LOG2, .height_log2 = BENCH_TEXELS_LOG2};
static const struct sheen_texture bilinear = {
    .texels = bench_texels, .width_log2 = BENCH_TEXELS_LOG2, .height_log2 = BENCH_TEXELS_LOG2, .bilinear = 1};

/* With the same settings as the core's matcaps. */
static const struct sheen_texture spheres[2] = {{.texels = bench_texels,
                                                 .width_log2 = BENCH_TEXELS_LOG2,
                                                 .height_log2 = BENCH_TEXELS_LOG2,
                                                 .clamp_u = 1,
                                                 .clamp_v = 1},
                                                {.texels = bench_texels,
                                                 .width_log2 = BENCH_TEXELS_LOG2,
                                                 .height_log2 = BENCH_TEXELS_LOG2,
                                                 .clamp_u = 1,
                                                 .clamp_v = 1,
                                                 .bilinear = 1}};

static void show_texture(struct sheen_material *material, enum bench_texture texture)
{
    const int is_lit = texture == BENCH_LIT || texture == BENCH_GLOSSY || texture == BENCH_TEXTURED_COLORED;

    material->texture = texture >= BENCH_MATCAP && !is_lit ? &spheres[texture == BENCH_MATCAP_BILINEAR]
                        : texture == BENCH_BILINEAR        ? &bilinear
                                                           : &nearest;
    material->base[0] = material->base[1] = material->base[2] = 255;
    if (texture != BENCH_GLOSSY)
        material->specular = 0;
    if (!is_lit) {
        material->ambient = SHEEN_Q16(1);
        material->diffuse = 0;
    }
}

int bench_begin(struct bench *bench, void *arena, size_t size)
{
    bench->material = (struct sheen_material){.base = {255, 153, 77}, /* 1, .6, .3 */
                                              .highlight = {255, 255, 255},
                                              .ambient = SHEEN_Q16(0.15),
                                              .diffuse = SHEEN_Q16(0.7),
                                              .specular = SHEEN_Q16(0.5),
                                              .shine = &sheen_shine_16};
    if (bench->edges != NULL) {
        bench->config.smooth = bench->edges == &sheen_edges_smooth;
        bench->config.max_edges = MAX_EDGES;
    }
    if (bench->texture == BENCH_HIGHLIGHTED) {
        bench->material.shine = &sheen_shine_4;
        bench->material.specular = SHEEN_Q16(0.1); /* up to .95, so that no pixel is clamped */
    } else if (bench->texture == BENCH_TRIANGLES) {
        bench->config.quads = NULL;
    } else if (bench->texture != BENCH_PLAIN && bench->texture != BENCH_COLORED && bench->texture != BENCH_LIGHTS)
        show_texture(&bench->material, (enum bench_texture)bench->texture);
    return sheen_init(&bench->frame, arena, &size, &bench->config);
}

static const struct sheen_shader *shader_of(const struct bench *bench)
{
    if (bench->texture == BENCH_PLAIN || bench->texture == BENCH_HIGHLIGHTED || bench->texture == BENCH_TRIANGLES)
        return sheen_shader_of(bench->shading);
    if (bench->texture == BENCH_COLORED || bench->texture == BENCH_LIGHTS)
        return sheen_colored_shader_of(bench->shading);
    if (bench->texture >= BENCH_TEXTURED_COLORED)
        return bench->texture == BENCH_MATCAP_COLORED ? &sheen_matcap_colored : &sheen_textured_colored;
    return bench->texture < BENCH_MATCAP           ? &sheen_textured
           : bench->texture == BENCH_MATCAP_VERTEX ? &sheen_matcap_vertex
                                                   : &sheen_matcap;
}

/* Everything of a frame, from clearing to the target's call. */
static int run(struct bench *bench, int frame)
{
    const struct sheen_fog fog = {bench->scene->near, bench->scene->far, {160, 170, 180}, &sheen_fog_mixer};
    const struct sheen_morph morph = {&bench->scene->mesh, &sheen_morpher, 16384};
    const int two = bench->texture == BENCH_LIGHTS;
    struct sheen_mesh mesh = bench->scene->mesh;
    struct sheen_view view = {
        .fov = SHEEN_DEGREES(60), .z_near = bench->scene->near, .z_far = bench->scene->far, .dither = bench->dither};
    struct sheen_object draw = {.mesh = &mesh,
                                .material = &bench->material,
                                .lights = lights,
                                .light_count = two ? 2 : 1,
                                .shader = shader_of(bench),
                                .pose = bench->scene->pose[frame],
                                .edges = bench->edges,
                                .stipple = &sheen_stipple,
                                .transparency = bench->transparency,
                                .morph = bench->morphed ? &morph : NULL};
    if (two)
        mesh.colors = NULL;
    view.fog = bench->fogged ? &fog : NULL;
    int status = sheen_begin(bench->frame, &view);

    if (status == SHEEN_OK)
        status = sheen_draw(bench->frame, &draw);
    return status == SHEEN_OK ? sheen_end(bench->frame) : status;
}

int bench_first(struct bench *bench)
{
    return run(bench, 0);
}

__attribute__((noinline)) int bench_measured(struct bench *bench)
{
    return run(bench, 1);
}
