/*
 * cmd_bake.c - `sheen bake`: a mesh, a matcap, a power table or a ramp, as const data for a firmware's flash.
 *
 * Triangles keep the file's order, so that of several triangles at equal depth the same one stays visible as when the
 * file is rendered. Another order would gain nothing: the core transforms each vertex once in any order.
 */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bake_name.h"
#include "bake_text.h"
#include "builtin.h"
#include "commands.h"
#include "frame_name.h"
#include "matcaps.h"
#include "out_file.h"
#include "progress.h"
#include "ramps.h"
#include "report.h"
#include "scene.h"
#include "textures_out.h"

/* Everything between the mesh file and the header. */
struct baking {
    const struct sheen_options *options;
    struct sheen_host_mesh host;
    struct sheen_quantised *meshes;
    struct sheen_group *groups;
    size_t count;
    uint32_t *pictures; /* per mesh, its part's `picture`: 1 + the texture's number, or 0 */
    struct sheen_texels *texels;
    /* In place of a mesh, what shine:N, matcap:NAME or ramp:gamma makes. */
    struct sheen_shine shine;
    struct sheen_texels matcap;
    struct sheen_ramp ramp;
    char name[48];
    char source[900]; /* the command line: up to three file names, at most 255 bytes each */
};

#define PLANNED_VIEWS 12 /* over one turn */
#define SHINE "shine:"
#define MATCAP "matcap:"
#define RAMP "ramp:"

/* What follows `kind` (SHINE, MATCAP or RAMP) in the operand; NULL: the operand does not begin with it. */
static const char *behind(const char *kind, const struct sheen_options *options)
{
    size_t length = strlen(kind);

    return strncmp(options->mesh, kind, length) == 0 ? options->mesh + length : NULL;
}

/* *with: a copy of the options whose ramp is the operand's. 0, or SHEEN_ERR_ARGUMENT and *problem. */
static int read_ramp(struct sheen_options *with, const struct sheen_options *options, struct sheen_problem *problem)
{
    *with = *options;
    if (sheen_ramp_read(&with->ramp, behind(RAMP, options)) == 0 && with->ramp.kind == SHEEN_RAMP_GAMMA)
        return sheen_ramp_check(with, problem);
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                         "%s: gamma or gamma:G, G in %g..%g; sheen_ramp_half and sheen_ramp_toon are in the core",
                         options->mesh, SHEEN_LEAST_GAMMA, SHEEN_MOST_GAMMA);
}

/* The N of shine:N, or 0 and *problem. */
static unsigned shininess_of(const struct sheen_options *options, struct sheen_problem *problem)
{
    const char *digits = behind(SHINE, options);
    size_t length = strspn(digits, "0123456789");
    long n = length > 0 && length < 4 && digits[length] == '\0' ? strtol(digits, NULL, 10) : 0;

    if (n < 1 || n > 128) {
        sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: a shininess is a whole number, 1 to 128", options->mesh);
        return 0;
    }
    return (unsigned)n;
}

static int check(const struct sheen_options *options, struct sheen_sim_choice *choice, struct sheen_problem *problem)
{
    if (!options->out)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "no output given (-o mesh.h)");
    if (options->name && !sheen_bake_is_name(options->name))
        return sheen_problem(
            problem, SHEEN_ERR_ARGUMENT,
            "--name '%s': not a C identifier of 1..39 letters, or a keyword or another name that C or sheen has",
            options->name);
    if (sheen_bake_is_own_header(options->out))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                             "%s: sheen has a header of that name, which the output includes", options->out);
    int error = sheen_textures_out_check(options, problem);
    if (error)
        return error;
    if (behind(SHINE, options))
        return shininess_of(options, problem) ? SHEEN_OK : SHEEN_ERR_ARGUMENT;
    const char *matcap = behind(MATCAP, options);
    if (matcap)
        return *matcap ? SHEEN_OK
                       : sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s no name; " SHEEN_MATCAP_NAMES " or a picture",
                                       options->mesh);
    if (behind(RAMP, options)) {
        struct sheen_options with;
        return read_ramp(&with, options, problem);
    }
    error = sheen_turntable_check(choice, options, problem);
    return error ? error : sheen_builtin_check(options->mesh, problem);
}

/* Appends words to the source; what does not fit is cut off. */
__attribute__((format(printf, 2, 3))) static void add_source(struct baking *baking, const char *format, ...)
{
    size_t used = strlen(baking->source);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(baking->source + used, sizeof baking->source - used, format, arguments);
    va_end(arguments);
}

