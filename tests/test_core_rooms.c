/*
 * test_core_rooms.c - each shading's room without a frame: light at the corners, set-up, rows, against its definition
 * in double precision, within a step of 565; rooms of texels and matcaps within a part of a texel besides.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core_raster.h"
#include "frame_stage.h"
#include "test_core_worst.h"

#define WIDTH 160
#define HEIGHT 120
#define TRIANGLES 400
#define AMBIENT 0.1
#define DIFFUSE 0.8

struct scene {
    double x[3], y[3];   /* px */
    double normal[3][3]; /* unit, as the core has them */
    double light[3];     /* unit */
    int16_t normals[3][3];
};

typedef double intensity_at(const struct scene *s, double x, double y);

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void coordinates(const struct scene *s, double x, double y, double b[3])
{
    double area = 0;

    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        b[k] = (s->x[i] - x) * (s->y[j] - y) - (s->x[j] - x) * (s->y[i] - y);
        area += b[k];
    }
    for (int k = 0; k < 3; k++)
        b[k] /= area;
}

static double of_gouraud(const struct scene *s, double x, double y)
{
    double b[3], sum = 0;

    coordinates(s, x, y, b);
    for (int k = 0; k < 3; k++)
        sum += b[k] * fmax(0, dot(s->normal[k], s->light));
    return sum;
}

static double of_phong(const struct scene *s, double x, double y)
{
    double b[3], n[3];

    coordinates(s, x, y, b);
    for (int i = 0; i < 3; i++)
        n[i] = b[0] * s->normal[0][i] + b[1] * s->normal[1][i] + b[2] * s->normal[2][i];
    return fmax(0, dot(n, s->light) / sqrt(dot(n, n)));
}

/* Along the great arc from a to b. */
static void slerp(const double a[3], const double b[3], double t, double out[3])
{
    double angle = acos(fmin(1, dot(a, b))), from = 1 - t, to = t;

    if (angle > 1e-6) {
        from = sin((1 - t) * angle) / sin(angle);
        to = sin(t * angle) / sin(angle);
    }
    for (int i = 0; i < 3; i++)
        out[i] = from * a[i] + to * b[i];
}

/* Lecture, "Phong Shading by spherical interpolation": along the edges, then along the scan line. */
static double of_slerp(const struct scene *s, double x, double y)
{
    double at[2] = {0, 0}, normal[2][3], n[3];
    int found = 0;

    for (int k = 0; k < 3 && found < 2; k++) {
        int j = (k + 1) % 3;
        if ((s->y[k] <= y) == (s->y[j] <= y))
            continue;
        double t = (y - s->y[k]) / (s->y[j] - s->y[k]);
        at[found] = s->x[k] + t * (s->x[j] - s->x[k]);
        slerp(s->normal[k], s->normal[j], t, normal[found++]);
    }
    slerp(normal[0], normal[1], (x - at[0]) / (at[1] - at[0]), n);
    return fmax(0, dot(n, s->light));
}

static double of_flat(const struct scene *s, double x, double y)
{
    (void)x, (void)y;
    return fmax(0, dot(s->normal[0], s->light)); /* the polygon's normal */
}

static void random_unit(uint32_t *state, const double near[3], double spread, double unit[3])
{
    for (int i = 0; i < 3; i++)
        unit[i] = near[i] + stage_uniform(state, -spread, spread);
    double length = sqrt(dot(unit, unit));
    for (int i = 0; i < 3; i++)
        unit[i] /= length;
}

/* Corners on 1/64 px, counterclockwise as they are seen; 0 where they span little. */
static int random_scene(struct scene *s, struct core_raster *r, uint32_t *state, double spread)
{
    static const double ahead[3] = {0, 0, 1};
    double middle[3];

    random_unit(state, ahead, 0.4, middle);
    for (int k = 0; k < 3; k++) {
        s->x[k] = floor(stage_uniform(state, 0, WIDTH) * 64) / 64;
        s->y[k] = floor(stage_uniform(state, 0, HEIGHT) * 64) / 64;
        random_unit(state, middle, spread, s->normal[k]);
        for (int i = 0; i < 3; i++) {
            s->normals[k][i] = (int16_t)lrint(s->normal[k][i] * 32767);
            s->normal[k][i] = s->normals[k][i] / 32767.0;
        }
        r->vertex[k].x = (int16_t)lrint(64 * (s->x[k] - WIDTH / 2.0));
        r->vertex[k].y = (int16_t)lrint(64 * (s->y[k] - HEIGHT / 2.0));
        r->vertex[k].z = 20000;
        r->vertex[k].flags = 0;
    }
    return sheen_twice_area(&r->vertex[0], &r->vertex[1], &r->vertex[2]) < -64 * 64 * 200;
}

