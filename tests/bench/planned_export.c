/*
 * planned_export.c - writes the scenes of the file `planned` as C for boards, and counts the features of their frames.
 *
 *   planned_export SCENES OUT.c    prints a line per frame: its name and number, then feature=count; and the bytes of
 *                                  its arena on a 32-bit processor, as `sheen plan` reports them
 *   planned_export                 prints the names of the features
 *
 * A line of SCENES is a name and the words of `sheen plan`. The bench's own frames follow (planned_bench.c).
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_text.h"
#include "memory.h"
#include "planned.h"
#include "run.h"

#define WORDS 64

static const struct sheen_command plan = {"plan", "MESH", "", SHEEN_PLAN, NULL};
static struct sheen_plan_run run;

static int fail(const char *name, const char *text)
{
    fprintf(stderr, "planned_export: %s: %s\n", name, text);
    return -1;
}

/* ---- what is printed ---- */

static void print_counts(const char *name, int number, const struct sheen_plan_counts *counts)
{
    printf("%s %d", name, number);
    for (unsigned i = 0; i < SHEEN_PLAN_COUNTS; i++)
        if (counts->of[i] > 0)
            printf(" %s=%" PRIu32, sheen_plan_feature_name(i), counts->of[i]);
    putchar('\n');
}

static void put_numbers(FILE *out, const char *name, const int32_t *numbers, int count)
{
    fprintf(out, ".%s = {", name);
    for (int i = 0; i < count; i++)
        fprintf(out, "%s%" PRId32, i ? ", " : "", numbers[i]);
    fputs("}, ", out);
}

static void put_pose(FILE *out, const struct sheen_pose *pose)
{
    fputs("{", out);
    put_numbers(out, "rotation", pose->rotation, 9);
    fprintf(out, ".scale = %" PRId32 ", ", pose->scale);
    put_numbers(out, "translation", pose->translation, 3);
    fputs("},\n", out);
}

/* An object of the core that pointers refer to, and its name. */
struct named {
    const void *at;
    const char *name;
};

#define NAMED(x)                                                                                                       \
    {                                                                                                                  \
        &(x), "&" #x                                                                                                   \
    }

static const struct named shaders[] = {NAMED(sheen_flat),
                                       NAMED(sheen_gouraud),
                                       NAMED(sheen_phong),
                                       NAMED(sheen_slerp),
                                       NAMED(sheen_flat_colored),
                                       NAMED(sheen_gouraud_colored),
                                       NAMED(sheen_textured),
                                       NAMED(sheen_textured_flat),
                                       NAMED(sheen_textured_colored),
                                       NAMED(sheen_textured_flat_colored),
                                       NAMED(sheen_matcap_colored),
                                       NAMED(sheen_matcap_vertex_colored),
                                       NAMED(sheen_phong_colored),
                                       NAMED(sheen_slerp_colored),
                                       NAMED(sheen_matcap),
                                       NAMED(sheen_matcap_vertex),
                                       {NULL, NULL}};
static const struct named edgings[] = {
    NAMED(sheen_edges_smooth), NAMED(sheen_edges_outline), NAMED(sheen_edges_wire), {NULL, NULL}};
static const struct named ramps[] = {NAMED(sheen_ramp_half), NAMED(sheen_ramp_toon), {NULL, NULL}};

/* The object's name; `otherwise` if it is not in the list. */
static const char *name_of(const struct named *named, const void *at, const char *otherwise)
{
    for (; named->at; named++)
        if (named->at == at)
            return named->name;
    return otherwise;
}

/* The textures that are drawn: texture_N_0 and so on, the matcap last. */
static void put_texture_of(FILE *out, const struct sheen_scene *scene, const struct sheen_texture *texture, unsigned n)
{
    size_t i = 0;

    if (!texture)
        return;
    while (i < scene->texel_count && texture != &scene->texels[i].texture)
        i++;
    fprintf(out, ", .texture = &texture_%u_%zu", n, i);
}

static void put_material(FILE *out, const struct sheen_scene *scene, const struct sheen_material *m, unsigned n)
{
    char own[32];

    fprintf(
        out,
        "    {.base = {%u, %u, %u}, .highlight = {255, 255, 255}, .ambient_color = {%u, %u, %u}, .ambient = %" PRId32
        ", .diffuse = %" PRId32 ", .specular = %" PRId32 ", .line = {%u, %u, %u}",
        m->base[0], m->base[1], m->base[2], m->ambient_color[0], m->ambient_color[1], m->ambient_color[2], m->ambient,
        m->diffuse, m->specular, m->line[0], m->line[1], m->line[2]);
    if (m->shine)
        fprintf(out, ", .shine = &sheen_shine_%u", m->shine->shininess);
    snprintf(own, sizeof own, "&ramp_%u", n);
    if (m->ramp)
        fprintf(out, ", .ramp = %s", name_of(ramps, m->ramp, own));
    put_texture_of(out, scene, m->texture, n);
    fputs("},\n", out);
}

