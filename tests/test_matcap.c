/*
 * test_matcap.c - matcaps against their definition (core/sheen.h) in double precision, within the limits of accuracy.h.
 * At the end faults are put in, and each must be refused.
 *
 *   test_matcap [all [PREFIX]]     one line per mesh, matcap and shading, a third of them or all; PREFIX: where to save
 *                                  pictures of what failed
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy_line.h"
#include "textured_scene.h"

static const char *prefix;
static bool draws_all;
static int lines; /* how many lines were asked for so far */

/* ---- pictures: the core's four matcaps, and one with large texels ---- */

#define SPHERES 5
#define TILES 4

static const char *const sphere_name[SPHERES] = {"chrome", "glaze", "clay", "jade", "tiles"};

/* 32 by 16 texels, so that width and height differ; tiles of 2 by 2 texels. */
static struct ref_texture tiles_texture(void)
{
    static uint16_t texels[16 * 32];

    for (int j = 0; j < 16; j++)
        for (int i = 0; i < 32; i++)
            texels[32 * j + i] = (uint16_t)((i / 2) << 12 | (j / 2) << 8 | ((i / 2 + j / 2) & 1 ? 0x1f : 0x08));
    return (struct ref_texture){.width = 32, .height = 16, .texels = texels, .clamp = {true, true}, .bits = 16};
}

static struct ref_texture sphere_texture(int index)
{
    static const struct sheen_texture *const own[TILES] = {&sheen_matcap_chrome, &sheen_matcap_glaze,
                                                           &sheen_matcap_clay, &sheen_matcap_jade};

    if (index == TILES)
        return tiles_texture();
    return (struct ref_texture){.width = 1 << own[index]->width_log2,
                                .height = 1 << own[index]->height_log2,
                                .texels = own[index]->texels,
                                .clamp = {own[index]->clamp_u, own[index]->clamp_v},
                                .bits = 16};
}

/* ---- meshes ---- */

#define MESHES 9
#define SCREEN 8 /* two triangles, whose normals are far apart */

static int make_mesh(struct accuracy_mesh *mesh, int index)
{
    return index == SCREEN ? textured_mesh_make(mesh, 4) : accuracy_mesh_make(mesh, index, false);
}

/* ---- judging ---- */

struct matcap_line {
    double equal;
    long covered, comparable, compared, beyond;
    int worst, pictures;
    uint64_t setups, by_way[SHEEN_WAYS];
};

static double part_of(long part, long whole)
{
    return whole > 0 ? (double)part / (double)whole : 1;
}

/* Adds the picture to the line. 1 if it is outside its limits. */
static int score_picture(struct matcap_line *line, const struct accuracy_shot *shot, const struct ref_scene *scene)
{
    const struct ref_score *s = &shot->score;
    const double equal = part_of(s->calm_equal, s->calm),
                 least = scene->texture->bilinear ? ACCURACY_BILINEAR : accuracy_limits[REF_GOURAUD].equal;

    line->covered += s->covered;
    line->comparable += s->comparable;
    line->compared += s->compared;
    line->beyond += s->beyond;
    line->equal = fmin(line->equal, equal);
    line->worst = s->worst > line->worst ? s->worst : line->worst;
    line->pictures++;
    line->setups += shot->stats.frame.setups;
    for (int way = 0; way < SHEEN_WAYS; way++)
        line->by_way[way] += shot->stats.by_way[way];
    return equal < least || s->beyond > 0;
}

static int judge_picture(struct matcap_line *line, const struct ref_scene *scene, const struct sheen_mesh *mesh)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;

    if (ref_render(&picture, scene) != 0)
        return 1;
    int status = accuracy_shoot(&shot, scene, &picture, mesh, 0);
    int failed = status < 0 || score_picture(line, &shot, scene);
    if (failed) {
        const struct ref_score *s = &shot.score;
        printf("  FAILED %s%s%s%s%s, picture %d, code %d: %ld compared, %ld equal, %ld beyond, worst %d at (%d, %d)\n",
               scene->texture->bilinear ? "bilinear" : "nearest", scene->affine ? " affine" : "",
               scene->ortho ? " ortho" : "", scene->dither ? " dither" : "", scene->two_sided ? " two sides" : "",
               line->pictures, status, s->compared, s->equal, s->beyond, s->worst, s->worst_x, s->worst_y);
        if (prefix)
            accuracy_write_difference(prefix, scene, &picture, &shot);
    }
    ref_picture_free(&picture);
    return failed;
}

static void matcap_view(struct ref_scene *scene, const struct ref_mesh *mesh, int view, enum ref_texels texels)
{
    static const double white[3] = {1, 1, 1};

    textured_view(scene, mesh, view, TEXTURED_SCENE_UNLIT);
    scene->shading = REF_PHONG;
    scene->texels = texels;
    scene->width = scene->height = 288;
    memcpy(scene->base, white, sizeof white);
}

static void print_line(const struct matcap_line *line, const char *mesh, const char *sphere, const char *how)
{
    printf("%-14s %-7s %-22s %5.1f %% compared %5.1f %% settled %6.2f %% equal, %ld beyond, worst %d; ways", mesh,
           sphere, how, 100 * part_of(line->compared, line->covered), 100 * part_of(line->compared, line->comparable),
           100 * line->equal, line->beyond, line->worst);
    for (int way = SHEEN_WAY_TEXTURED_LINEAR; way < SHEEN_WAYS; way++)
        printf(" %3.0f", 100 * part_of((long)line->by_way[way], (long)line->setups));
    printf("\n");
}