static void begin(struct core_raster *r, struct scene *s, const struct sheen_shader *shader)
{
    const struct sheen_light light = {.to = {19661, 26214, 56754}, .no_highlight = 1};
    struct sheen_pose pose;
    double length = 0;

    core_raster_begin(r, WIDTH, HEIGHT);
    sheen_pose_orbit(&pose, 0, 0, 0, 0);
    r->material = (struct sheen_material){
        .base = {200, 160, 90}, .ambient = (sheen_q16_t)(AMBIENT * 65536), .diffuse = (sheen_q16_t)(DIFFUSE * 65536)};
    assert_int_equal(sheen_light_begin(&r->draw.light, &light, 1, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
    sheen_colour_begin(&r->draw.colour, &r->format, &r->material, r->draw.light.diffuse_sum,
                       r->draw.light.specular_sum);
    sheen_colour_reach(&r->draw.colour, &r->format);
    r->draw.is_565 = 1;
    sheen_power_end(&r->draw.power, &r->draw.colour, &r->format, 0);
    sheen_loop_begin(&r->draw, NULL, NULL, NULL, NULL);
    r->format.swap = 0; /* this machine's order */
    r->draw.shader = shader;
    for (int i = 0; i < 3; i++)
        length += (double)light.to[i] * light.to[i];
    for (int i = 0; i < 3; i++)
        s->light[i] = light.to[i] / sqrt(length);
}

/* Steps that a pixel is off its definition, half a step for the rounding not counted. */
static double steps_off(uint16_t pixel, double intensity)
{
    static const double base[3] = {200 / 255.0, 160 / 255.0, 90 / 255.0}, top[3] = {31, 63, 31};
    const double level[3] = {pixel >> 11, pixel >> 5 & 63, pixel & 31};
    double most = 0;

    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(level[k] - (AMBIENT + DIFFUSE * intensity) * base[k] * top[k]));
    return fmax(0, most - 0.5);
}

/* Every pixel of random triangles, corner normals within `spread`. */
static void check_room(const struct sheen_shader *shader, intensity_at *intensity, double spread, double allowed)
{
    static uint16_t depth[WIDTH * HEIGHT], pixels[WIDTH * HEIGHT];
    struct worst worst = {0};
    struct core_raster r;
    struct scene s;
    uint32_t state = 3;

    begin(&r, &s, shader);
    for (int i = 0; i < TRIANGLES; i++) {
        if (!random_scene(&s, &r, &state, spread))
            continue;
        r.mesh.normals = &s.normals[0][0];
        r.mesh.polygon_normals = s.normals[0];
        for (int k = 0; k < 3 && shader->light != NULL; k++)
            shader->light(&r.draw, s.normals[k], r.vertex[k].kept);
        memset(depth, 0, sizeof depth);
        core_raster_draw(&r, depth, pixels);
        for (int at = 0; at < WIDTH * HEIGHT; at++)
            if (depth[at] != 0)
                worst_note(&worst, steps_off(pixels[at], intensity(&s, at % WIDTH + 0.5, at / WIDTH + 0.5)),
                           "triangle %d, pixel %d %d", i, at % WIDTH, at / WIDTH);
    }
    worst_assert(&worst, allowed, "steps of 565 beside the rounding");
}

/* ---- colours: of vertices, of the light, of ambient light ---- */

static const uint8_t vertex_colors[9] = {255, 128, 0, 40, 200, 255, 90, 30, 160};
static const uint8_t light_color[3] = {255, 180, 100}, ambient_color[3] = {120, 160, 255}, white[3] = {255, 255, 255};

/*
 * A colored room and its error, as in steps_off. intensity NULL: light is computed at corners (from one normal if
 * is_flat) and the lit colours are linear between them. Otherwise colours are linear and each pixel has its own light.
 */
struct colored_room {
    const struct sheen_shader *shader;
    intensity_at *intensity;
    int is_flat;
};

static double colored_off(const struct scene *s, uint16_t pixel, double x, double y, const struct colored_room *room,
                          const uint8_t *light, const uint8_t *ambient)
{
    static const double base[3] = {200 / 255.0, 160 / 255.0, 90 / 255.0}, top[3] = {31, 63, 31};
    const double level[3] = {pixel >> 11, pixel >> 5 & 63, pixel & 31};
    double b[3], most = 0;

    coordinates(s, x, y, b);
    for (int i = 0; i < 3; i++) {
        double channel = 0;
        for (int k = 0; k < 3; k++) {
            double intensity = room->intensity != NULL ? room->intensity(s, x, y)
                                                       : fmax(0, dot(s->normal[room->is_flat ? 0 : k], s->light));
            channel += b[k] * vertex_colors[3 * k + i] / 255 *
                       (AMBIENT * ambient[i] / 255 + DIFFUSE * intensity * light[i] / 255);
        }
        most = fmax(most, fabs(level[i] - channel * base[i] * top[i]));
    }
    return fmax(0, most - 0.5);
}

/* The picture of the triangle of random_scene; 0 where there is none to look at. */
static int draw_scene(struct core_raster *r, struct scene *s, uint32_t *state, double spread, uint16_t *depth,
                      uint16_t *pixels)
{
    const struct sheen_shader *shader = r->draw.shader;

    if (!random_scene(s, r, state, spread))
        return 0;
    r->mesh.normals = &s->normals[0][0];
    r->mesh.polygon_normals = s->normals[0];
    for (int k = 0; k < 3 && shader->light != NULL; k++)
        shader->light(&r->draw, s->normals[k], r->vertex[k].kept);
    memset(depth, 0, WIDTH * HEIGHT * sizeof *depth);
    core_raster_draw(r, depth, pixels);
    return 1;
}

static void check_colored(const struct colored_room *room, int tinted)
{
    static uint16_t depth[WIDTH * HEIGHT], pixels[WIDTH * HEIGHT];
    const uint8_t *light = tinted ? light_color : white, *ambient = tinted ? ambient_color : white;
    struct sheen_light lights[1] = {{.intensity = 0}};
    struct worst worst = {0};
    struct core_raster r;
    struct scene s;
    uint32_t state = 5;

    begin(&r, &s, room->shader);
    r.mesh.colors = vertex_colors;
    if (tinted) {
        memcpy(lights[0].color, light_color, sizeof light_color);
        memcpy(r.material.ambient_color, ambient_color, sizeof ambient_color);
    }
    const struct sheen_object object = {.material = &r.material, .lights = lights, .light_count = 1};
    room->shader->begin(&r.draw, &r.material, &r.format, &object, &object.pose);
    for (int i = 0; i < TRIANGLES; i++) {
        if (!draw_scene(&r, &s, &state, 0.5, depth, pixels))
            continue;
        for (int at = 0; at < WIDTH * HEIGHT; at++)
            if (depth[at] != 0)
                worst_note(&worst,
                           colored_off(&s, pixels[at], at % WIDTH + 0.5, at / WIDTH + 0.5, room, light, ambient),
                           "triangle %d, pixel %d %d", i, at % WIDTH, at / WIDTH);
    }
    worst_assert(&worst, 0.1, "steps of 565 beside the rounding");
}

static void colored_rooms(void **unused)
{
    static const struct colored_room rooms[] = {{&sheen_flat_colored, NULL, 1},
                                                {&sheen_gouraud_colored, NULL, 0},
                                                {&sheen_phong_colored, of_phong, 0},
                                                {&sheen_slerp_colored, of_slerp, 0}};

    (void)unused;
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++)
        for (int tinted = 0; tinted < 2; tinted++)
            check_colored(&rooms[i], tinted);
}

