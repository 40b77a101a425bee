/*
 * turntable.c - a mesh that turns on a simulated panel.
 */
#include "turntable.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "glass.h"

static sheen_q16_t to_q16(double x)
{
    return (sheen_q16_t)lround(x * 65536);
}

static sheen_q24_t to_q24(double x)
{
    return (sheen_q24_t)lround(x * 16777216);
}

/* Any finite angle in degrees to turns. fmod is exact, so a million turns too many lose nothing. */
static sheen_angle_t to_angle(double degrees)
{
    return (sheen_angle_t)(int64_t)llround(fmod(degrees, 360) / 360 * 4294967296.0);
}

/* ---- what is drawn ---- */

static int prepare_material(struct sheen_material *material, const struct sheen_options *options,
                            const uint8_t color[3])
{
    memset(material, 0, sizeof *material);
    memcpy(material->base, color, sizeof material->base);
    memset(material->highlight, 255, sizeof material->highlight);
    material->ambient = to_q16(options->ambient);
    material->diffuse = to_q16(options->diffuse);
    material->specular = to_q16(options->specular);
    material->shininess = (uint8_t)options->shininess;
    return sheen_material_prepare(material);
}

/* One mesh of everything, or one a material that has faces. */
static int make_meshes(struct sheen_turntable *table, const struct sheen_host_mesh *host)
{
    const struct sheen_paint *paint = &table->options->color;
    size_t groups = paint->from_file ? host->group_count : 1;

    table->meshes = calloc(groups, sizeof *table->meshes);
    table->materials = calloc(groups, sizeof *table->materials);
    if (!table->meshes || !table->materials)
        return SHEEN_ERR_MEMORY;
    for (size_t g = 0; g < groups; g++) {
        const struct sheen_group *group = &host->group[g];
        int use_group = paint->from_file && group->has_color;
        int error = sheen_quantise(&table->meshes[table->count], host,
                                   paint->from_file ? (uint32_t)g : SHEEN_ALL_GROUPS);
        if (error == SHEEN_ERR_ARGUMENT)
            continue; /* a material without faces */
        if (!error)
            error = prepare_material(&table->materials[table->count], table->options,
                                     use_group ? group->color : paint->color);
        if (error)
            return error;
        table->count++;
    }
    return SHEEN_OK;
}

static int load(struct sheen_turntable *table, struct sheen_problem *problem)
{
    const struct sheen_options *options = table->options;
    struct sheen_host_options how = {.average = options->average,
                                     .by_group = options->color.from_file,
                                     .use_crease = options->crease >= 0,
                                     .crease = options->crease};
    struct sheen_host_mesh host;
    int error = sheen_host_mesh_load(&host, options->mesh, &how, problem);

    if (error)
        return error;
    error = make_meshes(table, &host);
    sheen_host_mesh_free(&host);
    return error ? sheen_problem(problem, error, "%s: %s", options->mesh, sheen_strerror(error)) : SHEEN_OK;
}

static void set_view(struct sheen_turntable *table)
{
    const struct sheen_options *options = table->options;
    struct sheen_view *view = &table->view;

    /* The fitted mesh lies within 1 of its centre; 0.05 more for rounding. */
    view->near = to_q24(fmax(options->distance - 1.05, 0.05));
    view->far = to_q24(options->distance + 1.05);
    view->fov = to_angle(options->fov);
    view->affine = (uint8_t)options->affine;
    memcpy(view->background, options->background, sizeof view->background);
    for (int i = 0; i < options->lights.count; i++) {
        const double *to = options->lights.to[i];
        double largest = fmax(fabs(to[0]), fmax(fabs(to[1]), fabs(to[2])));
        for (int k = 0; k < 3; k++)
            table->lights[i].to[k] = (sheen_q30_t)lround(to[k] / largest * (1 << 30));
        table->lights[i].intensity = to_q16(1);
        table->lights[i].highlight = 1;
    }
}

/* ---- where ---- */

/*
 * An arena for all of the meshes. pieces: of clipped triangles, 0 for the core's
 * default; how many there will be is not known before they are cut.
 */
