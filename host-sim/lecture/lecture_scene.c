/*
 * lecture_scene.c - the lecture's scenes, drawn by the core into plain memory.
 */
#include "lecture_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "glass.h"

#define DITHER 8 /* px: period of the dither pattern */

static sheen_angle_t to_angle(double degrees)
{
    return (sheen_angle_t)(int64_t)llround(fmod(degrees, 360) / 360 * 4294967296.0);
}

void sheen_lecture_scene_default(struct sheen_lecture_scene *scene, const struct sheen_mesh *mesh)
{
    *scene = (struct sheen_lecture_scene){.mesh = mesh,
                                          .shading = SHEEN_GOURAUD,
                                          .ortho = 1,
                                          .distance = 4,
                                          .reach = 1,
                                          .light = {0, 0, 1},
                                          .diffuse = 1,
                                          .shininess = 1,
                                          .base = {255, 255, 255},
                                          .background = {255, 255, 255}};
}

void sheen_lecture_roll_light(struct sheen_lecture_scene *scene, double degrees)
{
    double c = cos(degrees * M_PI / 180), s = sin(degrees * M_PI / 180), x = scene->light[0], y = scene->light[1];

    scene->light[0] = c * x - s * y;
    scene->light[1] = s * x + c * y;
}

void sheen_lecture_facet_scene(struct sheen_lecture_scene *scene, const struct sheen_lecture_mesh *facet, int count,
                               int rows, double from)
{
    sheen_lecture_scene_default(scene, &facet->mesh);
    scene->width = count;
    scene->height = rows;
    scene->distance = 1; /* fov stays above a degree */
    scene->reach = rows / 512.0;
    scene->light[0] = -sin(from * M_PI / 180);
    scene->light[2] = cos(from * M_PI / 180);
}

/* Every scene lies at depths from 0.5 to 20. fov follows from `reach`, half the picture's height at `distance`. */
static void set_view(const struct sheen_lecture_scene *scene, struct sheen_view *view)
{
    sheen_q24_t distance = (sheen_q24_t)lround(scene->distance * 16777216);

    *view = (struct sheen_view){.fov = to_angle(2 * atan(scene->reach / scene->distance) * 180 / M_PI),
                                .z_near = SHEEN_Q24(0.5),
                                .z_far = SHEEN_Q24(20),
                                .orthographic = scene->ortho ? distance : 0,
                                .affine = (uint8_t)scene->affine};
}

/* The light's direction is scaled so that its largest component is 1.0: the core accepts any length. */
static int set_draw(const struct sheen_lecture_scene *scene, struct sheen_material *material, struct sheen_shine *shine,
                    struct sheen_light *light, struct sheen_object *draw)
{
    double largest = fmax(fabs(scene->light[0]), fmax(fabs(scene->light[1]), fabs(scene->light[2])));

    *material = (struct sheen_material){.highlight = {255, 255, 255},
                                        .ambient = (sheen_q16_t)lround(scene->ambient * 65536),
                                        .diffuse = (sheen_q16_t)lround(scene->diffuse * 65536),
                                        .specular = (sheen_q16_t)lround(scene->specular * 65536),
                                        .shine = shine};
    memcpy(material->base, scene->base, sizeof material->base);
    *light = (struct sheen_light){.intensity = SHEEN_Q16(1), .with_eye = 1};
    for (int k = 0; k < 3; k++)
        light->to[k] = (sheen_q30_t)lround(scene->light[k] / largest * (1 << 30));
    *draw = (struct sheen_object){.mesh = scene->mesh,
                                  .material = material,
                                  .lights = light,
                                  .light_count = 1,
                                  .two_sided = (uint8_t)scene->two_sided,
                                  .shader = sheen_shader_of((unsigned)scene->shading)};
    sheen_pose_orbit(&draw->pose, to_angle(scene->yaw), to_angle(scene->pitch), to_angle(scene->roll),
                     (sheen_q24_t)lround(scene->distance * 16777216));
    return sheen_shine_make(shine, (unsigned)scene->shininess);
}

