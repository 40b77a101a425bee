/*
 * test_morph.c - meshes between two frames, against their definition (core/sheen.h) in double precision, within the
 * limits of accuracy.h. At the end faults are put in, and each must be refused.
 *
 *   test_morph [PREFIX]     one line per shading; PREFIX: where to save pictures of what failed
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy_line.h"
#include "textured_scene.h"

static const char *prefix;

enum shown {
    FLAT,
    GOURAUD,
    PHONG,
    SLERP,
    TEXTURED,
    TEXTURED_FLAT,
    MATCAP,
    MATCAP_VERTEX,
    SHOWN
};
static const char *const shown_name[SHOWN] = {"flat",     "gouraud",       "phong",  "slerp",
                                              "textured", "textured flat", "matcap", "matcap-vertex"};

/* Two frames of a mesh, for the reference and for the core. */
struct pair {
    struct accuracy_mesh first;
    struct ref_mesh second;
    struct core_mesh own[2];
};

static void turned(double v[3], double angle)
{
    const double x = v[0], y = v[1];

    v[0] = cos(angle) * x - sin(angle) * y;
    v[1] = sin(angle) * x + cos(angle) * y;
}

/* The second frame is flattened, then turned by 70 degrees about z, so that planes stay planes. */
static const double stretch[3] = {0.95, 0.5, 0.8};
#define TURN (70 * 3.14159265358979324 / 180)

static void bend_position(double p[3])
{
    for (int k = 0; k < 3; k++)
        p[k] *= stretch[k];
    turned(p, TURN);
}

static void bend_normal(double n[3])
{
    double length = 0;

    for (int k = 0; k < 3; k++) {
        n[k] /= stretch[k];
        length += n[k] * n[k];
    }
    for (int k = 0; k < 3 && length > 0; k++)
        n[k] /= sqrt(length);
    turned(n, TURN);
}

static int pair_make(struct pair *p, enum shown shown, int i)
{
    int failed = shown == TEXTURED || shown == TEXTURED_FLAT
                     ? textured_mesh_make(&p->first, 1 + i % (TEXTURED_MESHES - 1))
                     : accuracy_mesh_make(&p->first, i % ACCURACY_SHAPES, shown == FLAT || i % 3 == 0);

    if (failed || ref_mesh_between(&p->second, &p->first.reference, &p->first.reference, 0) != 0)
        return -1;
    for (size_t c = 0; c < p->second.corner_count; c++) {
        bend_position(p->second.position[c]);
        bend_normal(p->second.normal[c]);
    }
    for (size_t q = 0; q < p->second.polygon_count; q++) {
        bend_normal(p->second.polygon_normal[q]);
        bend_position(p->second.center[q]);
    }
    return core_frames_make(p->own, &p->first.reference, &p->second);
}

static void pair_free(struct pair *p)
{
    accuracy_mesh_free(&p->first);
    ref_mesh_free(&p->second);
    core_mesh_free(&p->own[0]);
    core_mesh_free(&p->own[1]);
}

/* Faults put into the reference. */
enum fault {
    NO_FAULT,
    WEIGHT, /* off by 1/64 */
    NORMALS /* those of the first frame */
};

/* Draws a picture at weight / 32768. 1 if that failed. */
static int shoot(struct accuracy_shot *shot, struct ref_scene *scene, const struct pair *p, unsigned weight,
                 enum fault fault)
{
    const struct sheen_morph morph = {&p->own[1].mesh, &sheen_morpher, (uint16_t)weight};
    const double k = weight / 32768.0 + (fault == WEIGHT ? 1 / 64.0 : 0);
    struct ref_picture picture;
    struct ref_mesh between;

    if (ref_mesh_between(&between, &p->first.reference, &p->second, k) != 0)
        return 1;
    if (fault == NORMALS)
        memcpy(between.normal, p->first.reference.normal, between.corner_count * sizeof *between.normal);
    scene->mesh = &between;
    int failed = ref_render(&picture, scene) != 0;
    if (!failed) {
        failed = accuracy_shoot_between(shot, scene, &picture, &p->own[0].mesh, &morph) < 0;
        if (prefix && fault == NO_FAULT)
            accuracy_write_difference(prefix, scene, &picture, shot);
        ref_picture_free(&picture);
    }
    ref_mesh_free(&between);
    return failed;
}

/* The shading's own limits. How much was compared is judged over all pictures: cut or flat meshes show many edges. */
static bool kept(const struct ref_score *score, enum shown shown)
{
    const enum ref_shading limit = shown <= SLERP ? (enum ref_shading)shown : REF_GOURAUD;

    return score->compared > 0 && accuracy_kept(score, limit, 0) && score->dropped_drawn == 0;
}

