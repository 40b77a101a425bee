/*
 * scene.c - a mesh that turns, on any target.
 */
#include "scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builtin.h"
#include "host_border.h"
#include "matcaps.h"
#include "ramps.h"

#define FAR_OFF 10000.0   /* in radii: from there a mesh looks as in an orthographic view */
#define DEPTH_STEPS 65020 /* from z_far to z_near (struct sheen_canvas) */

static sheen_q16_t to_q16(double x)
{
    return (sheen_q16_t)lround(x * 65536);
}

static sheen_q24_t to_q24(double x)
{
    return (sheen_q24_t)lround(x * 16777216);
}

/* Any finite angle in degrees to turns. fmod is exact, so that even a million whole turns lose no precision. */
static sheen_angle_t to_angle(double degrees)
{
    return (sheen_angle_t)(int64_t)llround(fmod(degrees, 360) / 360 * 4294967296.0);
}

/* ---- what is drawn ---- */

static int is_black(const uint8_t color[3])
{
    return (color[0] | color[1] | color[2]) == 0;
}

static int is_white(const uint8_t color[3])
{
    return (color[0] & color[1] & color[2]) == 255;
}

static int has_points(const struct sheen_options *options)
{
    int found = 0;

    for (int i = 0; i < options->lights.count; i++)
        found |= options->lights.radius[i] > 0;
    return found;
}

/* 1 if the plain shaders would ignore a light's property: its colour, or that it is a point light. */
static int lights_are_colored(const struct sheen_options *options)
{
    int colored = has_points(options) || !(is_white(options->ambient_color) || is_black(options->ambient_color));

    for (int i = 0; i < options->lights.count; i++)
        colored |= !is_white(options->lights.color[i]);
    return colored;
}

int sheen_scene_is_colored(const struct sheen_scene *scene)
{
    return scene->has_colors || (scene->options->shade < SHEEN_MATCAP && lights_are_colored(scene->options));
}

int sheen_scene_corners_alone(const struct sheen_scene *scene)
{
    return scene->texel_count > 0 || has_points(scene->options);
}

/* Black on a background that a panel of two levels shows as white, where white lines would be lost; else white. */
static const uint8_t *line_color(const struct sheen_options *options)
{
    static const uint8_t white[3] = {255, 255, 255}, black[3] = {0, 0, 0};
    const uint8_t *b = options->background;

    if (options->line.given)
        return options->line.color;
    return 2 * (2126l * b[0] + 7152l * b[1] + 722l * b[2]) >= 10000l * 255 ? black : white;
}

static void set_material(struct sheen_material *material, const struct sheen_shine *shine,
                         const struct sheen_options *options, const uint8_t color[3])
{
    memset(material, 0, sizeof *material);
    memcpy(material->base, color, sizeof material->base);
    memset(material->highlight, 255, sizeof material->highlight);
    material->ambient = to_q16(options->ambient);
    material->diffuse = to_q16(options->diffuse);
    material->specular = to_q16(options->specular);
    material->shine = shine;
    memcpy(material->line, line_color(options), sizeof material->line);
    memcpy(material->ambient_color, options->ambient_color, sizeof material->ambient_color);
    if (is_black(options->ambient_color))
        material->ambient = 0;
}

/* Quantises each part of the host's mesh and makes its material. */
static int make_meshes(struct sheen_scene *scene, const struct sheen_host_mesh *host)
{
    const struct sheen_paint *paint = &scene->options->color;

    scene->meshes = calloc(host->part_count, sizeof *scene->meshes);
    scene->materials = calloc(host->part_count, sizeof *scene->materials);
    scene->morphs = calloc(host->part_count, sizeof *scene->morphs);
    scene->own_color = calloc(host->part_count, sizeof *scene->own_color);
    scene->own_texture = calloc(host->part_count, sizeof *scene->own_texture);
    if (!scene->meshes || !scene->materials || !scene->morphs || !scene->own_color || !scene->own_texture)
        return SHEEN_ERR_MEMORY;
    int error = sheen_shine_make(&scene->shine, (unsigned)scene->options->shininess);
    if (error)
        return error;
    const struct sheen_ramp *ramp = sheen_ramp_of(&scene->ramp, scene->options);
    for (size_t i = 0; i < host->part_count; i++) {
        const struct sheen_group *group = &host->group[host->part[i].group];
        const int use_group = paint->from_file && group->has_color;
        error = sheen_quantise(&scene->meshes[scene->count], host, (uint32_t)i);
        if (error)
            return error;
        struct sheen_material *material = &scene->materials[scene->count];
        set_material(material, &scene->shine, scene->options, use_group ? group->color : paint->color);
        material->ramp = ramp;
        scene->morphs[scene->count] = (struct sheen_morph){&scene->meshes[scene->count].second, &sheen_morpher, 0};
        if (host->part[i].picture)
            scene->own_texture[scene->count] = &scene->texels[host->part[i].picture - 1].texture;
        scene->own_color[scene->count++] = (uint8_t)use_group;
    }
    return SHEEN_OK;
}