/* A scene's frame and everything that the frame points to. */
struct stage {
    struct sheen_target target;
    struct sheen_memory memory;
    struct sheen_material material;
    struct sheen_shine shine;
    struct sheen_light light;
    struct sheen_object draw;
    struct sheen_view view;
    struct sheen_frame *frame;
    void *arena;
};

/* Call stage_close() in either case. */
static int stage_open(struct stage *stage, const struct sheen_lecture_scene *scene, int margin, enum sheen_pixel pixel)
{
    const uint16_t width = (uint16_t)(scene->width + margin), height = (uint16_t)(scene->height + margin);
    struct sheen_config config = {.target = &stage->target,
                                  .band_rows = height,
                                  .max_vertices = scene->mesh->vertices,
                                  .max_triangles = scene->mesh->triangles};

    memset(stage, 0, sizeof *stage);
    stage->memory.stride = sheen_row_bytes(pixel, width);
    stage->memory.pixels = calloc(height, stage->memory.stride);
    if (!stage->memory.pixels)
        return SHEEN_ERR_MEMORY;
    set_view(scene, &stage->view);
    int error = set_draw(scene, &stage->material, &stage->shine, &stage->light, &stage->draw);
    if (!error)
        error = sheen_memory_target(&stage->target, &stage->memory, width, height, pixel);
    if (error)
        return error;
    size_t size = sheen_arena_size(&config);
    stage->arena = malloc(size);
    return stage->arena ? sheen_init(&stage->frame, stage->arena, &size, &config) : SHEEN_ERR_MEMORY;
}

static void stage_close(struct stage *stage)
{
    free(stage->arena);
    free(stage->memory.pixels);
}

static int stage_draw(struct stage *stage)
{
    int error = sheen_begin(stage->frame, &stage->view);

    if (!error)
        error = sheen_draw(stage->frame, &stage->draw);
    return error ? error : sheen_end(stage->frame);
}

/*
 * A dither threshold belongs to a place on the target, so the viewport is shifted over the pattern. The shifts are
 * whole pixels, so that what the core interpolates has the same bits in all 64 pictures.
 */
int sheen_lecture_measure(const struct sheen_lecture_scene *scene, double *intensity)
{
    struct sheen_lecture_scene white = *scene;
    int width = scene->width, height = scene->height;
    struct stage stage;

    memset(white.base, 255, sizeof white.base);
    memset(intensity, 0, sizeof *intensity * (size_t)(width * height));
    int error = stage_open(&stage, &white, DITHER, SHEEN_GREY256);
    stage.view.dither = 1;
    /* The picture at each position relative to the dither pattern. */
    for (int shift = 0; !error && shift < DITHER * DITHER; shift++) {
        int x0 = shift % DITHER, y0 = shift / DITHER;
        stage.view.viewport =
            (struct sheen_rect){(int16_t)x0, (int16_t)y0, (int16_t)(x0 + width), (int16_t)(y0 + height)};
        error = stage_draw(&stage);
        const uint8_t *grey = stage.memory.pixels;
        for (int i = 0; !error && i < width * height; i++)
            intensity[i] += grey[(y0 + i / width) * (width + DITHER) + x0 + i % width] / (DITHER * DITHER * 255.0);
    }
    stage_close(&stage);
    return error;
}

int sheen_lecture_picture(const struct sheen_lecture_scene *scene, uint8_t *rgb)
{
    struct stage stage;
    int error = stage_open(&stage, scene, 0, SHEEN_RGB565_BE);

    stage.view.dither = 1;
    memcpy(stage.view.background, scene->background, sizeof stage.view.background);
    if (!error)
        error = stage_draw(&stage);
    for (int i = 0; !error && i < scene->width * scene->height; i++) {
        const uint8_t *byte = (const uint8_t *)stage.memory.pixels + 2 * i;
        sheen_sim_expand((uint16_t)(byte[0] << 8 | byte[1]), 0, rgb + 3 * i);
    }
    stage_close(&stage);
    return error;
}
