/*
 * core_picture.c - a scene of the reference, drawn by the core.
 */
#include "core_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TURN 360.0

/* A corner, sorted so that corners which become one vertex are neighbours. */
struct key {
    uint32_t weld, corner;
    int16_t normal[2][3], uv[2]; /* normal: per frame */
    uint8_t color[4];            /* three are used */
};

static int key_order(const void *a, const void *b)
{
    const struct key *p = a, *q = b;

    if (p->weld != q->weld)
        return p->weld < q->weld ? -1 : 1;
    int order = memcmp(p->normal, q->normal, sizeof p->normal);
    if (order == 0)
        order = memcmp(p->uv, q->uv, sizeof p->uv);
    return order != 0 ? order : memcmp(p->color, q->color, sizeof p->color);
}

static int16_t to_q15(double c)
{
    return (int16_t)lround(32767 * c);
}

/* Choose the uv grid: the finest power of two that fits 16 bits around an offset, the middle rounded to the grid. */
static void choose_grid(const struct ref_mesh *from, struct sheen_mesh *mesh)
{
    double low[2] = {0, 0}, high[2] = {0, 0}, span = 0;

    for (int i = 0; i < 2; i++) {
        low[i] = high[i] = from->uv[0][i];
        for (size_t c = 1; c < from->corner_count; c++) {
            low[i] = fmin(low[i], from->uv[c][i]);
            high[i] = fmax(high[i], from->uv[c][i]);
        }
        span = fmax(span, high[i] - low[i]);
    }
    for (mesh->uv_bits = 15; mesh->uv_bits > 0 && span * (1 << mesh->uv_bits) > 65000; mesh->uv_bits--)
        ;
    for (int i = 0; i < 2; i++)
        mesh->uv_offset[i] =
            (sheen_q16_t)(lround((low[i] + high[i]) / 2 * (1 << mesh->uv_bits)) * (1 << (16 - mesh->uv_bits)));
}

static int16_t to_grid(const struct sheen_mesh *mesh, const double uv[2], int i)
{
    return (int16_t)lround((uv[i] - mesh->uv_offset[i] / 65536.0) * (1 << mesh->uv_bits));
}

/* frame: `frames` frames of one mesh; weld, uv and colours are read from the first. */
static uint32_t number_vertices(const struct ref_mesh *const frame[], unsigned frames, const struct sheen_mesh *mesh,
                                struct key *keys, uint32_t *vertex_of)
{
    const struct ref_mesh *from = frame[0];
    uint32_t vertices = 0;

    for (size_t c = 0; c < from->corner_count; c++) {
        keys[c] = (struct key){.weld = from->weld[c], .corner = (uint32_t)c};
        for (unsigned k = 0; k < 3 * frames; k++)
            keys[c].normal[k / 3][k % 3] = to_q15(frame[k / 3]->normal[c][k % 3]);
        for (int i = 0; i < 2 && from->uv; i++)
            keys[c].uv[i] = to_grid(mesh, from->uv[c], i);
        for (int i = 0; i < 3 && from->color; i++)
            keys[c].color[i] = (uint8_t)lround(255 * from->color[c][i]);
    }
    qsort(keys, from->corner_count, sizeof *keys, key_order);
    for (size_t i = 0; i < from->corner_count; i++) {
        if (i > 0 && key_order(&keys[i - 1], &keys[i]) != 0)
            vertices++;
        vertex_of[keys[i].corner] = vertices;
    }
    return vertices + 1;
}