/* ---- texels ---- */

#define SIDE_LOG2 6
#define SIDE (1 << SIDE_LOG2)

/* Texel coordinates of a pixel, and the light on it by channel. */
typedef void texels_at(const struct scene *s, const int16_t uv[6], double x, double y, double at[5]);

static void at_uvs(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    double b[3];

    coordinates(s, x, y, b);
    at[0] = SIDE / 4096.0 * (b[0] * uv[0] + b[1] * uv[2] + b[2] * uv[4]);
    at[1] = SIDE / 4096.0 * (b[0] * uv[1] + b[1] * uv[3] + b[2] * uv[5]);
    at[2] = at[3] = at[4] = AMBIENT + DIFFUSE * of_gouraud(s, x, y);
}

static void at_uvs_flat(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    at_uvs(s, uv, x, y, at);
    at[2] = at[3] = at[4] = AMBIENT + DIFFUSE * of_flat(s, x, y);
}

static void at_normal(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    double b[3], n[3];

    (void)uv;
    coordinates(s, x, y, b);
    for (int i = 0; i < 3; i++)
        n[i] = b[0] * s->normal[0][i] + b[1] * s->normal[1][i] + b[2] * s->normal[2][i];
    const double length = sqrt(dot(n, n));
    at[0] = SIDE * (1 + n[0] / length) / 2;
    at[1] = SIDE * (1 - n[1] / length) / 2;
    at[2] = at[3] = at[4] = 1;
}