struct sheen_texture_options sheen_scene_texture_options(const struct sheen_options *options)
{
    int is_off = strcmp(options->texture, "off") == 0, is_own = strcmp(options->texture, "file") == 0;

    return (struct sheen_texture_options){.file = is_off || is_own ? NULL : options->texture,
                                          .wrap = options->wrap,
                                          .most = is_off ? 0 : 1u << options->texture_log2,
                                          .cutoff = options->alpha_cutoff};
}

int sheen_scene_texels(struct sheen_texels **texels, const struct sheen_host_mesh *host,
                       const struct sheen_options *options)
{
    int error = SHEEN_OK;

    *texels = calloc(host->picture_count + 1, sizeof **texels);
    for (size_t i = 0; *texels && !error && i < host->picture_count; i++)
        error = sheen_texels_make(&(*texels)[i], &host->picture[i], (unsigned)options->palette, options->bilinear);
    return *texels ? error : SHEEN_ERR_MEMORY;
}

struct sheen_host_options sheen_scene_host_options(const struct sheen_options *options, int by_group)
{
    return (struct sheen_host_options){.average = options->average,
                                       .by_group = by_group,
                                       .use_crease = options->crease < 180,
                                       .crease = options->crease,
                                       .equal = options->equal,
                                       .up = options->up < 0 ? SHEEN_UP_FORMAT
                                             : options->up   ? SHEEN_UP_Z
                                                             : SHEEN_UP_Y,
                                       .reduce = (unsigned)options->reduce,
                                       .morph = options->morph,
                                       .morph_target = (unsigned)options->morph_target,
                                       .colors = !options->no_vertex_colors};
}

/* Textures and point lights can only be lit flat or gouraud: refuses a --shade that asks for another lit shading. */
static int check_shading(struct sheen_scene *scene, struct sheen_problem *problem)
{
    const struct sheen_options *options = scene->options;
    const int is_lit = options->shade_given && options->shade > SHEEN_GOURAUD && options->shade < SHEEN_MATCAP;

    scene->is_usage = is_lit && sheen_scene_corners_alone(scene);
    if (!scene->is_usage)
        return SHEEN_OK;
    if (scene->texel_count)
        return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                             "--shade: %s shows a texture, which is lit flat or gouraud; --texture off shows none",
                             options->mesh);
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "--shade: point lights are for flat and gouraud");
}

/* Sets shows_inside, for the first frame. The builtin meshes are known to whoever draws them. */
static int look_inside(struct sheen_scene *scene, const struct sheen_host_mesh *host)
{
    const struct sheen_options *options = scene->options;
    struct sheen_pose pose;
    const double distance = options->ortho ? FAR_OFF : options->distance;
    double eye[3]; /* the third row of the rotation is the direction to it */

    if (options->quiet || options->cull_given || strncmp(options->mesh, SHEEN_BUILTIN, strlen(SHEEN_BUILTIN)) == 0)
        return SHEEN_OK;
    sheen_scene_pose(scene, 0, &pose);
    for (int k = 0; k < 3; k++)
        eye[k] = distance * pose.rotation[6 + k] / (1 << 30);
    int found = sheen_host_border_is_seen(host, eye);
    scene->shows_inside = found > 0;
    return found < 0 ? found : SHEEN_OK;
}

static int load(struct sheen_scene *scene, struct sheen_problem *problem)
{
    const struct sheen_options *options = scene->options;
    const struct sheen_texture_options textures = sheen_scene_texture_options(options);
    struct sheen_host_options how = sheen_scene_host_options(options, options->color.from_file);
    struct sheen_host_mesh host;

    how.textures = &textures;
    int error = sheen_host_mesh_load(&host, options->mesh, &how, problem);
    if (error)
        return error;
    if (!options->quiet)
        sheen_notes_print(&host.notes, options->color.from_file && !host.has_colors);
    scene->texel_count = host.picture_count;
    scene->has_colors = host.has_colors;
    error = sheen_scene_texels(&scene->texels, &host, options);
    if (!error)
        error = make_meshes(scene, &host);
    if (!error)
        error = look_inside(scene, &host);
    sheen_host_mesh_free(&host);
    if (!error && (error = check_shading(scene, problem)) != 0)
        return error;
    if (error)
        return sheen_problem(problem, error, "%s: %s", options->mesh, sheen_strerror(error));
    return sheen_matcap_load(&scene->matcap, options->matcap, (unsigned)options->palette, options->bilinear, problem);
}

