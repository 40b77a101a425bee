/*
 * random_scene.c - scenes by number.
 */
#include "random_scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "frame_stage.h"

/* ---- scenes that the core once drew wrongly ---- */

#define OCTAHEDRON 4 /* numbers of accuracy_mesh_make */
#define ICOSAHEDRON 6

static const struct known {
    int shape, size, affine;
    double pose[5]; /* yaw, pitch, roll, distance, fov */
    double light[3], ambient, diffuse, specular, shininess;
} known[KNOWN_SCENES] = {
    /* affine, cut by the guard band: at the new corners attributes were linear in space, so no pixel was right */
    {ICOSAHEDRON, 240, 1, {-96.5357, -35.4437, 162.451, 1.50011, 1}, {-0.963, 1.6496, 0.4668}, 1, 0.6, 0.3, 5},
    {OCTAHEDRON, 240, 1, {30, 20, 0, 1.2, 30}, {-0.5, 0.7, 0.5}, 0.1, 0.6, 0.3, 32},
    /* large triangles with strong highlights: N.N was wrong where it had been stepped far from its corner */
    {ICOSAHEDRON, 320, 0, {143.7777, 73.3442, 87.7114, 1.13013, 71.4566}, {0.3058, -1.1355, 1.6241}, 0.1, 0.3, 1, 127},
    {ICOSAHEDRON, 320, 0, {143.7777, 73.3442, 87.7114, 1.13013, 71.4566}, {0.3058, -1.1355, 1.6241}, 0.1, 0.3, 1, 32},
    /* lit from behind: without the fade the highlight ended in a jump */
    {ICOSAHEDRON, 240, 0, {30, 20, 0, 3, 40}, {-0.6, 0.3, -0.7}, 0.1, 0.3, 1, 1},
    {OCTAHEDRON, 240, 0, {75, -35, 20, 2.2, 55}, {0.5, 0.8, -0.4}, 0.1, 0.3, 1, 2},
};

static void set_known(struct random_scene *to, const struct random_meshes *meshes, const struct known *from)
{
    struct ref_scene *scene = &to->scene;

    to->mesh = &meshes->fine[from->shape];
    ref_scene_default(scene, &to->mesh->reference);
    ref_scene_orbit(scene, from->pose[0], from->pose[1], from->pose[2], from->pose[3]);
    scene->fov = from->pose[4];
    scene->width = scene->height = from->size;
    scene->affine = from->affine;
    scene->two_sided = true;
    memcpy(scene->light[0], from->light, sizeof scene->light[0]);
    scene->ambient = from->ambient;
    scene->diffuse = from->diffuse;
    scene->specular = from->specular;
    scene->shininess = from->shininess;
}

/* ---- random ones ---- */

static void random_pose(struct ref_scene *scene, enum random_kind kind, uint32_t *state)
{
    double yaw = stage_uniform(state, -180, 180), pitch = stage_uniform(state, -90, 90);
    double roll = stage_uniform(state, -180, 180);
    double farthest = kind == RANDOM_MAGNIFIED || kind == RANDOM_STRONG ? 2 : 4;

    ref_scene_orbit(scene, yaw, pitch, roll, stage_uniform(state, 1.1, farthest));
    scene->fov = kind == RANDOM_MAGNIFIED ? pow(2, stage_uniform(state, 0, 5)) : stage_uniform(state, 20, 90);
    scene->two_sided = stage_random(state) % 2;
    scene->ortho = stage_random(state) % 8 == 0;
    scene->affine = stage_random(state) % 2;
}

static void random_lights(struct ref_scene *scene, enum random_kind kind, uint32_t *state)
{
    scene->light_count = stage_random(state) % 4 == 0 ? 2 + (int)(stage_random(state) % 3) : 1;
    for (int i = 0; i < scene->light_count; i++) {
        for (int k = 0; k < 3; k++)
            scene->light[i][k] = stage_uniform(state, -1, 1);
        scene->light[i][2] += scene->light[i][2] < 0 ? -0.01 : 0.01; /* never zero */
        if (kind == RANDOM_BEHIND)
            scene->light[i][2] = -fabs(scene->light[i][2]);
    }
}

static bool is_clear_color(const struct ref_scene *scene, double intensity)
{
    for (int k = 0; k < 3; k++) {
        double level = (k == 1 ? 63 : 31) * intensity * scene->base[k] + 0.5;
        if (fabs(level - floor(level + 0.5)) < 0.01)
            return false;
    }
    return true;
}

/*
 * All pixels that no light reaches have one colour, and so have all pixels on a tread of a toon ramp. If a channel of
 * such a colour lies on the edge between two levels, one chance rounding decides them all: the scene is not clear.
 */