static void fill(struct core_mesh *to, const struct ref_mesh *from, const uint32_t *vertex_of, double reach)
{
    for (size_t c = 0; c < from->corner_count; c++) {
        for (int k = 0; k < 3; k++) {
            to->positions[3 * vertex_of[c] + (uint32_t)k] = to_q15(from->position[c][k] / reach);
            to->normals[3 * vertex_of[c] + (uint32_t)k] = to_q15(from->normal[c][k]);
        }
        for (int i = 0; i < 2 && from->uv; i++)
            to->uvs[2 * vertex_of[c] + (uint32_t)i] = to_grid(&to->mesh, from->uv[c], i);
        for (int i = 0; i < 3 && from->color; i++)
            to->colors[3 * vertex_of[c] + (uint32_t)i] = (uint8_t)lround(255 * from->color[c][i]);
    }
    for (size_t p = 0; p < from->polygon_count; p++) {
        for (int k = 0; k < 3; k++)
            to->polygon_normals[3 * p + (size_t)k] = to_q15(from->polygon_normal[p][k]);
    }
    for (size_t t = 0; t < from->triangle_count; t++) {
        to->polygons[t] = (uint16_t)from->triangles[t].polygon;
        for (int k = 0; k < 3; k++)
            to->indices[3 * t + (size_t)k] = (uint16_t)vertex_of[from->triangles[t].corner[k]];
    }
}

static double reach_of(const struct ref_mesh *from)
{
    double reach = 0;

    for (size_t c = 0; c < from->corner_count; c++) {
        for (int k = 0; k < 3; k++)
            reach = fmax(reach, fabs(from->position[c][k]));
    }
    return reach;
}

/* mesh: has the uv grid. */
static int make_frame(struct core_mesh *to, const struct ref_mesh *from, const struct sheen_mesh *mesh,
                      uint32_t vertices, const uint32_t *vertex_of, double reach)
{
    to->mesh = *mesh;
    to->positions = calloc(vertices, 3 * sizeof *to->positions);
    to->normals = calloc(vertices, 3 * sizeof *to->normals);
    to->uvs = calloc(vertices, 2 * sizeof *to->uvs);
    to->colors = calloc(vertices, 3);
    to->polygon_normals = calloc(from->polygon_count, 3 * sizeof *to->polygon_normals);
    to->polygons = calloc(from->triangle_count, sizeof *to->polygons);
    to->warp = calloc(from->polygon_count, 1);
    to->indices = calloc(from->triangle_count, 3 * sizeof *to->indices);
    if (vertices > 65535 || !to->positions || !to->normals || !to->polygon_normals || !to->polygons || !to->warp ||
        !to->indices || !to->uvs || !to->colors)
        return -1;
    fill(to, from, vertex_of, reach);
    to->mesh = (struct sheen_mesh){.positions = to->positions,
                                   .normals = to->normals,
                                   .polygon_normals = to->polygon_normals,
                                   .polygons = to->polygons,
                                   .indices = to->indices,
                                   .index_bytes = 2,
                                   .uvs = from->uv ? to->uvs : NULL,
                                   .colors = from->color ? to->colors : NULL,
                                   .uv_bits = to->mesh.uv_bits,
                                   .uv_offset = {to->mesh.uv_offset[0], to->mesh.uv_offset[1]},
                                   .vertices = (uint16_t)vertices,
                                   .triangles = (uint16_t)from->triangle_count,
                                   .scale = (sheen_q24_t)lround(reach * 32768 / 32767 * 16777216)};
    sheen_mesh_warp(&to->mesh, (uint32_t)from->polygon_count, to->warp);
    to->mesh.warp = to->warp;
    return 0;
}

static int make_frames(struct core_mesh *to, const struct ref_mesh *const frame[], unsigned frames)
{
    const struct ref_mesh *from = frame[0];
    struct key *keys = malloc(from->corner_count * sizeof *keys);
    uint32_t *vertex_of = malloc(from->corner_count * sizeof *vertex_of);
    struct sheen_mesh mesh = {.uv_bits = 0};
    double reach = 0;
    int status = keys && vertex_of && from->polygon_count <= 65535 && from->triangle_count <= 65535 ? 0 : -1;

    memset(to, 0, frames * sizeof *to);
    for (unsigned i = 0; i < frames; i++)
        reach = fmax(reach, reach_of(frame[i]));
    if (from->uv)
        choose_grid(from, &mesh);
    uint32_t vertices = status == 0 ? number_vertices(frame, frames, &mesh, keys, vertex_of) : 0;
    for (unsigned i = 0; i < frames && status == 0; i++)
        status = make_frame(&to[i], frame[i], &mesh, vertices, vertex_of, reach);
    for (unsigned i = 0; i < frames && status != 0; i++)
        core_mesh_free(&to[i]);
    free(keys);
    free(vertex_of);
    return status;
}

