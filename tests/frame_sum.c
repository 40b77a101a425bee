/*
 * frame_sum.c - prints one checksum per picture, which has to be the same with every compiler and on every machine.
 *
 * It uses integers only, no files and no libm, so that any difference between two machines comes from the core.
 * tests/golden/frame_sums.txt holds the expected output.
 */
#include <stdio.h>
#include <string.h>

#include "../host-sim/command/shadings.h"
#include "frame_sum_mesh.h"
#include "sheen.h"

/* If all scenes take too long, a build draws one of so many: a prime, to stay out of step with the loops below. */
#ifndef SUM_EVERY
#define SUM_EVERY 1
#endif

#define WIDTH 96
#define HEIGHT 80

static uint8_t picture[WIDTH * HEIGHT * 2];
static uint64_t arena[40 * 1024];

static const char *const mesh_name[] = {"ball", "torus", "box", "globe"};
static const char *const format_name[] = {"rgb565be", "rgb565le", "grey2", "grey16", "grey256"};

/* Shadings besides the lecture's. */
enum {
    TEXTURED = SHEEN_SHADINGS,
    MATCAP,  /* per pixel or per vertex, depending on mesh and view */
    COLORED, /* flat or Gouraud, likewise */
    TEXTURED_FLAT,
    SHADINGS, /* loops over all shadings end here; those that follow have loops of their own */
    TEXTURED_COLORED = SHADINGS,
    MATCAP_COLORED,
    PHONG_COLORED,
    SLERP_COLORED,
    ALL_SHADINGS
};
static const char *const shading_name[ALL_SHADINGS] = {"flat",    "gouraud", "phong",  "slerp",  "texture", "matcap",
                                                       "colored", "texflat", "texcol", "matcol", "phocol",  "slecol"};

/* What a draw of any shading can have in addition. */
enum extra {
    EXTRA_NOTHING,
    EXTRA_FOG, /* with a depth bias, which in some views moves the object in the fog */
    EXTRA_STIPPLE,
    EXTRA_BOTH,
    EXTRAS
};
static const char *const extra_name[EXTRAS] = {"", "fog ", "stipple ", "both "};

/* Lights of the colored shaders. */
enum own_lights {
    LIGHTS_WHITE,
    LIGHTS_COLORED,
    LIGHTS_AT, /* point lights with and without a colour, one of which moves with the eye */
};
static const char *const lights_name[] = {"view", "tints", "points"};

static const char *const edging_name[SHEEN_EDGINGS] = {"", "smooth ", "outline ", "wire "};

enum ramp {
    RAMP_NONE,
    RAMP_HALF,
    RAMP_TOON,
    RAMP_GAMMA,
    RAMPS
};
static const char *const ramp_name[RAMPS] = {"", "half ", "toon ", "gamma "};

struct scene {
    int mesh, shading, view, format;
    int extra, lights, ramp;
    unsigned edging;
    uint16_t weight;      /* of a morph to a second frame; 0: no morph */
    uint8_t orthographic; /* 1: an orthographic view */
    uint8_t mixed;        /* 1: the texture is bilinear in all views, and keyed except for matcaps */
    uint8_t quads;        /* 1: polygons have four corners, and the mesh has warp */
    uint8_t twice;        /* 1: drawn again in another colour at the same depths, which MUST NOT show */
};

static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    const struct sheen_target *target = ctx;
    enum sheen_pixel pixel = (enum sheen_pixel)target->pixel;
    size_t bytes = sheen_row_bytes(pixel, (unsigned)(rect.x1 - rect.x0));
    const uint8_t *from = pixels;

    for (int y = rect.y0; y < rect.y1; y++, from += bytes)
        memcpy(picture + (size_t)y * sheen_row_bytes(pixel, WIDTH) + sheen_row_bytes(pixel, (unsigned)rect.x0), from,
               bytes);
    return SHEEN_OK;
}