/* 1 if the fog ends well before z_near: all that is seen is wholly in the fog, whose depths Q7.24 may not resolve. */
static int ends_before(const struct sheen_scene *scene)
{
    return !scene->options->ortho && scene->options->fog.end < scene->view.z_near / 2.0 / (1 << 24);
}

static void look_through_fog(struct sheen_scene *scene)
{
    const struct sheen_options *options = scene->options;

    scene->view.fog = options->fog.end > 0 ? &scene->fog : NULL;
    scene->fog.start = (sheen_q24_t)fmax(to_q24(options->fog.start), 1);
    scene->fog.end = to_q24(options->fog.end);
    if (ends_before(scene)) {
        scene->fog.start = scene->view.z_near / 4;
        scene->fog.end = scene->view.z_near / 2;
    }
    memcpy(scene->fog.color, options->fog_color.given ? options->fog_color.color : options->background,
           sizeof scene->fog.color);
    scene->fog.mixer = options->edges == SHEEN_WIRE ? &sheen_line_fog_mixer : &sheen_fog_mixer;
}

int sheen_scene_check_fog(const struct sheen_scene *scene, struct sheen_problem *problem)
{
    const struct sheen_view *view = &scene->view;
    const struct sheen_depths *depths = &scene->options->fog;
    const int before = ends_before(scene);
    const double near = view->z_near, far = view->z_far;
    const double start = before ? depths->start * (1 << 24) : scene->fog.start;
    const double end = before ? depths->end * (1 << 24) : scene->fog.end;

    if (!view->fog)
        return SHEEN_OK;
    const double part =
        view->orthographic ? (end - start) / (far - near) : (1 / start - 1 / end) / (1 / near - 1 / far);
    if (part * DEPTH_STEPS >= 256.01) /* the core's own count is rounded */
        return SHEEN_OK;
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                         "--fog: START and END are %.0f steps of 16-bit depth apart, fewer than 256",
                         fmax(floor(part * DEPTH_STEPS), 0));
}

void sheen_scene_look(struct sheen_scene *scene)
{
    const struct sheen_options *options = scene->options;
    struct sheen_view *view = &scene->view;

    /* The fitted mesh lies within 1 of its centre; 0.05 more for rounding. */
    view->z_near = to_q24(fmax(options->distance - 1.05, 0.05));
    view->z_far = to_q24(options->distance + 1.05);
    view->fov = to_angle(options->fov);
    view->orthographic = options->ortho ? to_q24(options->distance) : 0;
    view->affine = (uint8_t)options->affine;
    view->dither = options->undithered < 0 ? scene->target->pixel != SHEEN_GREY256 : !options->undithered;
    if (options->edges == SHEEN_WIRE)
        view->dither = 0; /* the background is not dithered, and the faces have to look the same */
    memcpy(view->background, options->background, sizeof view->background);
    for (int i = 0; i < options->lights.count; i++) {
        const double *to = options->lights.to[i];
        double largest = fmax(fabs(to[0]), fmax(fabs(to[1]), fabs(to[2])));
        for (int k = 0; k < 3; k++) {
            if (options->lights.radius[i] > 0)
                scene->lights[i].at[k] = to_q24(to[k] - (k == 2 ? options->distance : 0));
            else
                scene->lights[i].to[k] = (sheen_q30_t)lround(to[k] / largest * (1 << 30));
        }
        scene->lights[i].points = &sheen_points;
        scene->lights[i].radius = (sheen_q16_t)ceil(options->lights.radius[i] * 65536);
        memcpy(scene->lights[i].color, options->lights.color[i], sizeof scene->lights[i].color);
        scene->lights[i].intensity = to_q16(1);
    }
    look_through_fog(scene);
}