static void put_view(FILE *out, const struct sheen_view *v, unsigned n)
{
    fprintf(out,
            "    .view = {.fov = %" PRIu32 "u, .z_near = %" PRId32 ", .z_far = %" PRId32 ", .orthographic = %" PRId32
            ", .affine = %u, .dither = %u, .background = {%u, %u, %u}",
            v->fov, v->z_near, v->z_far, v->orthographic, v->affine, v->dither, v->background[0], v->background[1],
            v->background[2]);
    if (v->fog)
        fprintf(out, ", .fog = &fog_%u", n);
    fputs("},\n", out);
}

static void put_meshes(FILE *out, const struct sheen_scene *scene, unsigned n)
{
    const int edges = sheen_scene_edging(scene) != SHEEN_NO_EDGES;
    char name[32];

    for (size_t i = 0; i < scene->count; i++) {
        snprintf(name, sizeof name, "mesh_%u_%zu", n, i);
        const struct sheen_bake bake = {
            .meshes = &scene->meshes[i], .count = 1, .name = name, .source = "", .flat = 1, .edges = edges};
        sheen_bake_text(out, &bake);
        if (scene->options->morph)
            fprintf(out, "static const struct sheen_morph morph_%u_%zu = {&%s_second, &sheen_morpher, %u};\n", n, i,
                    name, scene->morphs[i].weight);
    }
    for (size_t i = 0; i <= scene->texel_count; i++) {
        const struct sheen_texels *texels = i < scene->texel_count ? &scene->texels[i] : &scene->matcap;
        snprintf(name, sizeof name, "texture_%u_%zu", n, i);
        if (i < scene->texel_count || scene->options->shade >= SHEEN_MATCAP)
            sheen_bake_texture_text(out, texels, name, "");
    }
    if (scene->ramp.reader) {
        snprintf(name, sizeof name, "ramp_%u", n);
        sheen_bake_ramp_text(out, &scene->ramp, name, "");
    }
}

static void put_lights(FILE *out, const struct sheen_scene *scene, unsigned n)
{
    const struct sheen_fog *fog = &scene->fog;

    fprintf(out, "static const struct sheen_light lights_%u[] = {", n);
    for (int i = 0; i < scene->options->lights.count; i++) {
        const struct sheen_light *light = &scene->lights[i];
        fputs("{", out);
        put_numbers(out, "to", light->to, 3);
        fprintf(out, ".intensity = %" PRId32 ", .color = {%u, %u, %u}}, ", light->intensity, light->color[0],
                light->color[1], light->color[2]);
    }
    fputs("};\n", out);
    if (scene->view.fog)
        fprintf(out,
                "static const struct sheen_fog fog_%u = {%" PRId32 ", %" PRId32 ", {%u, %u, %u}, &sheen_fog_mixer};\n",
                n, fog->start, fog->end, fog->color[0], fog->color[1], fog->color[2]);
}

/* Writes meshes, textures, materials, lights and objects of a scene that was drawn, as number `n`. */
static void put_objects(FILE *out, const struct sheen_scene *scene, unsigned n)
{
    struct sheen_object o;

    put_meshes(out, scene, n);
    put_lights(out, scene, n);
    fprintf(out, "static const struct sheen_material materials_%u[] = {\n", n);
    for (size_t i = 0; i < scene->count; i++) {
        sheen_scene_object(scene, 0, i, &o);
        put_material(out, scene, o.material, n);
    }
    fprintf(out, "};\nstatic const struct sheen_object objects_%u[] = {\n", n);
    for (size_t i = 0; i < scene->count; i++) {
        sheen_scene_object(scene, 0, i, &o);
        fprintf(out,
                "    {.mesh = &mesh_%u_%zu, .material = &materials_%u[%zu], .shader = %s, .lights = lights_%u, "
                ".light_count = %u, .two_sided = %u, .edges = %s",
                n, i, n, i, name_of(shaders, o.shader, "unknown"), n, o.light_count, o.two_sided,
                name_of(edgings, o.edges, "NULL"));
        if (o.transparency)
            fprintf(out, ", .stipple = &sheen_stipple, .transparency = %u, .phase = %u", o.transparency, o.phase);
        if (o.morph)
            fprintf(out, ", .morph = &morph_%u_%zu", n, i);
        fputs("},\n", out);
    }
    fputs("};\n", out);
}