/* FNV-1a, 32 bits. */
static uint32_t checksum(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 0x811c9dc5u;

    for (size_t i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * 0x01000193u;
    return sum;
}

/*
 * Views: 0: one light with a highlight; 1: affine, three lights, intensities beyond 1; 2: cut by the near plane,
 * two-sided, in a viewport; 3: lit from behind, a wide highlight that fades; 4: affine, magnified, so that the guard
 * band cuts.
 */
#define VIEWS 5

static void set_view(int number, int orthographic, struct sheen_view *view, struct sheen_object *draw)
{
    static const struct sheen_light behind = {.to = {-0x20000000, 0x18000000, -0x2ccccccd}, .intensity = 65536};
    static const struct sheen_light lights[3] = {
        {.to = {-0x20000000, 0x2ccccccd, 0x20000000}, .intensity = 65536},
        {.to = {0x30000000, 0x08000000, 0x10000000}, .intensity = 40000},
        {.to = {0, -0x40000000, 0x00100000}, .intensity = 65536, .no_highlight = 1},
    };

    *view = (struct sheen_view){.fov = 0x1c71c71c, .z_near = 1 << 24, .z_far = 5 << 24, .background = {8, 16, 40}};
    view->affine = number == 1 || number == 4;
    if (number == 4)
        view->fov = 0x02000000;
    if (orthographic)
        view->orthographic = 0x02d00000;
    if (number == 2)
        view->viewport = (struct sheen_rect){8, 5, 88, 71};
    draw->lights = number == 3 ? &behind : lights;
    draw->light_count = number == 1 ? 3 : 1;
    draw->two_sided = number == 2 || number == 4;
    sheen_pose_orbit(&draw->pose, 0x1555a5a5u * (uint32_t)(number + 1), 0x0e3f1234u, 0x02468aceu * (uint32_t)number,
                     number == 2 ? 0x01a00000 : 0x02d00000);
}

static int set_material(struct sheen_material *material, struct sheen_shine *shine, int view)
{
    static const uint8_t shininess[VIEWS] = {32, 7, 128, 2, 32};

    *material = (struct sheen_material){.base = {200, 160, 80},
                                        .highlight = {255, 255, 240},
                                        .ambient = 6554,
                                        .diffuse = view == 1 ? 60000 : 40000,
                                        .specular = view == 1 ? 50000 : 20000,
                                        .shine = shine};
    return sheen_shine_make(shine, shininess[view]);
}

/*
 * uv are computed from the positions. The view decides whether texels have 16, 8 or 4 bits and are bilinear, keyed or
 * clamped; a bilinear matcap is clamped, as it has to be.
 */
static void hang_texture(struct sheen_mesh *mesh, struct sheen_texture *texture, const struct scene *s)
{
    static const uint16_t palette[16] = {0x0000, 0xffff, 0xf800, 0x07e0, 0x001f, 0xffe0, 0xf81f, 0x07ff,
                                         0x8410, 0xc618, 0x8000, 0x0400, 0x0010, 0x8400, 0xfc00, 0x2945};
    const int view = s->view, larger = (s->mesh == 1 && view == 3) || (s->mesh == 2 && view == 0);
    const int sphere = s->shading == MATCAP || s->shading == MATCAP_COLORED, held = sphere && (view == 3 || s->mixed);
    static int16_t uvs[2 * 1400];
    static uint16_t wide[128 * 64];
    static uint8_t byte[128 * 64];

    for (uint32_t i = 0; i < mesh->vertices && i < 1400; i++) {
        uvs[2 * i] = mesh->positions[3 * i];
        uvs[2 * i + 1] = (int16_t)(mesh->positions[3 * i + 1] / 2 + mesh->positions[3 * i + 2] / 4);
    }
    for (uint32_t i = 0; i < 128 * 64; i++) {
        byte[i] = (uint8_t)((i * i + 3 * (i >> 4)) & 15u);
        wide[i] = palette[byte[i]];
    }
    mesh->uvs = uvs;
    mesh->uv_bits = 14;
    *texture = (struct sheen_texture){.texels = byte, .palette = palette};
    texture->width_log2 = larger ? 7 : 4;
    texture->height_log2 = larger ? 6 : 3;
    texture->bits = view == 1 ? 4 : view == 2 ? 8 : 16;
    if (texture->bits == 16)
        texture->texels = wide;
    texture->bilinear = view == 3 || s->mixed;
    texture->keyed = view == 2 || (s->mixed && !sphere);
    texture->key = 0xf800;
    texture->clamp_u = view == 1 || held;
    texture->clamp_v = view == 4 || held;
}

/* Gives each vertex a colour that depends on its position. */
static void paint_vertices(struct sheen_mesh *mesh)
{
    static uint8_t colors[3 * 1400];

    for (uint32_t i = 0; i < 3u * mesh->vertices && i < 3 * 1400; i++)
        colors[i] = (uint8_t)((mesh->positions[i] + 32768) >> 8);
    mesh->colors = colors;
}

/* The second frame of a morph: a quarter turn about z, and flattened; normals are only turned. */
static void make_second(const struct sheen_mesh *mesh, struct sheen_mesh *second)
{
    static int16_t positions[3 * 1400], normals[3 * 1400];

    for (uint32_t i = 0; i < 3u * mesh->vertices && i < 3 * 1400; i += 3) {
        positions[i] = (int16_t)-mesh->positions[i + 1];
        positions[i + 1] = mesh->positions[i];
        positions[i + 2] = (int16_t)(mesh->positions[i + 2] / 2);
        normals[i] = (int16_t)-mesh->normals[i + 1];
        normals[i + 1] = mesh->normals[i];
        normals[i + 2] = mesh->normals[i + 2];
    }
    *second = *mesh;
    second->positions = positions;
    second->normals = normals;
}

static uint32_t corner_index(const struct sheen_mesh *mesh, uint32_t corner)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[corner]
                                  : ((const uint16_t *)mesh->indices)[corner];
}

