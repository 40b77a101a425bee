/*
 * frame_mix.c - frames of random objects.
 */
#include "frame_mix.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    const struct sheen_shader *shader;
    bool textured, matcap, points;
} shaders[] = {
    {"flat", &sheen_flat, false, false, false},
    {"gouraud", &sheen_gouraud, false, false, false},
    {"phong", &sheen_phong, false, false, false},
    {"slerp", &sheen_slerp, false, false, false},
    {"flat colored", &sheen_flat_colored, false, false, true},
    {"gouraud colored", &sheen_gouraud_colored, false, false, true},
    {"phong colored", &sheen_phong_colored, false, false, false},
    {"slerp colored", &sheen_slerp_colored, false, false, false},
    {"textured", &sheen_textured, true, false, false},
    {"textured flat", &sheen_textured_flat, true, false, false},
    {"textured colored", &sheen_textured_colored, true, false, true},
    {"textured flat colored", &sheen_textured_flat_colored, true, false, true},
    {"matcap", &sheen_matcap, true, true, false},
    {"matcap vertex", &sheen_matcap_vertex, true, true, false},
    {"matcap colored", &sheen_matcap_colored, true, true, false},
    {"matcap vertex colored", &sheen_matcap_vertex_colored, true, true, false},
};

unsigned mix_shaders(void)
{
    return sizeof shaders / sizeof shaders[0];
}

const char *mix_shader_name(unsigned shader)
{
    return shaders[shader].name;
}

/* ---- chance ---- */

static unsigned below(uint32_t *seed, unsigned n)
{
    return (stage_random(seed) >> 8) % n;
}

static bool one_in(uint32_t *seed, unsigned n)
{
    return below(seed, n) == 0;
}

static void random_color(uint32_t *seed, uint8_t color[3])
{
    for (int k = 0; k < 3; k++)
        color[k] = (uint8_t)below(seed, 256);
}

static sheen_angle_t random_angle(uint32_t *seed)
{
    return stage_random(seed);
}

/* ---- meshes ---- */

static void fill_mesh(struct mix_mesh *m, const struct sheen_mesh *from)
{
    static uint32_t scratch[SHEEN_EDGES_WORDS(MIX_VERTICES, MIX_TRIANGLES)];
    uint32_t polygons = 0;

    assert(from->vertices <= MIX_VERTICES && from->triangles <= MIX_TRIANGLES);
    m->mesh = *from;
    for (int i = 0; i < from->vertices; i++) {
        const int16_t *p = from->positions + 3 * i, *n = from->normals + 3 * i;
        m->uvs[2 * i] = p[0];
        m->uvs[2 * i + 1] = (int16_t)(p[1] / 2 + p[2] / 4);
        m->positions[3 * i] = (int16_t)-p[1];
        m->positions[3 * i + 1] = p[0];
        m->positions[3 * i + 2] = (int16_t)(p[2] / 2);
        m->normals[3 * i] = (int16_t)-n[1];
        m->normals[3 * i + 1] = n[0];
        m->normals[3 * i + 2] = n[2];
        for (int k = 0; k < 3; k++)
            m->colors[3 * i + k] = (uint8_t)((p[k] + 32768) >> 8);
    }
    for (int t = 0; t < from->triangles; t++) {
        const uint32_t polygon = from->polygons != NULL ? from->polygons[t] : (uint32_t)t;
        polygons = polygon >= polygons ? polygon + 1 : polygons;
    }
    m->mesh.uvs = m->uvs;
    m->mesh.uv_bits = 14;
    m->mesh.colors = m->colors;
    sheen_mesh_warp(&m->mesh, polygons, m->warp);
    m->mesh.warp = m->warp;
    sheen_mesh_edges(&m->mesh, SHEEN_Q30(0.8), scratch, m->edges);
    m->mesh.edges = m->edges;
    m->second = m->mesh;
    m->second.positions = m->positions;
    m->second.normals = m->normals;
}

void mix_meshes(struct mix_mesh meshes[STAGE_MESHES], const struct stage *stage)
{
    for (int i = 0; i < STAGE_MESHES; i++)
        fill_mesh(&meshes[i], &stage->mesh[i].mesh);
}

/* ---- looks ---- */

