/*
 * accuracy.c - scenes, limits and scores of the accuracy tests.
 */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct accuracy_limit accuracy_limits[4] = {
    [REF_FLAT] = {0.97, 1.0, 1},
    [REF_GOURAUD] = {0.97, 1.0, 1},
    [REF_PHONG] = {0.96, 0.999, 2},
    [REF_SLERP] = {0.96, 0.999, 2},
};

static int make_shape(struct shape *shape, int index, bool coarse, const char **name)
{
    switch (index) {
    case 0:
        *name = "sphere";
        return coarse ? shape_sphere(shape, 8, 12) : shape_sphere(shape, 32, 64);
    case 1:
        *name = "torus";
        return coarse ? shape_torus(shape, 0.75, 0.33, 12, 8) : shape_torus(shape, 0.75, 0.33, 40, 25);
    case 2:
        *name = "barrel, vn";
        return coarse ? shape_barrel(shape, 4, 8) : shape_barrel(shape, 12, 32);
    case 3:
        *name = "cube";
        return shape_cube(shape);
    case 4:
        *name = "octahedron";
        return shape_octahedron(shape);
    case 5: /* triangles as long as the mesh and a few pixels wide */
        *name = "needles, vn";
        return coarse ? shape_barrel(shape, 1, 8) : shape_barrel(shape, 1, 90);
    case 6:
        *name = "icosahedron";
        return shape_icosahedron(shape);
    default:
        *name = "ball 12x16";
        return coarse ? shape_sphere(shape, 6, 9) : shape_sphere(shape, 12, 16);
    }
}

double (*accuracy_corner_colors(const struct ref_polygons *p))[3]
{
    uint32_t count = p->first[p->polygon_count];
    double(*color)[3] = calloc(count, sizeof *color);

    for (uint32_t c = 0; color && c < count; c++) {
        const double *at = p->points[p->corners[c]];
        for (int k = 0; k < 3; k++)
            color[c][k] = floor(255 * (0.6 + 0.4 * sin(5 * at[k] + 3 * at[(k + 1) % 3] + k)) + 0.5) / 255;
    }
    return color;
}

int accuracy_mesh_make(struct accuracy_mesh *mesh, int index, bool coarse)
{
    static const struct ref_mesh_options options = {.fit = true, .crease = -1};
    struct shape shape;

    memset(mesh, 0, sizeof *mesh);
    int status = make_shape(&shape, index, coarse, &mesh->name);
    double(*color)[3] = status == 0 ? accuracy_corner_colors(&shape.polygons) : NULL;
    shape.polygons.color = (const double(*)[3])color;
    if (status == 0)
        status = color ? ref_mesh_build(&mesh->reference, &shape.polygons, &options) : -1;
    if (status == 0)
        status = core_mesh_make(&mesh->own, &mesh->reference);
    mesh->mesh = &mesh->own.mesh;
    free(color);
    shape_free(&shape);
    return status;
}

void accuracy_mesh_free(struct accuracy_mesh *mesh)
{
    ref_mesh_free(&mesh->reference);
    core_mesh_free(&mesh->own);
}

void accuracy_view(struct ref_scene *scene, const struct ref_mesh *mesh, int index)
{
    static const double pose[ACCURACY_VIEWS][5] = {
        {30, 20, 0, 3, 40}, {75, -35, 20, 2.2, 55}, {200, 60, -15, 1.9, 60}}; /* yaw, pitch, roll, distance, fov */
    static const double light[ACCURACY_VIEWS][3] = {{-0.5, 0.7, 0.5}, {0.3, 0.4, 1.0}, {0.9, -0.1, 0.3}};
    static const double parts[ACCURACY_VIEWS][3] = {{0.1, 0.6, 0.3}, {0.15, 0.7, 0.5}, {0.2, 0.9, 0.8}};
    static const int base[ACCURACY_VIEWS][3] = {{0xc8, 0xa0, 0x50}, {255, 153, 77}, {90, 220, 255}};

    ref_scene_default(scene, mesh);
    ref_scene_orbit(scene, pose[index][0], pose[index][1], pose[index][2], pose[index][3]);
    scene->fov = pose[index][4];
    memcpy(scene->light[0], light[index], sizeof scene->light[0]);
    scene->ambient = parts[index][0];
    scene->diffuse = parts[index][1];
    scene->specular = parts[index][2];
    for (int k = 0; k < 3; k++)
        scene->base[k] = base[index][k] / 255.0;
}