/* Makes each triangle a polygon or, with quads, each two successive triangles, which form a fan. */
static void find_polygons(struct sheen_mesh *mesh, int quads)
{
    static int16_t normals[3 * 1400];
    static uint16_t polygons[1400];
    static uint8_t warp[1400];
    static const uint32_t corners[4] = {0, 1, 2, 3};
    const uint32_t size = quads ? 2 : 1;

    for (uint32_t t = 0; t < mesh->triangles; t += size) {
        int32_t points[12];
        sheen_q30_t normal[3];
        for (uint32_t i = 0; i < 12; i++)
            points[i] = mesh->positions[3 * corner_index(mesh, 3 * t + (i < 9 || !quads ? i / 3 % 3 : 5)) + i % 3];
        if (sheen_polygon_normal(points, corners, 2 + size, normal) < 0)
            normal[0] = normal[1] = normal[2] = 0;
        for (uint32_t i = 0; i < 3; i++)
            normals[3 * (t / size) + i] = (int16_t)(normal[i] / (1 << 15) - (normal[i] == 1 << 30));
        for (uint32_t i = 0; i < size; i++)
            polygons[t + i] = (uint16_t)(t / size);
    }
    mesh->polygon_normals = normals;
    if (quads) {
        mesh->polygons = polygons;
        sheen_mesh_warp(mesh, mesh->triangles / 2, warp);
        mesh->warp = warp;
    }
}

static void find_edges(struct sheen_mesh *mesh)
{
    static struct sheen_triangle_edges of_mesh[1400];
    static uint32_t scratch[SHEEN_EDGES_WORDS(1400, 1400)];

    sheen_mesh_edges(mesh, 0x37000000, scratch, of_mesh); /* sharp from 30.8 degrees on */
    mesh->edges = of_mesh;
}

/* n / 10 in Q7.24; tcc takes no fractions in an initialiser. */
#define TENTHS(n) ((sheen_q24_t)(((int64_t)(n) * (1 << 24) + 5) / 10))

static void add_extra(struct sheen_view *view, struct sheen_object *draw, int extra, int number)
{
    static const struct sheen_fog fogs[VIEWS] = {
        {TENTHS(22), TENTHS(34), {200, 210, 220}, &sheen_fog_mixer},
        {TENTHS(1), TENTHS(30), {255, 255, 255}, &sheen_fog_mixer}, /* begins in front of near */
        {TENTHS(5), TENTHS(400), {90, 20, 0}, &sheen_fog_mixer},    /* ends beyond far */
        {TENTHS(26), TENTHS(29), {0, 0, 0}, &sheen_fog_mixer},
        {TENTHS(20), TENTHS(40), {8, 16, 40}, &sheen_fog_mixer}};
    static const int16_t bias[VIEWS] = {0, 900, -4096, 4095, -1};
    static const uint8_t transparency[VIEWS] = {32, 1, 63, 20, 45};

    view->fog = extra & EXTRA_FOG ? &fogs[number] : NULL;
    draw->depth_bias = extra & EXTRA_FOG ? bias[number] : 0;
    draw->stipple = extra & EXTRA_STIPPLE ? &sheen_stipple : NULL;
    draw->transparency = extra & EXTRA_STIPPLE ? transparency[number] : 0;
    draw->phase = extra & EXTRA_STIPPLE ? (uint8_t)(3 * number & 7) : 0;
}