static void at_vertices(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    double b[3];

    (void)uv;
    coordinates(s, x, y, b);
    at[0] = at[1] = 0;
    for (int k = 0; k < 3; k++) {
        at[0] += b[k] * SIDE * (1 + s->normal[k][0]) / 2;
        at[1] += b[k] * SIDE * (1 - s->normal[k][1]) / 2;
    }
    at[2] = at[3] = at[4] = 1;
}

enum lit_by {
    LIT_WHOLLY,
    LIT_FLAT,
    LIT_GOURAUD
};

/* Light at the corners times their colours. */
static void by_vertices(const struct scene *s, double x, double y, enum lit_by lit, double at[5])
{
    double b[3];

    coordinates(s, x, y, b);
    at[2] = at[3] = at[4] = 0;
    for (int k = 0; k < 9; k++) {
        const double intensity = fmax(0, dot(s->normal[lit == LIT_FLAT ? 0 : k / 3], s->light));
        const double light = lit == LIT_WHOLLY ? 1 : AMBIENT + DIFFUSE * intensity;
        at[2 + k % 3] += b[k / 3] * light * vertex_colors[k] / 255;
    }
}

static void at_uvs_colored(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    at_uvs(s, uv, x, y, at);
    by_vertices(s, x, y, LIT_GOURAUD, at);
}

static void at_uvs_flat_colored(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    at_uvs(s, uv, x, y, at);
    by_vertices(s, x, y, LIT_FLAT, at);
}

static void at_normal_colored(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    at_normal(s, uv, x, y, at);
    by_vertices(s, x, y, LIT_WHOLLY, at);
}

static void at_vertices_colored(const struct scene *s, const int16_t uv[6], double x, double y, double at[5])
{
    at_vertices(s, uv, x, y, at);
    by_vertices(s, x, y, LIT_WHOLLY, at);
}

static double channel_of(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* The picture repeats. */
static uint16_t texel_of(const uint16_t *texels, double u, double v)
{
    return texels[((int)floor(v) & (SIDE - 1)) << SIDE_LOG2 | ((int)floor(u) & (SIDE - 1))];
}

/* The texels about (u, v) by their shares. */
static double mixed_of(const uint16_t *texels, double u, double v, int k)
{
    const double a = u - 0.5 - floor(u - 0.5), b = v - 0.5 - floor(v - 0.5);

    return (1 - b) * ((1 - a) * channel_of(texel_of(texels, u - 0.5, v - 0.5), k) +
                      a * channel_of(texel_of(texels, u + 0.5, v - 0.5), k)) +
           b * ((1 - a) * channel_of(texel_of(texels, u - 0.5, v + 0.5), k) +
                a * channel_of(texel_of(texels, u + 0.5, v + 0.5), k));
}

/* Steps that a pixel is off the best of what its coordinates may be, `within` a texel of where they are. */
static double texels_off(const struct sheen_texture *texture, uint16_t pixel, const double at[5], double within)
{
    double least = 1e9;

    for (int i = 0; i < 9; i++) {
        const double u = at[0] + (i % 3 - 1) * within, v = at[1] + (i / 3 - 1) * within;
        double most = 0;
        for (int k = 0; k < 3; k++) {
            const double texel =
                texture->bilinear ? mixed_of(texture->texels, u, v, k) : channel_of(texel_of(texture->texels, u, v), k);
            most = fmax(most, fabs(channel_of(pixel, k) - at[2 + k] * texel));
        }
        least = fmin(least, most);
    }
    return fmax(0, least - 0.5);
}

/* A texture of random colours; if bilinear, of colours that change slowly. */
static void make_texture(struct sheen_texture *texture, uint16_t *texels, int bilinear, int clamp)
{
    uint32_t state = 9;

    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE, y = i / SIDE, smooth = abs(x - SIDE / 2) << 11 | abs(y - SIDE / 2) << 5 | 15;
        texels[i] = bilinear ? (uint16_t)smooth : (uint16_t)stage_uniform(&state, 0, 65536);
    }
    *texture = (struct sheen_texture){.texels = texels,
                                      .width_log2 = SIDE_LOG2,
                                      .height_log2 = SIDE_LOG2,
                                      .clamp_u = (uint8_t)clamp,
                                      .clamp_v = (uint8_t)clamp,
                                      .bilinear = (uint8_t)bilinear};
}