int core_mesh_make(struct core_mesh *to, const struct ref_mesh *from)
{
    return make_frames(to, &from, 1);
}

int core_frames_make(struct core_mesh to[2], const struct ref_mesh *first, const struct ref_mesh *second)
{
    const struct ref_mesh *const frame[2] = {first, second};

    return make_frames(to, frame, 2);
}

void core_mesh_free(struct core_mesh *mesh)
{
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->polygon_normals);
    free(mesh->uvs);
    free(mesh->colors);
    free(mesh->polygons);
    free(mesh->warp);
    free(mesh->indices);
    memset(mesh, 0, sizeof *mesh);
}

void core_view(struct sheen_view *view, const struct ref_scene *scene)
{
    *view = (struct sheen_view){.fov = (sheen_angle_t)llround(scene->fov / TURN * 4294967296.0),
                                .z_near = (sheen_q24_t)lround(scene->near * 16777216),
                                .z_far = (sheen_q24_t)lround(scene->far * 16777216),
                                .orthographic = scene->ortho ? (sheen_q24_t)lround(scene->distance * 16777216) : 0,
                                .affine = scene->affine,
                                .dither = scene->dither};
    for (int k = 0; k < 3; k++)
        view->background[k] = (uint8_t)lround(255 * scene->background[k]);
}

void core_fog(struct sheen_fog *fog, const struct ref_scene *scene)
{
    *fog = (struct sheen_fog){.start = (sheen_q24_t)lround(scene->fog_from * 16777216),
                              .end = (sheen_q24_t)lround(scene->fog_to * 16777216),
                              .mixer = &sheen_fog_mixer};
    for (int k = 0; k < 3; k++)
        fog->color[k] = (uint8_t)lround(255 * scene->fog_color[k]);
}

void core_pose(struct sheen_pose *pose, const struct ref_scene *scene)
{
    for (int k = 0; k < 9; k++)
        pose->rotation[k] = (sheen_q30_t)lround(scene->rotation[k] * 1073741824);
    pose->scale = (sheen_q16_t)lround(scene->scale * 65536);
    for (int k = 0; k < 3; k++)
        pose->translation[k] = (sheen_q24_t)lround(scene->translation[k] * 16777216);
}

/* Whether a light or the ambient light has a colour, or a light is a point. */
static bool is_tinted(const struct ref_scene *scene)
{
    bool tinted = false;

    for (int k = 0; k < 3; k++) {
        tinted |= scene->ambient_color[k] != 1;
        for (int i = 0; i < scene->light_count; i++)
            tinted |= scene->light_color[i][k] != 1 || scene->radius[i] > 0;
    }
    return tinted;
}

void core_lights(struct sheen_light lights[SHEEN_MAX_LIGHTS], const struct ref_scene *scene)
{
    for (int i = 0; i < scene->light_count; i++) {
        double reach = 0;
        for (int k = 0; k < 3; k++)
            reach = fmax(reach, fabs(scene->light[i][k]));
        lights[i] = (struct sheen_light){.intensity = 65536};
        for (int k = 0; k < 3 && is_tinted(scene); k++)
            lights[i].color[k] = (uint8_t)lround(255 * scene->light_color[i][k]);
        for (int k = 0; k < 3; k++)
            lights[i].to[k] = (sheen_q30_t)lround(scene->light[i][k] / reach * 1073741824);
        for (int k = 0; k < 3 && scene->radius[i] > 0; k++) {
            lights[i].to[k] = 0;
            lights[i].at[k] = (sheen_q24_t)lround((scene->light[i][k] + scene->translation[k]) * 16777216);
        }
        lights[i].points = &sheen_points;
        lights[i].radius = (sheen_q16_t)lround(scene->radius[i] * 65536);
    }
}