/* Writes the entry of the table that refers to these, into `table` until all entries are known. */
static void put_entry(FILE *table, const char *name, const struct sheen_turntable *t, unsigned n)
{
    const struct sheen_scene *scene = &t->scene;
    const struct sheen_config *c = &scene->config;
    struct sheen_pose pose;

    fprintf(table,
            "{.name = \"%s\", .panel = \"%s\", .orientation = %u, .draws = %zu,\n"
            "    .config = {.band_rows = %u, .buffers = 1, .max_vertices = %u, .max_triangles = %u, .max_draws = %u, "
            ".max_clipped = %u, .clipper = &sheen_clipper, .max_edges = %u, .smooth = %u},\n",
            name, sheen_turntable_panel_name(t), t->choice.orientation, scene->count, c->band_rows, c->max_vertices,
            c->max_triangles, c->max_draws, c->max_clipped, c->max_edges, c->smooth);
    put_view(table, &scene->view, n);
    fputs("    .pose = {", table);
    for (int number = 0; number < PLANNED_FRAMES; number++) {
        sheen_scene_pose(scene, number, &pose);
        put_pose(table, &pose);
    }
    fprintf(table, "    },\n    .objects = objects_%u},\n", n);
}

/* ---- a line of SCENES, and the bench's own frames ---- */

static int export_scene(FILE *out, FILE *table, char *line, unsigned n)
{
    static struct sheen_options options;
    struct sheen_problem problem = {0};
    struct sheen_sim_choice choice;
    struct sheen_plan_counts counts;
    char *words[WORDS + 1], *name = strtok(line, " \n");
    int count = 0;

    words[count++] = name;
    words[count++] = "--edges";
    words[count++] = "none"; /* unless the line says otherwise */
    for (char *word = strtok(NULL, " \n"); word && count < WORDS; word = strtok(NULL, " \n"))
        words[count++] = word;
    words[count] = NULL;
    int error = sheen_options_parse(&options, &plan, count, words, &problem) == 1 ? 0 : -1;
    if (!error)
        error = sheen_turntable_choose(&choice, &options, &problem);
    if (!error)
        error = sheen_plan_open(&run, &options, &choice, &problem);
    for (int number = 0; !error && number < PLANNED_FRAMES; number++) {
        error = sheen_plan_draw(&run, number, 0, &problem);
        sheen_plan_sum(&run, &counts);
        if (!error)
            print_counts(name, number, &counts);
    }
    if (!error) {
        struct sheen_plan_ram ram;
        sheen_plan_ram(&ram, &run.table.scene.config, run.panel);
        printf("%s arena %" PRIu32 " \n", name, ram.arena);
        put_objects(out, &run.table.scene, n);
        put_entry(table, name, &run.table, n);
    }
    sheen_plan_close(&run);
    return error ? fail(name, problem.text) : 0;
}

static int count_bench(struct bench *bench, const char *name)
{
    static uint64_t arena[46 * 1024];
    struct sheen_plan_counts counts;
    struct sheen_stats stats;

    int error = bench_begin(bench, arena, sizeof arena);
    if (!error)
        error = bench_first(bench);
    sheen_plan_counts_begin();
    if (!error)
        error = bench_measured(bench);
    sheen_plan_counts_take(&counts);
    sheen_frame_stats(bench->frame, &stats);
    sheen_plan_count_push(&counts, SHEEN_RGB565_BE, 0, stats.pixels);
    counts.of[SHEEN_PLAN_PUSH] = stats.rectangles;
    sheen_plan_count_draws(&counts, bench->frame, 1, bench->scene->mesh.vertices);
    print_counts(name, 1, &counts);
    return error ? fail(name, sheen_strerror(error)) : 0;
}

static int export_all(FILE *scenes, FILE *out, FILE *table)
{
    static struct bench bench;
    char line[1000], name[40];
    unsigned n = 0;
    int error = 0, c;

    fputs("/* Made by planned_export.c. */\n#include \"planned.h\"\n\n", out);
    while (!error && fgets(line, sizeof line, scenes))
        if (*line != '#' && *line != '\n')
            error = export_scene(out, table, line, n++);
    for (unsigned i = 0; !error && planned_bench(&bench, i, name); i++)
        error = count_bench(&bench, name);
    fputs("\nconst struct planned planned[] = {\n", out);
    rewind(table);
    while ((c = getc(table)) != EOF)
        putc(c, out);
    fprintf(out, "};\nconst unsigned planned_count = %u;\n", n);
    return error;
}

int main(int argc, char **argv)
{
    for (unsigned i = 0; argc == 1 && i < SHEEN_PLAN_COUNTS; i++)
        puts(sheen_plan_feature_name(i));
    if (argc == 1)
        return 0;
    FILE *scenes = argc == 3 ? fopen(argv[1], "r") : NULL, *out = argc == 3 ? fopen(argv[2], "w") : NULL;
    FILE *table = tmpfile();

    if (!scenes || !out || !table) {
        perror(argc == 3 ? argv[1] : "usage: planned_export SCENES OUT.c");
        return 2;
    }
    int error = export_all(scenes, out, table);
    fclose(scenes);
    fclose(table);
    return error != 0 || fclose(out) != 0 || fflush(stdout) != 0;
}