void accuracy_more_lights(struct ref_scene *scene)
{
    static const double more[3][3] = {{0.75, 0.1, 0.25}, {0.1, -1, 0.2}, {0.3, 0.3, -0.5}};

    memcpy(scene->light[1], more, sizeof more);
    scene->light_count = 4;
    scene->diffuse /= 2; /* so that most pixels stay below 1, where differences show */
    scene->specular /= 2;
}

void accuracy_tints(struct ref_scene *scene)
{
    static const double color[4][3] = {{1, 0.6, 0.2}, {0.2, 0.4, 1}, {1, 1, 1}, {0.8, 0.2, 0.6}};
    static const double ambient[3] = {0.4, 0.6, 1};

    for (int k = 0; k < 12; k++)
        scene->light_color[k / 3][k % 3] = floor(255 * color[k / 3][k % 3]) / 255;
    memcpy(scene->ambient_color, ambient, sizeof ambient);
}

void accuracy_points(struct ref_scene *scene)
{
    static const double at[3][3] = {{0.9, 0.5, 0.7}, {-0.8, -0.4, 1.1}, {0.1, 0.9, 0.2}}, radius[3] = {1.7, 2, 1.1};

    for (int k = 0; k < 3; k++) {
        memcpy(scene->light[k], at[k], sizeof at[k]);
        scene->radius[k] = radius[k];
    }
}

void accuracy_ortho(struct ref_scene *scene)
{
    scene->ortho = true;
    scene->affine = false; /* makes no difference without perspective */
}

static enum sheen_pixel format_of(int levels)
{
    return levels == 0 ? SHEEN_RGB565_BE : levels == 2 ? SHEEN_GREY2 : levels < 17 ? SHEEN_GREY16 : SHEEN_GREY256;
}

static int shoot(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                 const struct sheen_mesh *mesh, const struct sheen_morph *morph, unsigned way)
{
    struct memory_target target;
    int status;

    if (scene->width * scene->height > ACCURACY_PIXELS)
        return SHEEN_ERR_ARGUMENT;
    if (memory_target_init(&target, scene->width, scene->height, format_of(scene->levels)) != 0)
        return SHEEN_ERR_MEMORY;
    if (morph)
        status = core_draw_between(&target.target, scene, mesh, morph, 16, &shot->stats);
    else
        status = core_draw_scene_way(&target.target, scene, mesh, 16, way, &shot->stats);
    for (int i = 0; i < scene->width * scene->height; i++)
        shot->values[i] = (uint16_t)memory_target_pixel(&target, i % scene->width, i / scene->width);
    memset(&shot->score, 0, sizeof shot->score);
    if (status == SHEEN_OK && ref_compare(&shot->score, scene, picture, shot->values) != 0)
        status = SHEEN_ERR_MEMORY;
    if (status == SHEEN_OK && target.breaches > 0)
        status = SHEEN_ERR_STATE;
    memory_target_free(&target);
    return status;
}

int accuracy_shoot(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                   const struct sheen_mesh *mesh, unsigned way)
{
    return shoot(shot, scene, picture, mesh, NULL, way);
}

int accuracy_shoot_between(struct accuracy_shot *shot, const struct ref_scene *scene, const struct ref_picture *picture,
                           const struct sheen_mesh *mesh, const struct sheen_morph *morph)
{
    return shoot(shot, scene, picture, mesh, morph, 0);
}

bool accuracy_kept(const struct ref_score *score, enum ref_shading shading, double least_compared)
{
    const struct accuracy_limit *limit = &accuracy_limits[shading];
    double compared = (double)score->compared;

    return compared >= least_compared * (double)score->covered && score->equal >= limit->equal * compared &&
           score->within_one >= limit->within_one * compared && score->worst <= limit->worst;
}