static void color_lights(struct sheen_view *view, struct sheen_object *draw, struct sheen_material *material,
                         int own_lights, int number)
{
    static struct sheen_light lights[4];
    static const uint8_t colors[4][3] = {{255, 128, 40}, {0, 0, 0}, {30, 90, 255}, {200, 0, 1}};
    const uint8_t count = (uint8_t)(1 + number % 3 + draw->light_count % 2);

    for (uint8_t i = 0; i < count; i++) {
        lights[i] = draw->lights[i % draw->light_count];
        memcpy(lights[i].color, colors[i], sizeof colors[i]);
        if (own_lights == LIGHTS_AT && i != 2) {
            lights[i].at[0] = TENTHS(7 * i - 9);
            lights[i].at[1] = TENTHS(6);
            lights[i].at[2] = TENTHS(3 * number - 20);
            lights[i].radius = (30 + number) << 12;
            lights[i].points = &sheen_points;
            lights[i].with_eye = i == 1;
        }
    }
    if (own_lights == LIGHTS_AT)
        (void)sheen_pose_rotate(&view->pose, 1, 0x05000000);
    draw->lights = lights;
    draw->light_count = count;
    material->ambient_color[0] = 90;
    material->ambient_color[2] = 255;
}

/* How a picture's bands are drawn, which MUST NOT change its pixels. */
struct settings {
    uint8_t rows, buffers, workers, carried; /* of the configuration */
    uint8_t backward;                        /* 1: the lowest band first; the workers take turns */
};

/* Three without and three with dither. */
static const struct settings all_settings[2][3] = {{{1, 1, 1, 0, 0}, {16, 2, 3, 1, 1}, {HEIGHT, 1, 1, 0, 0}},
                                                   {{1, 2, 1, 0, 0}, {16, 1, 2, 2, 0}, {HEIGHT, 1, 1, 0, 0}}};

static int run_bands(struct sheen_frame *frame, const struct settings *settings)
{
    const unsigned count = sheen_band_count(frame);
    int status = SHEEN_OK;

    for (unsigned i = 0; i < count && status == SHEEN_OK; i++)
        status = sheen_band(frame, i % settings->workers, settings->backward ? count - 1 - i : i);
    return status == SHEEN_OK ? sheen_finish(frame) : status;
}

static const struct sheen_shader *shader_of(const struct scene *s)
{
    if (s->shading == TEXTURED_COLORED)
        return (s->mesh + s->view) % 2 ? &sheen_textured_flat_colored : &sheen_textured_colored;
    if (s->shading >= PHONG_COLORED)
        return s->shading == PHONG_COLORED ? &sheen_phong_colored : &sheen_slerp_colored;
    if (s->shading == MATCAP_COLORED)
        return (s->mesh + s->view) % 2 ? &sheen_matcap_vertex_colored : &sheen_matcap_colored;
    if (s->shading == COLORED)
        return (s->mesh + s->view) % 2 ? &sheen_flat_colored : &sheen_gouraud_colored;
    if (s->shading == MATCAP)
        return (s->mesh + s->view) % 3 == 2 ? &sheen_matcap_vertex : &sheen_matcap;
    if (s->shading == TEXTURED_FLAT)
        return &sheen_textured_flat;
    return s->shading == TEXTURED ? &sheen_textured : sheen_shader_of((unsigned)s->shading);
}

/* The ball keeps the material's colours, others are white. TEXTURED_FLAT and TEXTURED_COLORED alone light the box. */
static void light_texels(struct sheen_material *material, const struct scene *s)
{
    if (s->mesh == SUM_BALL)
        return;
    for (int k = 0; k < 3; k++)
        material->base[k] = material->highlight[k] = 255;
    if (s->mesh == SUM_BOX && s->shading != TEXTURED_FLAT && s->shading != TEXTURED_COLORED) {
        material->ambient = SHEEN_Q16(1);
        material->diffuse = material->specular = 0;
    }
}