static int make_frame(struct sheen_turntable *table, unsigned pieces)
{
    struct sheen_config *config = &table->config;
    uint32_t vertices = 0, triangles = pieces;

    for (size_t i = 0; i < table->count; i++) {
        vertices += table->meshes[i].mesh.vertices;
        triangles += table->meshes[i].mesh.triangles;
    }
    *config = (struct sheen_config){.target = sheen_sim_panel_target(table->panel),
                                    .band_rows = (uint16_t)table->options->band,
                                    .buffers = (uint8_t)table->options->buffers,
                                    .max_vertices = (uint16_t)vertices,
                                    .max_triangles = (uint16_t)(triangles < UINT16_MAX ? triangles : UINT16_MAX),
                                    .max_draws = (uint16_t)table->count,
                                    .max_clipped = (uint16_t)pieces};
    size_t size = sheen_arena_size(config);
    if (size == 0)
        return SHEEN_ERR_ARGUMENT;
    free(table->arena);
    table->arena = malloc(size);
    if (!table->arena)
        return SHEEN_ERR_MEMORY;
    return sheen_init(&table->frame, table->arena, &size, config);
}

int sheen_turntable_open(struct sheen_turntable *table, const struct sheen_options *options,
                         const struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    size_t pixels = (size_t)choice->width * choice->height;

    memset(table, 0, sizeof *table);
    table->options = options;
    table->choice = *choice;
    int error = load(table, problem);
    if (error)
        return error;
    set_view(table);
    table->values = malloc(pixels * sizeof *table->values);
    table->rgb = malloc(pixels * 3);
    error = table->values && table->rgb ? sheen_sim_panel_open(&table->panel, choice) : SHEEN_ERR_MEMORY;
    if (!error)
        error = sheen_sim_panel_init(table->panel);
    if (!error)
        error = make_frame(table, 0);
    return error ? sheen_problem(problem, error, "%s: %s", options->mesh, sheen_strerror(error)) : SHEEN_OK;
}

void sheen_turntable_close(struct sheen_turntable *table)
{
    for (size_t i = 0; i < table->count; i++)
        sheen_quantised_free(&table->meshes[i]);
    free(table->meshes);
    free(table->materials);
    free(table->arena);
    free(table->values);
    free(table->rgb);
    if (table->panel)
        sheen_sim_panel_close(table->panel);
    memset(table, 0, sizeof *table);
}

/* ---- a frame ---- */

static int draw_all(struct sheen_turntable *table, int number)
{
    const struct sheen_options *options = table->options;
    struct sheen_draw draw = {.lights = table->lights,
                              .light_count = (uint8_t)options->lights.count,
                              .shading = (uint8_t)options->shade,
                              .two_sided = (uint8_t)options->two_sided};

    sheen_pose_orbit(&draw.pose, to_angle(options->yaw + number * options->yaw_step), to_angle(options->pitch),
                     to_angle(options->roll), to_q24(options->distance));
    int error = sheen_begin(table->frame, &table->view);
    for (size_t i = 0; !error && i < table->count; i++) {
        draw.mesh = &table->meshes[i].mesh;
        draw.material = &table->materials[i];
        error = sheen_draw(table->frame, &draw);
    }
    return error;
}

/* Close to the eye more triangles are cut than the frame has room for: it is made anew with more. */
static int draw_with_room(struct sheen_turntable *table, int number)
{
    int error = draw_all(table, number);

    for (unsigned pieces = 256; error == SHEEN_ERR_CAPACITY && pieces <= UINT16_MAX / 2 + 1; pieces *= 2) {
        error = make_frame(table, pieces);
        if (!error)
            error = draw_all(table, number);
    }
    if (!error)
        error = sheen_end(table->frame);
    return error ? error : sheen_wait(table->frame);
}

static int read_picture(struct sheen_turntable *table)
{
    size_t pixels = (size_t)table->choice.width * table->choice.height;
    int error = sheen_sim_panel_picture(table->panel, table->values);

    for (size_t i = 0; !error && i < pixels; i++)
        sheen_sim_expand(table->values[i], sheen_sim_panel_levels(table->panel), table->rgb + 3 * i);
    return error;
}

int sheen_turntable_draw(struct sheen_turntable *table, int number, struct sheen_problem *problem)
{
    const char *panel = table->choice.record ? table->choice.record->name : "ideal";

    sheen_sim_bus_counters_reset(sheen_sim_panel_bus(table->panel));
    int error = draw_with_room(table, number);
    if (error)
        return sheen_problem(problem, error, "%s: %s", table->options->mesh, sheen_strerror(error));
    if (sheen_sim_panel_complaints(table->panel) > 0)
        return sheen_problem(problem, SHEEN_ERR_BUS, "%s: the controller complains: %s", panel,
                             sheen_sim_panel_complaint(table->panel));
    error = read_picture(table);
    return error ? sheen_problem(problem, error, "%s: %s", panel, sheen_strerror(error)) : SHEEN_OK;
}
