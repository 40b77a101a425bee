/*
 * textured_scene.c - meshes, textures and scenes for the tests of textures.
 */
#include "textured_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846
#define GRID 4096.0 /* uv are multiples of 1 / GRID, which 16 bits hold */

/* ---- meshes ---- */

static double on_grid(double x)
{
    return floor(x * GRID + 0.5) / GRID;
}

/* Puts the picture, `times` times, on each quad; a triangle gets the uv of three of its corners. */
static void uv_of_sides(const struct ref_polygons *p, double (*uv)[2], double times)
{
    static const double at[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};

    for (size_t polygon = 0; polygon < p->polygon_count; polygon++) {
        for (uint32_t c = p->first[polygon]; c < p->first[polygon + 1]; c++) {
            for (int i = 0; i < 2; i++)
                uv[c][i] = times * at[(c - p->first[polygon]) & 3][i];
        }
    }
}

/* uv by longitude and height, the picture `around` times about the y axis; across the seam a polygon's u exceeds 1. */
static void uv_of_globe(const struct ref_polygons *p, double (*uv)[2], double around, double down)
{
    for (size_t polygon = 0; polygon < p->polygon_count; polygon++) {
        double high = 0;
        for (uint32_t c = p->first[polygon]; c < p->first[polygon + 1]; c++) {
            const double *at = p->points[p->corners[c]];
            double turn = atan2(-at[2], at[0]) / (2 * PI);
            uv[c][0] = turn - floor(turn);
            uv[c][1] = on_grid(down * (1 - at[1]) / 2);
            high = fmax(high, uv[c][0]);
        }
        for (uint32_t c = p->first[polygon]; c < p->first[polygon + 1]; c++)
            uv[c][0] = on_grid(around * (uv[c][0] + (high - uv[c][0] > 0.5 ? 1 : 0)));
    }
}

/* A square of 2 by 2 units in two quads, lying under the eye. */
static int shape_floor(struct shape *shape)
{
    static const uint32_t quads[2][4] = {{0, 1, 3, 2}, {2, 3, 5, 4}};
    int status = 0;

    memset(shape, 0, sizeof *shape);
    for (int i = 0; i < 6; i++)
        status |= shape_point(shape, i & 1 ? 1 : -1, 0, (i >> 1) - 1);
    for (int i = 0; i < 2; i++)
        status |=
            shape_polygon(shape, 4, (uint32_t[]){quads[i][2], quads[i][1], quads[i][0], quads[i][3]}); /* faces up */
    return status;
}

static int make_textured_shape(struct shape *shape, int index, const char **name)
{
    static const char *const names[TEXTURED_MESHES] = {"floor", "cube", "sphere", "torus", "screen", "barrel, vn"};

    *name = names[index];
    return index == 0   ? shape_floor(shape)
           : index == 1 ? shape_cube(shape)
           : index == 2 ? shape_sphere(shape, 12, 16)
           : index == 3 ? shape_torus(shape, 0.75, 0.33, 20, 12)
           : index == 4 ? shape_screen(shape)
                        : shape_barrel(shape, 4, 8);
}

int textured_mesh_make(struct accuracy_mesh *mesh, int index)
{
    static const struct ref_mesh_options options = {.fit = true, .crease = -1};
    struct shape shape;
    double(*uv)[2] = NULL, (*color)[3] = NULL;

    memset(mesh, 0, sizeof *mesh);
    int status = make_textured_shape(&shape, index, &mesh->name);
    if (status == 0) {
        uv = calloc(shape.polygons.first[shape.polygons.polygon_count], sizeof *uv);
        color = accuracy_corner_colors(&shape.polygons);
        status = uv && color ? 0 : -1;
    }
    if (status == 0) {
        if (index == 2 || index == 3 || index == 5)
            uv_of_globe(&shape.polygons, uv, index == 3 ? 4 : 2, index == 3 ? 3 : 1);
        else
            uv_of_sides(&shape.polygons, uv, index == 0 ? 3 : index == 4 ? -2.5 : 1);
        shape.polygons.uv = (const double(*)[2])uv;
        shape.polygons.color = (const double(*)[3])color;
        status = ref_mesh_build(&mesh->reference, &shape.polygons, &options);
    }
    if (status == 0)
        status = core_mesh_make(&mesh->own, &mesh->reference);
    mesh->mesh = &mesh->own.mesh;
    free(uv);
    free(color);
    shape_free(&shape);
    return status;
}

/* ---- textures ---- */