static bool is_clear(const struct ref_scene *scene)
{
    int thirds = scene->ramp == REF_TOON ? 3 * scene->light_count : 0;
    double dark = scene->ambient + scene->light_count * scene->diffuse * ref_ramp(scene, -1);

    for (int i = 0; i <= thirds; i++)
        if (!is_clear_color(scene, dark + scene->diffuse * i / 3))
            return false;
    return true;
}

static void random_material(struct ref_scene *scene, enum random_kind kind, uint32_t *state)
{
    double low = kind == RANDOM_STRONG ? 4 : 0, high = kind == RANDOM_BEHIND ? 3 : 7;

    scene->ambient = stage_uniform(state, 0.01, 0.5);
    scene->diffuse = stage_uniform(state, 0, 1) / scene->light_count;
    scene->specular = kind == RANDOM_STRONG || stage_random(state) % 2 ? 1 : stage_uniform(state, 0, 1);
    scene->specular /= scene->light_count;
    scene->shininess = floor(pow(2, stage_uniform(state, low, high)) + 0.5);
    for (int k = 0; k < 3; k++)
        scene->base[k] = (stage_random(state) >> 24) / 255.0;
    scene->dither = stage_random(state) % 2;
}

static void random_ramp(struct ref_scene *scene, uint32_t *state)
{
    scene->ramp = stage_random(state) % 4 == 0 ? (enum ref_ramp)(REF_HALF + stage_random(state) % 3) : REF_LAMBERT;
    if (scene->ramp == REF_GAMMA)
        scene->diffuse = fmax(scene->diffuse, 0.01);
    while (!is_clear(scene))
        scene->ambient += 0.001;
}

/* A texture without filtering, in as few bits as hold the picture or in more. */
static void random_texture(struct random_scene *to, const struct random_meshes *meshes, uint32_t *state)
{
    static const int fewest[TEXTURED_PICTURES] = {8, 8, 16, 4};
    const unsigned picture = stage_random(state) % TEXTURED_PICTURES;
    struct ref_texture *texture = &to->texture;

    to->mesh = &meshes->textured[stage_random(state) % TEXTURED_MESHES];
    to->scene.mesh = &to->mesh->reference;
    to->scene.texture = texture;
    *texture = *textured_picture((int)picture);
    texture->bits = fewest[picture] << stage_random(state) % 3;
    texture->bits = texture->bits > 16 ? 16 : texture->bits;
    texture->clamp[0] = stage_random(state) % 4 == 0;
    texture->clamp[1] = stage_random(state) % 4 == 0;
    texture->keyed = stage_random(state) % 3 == 0;
    texture->key = texture->texels[stage_random(state) % (unsigned)(texture->width * texture->height)];
}

static void random_fog(struct ref_scene *scene, uint32_t *state)
{
    const double depth = scene->far - scene->near;

    scene->fog = true;
    scene->fog_from = scene->near + stage_uniform(state, -0.3, 0.6) * depth;
    scene->fog_from = fmax(scene->fog_from, 0.02);
    scene->fog_to = fmax(scene->fog_from, scene->near) + stage_uniform(state, 0.2, 2) * depth;
    scene->bias = stage_random(state) % 4 == 0 ? (int)stage_uniform(state, -300, 300) : 0;
    for (int k = 0; k < 3; k++)
        scene->fog_color[k] = (stage_random(state) >> 24) / 255.0;
}

/* Gives some lights and the ambient light colours; makes some lights points around the mesh. */
static void random_tints(struct ref_scene *scene, uint32_t *state)
{
    for (int i = 0; i < scene->light_count; i++) {
        for (int k = 0; k < 3 && stage_random(state) % 4 != 0; k++)
            scene->light_color[i][k] = (1 + (stage_random(state) >> 24) % 255) / 255.0;
        if (scene->shading > REF_GOURAUD || stage_random(state) % 2 == 0)
            continue;
        for (int k = 0; k < 3; k++)
            scene->light[i][k] = stage_uniform(state, -1.5, 1.5);
        scene->radius[i] = stage_uniform(state, 0.3, 4);
    }
    for (int k = 0; k < 3; k++)
        scene->ambient_color[k] = (1 + (stage_random(state) >> 24) % 255) / 255.0;
    scene->ramp = stage_random(state) % 2 ? REF_LAMBERT : scene->ramp == REF_TOON ? REF_HALF : scene->ramp;
}