int core_material(struct sheen_material *material, struct core_tables *tables, const struct ref_scene *scene)
{
    const struct sheen_ramp *const ramp[] = {NULL, &sheen_ramp_half, &tables->gamma, &sheen_ramp_toon};

    *material = (struct sheen_material){.ambient = (sheen_q16_t)lround(scene->ambient * 65536),
                                        .diffuse = (sheen_q16_t)lround(scene->diffuse * 65536),
                                        .specular = (sheen_q16_t)lround(scene->specular * 65536),
                                        .shine = &tables->shine,
                                        .ramp = ramp[scene->ramp]};
    for (int k = 0; k < 3; k++) {
        material->base[k] = (uint8_t)lround(255 * scene->base[k]);
        material->highlight[k] = (uint8_t)lround(255 * scene->highlight[k]);
        material->ambient_color[k] = is_tinted(scene) ? (uint8_t)lround(255 * scene->ambient_color[k]) : 0;
    }
    int status = sheen_shine_make(&tables->shine, (unsigned)lround(scene->shininess));
    if (status == SHEEN_OK && scene->ramp == REF_GAMMA)
        status = sheen_ramp_make_gamma(&tables->gamma, material->ambient, material->diffuse);
    return status;
}

int core_frame_make(struct core_frame *f, const struct sheen_config *config)
{
    f->arena_bytes = sheen_arena_size(config);
    f->arena = f->arena_bytes ? malloc(f->arena_bytes) : NULL;
    if (!f->arena)
        return SHEEN_ERR_MEMORY;
    static uint32_t noise; /* the core must not rely on what the arena contains */
    for (size_t i = 0; i < f->arena_bytes; i++)
        ((uint8_t *)f->arena)[i] = (uint8_t)((noise = noise * 1664525u + 1013904223u) >> 24);
    int status = sheen_init(&f->frame, f->arena, &f->arena_bytes, config);
    if (status < 0)
        core_frame_free(f);
    return status;
}

void core_frame_free(struct core_frame *f)
{
    free(f->arena);
    memset(f, 0, sizeof *f);
}

int core_draw_scene(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                    int band_rows)
{
    struct core_stats unused;

    return core_draw_scene_way(target, scene, mesh, band_rows, 0, &unused);
}

/* A texture in the core's form. */
struct core_texture {
    struct sheen_texture texture;
    uint16_t palette[256];
    uint8_t *numbers;
};

/* The number of a colour in the palette; a new colour gets a new number. */
static unsigned number_of(struct core_texture *to, unsigned *count, uint16_t value)
{
    for (unsigned i = 0; i < *count; i++) {
        if (to->palette[i] == value)
            return i;
    }
    if (*count < 256)
        to->palette[*count] = value;
    return (*count)++;
}

/* 0, or -1 if memory is short or the palette has too few numbers. */
static int core_texture_make(struct core_texture *to, const struct ref_texture *from)
{
    unsigned count = 0, texels = (unsigned)(from->width * from->height);

    memset(to, 0, sizeof *to);
    to->texture = (struct sheen_texture){.texels = from->texels,
                                         .bits = (uint8_t)from->bits,
                                         .clamp_u = from->clamp[0],
                                         .clamp_v = from->clamp[1],
                                         .bilinear = from->bilinear,
                                         .keyed = from->keyed,
                                         .key = from->key};
    while (1 << to->texture.width_log2 < from->width)
        to->texture.width_log2++;
    while (1 << to->texture.height_log2 < from->height)
        to->texture.height_log2++;
    if (from->bits == 16)
        return 0;
    to->numbers = calloc(texels, 1);
    for (unsigned i = 0; i < texels && to->numbers; i++) {
        unsigned number = number_of(to, &count, from->texels[i]);
        if (from->bits == 8)
            to->numbers[i] = (uint8_t)number;
        else
            to->numbers[i / 2] |= (uint8_t)(number << (4 * (i & 1)));
    }
    to->texture.texels = to->numbers;
    to->texture.palette = to->palette;
    return to->numbers && count <= 1u << from->bits ? 0 : -1;
}