static uint32_t scrambled(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

static uint16_t rgb(double r, double g, double b)
{
    return (uint16_t)((int)floor(31 * r + 0.5) << 11 | (int)floor(63 * g + 0.5) << 5 | (int)floor(31 * b + 0.5));
}

static uint16_t texel_at(int index, int i, int j)
{
    static const uint16_t few[16] = {0x0000, 0xffff, 0xf800, 0x07e0, 0x001f, 0xffe0, 0xf81f, 0x07ff,
                                     0x8410, 0xc618, 0x8000, 0x0400, 0x0010, 0x8400, 0xfc00, 0x2945};
    const int block = index == 0 ? 2 : index == 2 ? 1 : 4; /* texels of equal colour: at borders none is settled */
    uint32_t noise = scrambled((uint32_t)(index << 20 | j / block << 10 | i / block));

    switch (index) {
    case 0:
        i /= block;
        j /= block;
        return (i ^ j) & 1 ? rgb(0.9, 0.8 - 0.05 * i, 0.2 + 0.1 * j) : rgb(0.1 + 0.1 * i, 0.3, 0.9 - 0.1 * j);
    case 1:
        return (uint16_t)(noise & 0xffff);
    case 2: { /* smooth, even where it repeats */
        double x = 2 * PI * i / 32, y = 2 * PI * j / 32;
        return rgb(0.5 + 0.2 * sin(x) + 0.15 * cos(y), 0.55 + 0.2 * cos(x + y), 0.4 + 0.15 * sin(y) + 0.1 * cos(2 * x));
    }
    default:
        return few[noise & 15];
    }
}

const struct ref_texture *textured_picture(int index)
{
    static const int width[TEXTURED_PICTURES] = {16, 32, 32, 16}, height[TEXTURED_PICTURES] = {8, 16, 32, 16};
    static uint16_t texels[TEXTURED_PICTURES][32 * 32];
    static struct ref_texture texture[TEXTURED_PICTURES];
    struct ref_texture *t = &texture[index];

    *t = (struct ref_texture){.width = width[index], .height = height[index], .texels = texels[index], .bits = 16};
    for (int j = 0; j < t->height; j++) {
        for (int i = 0; i < t->width; i++)
            texels[index][j * t->width + i] = texel_at(index, i, j);
    }
    return t;
}

/* ---- scenes ---- */

bool textured_is_flat(enum textured_light light)
{
    return light == TEXTURED_SCENE_FLAT || light == TEXTURED_SCENE_FLAT_COLORS || light == TEXTURED_SCENE_FLAT_POINTS;
}

static void set_light(struct ref_scene *scene, enum textured_light light)
{
    static const double white[3] = {1, 1, 1};

    scene->shading = textured_is_flat(light) ? REF_FLAT : REF_GOURAUD;
    scene->shininess = 16;
    scene->ambient = light == TEXTURED_SCENE_UNLIT ? 1 : 0.23; /* 1/4 would make many texels ties in rounding */
    scene->diffuse = light == TEXTURED_SCENE_UNLIT ? 0 : light == TEXTURED_SCENE_GLOSSY ? 0.9 : 0.7;
    scene->specular = light >= TEXTURED_SCENE_GLOSSY ? 0.6 : light == TEXTURED_SCENE_FLAT ? 0.2 : 0;
    if (light < TEXTURED_SCENE_GLOSSY)
        memcpy(scene->base, white, sizeof scene->base);
    if (light == TEXTURED_SCENE_LIGHTS || light >= TEXTURED_SCENE_TINTS)
        accuracy_more_lights(scene);
    if (light == TEXTURED_SCENE_TINTS)
        accuracy_tints(scene);
    if (light >= TEXTURED_SCENE_POINTS) {
        scene->diffuse = 1.6;
        accuracy_points(scene);
    }
}

void textured_view(struct ref_scene *scene, const struct ref_mesh *mesh, int view, enum textured_light light)
{
    accuracy_view(scene, mesh, view % ACCURACY_VIEWS);
    scene->width = scene->height = 240;
    if (view == 3) {
        ref_scene_orbit(scene, 20, 25, 5, 1.2);
        scene->near = 0.6;
        scene->far = 2.6;
        scene->fov = 70;
        scene->two_sided = true;
    }
    if (view == 4)
        scene->fov = 9;
    set_light(scene, light);
    scene->colored = light >= TEXTURED_SCENE_COLORS; /* flat without colours, one tie may decide a whole picture */
    if (light == TEXTURED_SCENE_TINTS || light == TEXTURED_SCENE_POINTS)
        scene->colored = view % 2;
}