/*
 * All views (3 is cut by the near plane and seen from inside, 4 is cut by the guard band), then one affine and one
 * orthographic, each with nearest and bilinear texels.
 */
static int judge_matcap(const struct accuracy_mesh *mesh, int sphere, enum ref_texels texels, bool colored, int turn)
{
    static const double tint[3] = {230 / 255.0, 140 / 255.0, 51 / 255.0};
    struct matcap_line line[2] = {{.equal = 1}, {.equal = 1}};
    int failed = 0;

    if (!draws_all && lines++ % 3 != 0)
        return 0;
    for (int i = 0; i < 2 * (TEXTURED_VIEWS + 2); i++, turn++) {
        const int view = i >> 1, bilinear = i & 1;
        struct ref_texture texture = sphere_texture(sphere);
        struct ref_scene scene;
        matcap_view(&scene, &mesh->reference, view < TEXTURED_VIEWS ? view : 1, texels);
        scene.affine = view == TEXTURED_VIEWS;
        scene.texture = &texture;
        scene.colored = colored;
        scene.dither = turn % 3 == 1;
        texture.bilinear = bilinear;
        if (turn % 4 == 1)
            memcpy(scene.base, tint, sizeof tint);
        if (view == TEXTURED_VIEWS + 1)
            accuracy_ortho(&scene);
        failed += judge_picture(&line[bilinear], &scene, mesh->mesh);
    }
    for (int bilinear = 0; bilinear < 2; bilinear++) {
        char how[32];
        snprintf(how, sizeof how, "%s %s%s", texels == REF_TEXELS_NORMAL ? "pixel" : "vertex",
                 bilinear ? "bilinear" : "nearest", colored ? " colors" : "");
        print_line(&line[bilinear], mesh->name, sphere_name[sphere], how);
        if (part_of(line[bilinear].compared, line[bilinear].covered) < ACCURACY_COMPARED) {
            printf("  FAILED too little was compared\n");
            failed++;
        }
    }
    return failed;
}

/* ---- the test of the test ---- */

enum fault {
    FLIPPED,
    LONG_NORMAL,
    SHIFTED,
    FAULTS
};

static const char *const fault_name[FAULTS] = {"v upwards", "normals that are not of unit length",
                                               "1/8 texel to the right"};

/* The core's picture of one scene must be refused against the reference's picture of a different one. */
static int judge_fault(enum fault fault)
{
    static struct accuracy_shot shot;
    static uint16_t moved[512 * 64];
    struct ref_texture texture = sphere_texture(0), wrong = texture;
    struct matcap_line line = {.equal = 1};
    struct accuracy_mesh mesh;
    struct ref_scene scene;
    struct ref_picture picture;
    int kept = 1;

    for (int j = 0; j < 64; j++)
        for (int i = 0; i < 512; i++) /* each texel 8 times, so that one place is 1/8 texel */
            moved[512 * j + i] =
                ref_texel(&texture, fault == SHIFTED ? (i - 1) >> 3 : i >> 3, fault == FLIPPED ? 63 - j : j);
    wrong.width = 512;
    wrong.texels = moved;
    if (make_mesh(&mesh, 6) != 0) /* coarse, so that interpolated normals are far from unit length */
        return 1;
    matcap_view(&scene, &mesh.reference, 1, fault == LONG_NORMAL ? REF_TEXELS_CORNER_NORMALS : REF_TEXELS_NORMAL);
    scene.texture = fault == LONG_NORMAL ? &texture : &wrong;
    if (ref_render(&picture, &scene) == 0) {
        scene.texels = REF_TEXELS_NORMAL;
        scene.texture = &texture;
        if (accuracy_shoot(&shot, &scene, &picture, mesh.mesh, 0) == SHEEN_OK)
            kept = !score_picture(&line, &shot, &scene);
        ref_picture_free(&picture);
    }
    printf("fault, %s: %s, %.1f %% equal\n", fault_name[fault], kept ? "NOT REFUSED" : "refused, as it has to be",
           100 * line.equal);
    accuracy_mesh_free(&mesh);
    return kept;
}

int main(int argc, char **argv)
{
    int failed = 0, faults = 0, turn = 0;

    draws_all = argc > 1 && strcmp(argv[1], "all") == 0;
    prefix = argc > 2 ? argv[2] : NULL;
    printf("shares in percent; ways: texels linear, quotient, matcap quadratic, normals\n");
    for (int index = 0; index < MESHES; index++) {
        struct accuracy_mesh mesh;
        if (make_mesh(&mesh, index) != 0) {
            fprintf(stderr, "test_matcap: mesh %d could not be made\n", index);
            return 1;
        }
        for (int k = 0; k < 3; k++, turn++) { /* tiles, and two of the other matcaps in turn */
            const int sphere = k == 0 ? TILES : (index + k) % TILES;
            failed += judge_matcap(&mesh, sphere, REF_TEXELS_NORMAL, false, turn);
            if (k < 2)
                failed += judge_matcap(&mesh, sphere, REF_TEXELS_CORNER_NORMALS, false, turn) +
                          judge_matcap(&mesh, sphere, REF_TEXELS_NORMAL, true, turn);
            if (k == 1)
                failed += judge_matcap(&mesh, sphere, REF_TEXELS_CORNER_NORMALS, true, turn);
        }
        accuracy_mesh_free(&mesh);
    }
    for (int fault = 0; fault < FAULTS; fault++)
        faults += judge_fault((enum fault)fault);
    printf("%d pictures outside their limits\n", failed);
    return failed + faults != 0;
}
