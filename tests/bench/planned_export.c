/*
 * planned_export.c - the scenes of the file `planned` as C for boards, and what their frames are made of.
 *
 *   planned_export SCENES OUT.c    prints a line a frame: its name and number, then feature=count; and the bytes of
 *                                  its arena on a processor of 32 bits, as `sheen plan` tells them
 *   planned_export                 prints the features
 *
 * A line of SCENES is a name and the words of `sheen plan`. The scenes of the bench (scenes.h) follow in every shading.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_text.h"
#include "memory.h"
#include "planned.h"
#include "run.h"
#include "scenes.h"

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

static void put_material(FILE *out, const struct sheen_material *m)
{
    fprintf(out,
            "    {.base = {%u, %u, %u}, .highlight = {255, 255, 255}, .ambient = %" PRId32 ", .diffuse = %" PRId32
            ", .specular = %" PRId32 ", .shine = &sheen_shine_%u},\n",
            m->base[0], m->base[1], m->base[2], m->ambient, m->diffuse, m->specular, m->shine->shininess);
}

static void put_view(FILE *out, const struct sheen_view *v)
{
    fprintf(out,
            "    .view = {.fov = %" PRIu32 "u, .z_near = %" PRId32 ", .z_far = %" PRId32 ", .orthographic = %" PRId32
            ", .affine = %u, .dither = %u, .background = {%u, %u, %u}},\n",
            v->fov, v->z_near, v->z_far, v->orthographic, v->affine, v->dither, v->background[0], v->background[1],
            v->background[2]);
}

/* The meshes and materials of a scene, at number `n`. */
static void put_objects(FILE *out, const struct sheen_scene *scene, unsigned n)
{
    char name[32];

    for (size_t i = 0; i < scene->count; i++) {
        snprintf(name, sizeof name, "mesh_%u_%zu", n, i);
        const struct sheen_bake bake = {.meshes = &scene->meshes[i], .count = 1, .name = name, .source = "", .flat = 1};
        sheen_bake_text(out, &bake);
    }
    fprintf(out, "static const struct sheen_mesh *const meshes_%u[] = {", n);
    for (size_t i = 0; i < scene->count; i++)
        fprintf(out, "&mesh_%u_%zu, ", n, i);
    fprintf(out, "};\nstatic const struct sheen_material materials_%u[] = {\n", n);
    for (size_t i = 0; i < scene->count; i++)
        put_material(out, &scene->materials[i]);
    fputs("};\n", out);
}

/* The entry of the table that refers to them: written to `table` until all are known. */
static void put_entry(FILE *table, const char *name, const struct sheen_turntable *t, unsigned n)
{
    const struct sheen_scene *scene = &t->scene;
    const struct sheen_config *c = &scene->config;
    struct sheen_pose pose;

    fprintf(table,
            "{.name = \"%s\", .panel = \"%s\", .orientation = %u, .shading = %d, .light_count = %d, .two_sided = %d,\n"
            "    .draws = %zu, .config = {.band_rows = %u, .buffers = 1, .max_vertices = %u, .max_triangles = %u, "
            ".max_draws = %u, .max_clipped = %u},\n",
            name, sheen_turntable_panel_name(t), t->choice.orientation, scene->options->shade,
            scene->options->lights.count, scene->options->two_sided, scene->count, c->band_rows, c->max_vertices,
            c->max_triangles, c->max_draws, c->max_clipped);
    put_view(table, &scene->view);
    fputs("    .lights = {", table);
    for (int i = 0; i < scene->options->lights.count; i++) {
        fputs("{", table);
        put_numbers(table, "to", scene->lights[i].to, 3);
        fputs("}, ", table);
    }
    fputs("},\n    .pose = {", table);
    for (int number = 0; number < PLANNED_FRAMES; number++) {
        sheen_scene_pose(scene, number, &pose);
        put_pose(table, &pose);
    }
    fprintf(table, "    },\n    .meshes = meshes_%u, .materials = materials_%u},\n", n, n);
}

/* ---- a line, and the bench's own ---- */

static int export_scene(FILE *out, FILE *table, char *line, unsigned n)
{
    static struct sheen_options options;
    struct sheen_problem problem = {0};
    struct sheen_sim_choice choice;
    struct sheen_plan_counts counts;
    char *words[WORDS + 1], *name = strtok(line, " \n");
    int count = 0;

    for (char *word = name; word && count < WORDS; word = strtok(NULL, " \n"))
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

static int count_bench(const struct bench_scene *scene, unsigned shading, int dither)
{
    static const char *const shadings[] = {"flat", "gouraud", "phong", "slerp"};
    static uint64_t arena[46 * 1024];
    struct sheen_plan_counts counts;
    struct sheen_stats stats;
    struct bench bench;
    char name[32];

    bench_config(&bench, scene, (enum sheen_shading)shading, 16);
    bench.dither = (uint8_t)dither;
    int error = bench_begin(&bench, arena, sizeof arena);
    if (!error)
        error = bench_first(&bench);
    sheen_plan_counts_begin();
    if (!error)
        error = bench_measured(&bench);
    sheen_plan_counts_take(&counts);
    sheen_frame_stats(bench.frame, &stats);
    sheen_plan_count_push(&counts, SHEEN_RGB565_BE, 0, stats.pixels);
    counts.of[SHEEN_PLAN_PUSH] = stats.rectangles;
    sheen_plan_count_draws(&counts, bench.frame, 1, scene->mesh.vertices);
    snprintf(name, sizeof name, "%s-%s%s", scene->name, shadings[shading], dither ? "-dithered" : "");
    print_counts(name, 1, &counts);
    return error;
}

static int export_all(FILE *scenes, FILE *out, FILE *table)
{
    char line[1000];
    unsigned n = 0;
    int error = 0, c;

    fputs("/* Made by planned_export.c. */\n#include \"planned.h\"\n\n", out);
    while (!error && fgets(line, sizeof line, scenes))
        if (*line != '#' && *line != '\n')
            error = export_scene(out, table, line, n++);
    for (int i = 0; !error && i < BENCH_SCENES; i++)
        for (unsigned k = 0; !error && k < 2 * SHEEN_SHADINGS; k++)
            error = count_bench(&bench_scenes[i], k / 2, k % 2);
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
