/*
 * test_fog.c - fog, and pixels that are left out, against their definition in double precision (README, "How close the
 * integers come").
 *
 *   test_fog [PREFIX]     a line a shading and kind; PREFIX: pictures of what failed
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy_line.h"
#include "textured_scene.h"

static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp", "textured", "matcap", "matcap-vertex"};
static const char *prefix;

#define TEXTURED 4
#define MATCAP 5
#define MATCAP_VERTEX 6

/* Of a scene without perspective that fog might be measured by: what lies between its planes. */
struct range {
    double from, to; /* of near to far, 0..1; below 0 and above 1: beyond the planes */
    double color[3];
};

static const struct range ranges[] = {
    {0.1, 0.9, {0.62, 0.66, 0.7}}, {-0.4, 0.6, {1, 1, 1}}, {0.45, 0.75, {0.1, 0.0, 0.2}}, {0.3, 6, {0.9, 0.2, 0.1}}};

static void set_fog(struct ref_scene *scene, const struct range *range)
{
    const double depth = scene->far - scene->near;

    scene->fog = true;
    scene->fog_from = fmax(scene->near + range->from * depth, 0.02);
    scene->fog_to = scene->near + range->to * depth;
    memcpy(scene->fog_color, range->color, sizeof scene->fog_color);
}

/* Equal 95 %; within one step what the shading has to be, worst a step more. */
static bool kept(const struct ref_score *s, int shading, bool fog)
{
    const struct accuracy_limit *limit = &accuracy_limits[shading >= TEXTURED ? REF_GOURAUD : shading];
    const double compared = (double)s->compared;

    return s->equal >= (fog ? fmin(limit->equal, 0.95) : limit->equal) * compared &&
           s->within_one >= limit->within_one * compared && s->worst <= limit->worst + fog && s->dropped_drawn == 0;
}

struct fog_line {
    double equal;
    long covered, compared, dropped, dropped_drawn;
    int worst, pictures;
};

static int judge_picture(struct fog_line *line, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                         int shading)
{
    static struct accuracy_shot shot;
    const struct ref_score *s = &shot.score;
    struct ref_picture picture;

    if (ref_render(&picture, scene) != 0)
        return 1;
    int status = accuracy_shoot(&shot, scene, &picture, mesh, 0);
    int failed = status < 0 || !kept(s, shading, scene->fog);
    const double equal = s->compared > 0 ? (double)s->equal / (double)s->compared : 1;
    line->equal = fmin(line->equal, equal);
    line->covered += s->covered;
    line->compared += s->compared;
    line->dropped += s->dropped;
    line->dropped_drawn += s->dropped_drawn;
    line->worst = s->worst > line->worst ? s->worst : line->worst;
    line->pictures++;
    if (failed)
        printf(
            "  FAILED %s, picture %d%s%s%s: %s, %ld compared, %.2f %% equal, %.2f %% within 1, worst %d at (%d, %d), "
            "%ld of %ld drawn\n",
            shading_name[shading], line->pictures, scene->dither ? " dither" : "", scene->ortho ? " ortho" : "",
            scene->affine ? " affine" : "", status < 0 ? sheen_strerror(status) : "", s->compared, 100 * equal,
            100 * (double)s->within_one / (double)(s->compared + !s->compared), s->worst, s->worst_x, s->worst_y,
            s->dropped_drawn, s->dropped);
    if (failed && prefix)
        accuracy_write_difference(prefix, scene, &picture, &shot);
    ref_picture_free(&picture);
    return failed;
}

static int view_of(struct ref_scene *scene, struct accuracy_mesh *mesh, int shading, int i)
{
    if (shading == TEXTURED) {
        if (textured_mesh_make(mesh, i % 3) != 0)
            return -1;
        textured_view(scene, &mesh->reference, i % TEXTURED_VIEWS, TEXTURED_SCENE_GOURAUD);
        return 0;
    }
    if (accuracy_mesh_make(mesh, i % ACCURACY_SHAPES, shading == REF_FLAT || (i % 3 == 0 && shading < MATCAP)) != 0)
        return -1;
    accuracy_view(scene, &mesh->reference, i / 2 % ACCURACY_VIEWS);
    scene->shading = shading >= MATCAP ? REF_PHONG : (enum ref_shading)shading;
    if (shading >= MATCAP)
        scene->texels = shading == MATCAP ? REF_TEXELS_NORMAL : REF_TEXELS_CORNER_NORMALS;
    if (i % 7 == 6)
        accuracy_more_lights(scene);
    return 0;
}