static int set_ramp(struct sheen_material *material, int ramp)
{
    static struct sheen_ramp gamma;

    material->ramp = ramp == RAMP_HALF   ? &sheen_ramp_half
                     : ramp == RAMP_TOON ? &sheen_ramp_toon
                     : ramp == RAMP_NONE ? NULL
                                         : &gamma;
    return ramp == RAMP_GAMMA ? sheen_ramp_make_gamma(&gamma, material->ambient, material->diffuse) : SHEEN_OK;
}

/* Draws two frames between which the mesh turns, so that the second one sends only what changed. */
static int draw_frames(struct sheen_frame *frame, const struct scene *s, struct sheen_object *draw,
                       struct sheen_material *material, const struct settings *settings, int dither)
{
    struct sheen_material other = *material;
    int status = SHEEN_OK;

    other.base[0] = 20;
    other.base[2] = 255;
    for (int i = 0; i < 2 && status == SHEEN_OK; i++) {
        struct sheen_view view;
        set_view(s->view, s->orthographic, &view, draw);
        add_extra(&view, draw, s->extra, s->view);
        if (s->lights != LIGHTS_WHITE)
            color_lights(&view, draw, material, s->lights, s->view);
        view.dither = (uint8_t)dither;
        if (i == 0)
            sheen_pose_orbit(&draw->pose, 0, 0, 0, 0x03000000);
        status = sheen_begin(frame, &view);
        if (status == SHEEN_OK)
            status = sheen_draw(frame, draw);
        if (status == SHEEN_OK && s->twice) {
            draw->material = &other;
            status = sheen_draw(frame, draw);
            draw->material = material;
        }
        if (status == SHEEN_OK)
            status = settings->rows == HEIGHT ? sheen_end(frame) : run_bands(frame, settings);
    }
    return status;
}

static int draw_picture(const struct scene *s, struct sheen_object *draw, const struct sheen_texture *texture,
                        const struct settings *settings, int dither)
{
    struct sheen_target target = {.push = push,
                                  .width = WIDTH,
                                  .height = HEIGHT,
                                  .pixel = (uint8_t)s->format,
                                  .align_x = s->format == SHEEN_GREY2    ? 8
                                             : s->format == SHEEN_GREY16 ? 2
                                                                         : 1};
    struct sheen_config config = {
        .target = &target,
        .band_rows = settings->rows,
        .buffers = settings->buffers,
        .workers = settings->workers,
        .max_vertices = (uint16_t)(draw->mesh->vertices * (s->twice ? 2 : 1) + (s->edging != 0 ? 500 : 0)),
        .max_shades = s->twice ? 2 : 1,
        .max_triangles = 1400,
        .max_clipped = 600,
        .clipper = &sheen_clipper,
        .quads = s->quads ? &sheen_quads : NULL,
        .max_carried = settings->carried,
        .max_edges = s->edging != 0 ? 8000 : 0,
        .smooth = s->edging == SHEEN_SMOOTH};
    struct sheen_frame *frame;
    struct sheen_material material;
    struct sheen_shine shine;
    size_t size = sizeof arena;
    int status = sheen_init(&frame, arena, &size, &config);

    target.ctx = &target;
    memset(picture, 0, sizeof picture);
    if (status == SHEEN_OK)
        status = set_material(&material, &shine, s->view);
    material.texture = texture;
    if (texture != NULL)
        light_texels(&material, s);
    if (status == SHEEN_OK)
        status = set_ramp(&material, s->ramp);
    draw->material = &material;
    return status == SHEEN_OK ? draw_frames(frame, s, draw, &material, settings, dither) : status;
}

static int left_out(void)
{
    static unsigned scenes;

    return scenes++ % SUM_EVERY != 0;
}