static void view_of(struct ref_scene *scene, const struct pair *p, struct ref_texture *texture, enum shown shown, int i)
{
    if (shown == TEXTURED || shown == TEXTURED_FLAT) {
        textured_view(scene, &p->first.reference, i % TEXTURED_VIEWS,
                      shown == TEXTURED ? TEXTURED_SCENE_GOURAUD : TEXTURED_SCENE_FLAT);
    } else {
        accuracy_view(scene, &p->first.reference, i % ACCURACY_VIEWS);
        scene->shading = shown <= SLERP ? (enum ref_shading)shown : REF_PHONG;
        scene->two_sided = i % 4 == 3;
    }
    if (shown >= MATCAP)
        scene->texels = shown == MATCAP ? REF_TEXELS_NORMAL : REF_TEXELS_CORNER_NORMALS;
    if (shown >= TEXTURED) {
        scene->texture = texture;
        scene->width = scene->height = 320; /* larger, so that fewer pixels are near a texel's border */
    }
    /* A picture of many colours; with few, much would depend on where a flat mesh's colours fall between levels. */
    *texture = *textured_picture(shown == TEXTURED ? i % 2 : 2);
    texture->clamp[0] = texture->clamp[1] = shown >= MATCAP;
    if (i % 5 == 3)
        accuracy_ortho(scene);
    scene->affine = i % 5 == 4;
    scene->dither = shown < TEXTURED && i % 3 == 1;
}

/* The near and far planes cut every fourth picture; not with slerp, which is not judged on cut triangles. */
static void cut(struct ref_scene *scene, enum shown shown, int i)
{
    if (i % 4 != 1 || shown == SLERP || scene->ortho || shown >= TEXTURED)
        return;
    scene->near = scene->distance - 0.6;
    scene->far = scene->distance + 0.3;
}

static int judge(enum shown shown)
{
    static struct accuracy_shot shot;
    static const uint16_t weights[] = {16384, 8000, 32768, 27001, 300};
    double lowest = 1;
    long compared = 0, covered = 0;
    int failed = 0, worst = 0;

    for (int i = 0; i < 15; i++) {
        const struct ref_score *s = &shot.score;
        struct ref_texture texture;
        struct ref_scene scene;
        struct pair p;
        if (pair_make(&p, shown, i) != 0)
            return 1;
        view_of(&scene, &p, &texture, shown, i);
        cut(&scene, shown, i);
        int wrong = shoot(&shot, &scene, &p, weights[i % 5], NO_FAULT) || !kept(s, shown);
        if (wrong)
            printf("  FAILED %s, picture %d, %s: %ld of %ld compared, %.2f %% equal, worst %d at (%d, %d)\n",
                   shown_name[shown], i, p.first.name, s->compared, s->covered,
                   100.0 * (double)s->equal / (double)(s->compared + !s->compared), s->worst, s->worst_x, s->worst_y);
        failed += wrong;
        lowest = fmin(lowest, s->compared ? (double)s->equal / (double)s->compared : 1);
        worst = s->worst > worst ? s->worst : worst;
        compared += s->compared;
        covered += s->covered;
        pair_free(&p);
    }
    printf("%-14s 15 pictures %5.1f %% compared, lowest %6.2f %% equal, worst %d\n", shown_name[shown],
           100 * (double)compared / (double)covered, 100 * lowest, worst);
    if ((double)compared < ACCURACY_COMPARED * (double)covered) {
        printf("  FAILED too little was compared\n");
        failed++;
    }
    return failed;
}

/* Proves that the comparison detects faults in the reference. */
static int judge_fault(enum fault fault, const char *name)
{
    static struct accuracy_shot shot;
    struct ref_texture texture;
    struct ref_scene scene;
    struct pair p;

    if (pair_make(&p, PHONG, 0) != 0)
        return 1;
    view_of(&scene, &p, &texture, PHONG, 0);
    int failed = shoot(&shot, &scene, &p, 16384, fault) || kept(&shot.score, PHONG);
    pair_free(&p);
    printf("a reference with %s %s\n", name, failed ? "  FAILED: not refused" : "is refused");
    return failed;
}

int main(int argc, char **argv)
{
    int failed = 0;

    prefix = argc > 1 ? argv[1] : NULL;
    for (int shown = 0; shown < SHOWN; shown++)
        failed += judge((enum shown)shown);
    failed += judge_fault(WEIGHT, "a weight that is off by 1/64");
    failed += judge_fault(NORMALS, "the first frame's normals");
    printf("%d pictures outside their limits\n", failed);
    return failed != 0;
}