static void random_texture(uint32_t *seed, struct sheen_texture *t, bool matcap)
{
    static uint16_t wide[64 * 64], palette[256];
    static uint8_t narrow[64 * 64];
    static const uint8_t bits[4] = {0, 16, 8, 4};

    for (unsigned i = 0; i < 64 * 64; i++) {
        narrow[i] = (uint8_t)(i * i / 3 + (i >> 6) * 5);
        wide[i] = (uint16_t)((i & 63) * 0x0841 ^ (i >> 6) * 0x1083);
    }
    for (unsigned i = 0; i < 256; i++)
        palette[i] = (uint16_t)(i * 0x9e37);
    *t = (struct sheen_texture){.palette = palette,
                                .bits = bits[below(seed, 4)],
                                .width_log2 = (uint8_t)below(seed, 7),
                                .height_log2 = (uint8_t)below(seed, 7),
                                .clamp_u = one_in(seed, 3),
                                .clamp_v = one_in(seed, 3),
                                .bilinear = one_in(seed, 2),
                                .keyed = one_in(seed, 3),
                                .key = one_in(seed, 2) ? palette[below(seed, 16)] : wide[below(seed, 64 * 64)]};
    t->texels = (t->bits & 15) != 0 ? (const void *)narrow : wide;
    if (matcap && t->bilinear)
        t->clamp_u = t->clamp_v = 1;
}

static void random_material(uint32_t *seed, struct mix_look *look, bool textured)
{
    static const struct sheen_shine *const shines[] = {&sheen_shine_4,  &sheen_shine_8,  &sheen_shine_16,
                                                       &sheen_shine_32, &sheen_shine_64, &sheen_shine_128};
    struct sheen_material *m = &look->material;
    const bool unlit = textured && one_in(seed, 4);

    *m = (struct sheen_material){.ambient = unlit ? SHEEN_Q16(1) : (sheen_q16_t)below(seed, 30000),
                                 .diffuse = unlit ? 0 : 64 + (sheen_q16_t)below(seed, 90000),
                                 .specular = unlit || one_in(seed, 3) ? 0 : (sheen_q16_t)below(seed, 90000),
                                 .shine = shines[below(seed, 6)],
                                 .texture = textured ? &look->texture : NULL};
    random_color(seed, m->base);
    random_color(seed, m->highlight);
    random_color(seed, m->ambient_color);
    random_color(seed, m->line);
    if (!unlit && one_in(seed, 12)) /* the largest values allowed */
        m->ambient = m->diffuse = m->specular = SHEEN_Q16(4);
    if (one_in(seed, 2))
        memset(m->base, 255, sizeof m->base);
    if (one_in(seed, 2))
        memset(m->highlight, 0, sizeof m->highlight);
    const unsigned ramp = below(seed, 6);
    m->ramp = ramp == 0 ? &sheen_ramp_half : ramp == 1 ? &sheen_ramp_toon : NULL;
    if (ramp == 2 && sheen_ramp_make_gamma(&look->gamma, m->ambient, m->diffuse) == SHEEN_OK)
        m->ramp = &look->gamma;
}

static unsigned random_lights(uint32_t *seed, struct sheen_light lights[SHEEN_MAX_LIGHTS], bool points)
{
    const unsigned count = one_in(seed, 8) ? 0 : 1 + below(seed, SHEEN_MAX_LIGHTS);

    for (unsigned i = 0; i < count; i++) {
        struct sheen_light *l = &lights[i];
        *l = (struct sheen_light){.intensity = one_in(seed, 3) ? 0 : 1 + (sheen_q16_t)below(seed, 65536),
                                  .no_highlight = one_in(seed, 4),
                                  .with_eye = one_in(seed, 4)};
        for (int k = 0; k < 3; k++) {
            l->to[k] = (sheen_q30_t)stage_random(seed) / 4;
            l->at[k] = SHEEN_Q24(stage_uniform(seed, -2, 2));
        }
        l->to[2] |= 1; /* so that the direction is not zero */
        l->at[2] -= SHEEN_Q24(3);
        if (one_in(seed, 2))
            random_color(seed, l->color);
        if (points && one_in(seed, 3)) {
            l->radius = SHEEN_Q16(stage_uniform(seed, 0.5, 6));
            l->points = &sheen_points;
        }
    }
    return count;
}