/* Prints a line for each of `all_settings`. */
static int print_sums(const struct scene *s)
{
    if (left_out())
        return SHEEN_OK;
    struct sheen_mesh own = *sum_mesh((enum sum_mesh)s->mesh), second;
    const struct sheen_morph morph = {&second, &sheen_morpher, s->weight};
    struct sheen_texture texture;
    struct sheen_object draw = {.mesh = &own, .shader = shader_of(s), .edges = sheen_edges_of(s->edging)};
    const int textured =
        s->shading == TEXTURED || s->shading == MATCAP || (s->shading >= TEXTURED_FLAT && s->shading < PHONG_COLORED);

    if (s->shading == COLORED || s->shading >= TEXTURED_COLORED)
        paint_vertices(&own);
    if (textured)
        hang_texture(&own, &texture, s);
    if (s->weight != 0) {
        make_second(&own, &second);
        draw.morph = &morph;
    }
    if (s->edging != 0 || s->quads)
        find_polygons(&own, s->quads);
    if (s->edging != 0)
        find_edges(&own);
    for (int i = 0; i < 6; i++) {
        const struct settings *settings = &all_settings[i / 3][i % 3];
        int status = draw_picture(s, &draw, textured ? &texture : NULL, settings, i / 3);
        if (status < 0) {
            fprintf(stderr, "frame_sum: %s, %s, view %d, %s, %d rows: %s\n", mesh_name[s->mesh],
                    shading_name[s->shading], s->view, format_name[s->format], settings->rows, sheen_strerror(status));
            return status;
        }
        printf("%-5s %-7s %s %d %s%s%s%s%s%s%-8s %s %2d rows %08x\n", mesh_name[s->mesh], shading_name[s->shading],
               s->lights == LIGHTS_WHITE && s->weight != 0 ? "morph" : lights_name[s->lights], s->view,
               s->orthographic ? "ortho "
               : s->twice      ? "twice "
                               : "",
               s->quads ? "quads " : "", s->mixed ? "mixed " : "", ramp_name[s->ramp], extra_name[s->extra],
               edging_name[s->edging], format_name[s->format], i / 3 ? "dither" : "plain ", settings->rows,
               (unsigned)checksum(picture, sizeof picture));
    }
    return SHEEN_OK;
}

/* ---- the scenes ---- */

/* Every view and format of a shading and a mesh. */
static int plain(int shading, int mesh)
{
    int status = SHEEN_OK;

    for (int i = 0; i < VIEWS * 5 && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){.mesh = mesh, .shading = shading, .view = i / 5, .format = i % 5});
    return status;
}

static int shadings(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < SUM_MESHES * SHEEN_SHADINGS && status == SHEEN_OK; i++)
        status = plain(i % SHEEN_SHADINGS, i / SHEEN_SHADINGS);
    for (int i = 0; i < SUM_MESHES * (COLORED + 1 - SHEEN_SHADINGS) && status == SHEEN_OK; i++)
        status = plain(SHEEN_SHADINGS + i / SUM_MESHES, i % SUM_MESHES);
    return status;
}

/* The same depths twice: the first drawn has to stay, in short rows (ball) and long ones (box) of each shading. */
static int ties(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < 2 * SHEEN_SHADINGS * VIEWS && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){.mesh = i % 2 == 0 ? SUM_BOX : SUM_BALL,
                                            .shading = i / 2 % SHEEN_SHADINGS,
                                            .view = i / 2 / SHEEN_SHADINGS,
                                            .format = SHEEN_RGB565_BE,
                                            .twice = 1});
    return status;
}

/* Shadings up to MATCAP in every view with each enum extra; these choose the mesh. */
static int with_extras(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < (MATCAP + 1) * VIEWS * (EXTRAS - 1) * 2 && status == SHEEN_OK; i++) {
        struct scene s = {.shading = i / (2 * (EXTRAS - 1) * VIEWS),
                          .view = i / (2 * (EXTRAS - 1)) % VIEWS,
                          .extra = 1 + i / 2 % (EXTRAS - 1)};
        s.mesh = (s.shading + s.view + s.extra) % SUM_MESHES;
        s.format = i % 2 == 0 ? SHEEN_RGB565_BE : SHEEN_RGB565_LE + (s.shading + s.view + s.extra) % 4;
        status = print_sums(&s);
    }
    return status;
}

static int morphs(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < SUM_MESHES * (COLORED + 1) && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){.mesh = i / (COLORED + 1),
                                            .shading = i % (COLORED + 1),
                                            .view = (i + i / (COLORED + 1)) % VIEWS,
                                            .format = i * 2 % 5,
                                            .weight = (uint16_t)(5000 + 1000 * i)});
    return status;
}