static void add_texture_source(struct baking *baking)
{
    static const char *const wraps[] = {"file", "repeat", "clamp"};
    const struct sheen_options *options = baking->options;

    if (strcmp(options->texture, "file") != 0)
        add_source(baking, " --texture %s", sheen_file_of(options->texture));
    if (options->bilinear)
        add_source(baking, " --filter bilinear");
    if (options->wrap)
        add_source(baking, " --wrap %s", wraps[options->wrap]);
    if (options->texture_log2 != 8)
        add_source(baking, " --texture-size %u", 1u << options->texture_log2);
    if (options->palette)
        add_source(baking, " --palette %d", options->palette);
    if (options->alpha_cutoff >= 0)
        add_source(baking, " --alpha-cutoff %g", options->alpha_cutoff);
}

/* The command line that makes the same header, but without folders, which differ from machine to machine. */
static void set_source(struct baking *baking)
{
    const struct sheen_options *options = baking->options;

    add_source(baking, "sheen bake %s", sheen_file_of(options->mesh));
    if (options->average)
        add_source(baking, " --normals average");
    if (options->equal)
        add_source(baking, " --weights equal");
    if (options->crease != 60)
        add_source(baking, " --crease %g", options->crease);
    if (options->up >= 0)
        add_source(baking, " --up %s", options->up ? "z" : "y");
    if (options->reduce)
        add_source(baking, " --reduce %d", options->reduce);
    if (options->morph)
        add_source(baking, " --morph %s", sheen_file_of(options->morph));
    if (options->morph_target)
        add_source(baking, " --morph-target %d", options->morph_target);
    if (options->groups)
        add_source(baking, " --groups");
    if (options->no_flat)
        add_source(baking, " --no-flat");
    if (options->bake_edges)
        add_source(baking, " --edges");
    if (options->no_vertex_colors)
        add_source(baking, " --vertex-colors off");
    add_texture_source(baking);
}

static int quantise(struct baking *baking)
{
    size_t parts = baking->host.part_count;

    baking->meshes = calloc(parts, sizeof *baking->meshes);
    baking->groups = calloc(parts, sizeof *baking->groups);
    baking->pictures = calloc(parts, sizeof *baking->pictures);
    if (!baking->meshes || !baking->groups || !baking->pictures)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 0; i < parts; i++) {
        int error = sheen_quantise(&baking->meshes[baking->count], &baking->host, (uint32_t)i);
        if (error)
            return error;
        baking->pictures[baking->count] = baking->host.part[i].picture;
        struct sheen_group *group = &baking->groups[baking->count++];
        *group = baking->host.group[baking->host.part[i].group];
        if (!group->has_color)
            memcpy(group->color, baking->options->color.color, sizeof group->color);
    }
    return sheen_scene_texels(&baking->texels, &baking->host, baking->options);
}

/* ---- the report ---- */

/* The largest errors of the quantised vertices: of a position, relative to the radius; of a normal, in radians. */
static void measure(const struct sheen_host_mesh *host, double *position, double *normal)
{
    *position = *normal = 0;
    for (size_t i = 0; i < host->vertex_count; i++) {
        const struct sheen_host_vertex *vertex = &host->vertices[i];
        int16_t q[3];
        double off = 0, cross = 0, length = 0;

        sheen_quantise_unit(vertex->normal, q);
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            double d = vertex->position[k] - floor(vertex->position[k] * 32767 + 0.5) / 32767;
            double c = vertex->normal[u] * q[v] - vertex->normal[v] * q[u];
            off += d * d;
            cross += c * c;
            length += q[k] * q[k];
        }
        *position = fmax(*position, sqrt(off));
        *normal = fmax(*normal, sqrt(cross / length));
    }
}

/* An edge between two triangles is stored with both and counted once. Edges inside polygons are not the file's own. */
static void report_edges(const struct baking *baking, uint32_t triangles)
{
    uint32_t edges = 0, sharp = 0, borders = 0;

    for (size_t i = 0; i < baking->count; i++) {
        const struct sheen_mesh *mesh = &baking->meshes[i].mesh;
        for (uint32_t h = 0; h < 3u * mesh->triangles; h++) {
            const struct sheen_triangle_edges *e = &mesh->edges[h / 3];
            uint32_t k = h % 3, other = e->across[k];
            if ((e->inner >> k & 1) != 0 || (other != SHEEN_NO_TRIANGLE && other < h / 3))
                continue;
            edges++;
            borders += other == SHEEN_NO_TRIANGLE;
            sharp += e->sharp >> k & 1;
        }
    }
    printf("edges: %u, %u of them sharp, %u borders; %zu B of the flash\n", edges, sharp, borders,
           triangles * sizeof(struct sheen_triangle_edges));
}