/* Sets each material's texture, and its base unless the file gives one: as asked for, else what shows best. */
static void paint(struct sheen_scene *scene)
{
    static const uint8_t white[3] = {255, 255, 255};
    const struct sheen_paint *paint = &scene->options->color;
    const int is_matcap = scene->options->shade >= SHEEN_MATCAP;
    const int shows_colors = scene->texel_count || scene->has_colors || is_matcap;
    const int shows_white = scene->target->pixel > SHEEN_RGB565_LE || shows_colors;

    for (size_t i = 0; i < scene->count; i++) {
        struct sheen_material *material = &scene->materials[i];
        material->texture = is_matcap ? &scene->matcap.texture : scene->own_texture[i];
        if (scene->own_color[i])
            continue;
        const int is_asked = paint->given && !(paint->from_file && shows_colors);
        memcpy(material->base, shows_white && !is_asked ? white : paint->color, sizeof material->base);
    }
}

/* ---- the frame's memory ---- */

/*
 * Makes the arena for all meshes. pieces: room for pieces of clipped triangles, 0 for the core's default; how many a
 * frame needs is not known before it is clipped. The same holds for clipped edges, whose cut ends are new vertices.
 */
static int make_frame(struct sheen_scene *scene, unsigned pieces)
{
    struct sheen_config *config = &scene->config;
    uint32_t vertices = 0, triangles = pieces;

    for (size_t i = 0; i < scene->count; i++) {
        vertices += scene->meshes[i].mesh.vertices;
        triangles += scene->meshes[i].mesh.triangles;
    }
    const int wants_edges = sheen_scene_edging(scene) != SHEEN_NO_EDGES;
    uint32_t edges = wants_edges ? 3 * triangles + triangles / 64 + 1 : 0; /* an upper bound for all edges */
    vertices += wants_edges ? 4 * pieces : 0;
    *config = (struct sheen_config){.target = scene->target,
                                    .band_rows = (uint16_t)scene->options->band,
                                    .buffers = (uint8_t)scene->options->buffers,
                                    .max_vertices = (uint16_t)(vertices < UINT16_MAX ? vertices : UINT16_MAX),
                                    .max_triangles = (uint16_t)(triangles < UINT16_MAX ? triangles : UINT16_MAX),
                                    .max_draws = (uint16_t)scene->count,
                                    .max_clipped = (uint16_t)pieces,
                                    .clipper = &sheen_clipper,
                                    .max_edges = (uint16_t)(edges < UINT16_MAX ? edges : UINT16_MAX),
                                    .smooth = wants_edges && scene->target->pixel != SHEEN_GREY2};
    size_t size = sheen_arena_size(config);
    if (size == 0)
        return SHEEN_ERR_ARGUMENT;
    free(scene->arena);
    scene->arena = malloc(size);
    if (!scene->arena)
        return SHEEN_ERR_MEMORY;
    return sheen_init(&scene->frame, scene->arena, &size, config);
}

/* Keeps the room for pieces that the last frame needed. */
int sheen_scene_retarget(struct sheen_scene *scene, const struct sheen_target *target)
{
    scene->target = target;
    sheen_scene_look(scene);
    return make_frame(scene, scene->config.max_clipped);
}

int sheen_scene_open(struct sheen_scene *scene, const struct sheen_options *options, const struct sheen_target *target,
                     struct sheen_problem *problem)
{
    memset(scene, 0, sizeof *scene);
    scene->options = options;
    int error = load(scene, problem);
    if (error)
        return error;
    error = sheen_scene_retarget(scene, target);
    if (error)
        return sheen_problem(problem, error, "%s: %s", options->mesh, sheen_strerror(error));
    error = sheen_scene_check_fog(scene, problem);
    scene->is_usage = error != SHEEN_OK;
    return error;
}

void sheen_scene_close(struct sheen_scene *scene)
{
    for (size_t i = 0; i < scene->count; i++)
        sheen_quantised_free(&scene->meshes[i]);
    for (size_t i = 0; i < scene->texel_count && scene->texels; i++)
        sheen_texels_free(&scene->texels[i]);
    free(scene->texels);
    free(scene->meshes);
    free(scene->materials);
    free(scene->morphs);
    free(scene->own_color);
    free(scene->own_texture);
    sheen_texels_free(&scene->matcap);
    free(scene->arena);
    memset(scene, 0, sizeof *scene);
}

/* ---- a frame ---- */

/* The material of faces with `--edges wire`: the background's colour, so that they are unseen but still hide lines. */
static struct sheen_material hidden_faces(const struct sheen_options *options)
{
    struct sheen_material material = {.ambient = to_q16(1)};

    memcpy(material.base, options->background, sizeof material.base);
    memcpy(material.line, line_color(options), sizeof material.line);
    return material;
}

enum sheen_shading sheen_scene_shading(const struct sheen_scene *scene)
{
    enum sheen_shading asked = (enum sheen_shading)scene->options->shade;