static int with_edges(void)
{
    const int edgings = SHEEN_EDGINGS - 1;
    int status = SHEEN_OK;

    for (int i = 0; i < SUM_MESHES * VIEWS * edgings && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){.mesh = i / edgings % SUM_MESHES,
                                            .shading = i % SHEEN_SHADINGS,
                                            .view = i / edgings / SUM_MESHES,
                                            .format = i % 5,
                                            .edging = (unsigned)(1 + i % edgings)});
    for (int i = 0; i < VIEWS * edgings && status == SHEEN_OK; i++) {
        struct scene s = {.shading = i % SHEEN_SHADINGS,
                          .view = i / edgings,
                          .extra = EXTRA_FOG,
                          .edging = (unsigned)(1 + i % edgings)};
        s.mesh = (i + s.view) % SUM_MESHES;
        s.format = (i + 2 * s.view) % 5;
        status = print_sums(&s);
    }
    return status;
}

static int own_lights(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < SUM_MESHES * VIEWS * 2 && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){.mesh = i / 2 % SUM_MESHES,
                                            .shading = COLORED,
                                            .view = i / 2 / SUM_MESHES,
                                            .format = i % 5,
                                            .lights = i % 2 == 0 ? LIGHTS_COLORED : LIGHTS_AT,
                                            .weight = i % 5 == 4 ? 9000 : 0});
    return status;
}

/* A scene whose shading and view choose mesh, format and extras, so that most combinations occur. */
static struct scene varied(int shading, int view)
{
    const int sum = shading + view;

    return (struct scene){.mesh = (shading + 2 * view) % SUM_MESHES,
                          .shading = shading,
                          .view = view,
                          .format = sum % 2 == 0 ? SHEEN_RGB565_BE : 1 + (shading + sum / 2) % 4,
                          .extra = (sum + view / 2) % EXTRAS};
}

/* Textures lit per polygon, and the shadings that with_extras() leaves out with fog and stipple. */
static int flat_texels(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < SUM_MESHES * VIEWS && status == SHEEN_OK; i++)
        status = print_sums(&(struct scene){
            .mesh = i / VIEWS, .shading = TEXTURED_FLAT, .view = i % VIEWS, .format = i % 2 == 0 ? i / 2 % 5 : 0});
    for (int i = 0; i < 2 * VIEWS * (EXTRAS - 1) && status == SHEEN_OK; i++) {
        struct scene s = varied(COLORED + i % 2, i / 2 % VIEWS);
        s.extra = 1 + i / (2 * VIEWS);
        s.mesh = (s.mesh + s.extra) % SUM_MESHES;
        status = print_sums(&s);
    }
    return status;
}

static int bilinear_texels(void)
{
    static const int shading[3] = {TEXTURED, TEXTURED_FLAT, MATCAP};
    int status = SHEEN_OK;

    for (int i = 0; i < 3 * VIEWS && status == SHEEN_OK; i++) {
        struct scene s = varied(shading[i % 3], i / 3);
        s.mixed = 1;
        status = print_sums(&s);
    }
    return status;
}

/* Every lit shading with every ramp. TEXTURED does not use the box, because texels are unlit there. */
static int ramps(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < SHADINGS * VIEWS && status == SHEEN_OK; i++) {
        struct scene s = varied(i % SHADINGS, i / SHADINGS);
        s.ramp = 1 + (s.shading + s.view) % (RAMPS - 1);
        if (s.shading == TEXTURED)
            s.mesh %= SUM_BOX;
        if (s.shading != MATCAP)
            status = print_sums(&s);
    }
    return status;
}

/* Every shading, then every kind of edges. */
static int orthographic(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < (SHADINGS + SHEEN_EDGINGS - 1) * VIEWS && status == SHEEN_OK; i++) {
        const int edging = i / VIEWS - (SHADINGS - 1);
        struct scene s = varied(edging > 0 ? edging % SHEEN_SHADINGS : i / VIEWS, i % VIEWS);
        s.edging = (unsigned)(edging > 0 ? edging : 0);
        s.orthographic = 1;
        status = print_sums(&s);
    }
    return status;
}