static void report(const struct baking *baking)
{
    uint32_t vertices = 0, triangles = 0, polygons = 0;
    size_t bytes = 0, texture_bytes = 0;
    double position, normal;

    for (size_t i = 0; i < baking->count; i++) {
        vertices += baking->meshes[i].mesh.vertices;
        triangles += baking->meshes[i].mesh.triangles;
        polygons += baking->meshes[i].polygon_count;
        bytes += sheen_bake_bytes(&baking->meshes[i], !baking->options->no_flat, baking->options->bake_edges);
    }
    for (size_t i = 0; i < baking->host.picture_count; i++)
        texture_bytes += sheen_texels_bytes(&baking->texels[i]);
    measure(&baking->host, &position, &normal);
    printf("%s: %u vertices, %u triangles, %u polygons", baking->name, vertices, triangles, polygons);
    printf(baking->options->groups ? ", %zu groups\n" : "\n", baking->count);
    printf("flash: %zu B", bytes + texture_bytes);
    if (baking->host.picture_count)
        printf(", %zu B of them texture%s", texture_bytes, baking->host.picture_count > 1 ? "s" : "");
    putchar('\n');
    if (baking->options->bake_edges)
        report_edges(baking, triangles);
    printf("rounding: positions by at most %.2g of the radius, normals by at most %.2g rad\n", position, normal);
    printf("one unit is %.9g of the file's, its origin at %.9g %.9g %.9g\n", baking->host.radius,
           baking->host.center[0], baking->host.center[1], baking->host.center[2]);
}

/* ---- the command ---- */

/* Writes what the command makes. The stream is in memory, so that the file appears whole or not at all. */
static int write_text(const struct baking *baking, FILE *stream)
{
    const struct sheen_bake bake = {.meshes = baking->meshes,
                                    .groups = baking->options->groups ? baking->groups : NULL,
                                    .count = baking->count,
                                    .texels = baking->texels,
                                    .texel_count = baking->host.picture_count,
                                    .pictures = baking->pictures,
                                    .name = baking->name,
                                    .source = baking->source,
                                    .flat = !baking->options->no_flat,
                                    .edges = baking->options->bake_edges};

    if (behind(SHINE, baking->options))
        return sheen_bake_shine_text(stream, &baking->shine, baking->name, baking->source);
    if (behind(RAMP, baking->options))
        return sheen_bake_ramp_text(stream, &baking->ramp, baking->name, baking->source);
    if (behind(MATCAP, baking->options))
        return sheen_bake_texture_text(stream, &baking->matcap, baking->name, baking->source);
    return sheen_bake_text(stream, &bake);
}

static int write_header(const struct baking *baking, struct sheen_problem *problem)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    int error = stream ? write_text(baking, stream) : SHEEN_ERR_MEMORY;

    if (stream && fclose(stream) != 0)
        error = SHEEN_ERR_MEMORY;
    error = error ? sheen_problem(problem, error, "%s: not enough memory", baking->options->out)
                  : sheen_out_file(baking->options->out, text, size, problem);
    free(text);
    return error;
}

static void set_name(struct baking *baking)
{
    if (baking->options->name)
        snprintf(baking->name, sizeof baking->name, "%s", baking->options->name);
    else
        sheen_bake_name(baking->name, 40, baking->options->out);
}

/* Prints a brief plan of the mesh as `sheen plan` makes it: for the given band height, or for 4, 8 and 16 rows. */
static int plan_briefly(const struct baking *baking, const struct sheen_sim_choice *choice,
                        struct sheen_problem *problem)
{
    struct sheen_options options = *baking->options;
    struct sheen_plan *plan = malloc(sizeof *plan);
    int error = plan ? SHEEN_OK : sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", options.mesh);

    options.quiet = 1;
    for (int rows = 4; rows <= 16 && !error; rows *= 2) {
        options.band = baking->options->band ? baking->options->band : rows;
        error = sheen_plan_make(plan, &options, choice, PLANNED_VIEWS, problem);
        if (!error)
            sheen_plan_brief(stdout, plan);
        if (baking->options->band)
            break;
    }
    free(plan);
    return error;
}

static enum sheen_exit bake_shine(struct baking *baking)
{
    struct sheen_problem problem;