static void random_object(uint32_t *seed, struct mix *mix, unsigned i, const struct mix_mesh meshes[STAGE_MESHES])
{
    const struct mix_mesh *mesh = &meshes[below(seed, STAGE_MESHES)];
    const unsigned shader = below(seed, mix_shaders());
    struct mix_look *look = &mix->look[i];
    struct sheen_object *o = &mix->frame[0].object[i];

    mix->shader[i] = shader;
    if (shaders[shader].textured)
        random_texture(seed, &look->texture, shaders[shader].matcap);
    random_material(seed, look, shaders[shader].textured);
    *o = (struct sheen_object){.mesh = &mesh->mesh,
                               .material = &look->material,
                               .shader = shaders[shader].shader,
                               .lights = look->lights,
                               .two_sided = one_in(seed, 3)};
    o->light_count = (uint8_t)random_lights(seed, look->lights, shaders[shader].points);
    if (one_in(seed, 3)) {
        o->stipple = &sheen_stipple;
        o->transparency = (uint8_t)below(seed, 64);
        o->phase = (uint8_t)below(seed, 8);
    }
    if (one_in(seed, 3))
        o->depth_bias = (int16_t)(one_in(seed, 2) ? (int)below(seed, 8192) - 4096 : (int)below(seed, 60) - 30);
    if (one_in(seed, 4))
        o->edges = sheen_edges_of(1 + below(seed, SHEEN_EDGINGS - 1));
    if (one_in(seed, 4)) {
        look->morph = (struct sheen_morph){&mesh->second, &sheen_morpher, (uint16_t)below(seed, 32769)};
        o->morph = &look->morph;
    }
}

/* ---- frames ---- */

/* A rectangle with its edges on the target's alignment. */
static struct sheen_rect random_rect(uint32_t *seed, int align_x, int align_y)
{
    const int x = (int)below(seed, MIX_WIDTH / 2) / align_x * align_x;
    const int y = (int)below(seed, MIX_HEIGHT / 2) / align_y * align_y;
    const int width = (int)(16 + below(seed, MIX_WIDTH / 2 - 16)) / align_x * align_x;
    const int height = one_in(seed, 4) ? align_y : (int)(16 + below(seed, MIX_HEIGHT / 2 - 16)) / align_y * align_y;

    return (struct sheen_rect){(int16_t)x, (int16_t)y, (int16_t)(x + width), (int16_t)(y + height)};
}

static void random_view(uint32_t *seed, struct mix_frame *f, int align_x, int align_y)
{
    const double near = stage_uniform(seed, 0.5, 2.5), depth = stage_uniform(seed, 3, 10);
    const double start = near + stage_uniform(seed, -0.4, 0.5) * depth;
    struct sheen_view *v = &f->view;

    *v = (struct sheen_view){.fov = SHEEN_DEGREES(stage_uniform(seed, 20, 80)),
                             .z_near = SHEEN_Q24(near),
                             .z_far = SHEEN_Q24(near + depth),
                             .affine = one_in(seed, 4),
                             .dither = one_in(seed, 2)};
    random_color(seed, v->background);
    if (one_in(seed, 4))
        v->orthographic = SHEEN_Q24(stage_uniform(seed, 2, 6));
    if (one_in(seed, 6))
        v->viewport = random_rect(seed, align_x, align_y);
    if (one_in(seed, 3)) {
        sheen_pose_orbit(&v->pose, random_angle(seed) / 16, random_angle(seed) / 16, random_angle(seed), 0);
        v->pose.translation[0] = SHEEN_Q24(stage_uniform(seed, -0.5, 0.5));
    }
    if (!one_in(seed, 3))
        return;
    f->fog = (struct sheen_fog){.start = one_in(seed, 8) ? 1 + (sheen_q24_t)below(seed, 5000)
                                         : start > 0.1   ? SHEEN_Q24(start)
                                                         : SHEEN_Q24(0.1),
                                .mixer = &sheen_fog_mixer};
    f->fog.end = f->fog.start + SHEEN_Q24(stage_uniform(seed, 0.2, 1.5) * depth);
    random_color(seed, f->fog.color);
    v->fog = &f->fog;
}