/* within: of a texel, what a room's coordinates may be off. */
static void check_texels(const struct sheen_shader *shader, texels_at *coordinates_at, int bilinear, double spread,
                         double within)
{
    static uint16_t depth[WIDTH * HEIGHT], pixels[WIDTH * HEIGHT], texels[SIDE * SIDE];
    const struct sheen_light lights[1] = {{.intensity = 0}};
    struct sheen_texture texture;
    struct worst worst = {0};
    struct core_raster r;
    struct scene s;
    int16_t uv[6];
    uint32_t state = 7;

    begin(&r, &s, shader);
    make_texture(&texture, texels, bilinear, shader->axes != NULL);
    memset(r.material.base, 255, sizeof r.material.base);
    r.material.texture = &texture;
    r.mesh.colors = vertex_colors; /* which plain rooms do not read */
    sheen_colour_begin(&r.draw.colour, &r.format, &r.material, r.draw.light.diffuse_sum, r.draw.light.specular_sum);
    sheen_colour_reach(&r.draw.colour, &r.format);
    if (shader->axes != NULL) {
        struct sheen_pose pose;
        sheen_pose_orbit(&pose, 0, 0, 0, 0);
        assert_int_equal(sheen_light_begin(&r.draw.light, shader->axes, 2, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
    }
    const struct sheen_object object = {.material = &r.material, .lights = lights, .light_count = 1};
    shader->begin(&r.draw, &r.material, &r.format, &object, &object.pose);
    r.mesh.uvs = uv;
    r.mesh.uv_bits = 12;
    for (int i = 0; i < TRIANGLES; i++) {
        for (int k = 0; k < 6; k++)
            uv[k] = (int16_t)stage_uniform(&state, -6000, 6000);
        if (!draw_scene(&r, &s, &state, spread, depth, pixels))
            continue;
        for (int at = 0; at < WIDTH * HEIGHT; at++) {
            double where[5];
            coordinates_at(&s, uv, at % WIDTH + 0.5, at / WIDTH + 0.5, where);
            if (depth[at] != 0)
                worst_note(&worst, texels_off(&texture, pixels[at], where, within), "triangle %d, pixel %d %d", i,
                           at % WIDTH, at / WIDTH);
        }
    }
    worst_assert(&worst, 0.1, "steps of 565 beside the rounding");
}

static void textured_rooms(void **unused)
{
    (void)unused;
    for (int bilinear = 0; bilinear < 2; bilinear++) {
        check_texels(&sheen_textured, at_uvs, bilinear, 0.5, 1 / 32.0);
        check_texels(&sheen_textured_flat, at_uvs_flat, bilinear, 0.5, 1 / 32.0);
        check_texels(&sheen_textured_colored, at_uvs_colored, bilinear, 0.5, 1 / 32.0);
        check_texels(&sheen_textured_flat_colored, at_uvs_flat_colored, bilinear, 0.5, 1 / 32.0);
    }
}

static void matcap_rooms(void **unused)
{
    (void)unused;
    for (int bilinear = 0; bilinear < 2; bilinear++) {
        check_texels(&sheen_matcap, at_normal, bilinear, 0.05, 1 / 24.0);
        check_texels(&sheen_matcap, at_normal, bilinear, 0.5, 1 / 24.0);
        check_texels(&sheen_matcap_vertex, at_vertices, bilinear, 0.5, 1 / 32.0);
        check_texels(&sheen_matcap_colored, at_normal_colored, bilinear, 0.05, 1 / 24.0);
        check_texels(&sheen_matcap_colored, at_normal_colored, bilinear, 0.5, 1 / 24.0);
        check_texels(&sheen_matcap_vertex_colored, at_vertices_colored, bilinear, 0.5, 1 / 32.0);
    }
}

static void flat_room(void **unused)
{
    (void)unused;
    check_room(&sheen_flat, of_flat, 0.5, 0.01);
}

static void gouraud_room(void **unused)
{
    (void)unused;
    check_room(&sheen_gouraud, of_gouraud, 0.5, 0.1);
}

static void phong_room(void **unused)
{
    (void)unused;
    check_room(&sheen_phong, of_phong, 0.1, 0.1);
    check_room(&sheen_phong, of_phong, 0.5, 0.1);
}

static void slerp_room(void **unused)
{
    (void)unused;
    check_room(&sheen_slerp, of_slerp, 0.05, 0.1);
    check_room(&sheen_slerp, of_slerp, 0.5, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(flat_room),     cmocka_unit_test(gouraud_room),
                                       cmocka_unit_test(phong_room),    cmocka_unit_test(slerp_room),
                                       cmocka_unit_test(colored_rooms), cmocka_unit_test(textured_rooms),
                                       cmocka_unit_test(matcap_rooms)};

    return cmocka_run_group_tests_name("rooms", tests, NULL, NULL);
}