    set_name(baking);
    snprintf(baking->source, sizeof baking->source, "sheen bake %s", baking->options->mesh);
    int error = sheen_shine_make(&baking->shine, shininess_of(baking->options, &problem));
    if (!error)
        error = write_header(baking, &problem);
    if (error)
        return sheen_fail(SHEEN_EXIT_FAILURE, &problem);
    printf("%s: the power table of shininess %u\nflash: %zu B\n", baking->name, baking->shine.shininess,
           sizeof baking->shine);
    return SHEEN_EXIT_OK;
}

static enum sheen_exit bake_ramp(struct baking *baking)
{
    struct sheen_options with;
    struct sheen_problem problem;

    set_name(baking);
    int error = read_ramp(&with, baking->options, &problem);
    if (!error) {
        baking->ramp = *sheen_ramp_of(&baking->ramp, &with);
        add_source(baking, "sheen bake %s", with.mesh);
        if (with.ambient != 0.2)
            add_source(baking, " --ambient %g", with.ambient);
        if (with.diffuse != 0.8)
            add_source(baking, " --diffuse %g", with.diffuse);
        error = write_header(baking, &problem);
    }
    if (error)
        return sheen_fail(SHEEN_EXIT_FAILURE, &problem);
    printf("%s: the ramp of gamma %g, for ambient light %g and diffuse %g\nflash: %u B\n", baking->name,
           with.ramp.gamma, with.ambient, with.diffuse, SHEEN_RAMP_BYTES);
    return SHEEN_EXIT_OK;
}

static enum sheen_exit bake_matcap(struct baking *baking)
{
    const struct sheen_options *options = baking->options;
    const char *name = behind(MATCAP, options);
    struct sheen_problem problem;

    set_name(baking);
    add_source(baking, "sheen bake " MATCAP "%s", sheen_file_of(name));
    if (options->bilinear)
        add_source(baking, " --filter bilinear");
    if (options->palette)
        add_source(baking, " --palette %d", options->palette);
    int error = sheen_matcap_load(&baking->matcap, name, (unsigned)options->palette, options->bilinear, &problem);
    if (!error)
        error = sheen_textures_out(options, &baking->matcap, 1, &problem);
    if (!error)
        error = write_header(baking, &problem);
    if (!error)
        printf("%s: a matcap of %ux%u texels\nflash: %zu B\n", baking->name, 1u << baking->matcap.texture.width_log2,
               1u << baking->matcap.texture.height_log2, sheen_texels_bytes(&baking->matcap));
    sheen_texels_free(&baking->matcap);
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}

static int bake(struct baking *baking, struct sheen_problem *problem)
{
    const struct sheen_options *options = baking->options;
    const struct sheen_texture_options textures = sheen_scene_texture_options(options);
    struct sheen_host_options how = sheen_scene_host_options(options, options->groups);

    how.textures = &textures;
    sheen_progress("reading the mesh", 0, 0);
    int error = sheen_host_mesh_load(&baking->host, options->mesh, &how, problem);
    sheen_progress_end();

    if (error)
        return error;
    sheen_notes_print(&baking->host.notes, options->groups);
    set_name(baking);
    set_source(baking);
    error = quantise(baking);
    if (error)
        return sheen_problem(problem, error, "%s: %s", options->mesh, sheen_strerror(error));
    error = sheen_textures_out(options, baking->texels, baking->host.picture_count, problem);
    return error ? error : write_header(baking, problem);
}

enum sheen_exit sheen_cmd_bake(struct sheen_options *options)
{
    struct baking baking = {.options = options};
    struct sheen_sim_choice choice;
    struct sheen_problem problem;

    if (check(options, &choice, &problem) != 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    if (behind(SHINE, options))
        return bake_shine(&baking);
    if (behind(MATCAP, options))
        return bake_matcap(&baking);
    if (behind(RAMP, options))
        return bake_ramp(&baking);
    int error = bake(&baking, &problem);
    if (!error) {
        report(&baking);
        error = plan_briefly(&baking, &choice, &problem);
    }
    for (size_t i = 0; i < baking.count; i++)
        sheen_quantised_free(&baking.meshes[i]);
    free(baking.meshes);
    free(baking.groups);
    free(baking.pictures);
    for (size_t i = 0; baking.texels && i < baking.host.picture_count; i++)
        sheen_texels_free(&baking.texels[i]);
    free(baking.texels);
    sheen_host_mesh_free(&baking.host);
    return error ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : SHEEN_EXIT_OK;
}