/* Places an object in the view, now and then across one of its sides or the near or far plane. */
static void place(uint32_t *seed, struct sheen_object *o, const struct sheen_view *view)
{
    const double near = view->z_near / 16777216.0, far = view->z_far / 16777216.0;
    const double m = one_in(seed, 3) ? stage_uniform(seed, near * 0.7, far) : stage_uniform(seed, near + 0.5, far);
    const double reach = view->orthographic != 0 ? 1 : m / 4;

    sheen_pose_orbit(&o->pose, random_angle(seed), random_angle(seed), random_angle(seed), SHEEN_Q24(m));
    o->pose.scale = SHEEN_Q16(stage_uniform(seed, 0.15, 1.4));
    for (int k = 0; k < 2; k++)
        o->pose.translation[k] = SHEEN_Q24(stage_uniform(seed, -reach, reach));
}

void mix_next(uint32_t *seed, const struct mix *mix, const struct mix_frame *from, struct mix_frame *to, int align_x,
              int align_y)
{
    *to = *from;
    if (to->view.fog != NULL)
        to->view.fog = &to->fog;
    to->count = 0;
    for (unsigned i = 0; i < mix->count; i++) {
        struct sheen_object o = mix->frame[0].object[i];
        if (one_in(seed, 3))
            o.pose.translation[below(seed, 3)] += SHEEN_Q24(stage_uniform(seed, -0.3, 0.3));
        else if (one_in(seed, 4))
            place(seed, &o, &to->view);
        if (!one_in(seed, 4))
            to->object[to->count++] = o;
    }
    if (one_in(seed, 6))
        random_color(seed, to->view.background);
    if (one_in(seed, 6))
        random_view(seed, to, align_x, align_y);
    to->invalidated = one_in(seed, 6);
    to->mark = one_in(seed, 3) ? random_rect(seed, 1, 1) : (struct sheen_rect){0, 0, 0, 0};
}

void mix_make(struct mix *mix, unsigned number, const struct mix_mesh meshes[STAGE_MESHES], int align_x, int align_y)
{
    uint32_t seed = (number + 1) * 2654435761u;

    memset(mix, 0, sizeof *mix);
    for (int i = 0; i < 8; i++)
        (void)stage_random(&seed);
    mix->count = mix->frame[0].count = 1 + below(&seed, MIX_OBJECTS);
    random_view(&seed, &mix->frame[0], align_x, align_y);
    for (unsigned i = 0; i < mix->count; i++) {
        random_object(&seed, mix, i, meshes);
        place(&seed, &mix->frame[0].object[i], &mix->frame[0].view);
    }
    for (unsigned f = 1; f < MIX_FRAMES; f++)
        mix_next(&seed, mix, &mix->frame[f - 1], &mix->frame[f], align_x, align_y);
}

void mix_print(const struct mix *mix)
{
    for (unsigned i = 0; i < mix->count; i++) {
        const struct sheen_object *o = &mix->frame[0].object[i];
        const struct sheen_texture *t = o->material->texture;
        printf("  %s, %d triangles, %d lights%s%s%s, transparency %d, bias %d, %s%s", shaders[mix->shader[i]].name,
               o->mesh->triangles, o->light_count, o->two_sided ? ", two-sided" : "", o->edges != NULL ? ", edges" : "",
               o->material->ramp != NULL ? ", a ramp" : "", o->transparency, o->depth_bias,
               o->morph != NULL ? "a morph" : "no morph", t == NULL ? "\n" : "");
        if (t != NULL)
            printf(", %d bits, %d x %d, %s%s%s\n", t->bits, 1 << t->width_log2, 1 << t->height_log2,
                   t->bilinear ? "bilinear" : "nearest", t->keyed ? ", keyed" : "",
                   t->clamp_u || t->clamp_v ? ", clamped" : "");
    }
    for (unsigned f = 0; f < MIX_FRAMES; f++) {
        const struct sheen_view *v = &mix->frame[f].view;
        printf("  frame %u: %u objects%s%s%s%s\n", f, mix->frame[f].count, v->orthographic ? ", ortho" : "",
               v->affine ? ", affine" : "", v->dither ? ", dithered" : "", v->fog != NULL ? ", fog" : "");
    }
}