void random_scene(struct random_scene *to, const struct random_meshes *meshes, uint32_t number)
{
    static const int size[3][2] = {{240, 240}, {320, 240}, {240, 320}};
    static const enum sheen_way first[4] = {SHEEN_WAY_FLAT, SHEEN_WAY_GOURAUD_LINEAR, SHEEN_WAY_PHONG_QUADRATIC,
                                            SHEEN_WAY_SLERP};
    static const unsigned ways[4] = {1, 3, 3, 2};
    uint32_t state = (number + 1) * 2654435761u;

    *to = (struct random_scene){.kind = RANDOM_KNOWN};
    if (number < KNOWN_SCENES) {
        set_known(to, meshes, &known[number]);
        return;
    }
    to->kind = (enum random_kind)(number % RANDOM_KNOWN);
    int shading = (int)(number / RANDOM_KNOWN % 4);
    for (int i = 0; i < 8; i++)
        stage_random(&state);
    uint32_t shape = stage_random(&state) % ACCURACY_SHAPES, shot = stage_random(&state) % 3;
    to->mesh = shading == REF_FLAT || to->kind == RANDOM_STRONG ? &meshes->coarse[shape] : &meshes->fine[shape];
    ref_scene_default(&to->scene, &to->mesh->reference);
    to->scene.shading = (enum ref_shading)shading;
    to->scene.width = size[shot][0];
    to->scene.height = size[shot][1];
    random_pose(&to->scene, to->kind, &state);
    random_lights(&to->scene, to->kind, &state);
    random_material(&to->scene, to->kind, &state);
    to->way = stage_random(&state) % 2 ? 0 : 1 + first[shading] + stage_random(&state) % ways[shading];
    random_ramp(&to->scene, &state);
    to->scene.colored = stage_random(&state) % 4 == 0;
    if (to->way == 0 && shading <= REF_GOURAUD && stage_random(&state) % 3 == 0)
        random_texture(to, meshes, &state);
    if (stage_random(&state) % 6 == 1)
        random_fog(&to->scene, &state);
    if (stage_random(&state) % 8 == 3) {
        to->scene.left_out = 1 + (int)(stage_random(&state) % 63);
        to->scene.phase = (int)(stage_random(&state) % 8);
    }
    if (stage_random(&state) % 4 == 1)
        random_tints(&to->scene, &state);
}

void random_scene_print(const struct random_scene *from)
{
    static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};
    static const char *const ramp_name[] = {"", " half", " gamma", " toon"};
    const struct ref_scene *scene = &from->scene;

    if (scene->texture)
        printf("    texels of %d bits, %dx%d%s%s%s\n", scene->texture->bits, scene->texture->width,
               scene->texture->height, scene->texture->clamp[0] ? ", u held" : "",
               scene->texture->clamp[1] ? ", v held" : "", scene->texture->keyed ? ", key" : "");
    if (scene->fog)
        printf("    fog from %.3f to %.3f, %.3f %.3f %.3f, bias %d\n", scene->fog_from, scene->fog_to,
               scene->fog_color[0], scene->fog_color[1], scene->fog_color[2], scene->bias);
    if (scene->left_out > 0)
        printf("    %d of 64 left out, phase %d\n", scene->left_out, scene->phase);
    printf("    %s %dx%d %s%s%s%s%s%s%s distance %.4f fov %.4f shininess %.0f ambient %.3f diffuse %.3f specular %.3f "
           "way %u lights",
           from->mesh->name, scene->width, scene->height, shading_name[scene->shading], scene->affine ? " affine" : "",
           scene->ortho ? " ortho" : "", scene->dither ? " dither" : "", scene->two_sided ? " two-sided" : "",
           scene->colored ? " colored" : "", ramp_name[scene->ramp], scene->distance, scene->fov, scene->shininess,
           scene->ambient, scene->diffuse, scene->specular, from->way);
    for (int i = 0; i < scene->light_count; i++)
        printf(" %.3f,%.3f,%.3f radius %.3f color %.3f,%.3f,%.3f", scene->light[i][0], scene->light[i][1],
               scene->light[i][2], scene->radius[i], scene->light_color[i][0], scene->light_color[i][1],
               scene->light_color[i][2]);
    printf(" ambient %.3f,%.3f,%.3f", scene->ambient_color[0], scene->ambient_color[1], scene->ambient_color[2]);
    printf("\n");
}

int random_meshes_make(struct random_meshes *meshes)
{
    int status = 0;

    for (int i = 0; i < ACCURACY_SHAPES; i++) {
        status |= accuracy_mesh_make(&meshes->fine[i], i, false);
        status |= accuracy_mesh_make(&meshes->coarse[i], i, true);
    }
    for (int i = 0; i < TEXTURED_MESHES; i++)
        status |= textured_mesh_make(&meshes->textured[i], i);
    return status;
}

void random_meshes_free(struct random_meshes *meshes)
{
    for (int i = 0; i < ACCURACY_SHAPES; i++) {
        accuracy_mesh_free(&meshes->fine[i]);
        accuracy_mesh_free(&meshes->coarse[i]);
    }
    for (int i = 0; i < TEXTURED_MESHES; i++)
        accuracy_mesh_free(&meshes->textured[i]);
}