enum kind {
    FOG,
    BIASED, /* in depth, which moves it in the fog */
    LEFT_OUT,
    BOTH,
    KINDS
};

static const char *const kind_name[KINDS] = {"fog", "biased", "left out", "both"};

/* Texels with a key, or one of the core's spheres. */
static struct ref_texture texture_of(int shading, int i)
{
    static const struct sheen_texture *const sphere[] = {&sheen_matcap_chrome, &sheen_matcap_glaze, &sheen_matcap_clay,
                                                         &sheen_matcap_jade};
    struct ref_texture texture = *textured_picture(i % 2);

    texture.keyed = i % 3 == 2;
    texture.key = texture.texels[0];
    if (shading >= MATCAP)
        texture = (struct ref_texture){.width = 1 << sphere[i % 4]->width_log2,
                                       .height = 1 << sphere[i % 4]->height_log2,
                                       .texels = sphere[i % 4]->texels,
                                       .clamp = {true, true}};
    texture.bits = 16;
    return texture;
}

static int judge(int shading, enum kind kind)
{
    struct fog_line line = {.equal = 1};
    int failed = 0;

    for (int i = 0; i < (shading == TEXTURED ? 10 : 16); i++) {
        struct ref_texture texture = texture_of(shading, i);
        struct accuracy_mesh mesh;
        struct ref_scene scene;
        if (view_of(&scene, &mesh, shading, i) != 0)
            return 1;
        scene.texture = shading >= TEXTURED ? &texture : NULL;
        if (i % 5 == 3)
            accuracy_ortho(&scene);
        scene.affine = i % 5 == 4;
        scene.dither = i % 2;
        if (kind != LEFT_OUT)
            set_fog(&scene, &ranges[i % 4]);
        if (kind == BIASED)
            scene.bias = i % 2 ? 900 - 20 * i : 30 * i - 900;
        if (kind >= LEFT_OUT) {
            scene.left_out = 4 + 13 * i % 56;
            scene.phase = i % 8;
        }
        failed += judge_picture(&line, &scene, mesh.mesh, shading);
        accuracy_mesh_free(&mesh);
    }
    printf("%-13s %-8s %2d pictures %5.1f %% compared %6.2f %% equal, worst %d, %ld of %ld left out are drawn\n",
           shading_name[shading], kind_name[kind], line.pictures, 100 * (double)line.compared / (double)line.covered,
           100 * line.equal, line.worst, line.dropped_drawn, line.dropped);
    return failed;
}

enum fault {
    IN_M,
    PHASE,
    UNBIASED,
    FAULTS
};

static const char *const fault_name[FAULTS] = {"fog linear in m", "another phase", "fog without the bias"};

/* The test of the test: a picture that the reference has otherwise has to be refused. */
static int judge_fault(enum fault fault)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;
    struct accuracy_mesh mesh;
    struct ref_scene scene;
    bool is_kept = true;

    if (view_of(&scene, &mesh, REF_GOURAUD, 0) != 0)
        return 1;
    set_fog(&scene, &ranges[0]);
    scene.left_out = fault == PHASE ? 32 : 0;
    scene.fog_in_m = fault == IN_M;
    if (ref_render(&picture, &scene) == 0) {
        scene.bias = fault == UNBIASED ? 900 : 0;
        if (accuracy_shoot(&shot, &scene, &picture, mesh.mesh, 0) == SHEEN_OK) {
            if (fault == PHASE) {
                scene.phase = 1;
                memset(&shot.score, 0, sizeof shot.score);
                if (ref_compare(&shot.score, &scene, &picture, shot.values) != 0)
                    return 1;
            }
            is_kept = kept(&shot.score, REF_GOURAUD, true);
        }
        ref_picture_free(&picture);
    }
    printf("fault, %s: %s\n", fault_name[fault], is_kept ? "NOT REFUSED" : "refused, as it has to be");
    accuracy_mesh_free(&mesh);
    return is_kept;
}

int main(int argc, char **argv)
{
    int failed = 0;

    prefix = argc > 1 ? argv[1] : NULL;
    for (int shading = 0; shading <= MATCAP_VERTEX; shading++)
        for (int kind = 0; kind < KINDS; kind++)
            failed += judge(shading, (enum kind)kind);
    for (int fault = 0; fault < FAULTS; fault++)
        failed += judge_fault((enum fault)fault);
    printf("%d pictures outside their limits\n", failed);
    return failed != 0;
}