static const struct sheen_shader *shader_of(const struct ref_scene *scene)
{
    const bool colored = scene->colored || is_tinted(scene);
    const unsigned shading = scene->texels == REF_TEXELS_UV       ? (unsigned)scene->shading
                             : scene->texels == REF_TEXELS_NORMAL ? SHEEN_MATCAP
                                                                  : SHEEN_MATCAP_VERTEX;

    if (scene->texture && shading < SHEEN_MATCAP)
        return sheen_textured_shader_of(shading, colored);
    return colored ? sheen_colored_shader_of(shading) : sheen_shader_of(shading);
}

#define CLIPPED 2000 /* pieces, more than any test makes */

static int draw_scene(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                      const struct sheen_morph *morph, int band_rows, unsigned way, struct core_stats *stats)
{
    struct sheen_config config = {.target = target,
                                  .band_rows = (uint16_t)band_rows,
                                  .max_vertices = mesh->vertices,
                                  .max_triangles = (uint16_t)(mesh->triangles + CLIPPED),
                                  .max_clipped = CLIPPED,
                                  .clipper = &sheen_clipper,
                                  .quads = &sheen_quads};
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_material material;
    struct core_tables tables;
    struct sheen_view view;
    struct sheen_mesh own = *mesh;
    struct sheen_object draw = {.mesh = &own,
                                .material = &material,
                                .lights = lights,
                                .light_count = (uint8_t)scene->light_count,
                                .shader = shader_of(scene),
                                .two_sided = scene->two_sided,
                                .stipple = scene->left_out > 0 ? &sheen_stipple : NULL,
                                .transparency = (uint8_t)scene->left_out,
                                .phase = (uint8_t)scene->phase,
                                .depth_bias = (int16_t)scene->bias,
                                .morph = morph};
    struct core_texture texture = {.numbers = NULL};
    struct sheen_fog fog;
    struct core_frame f;
    int status = core_frame_make(&f, &config);

    if (status < 0)
        return status;
    if (!scene->colored && is_tinted(scene))
        own.colors = NULL;
    sheen_frame_force(f.frame, way);
    core_view(&view, scene);
    core_fog(&fog, scene);
    view.fog = scene->fog ? &fog : NULL;
    core_pose(&draw.pose, scene);
    core_lights(lights, scene);
    if ((status = core_material(&material, &tables, scene)) == SHEEN_OK && scene->texture) {
        status = core_texture_make(&texture, scene->texture) == 0 ? SHEEN_OK : SHEEN_ERR_MEMORY;
        material.texture = &texture.texture;
    }
    if (status == SHEEN_OK && (status = sheen_begin(f.frame, &view)) == SHEEN_OK &&
        (status = sheen_draw(f.frame, &draw)) == SHEEN_OK && (status = sheen_end(f.frame)) == SHEEN_OK)
        status = sheen_wait(f.frame);
    sheen_frame_stats(f.frame, &stats->frame);
    sheen_frame_ways(f.frame, stats->by_way);
    core_frame_free(&f);
    free(texture.numbers);
    return status;
}

int core_draw_scene_way(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                        int band_rows, unsigned way, struct core_stats *stats)
{
    return draw_scene(target, scene, mesh, NULL, band_rows, way, stats);
}

int core_draw_between(const struct sheen_target *target, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                      const struct sheen_morph *morph, int band_rows, struct core_stats *stats)
{
    return draw_scene(target, scene, mesh, morph, band_rows, 0, stats);
}