/* Point lights and coloured lights with fog, stipple, ramps, morphs and orthographic views. */
static int own_lights_with_extras(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < 2 * VIEWS && status == SHEEN_OK; i++) {
        struct scene s = varied(COLORED, i / 2);
        s.lights = i % 2 == 0 ? LIGHTS_COLORED : LIGHTS_AT;
        s.mesh = i % SUM_MESHES;
        s.extra = 1 + i % (EXTRAS - 1);
        s.ramp = i % 3 == 0 ? RAMP_HALF : RAMP_NONE;
        s.orthographic = i % 4 == 3;
        s.weight = i % 5 == 4 ? 20000 : 0;
        status = print_sums(&s);
    }
    return status;
}

/* Each view in six turns: plain, fog, stipple, bilinear, orthographic, ramp; the lights change with the turn. */
static int colored_texels(void)
{
    static const int lights[3] = {LIGHTS_WHITE, LIGHTS_COLORED, LIGHTS_AT};
    int status = SHEEN_OK;

    for (int i = 0; i < 2 * VIEWS * 6 && status == SHEEN_OK; i++) {
        const int turn = i / (2 * VIEWS);
        struct scene s = varied(TEXTURED_COLORED + i % 2, i / 2 % VIEWS);
        s.mesh = (s.mesh + turn) % SUM_MESHES;
        s.format = turn % 2 == 0 ? SHEEN_RGB565_BE : (s.format + turn) % 5;
        s.extra = turn % EXTRAS;
        s.mixed = turn == 3;
        s.orthographic = turn == 4;
        s.weight = turn == 2 ? 20000 : 0;
        s.ramp = turn == 5 && s.shading == TEXTURED_COLORED ? RAMP_HALF : RAMP_NONE;
        s.lights = s.shading == TEXTURED_COLORED ? lights[turn % 3] : LIGHTS_WHITE;
        status = print_sums(&s);
    }
    return status;
}

/* Colored shadings with light per pixel: as own_lights() and own_lights_with_extras(), but without point lights. */
static int colored_pixels(void)
{
    int status = SHEEN_OK;

    for (int i = 0; i < 2 * VIEWS * SUM_MESHES && status == SHEEN_OK; i++) {
        struct scene s = varied(PHONG_COLORED + i % 2, i / 2 % VIEWS);
        s.mesh = i / (2 * VIEWS);
        s.format = i % 5;
        s.lights = i % 3 == 0 ? LIGHTS_WHITE : LIGHTS_COLORED;
        s.extra = i % 4 == 1 ? 1 + i / 4 % (EXTRAS - 1) : EXTRA_NOTHING;
        s.ramp = i % 7 == 3 ? RAMP_HALF : RAMP_NONE;
        s.orthographic = i % 9 == 4;
        s.weight = i % 5 == 2 ? 20000 : 0;
        status = print_sums(&s);
    }
    return status;
}

/* Plane quads in view 0, affine, lit from behind, and orthographic. */
static int quads(void)
{
    static const uint8_t views[4] = {0, 1, 3, 0};
    int status = SHEEN_OK;

    for (int i = 0; i < 3 * 4 * SHEEN_SHADINGS && status == SHEEN_OK; i++) {
        struct scene s = {.mesh = SUM_TORUS + i % 3,
                          .shading = i / 3 % SHEEN_SHADINGS,
                          .view = views[i / 3 / SHEEN_SHADINGS],
                          .format = i * 2 % 5,
                          .quads = 1};
        s.orthographic = i / 3 / SHEEN_SHADINGS == 3;
        s.extra = i % 4 == 1 ? 1 + i / 4 % (EXTRAS - 1) : EXTRA_NOTHING;
        s.edging = i % 5 == 2 ? (unsigned)(1 + i / 5 % (SHEEN_EDGINGS - 1)) : 0;
        status = print_sums(&s);
    }
    return status;
}

int main(void)
{
    static int (*const part[])(void) = {shadings,
                                        ties,
                                        with_extras,
                                        morphs,
                                        with_edges,
                                        own_lights,
                                        flat_texels,
                                        bilinear_texels,
                                        ramps,
                                        orthographic,
                                        own_lights_with_extras,
                                        colored_texels,
                                        colored_pixels,
                                        quads};

    for (size_t i = 0; i < sizeof part / sizeof part[0]; i++)
        if (part[i]() < 0)
            return 1;
    return ferror(stdout) || fflush(stdout) != 0;
}