    return sheen_scene_corners_alone(scene) && asked > SHEEN_GOURAUD && asked < SHEEN_MATCAP ? SHEEN_GOURAUD : asked;
}

enum sheen_edging sheen_scene_edging(const struct sheen_scene *scene)
{
    const struct sheen_options *options = scene->options;

    if (options->edges >= 0)
        return (enum sheen_edging)options->edges;
    if (scene->edgeless || options->opacity < 1)
        return SHEEN_NO_EDGES;
    return scene->target->pixel == SHEEN_GREY2 ? SHEEN_OUTLINE : SHEEN_SMOOTH;
}

void sheen_scene_pose(const struct sheen_scene *scene, int number, struct sheen_pose *pose)
{
    const struct sheen_options *options = scene->options;

    sheen_pose_orbit(pose, to_angle(options->yaw + number * options->yaw_step), to_angle(options->pitch),
                     to_angle(options->roll), to_q24(options->distance));
}

static const struct sheen_shader *shader_at(const struct sheen_scene *scene, size_t i)
{
    const enum sheen_shading shading = sheen_scene_shading(scene);
    const int is_colored = sheen_scene_is_colored(scene);
    const struct sheen_shader *colored = is_colored ? sheen_colored_shader_of(shading) : NULL;

    if (scene->options->edges == SHEEN_WIRE)
        return &sheen_flat;
    if (scene->materials[i].texture && shading < SHEEN_MATCAP)
        return sheen_textured_shader_of(shading, is_colored);
    return colored ? colored : sheen_shader_of(shading);
}

void sheen_scene_object(const struct sheen_scene *scene, int number, size_t i, struct sheen_object *object)
{
    const struct sheen_options *options = scene->options;
    const int wire = options->edges == SHEEN_WIRE;

    *object = (struct sheen_object){.mesh = &scene->meshes[i].mesh,
                                    .material = wire ? &scene->hidden : &scene->materials[i],
                                    .shader = shader_at(scene, i),
                                    .lights = scene->lights,
                                    .light_count = (uint8_t)(wire ? 0 : options->lights.count),
                                    .stipple = &sheen_stipple,
                                    .transparency = (uint8_t)(wire ? 0 : 64 - (int)floor(64 * options->opacity + 0.5)),
                                    .phase = (uint8_t)options->phase,
                                    .two_sided = (uint8_t)options->two_sided,
                                    .morph = options->morph ? &scene->morphs[i] : NULL,
                                    .edges = sheen_edges_of(sheen_scene_edging(scene))};
    sheen_scene_pose(scene, number, &object->pose);
}

static int draw_all(struct sheen_scene *scene, int number)
{
    struct sheen_object object;

    paint(scene);
    scene->hidden = hidden_faces(scene->options);
    int error = sheen_begin(scene->frame, &scene->view);
    for (size_t i = 0; !error && i < scene->count; i++) {
        scene->morphs[i].weight = (uint16_t)lround(scene->options->morph_weight * 32768);
        sheen_scene_object(scene, number, i, &object);
        error = sheen_draw(scene->frame, &object);
    }
    return error;
}

/* 1 if the edges, or the vertices at their cut ends, need more room than this frame has, which is the most possible. */
static int edges_are_too_many(const struct sheen_scene *scene)
{
    const enum sheen_subject about = sheen_frame_about(scene->frame, NULL);

    return about == SHEEN_ABOUT_MAX_EDGES ||
           (about == SHEEN_ABOUT_MAX_USED && scene->config.max_vertices == UINT16_MAX);
}

/*
 * Close to the eye more triangles may be cut than the frame has room for; then it is made anew with more room. If the
 * edges are too many for any frame and were not asked for, they are left out.
 */
int sheen_scene_begin(struct sheen_scene *scene, int number)
{
    int error = SHEEN_OK;

    if (sheen_scene_edging(scene) != SHEEN_NO_EDGES && scene->config.max_edges == 0)
        error = make_frame(scene, scene->config.max_clipped);
    if (!error)
        error = draw_all(scene, number);
    for (unsigned pieces = 256; error == SHEEN_ERR_CAPACITY && pieces <= UINT16_MAX / 2 + 1; pieces *= 2) {
        if (scene->options->edges < 0 && edges_are_too_many(scene))
            scene->edgeless = 1;
        error = make_frame(scene, pieces);
        if (!error)
            error = draw_all(scene, number);
    }
    return error;
}

int sheen_scene_draw(struct sheen_scene *scene, int number)
{
    int error = sheen_scene_begin(scene, number);

    return error ? error : sheen_end(scene->frame);
}
