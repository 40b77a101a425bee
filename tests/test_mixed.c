/*
 * test_mixed.c - random mixes of everything that a picture is made of, on 565 and on greys, against the same picture in
 * double precision.
 *
 *   test_mixed MIXES [FIRST]
 *
 * A mix's number gives its shading, format, filter and whether there is fog, so that these meet in all combinations.
 * Poses, lights, materials, ramps and meshes come from random_scene.c. Texels (key, palettes, wrap), vertex colours,
 * coloured and point lights, stipple, bias, dither, ortho, affine and cuts are random. Each picture must be within its
 * shading's steps, one more in fog and one more on 256 greys (bilinear: within what its texels allow), and must draw
 * nothing that stipple leaves out. Shares of equal pixels (bilinear: of calm ones, REF_CALM) are judged per shading,
 * format, filter and fog over all mixes, because in one mix an area of one colour on a rounding boundary could decide.
 * The share of pixels compared is judged per shading.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frame_stage.h"
#include "random_scene.h"

enum shown {
    FLAT,
    GOURAUD,
    PHONG,
    SLERP,
    FLAT_COLORED,
    GOURAUD_COLORED,
    PHONG_COLORED,
    SLERP_COLORED,
    TEXTURED_FLAT,
    TEXTURED,
    MATCAP,
    MATCAP_VERTEX,
    SHOWN
};

static const struct {
    const char *name;
    enum ref_shading shading;
} shown_as[SHOWN] = {{"flat", REF_FLAT},           {"gouraud", REF_GOURAUD},     {"phong", REF_PHONG},
                     {"slerp", REF_SLERP},         {"flat colored", REF_FLAT},   {"gouraud colored", REF_GOURAUD},
                     {"phong colored", REF_PHONG}, {"slerp colored", REF_SLERP}, {"textured flat", REF_FLAT},
                     {"textured", REF_GOURAUD},    {"matcap", REF_PHONG},        {"matcap-vertex", REF_PHONG}};

#define FORMATS 4
static const int format_levels[FORMATS] = {0, 2, 16, 256};

struct mix {
    struct random_scene random; /* what the scene is made from */
    enum shown shown;
    int format;
    struct ref_texture texture;
};

/* Sums for one shading, format and fog; nearest and bilinear texels are counted apart. */
static struct row {
    long pictures, covered, compared, calm, equal, beyond, dropped, dropped_drawn;
    int worst;
} rows[SHOWN][FORMATS][2][2];

/* ---- mixes ---- */

/* Takes a random scene of that shading, without texels, fog and the like, which are chosen below. */
static void take_scene(struct mix *mix, const struct random_meshes *meshes, uint32_t *state)
{
    uint32_t number = KNOWN_SCENES + stage_random(state) % 1000000;
    struct ref_scene *scene = &mix->random.scene;

    while (number / RANDOM_KNOWN % 4 != (uint32_t)shown_as[mix->shown].shading)
        number++;
    random_scene(&mix->random, meshes, number);
    mix->random.way = 0;
    scene->texture = NULL;
    scene->fog = scene->colored = false;
    scene->left_out = scene->bias = 0;
    for (int i = 0; i < REF_MAX_LIGHTS; i++) {
        double length = 0;
        for (int k = 0; k < 3; k++) {
            length += fabs(scene->light[i][k]);
            scene->light_color[i][k] = scene->ambient_color[k] = 1;
        }
        /* was a point and is now a direction, which must not be zero */
        scene->light[i][2] += scene->radius[i] > 0 && length < 0.05;
        scene->radius[i] = 0;
    }
}

static void choose_mesh(struct mix *mix, const struct random_meshes *meshes, uint32_t *state)
{
    const uint32_t shape = stage_random(state) % ACCURACY_SHAPES, textured = stage_random(state) % TEXTURED_MESHES;
    const bool has_uv = mix->shown == TEXTURED || mix->shown == TEXTURED_FLAT;

    mix->random.mesh = has_uv                                     ? &meshes->textured[textured]
                       : shown_as[mix->shown].shading == REF_FLAT ? &meshes->coarse[shape]
                                                                  : &meshes->fine[shape];
    mix->random.scene.mesh = &mix->random.mesh->reference;
}

static void choose_colors(struct mix *mix, uint32_t *state)
{
    struct ref_scene *scene = &mix->random.scene;

    scene->colored = stage_random(state) % 2;
    scene->ramp = scene->ramp == REF_TOON ? REF_HALF : scene->ramp; /* rounding would decide a jump at a corner */
    for (int i = 0; i < scene->light_count; i++) {
        for (int k = 0; k < 3; k++)
            scene->light_color[i][k] = (1 + stage_random(state) % 255) / 255.0;
        if (scene->shading > REF_GOURAUD || stage_random(state) % 2 == 0)
            continue;
        for (int k = 0; k < 3; k++)
            scene->light[i][k] = stage_uniform(state, -1.5, 1.5);
        scene->radius[i] = stage_uniform(state, 0.3, 4);
    }
    for (int k = 0; k < 3; k++)
        scene->ambient_color[k] = (1 + stage_random(state) % 255) / 255.0;
}

static void choose_texels(struct mix *mix, uint32_t *state)
{
    static const int fewest[TEXTURED_PICTURES] = {8, 8, 16, 4};
    const unsigned picture = stage_random(state) % TEXTURED_PICTURES;
    struct ref_texture *t = &mix->texture;
    struct ref_scene *scene = &mix->random.scene;

    *t = *textured_picture((int)picture);
    t->bits = fewest[picture] << stage_random(state) % 3;
    t->bits = t->bits > 16 ? 16 : t->bits;
    t->clamp[0] = stage_random(state) % 4 == 0;
    t->clamp[1] = stage_random(state) % 4 == 0;
    t->keyed = stage_random(state) % 3 == 0;
    t->key = t->texels[stage_random(state) % (unsigned)(t->width * t->height)];
    if (stage_random(state) % 4 == 0) { /* the texels as they are */
        scene->ambient = scene->base[0] = scene->base[1] = scene->base[2] = 1;
        scene->diffuse = scene->specular = 0;
        scene->ramp = REF_LAMBERT;
    }
}

static void choose_sphere(struct mix *mix, uint32_t *state)
{
    static const struct sheen_texture *const own[] = {&sheen_matcap_chrome, &sheen_matcap_glaze, &sheen_matcap_clay,
                                                      &sheen_matcap_jade};
    const struct sheen_texture *sphere = own[stage_random(state) % 4];

    mix->texture = (struct ref_texture){.width = 1 << sphere->width_log2,
                                        .height = 1 << sphere->height_log2,
                                        .texels = sphere->texels,
                                        .clamp = {true, true},
                                        .bits = 16};
    mix->random.scene.texels = mix->shown == MATCAP ? REF_TEXELS_NORMAL : REF_TEXELS_CORNER_NORMALS;
    mix->random.scene.ramp = REF_LAMBERT;
    mix->random.scene.colored = stage_random(state) % 2;
}

static void choose_view(struct ref_scene *scene, uint32_t *state)
{
    scene->ortho = stage_random(state) % 4 == 0;
    scene->affine = !scene->ortho && scene->affine;
    scene->dither = stage_random(state) % 2;
    scene->width = 160 + 8 * (int)(stage_random(state) % 20);
    scene->height = 160 + 8 * (int)(stage_random(state) % 20);
    if (stage_random(state) % 3 == 0) {
        scene->left_out = 1 + (int)(stage_random(state) % 63);
        scene->phase = (int)(stage_random(state) % 8);
    }
    if (stage_random(state) % 5 == 0) { /* the near plane cuts the mesh */
        scene->near = fmax(0.1, scene->distance - stage_uniform(state, 0.2, 0.9));
        scene->two_sided = true;
        return;
    }
    /* The largest bias, in steps, with which no depth of the mesh (within 1 of its centre) is clamped at a plane. */
    const double beyond = ref_nearness(scene, scene->distance + 1);
    const double before = 1 - ref_nearness(scene, scene->distance - (scene->distance > 1.06 ? 1 : 1.04));
    const int most = (int)(REF_STEPS * fmin(beyond, before)) - 1;
    if (stage_random(state) % 2)
        scene->bias = (int)stage_uniform(state, -most, most);
}

static void choose_fog(struct ref_scene *scene, uint32_t *state)
{
    const double depth = scene->far - scene->near;

    scene->fog = true;
    scene->fog_from = fmax(scene->near + stage_uniform(state, -0.3, 0.6) * depth, 0.02);
    scene->fog_to = fmax(scene->fog_from, scene->near) + stage_uniform(state, 0.2, 2) * depth;
    for (int k = 0; k < 3; k++)
        scene->fog_color[k] = stage_random(state) % 256 / 255.0;
}

static void make_mix(struct mix *mix, const struct random_meshes *meshes, uint32_t number)
{
    uint32_t state = (number + 1) * 2246822519u;

    for (int i = 0; i < 8; i++)
        stage_random(&state);
    mix->shown = (enum shown)(number % SHOWN);
    mix->format = (int)(number / SHOWN % FORMATS);
    take_scene(mix, meshes, &state);
    choose_mesh(mix, meshes, &state);
    if ((mix->shown >= FLAT_COLORED && mix->shown <= SLERP_COLORED) ||
        (shown_as[mix->shown].shading <= REF_GOURAUD && mix->shown >= TEXTURED_FLAT && stage_random(&state) % 2))
        choose_colors(mix, &state);
    if (mix->shown == TEXTURED || mix->shown == TEXTURED_FLAT)
        choose_texels(mix, &state);
    if (mix->shown == MATCAP || mix->shown == MATCAP_VERTEX)
        choose_sphere(mix, &state);
    if (mix->shown >= TEXTURED_FLAT) {
        mix->texture.bilinear = number / (SHOWN * FORMATS * 2) % 2;
        mix->random.scene.texture = &mix->texture;
    }
    choose_view(&mix->random.scene, &state);
    if (number / (SHOWN * FORMATS) % 2)
        choose_fog(&mix->random.scene, &state);
    mix->random.scene.levels = format_levels[mix->format];
}

/* ---- judged ---- */

#define FEWEST 2000 /* compared pixels; shares of fewer would depend on a handful of pixels */

static double share(long part, long whole)
{
    return whole > 0 ? (double)part / (double)whole : 1;
}

/* How many steps a picture may be off by. */
static int most_off(const struct mix *mix)
{
    const bool in_fog = mix->random.scene.fog, is_fine = format_levels[mix->format] > 64;
    const enum ref_shading limit = mix->shown <= SLERP_COLORED ? shown_as[mix->shown].shading : REF_GOURAUD;

    return accuracy_limits[limit].worst + in_fog + is_fine;
}

static int judge(const struct random_meshes *meshes, uint32_t number)
{
    static struct accuracy_shot shot;
    const struct ref_score *s = &shot.score;
    struct mix mix;
    struct ref_picture picture;

    make_mix(&mix, meshes, number);
    const struct ref_scene *scene = &mix.random.scene;
    if (ref_render(&picture, scene) != 0)
        return 1;
    const int status = accuracy_shoot(&shot, scene, &picture, mix.random.mesh->mesh, 0);
    ref_picture_free(&picture);
    if (status == SHEEN_OK &&
        (s->compared < FEWEST || (shown_as[mix.shown].shading == REF_SLERP && shot.stats.frame.clipped > 0)))
        return 0;
    const bool bilinear = scene->texture && scene->texture->bilinear;
    struct row *row = &rows[mix.shown][mix.format][scene->fog][bilinear];
    row->pictures++;
    row->covered += s->covered;
    row->compared += s->compared;
    row->calm += s->calm;
    row->equal += s->calm_equal;
    row->beyond += s->beyond;
    row->dropped += s->dropped;
    row->dropped_drawn += s->dropped_drawn;
    row->worst = s->worst > row->worst ? s->worst : row->worst;
    if (status == SHEEN_OK && s->dropped_drawn == 0 && (bilinear ? s->beyond == 0 : s->worst <= most_off(&mix)))
        return 0;
    printf(
        "  FAILED mix %u: %s, %s, %d levels%s, %ld compared, %ld equal, %ld beyond, worst %d at (%d, %d), %ld drawn, "
        "bias %d, near %.3f\n",
        number, status < 0 ? sheen_strerror(status) : "drawn", shown_as[mix.shown].name, format_levels[mix.format],
        bilinear ? ", bilinear" : "", s->compared, s->equal, s->beyond, s->worst, s->worst_x, s->worst_y,
        s->dropped_drawn, scene->bias, scene->near);
    random_scene_print(&mix.random);
    return 1;
}

static int judge_row(const struct row *row, int shown, int format, int in_fog, int bilinear)
{
    const enum ref_shading limit = shown <= SLERP_COLORED ? shown_as[shown].shading : REF_GOURAUD;
    const double asked = bilinear ? ACCURACY_BILINEAR : accuracy_limits[limit].equal;
    const double equal = share(row->equal, row->calm);

    if (row->pictures == 0)
        return 0;
    printf("%-15s %3d levels %-3s %-8s %4ld pictures, %5.1f %% compared, %6.2f %% equal, worst %d, %ld of %ld drawn\n",
           shown_as[shown].name, format_levels[format], in_fog ? "fog" : "", bilinear ? "bilinear" : "", row->pictures,
           100 * share(row->compared, row->covered), 100 * equal, row->worst, row->dropped_drawn, row->dropped);
    if (equal >= (in_fog ? fmin(asked, ACCURACY_FOGGED) : asked))
        return 0;
    printf("  FAILED too few are equal\n");
    return 1;
}

/* Enough pixels must be compared for the result to mean anything. */
static int judge_compared(int shown)
{
    long covered = 0, compared = 0;

    for (int i = 0; i < FORMATS * 4; i++) {
        const struct row *row = &rows[shown][i / 4][i / 2 % 2][i % 2];
        covered += row->covered;
        compared += row->compared;
    }
    printf("%-15s %5.1f %% of covered pixels compared\n", shown_as[shown].name, 100 * share(compared, covered));
    if (share(compared, covered) >= ACCURACY_COMPARED)
        return 0;
    printf("  FAILED too little was compared\n");
    return 1;
}

int main(int argc, char **argv)
{
    static struct random_meshes meshes;
    const uint32_t count = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0;
    const uint32_t first = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 0;
    int failed = 0;

    if (count == 0 || random_meshes_make(&meshes) != 0) {
        fprintf(stderr, "usage: test_mixed MIXES [FIRST]\n");
        return 2;
    }
    for (uint32_t i = 0; i < count; i++)
        failed += judge(&meshes, first + i);
    for (int i = 0; i < SHOWN * FORMATS * 4; i++)
        failed += judge_row(&rows[i / 4 / FORMATS][i / 4 % FORMATS][i / 2 % 2][i % 2], i / 4 / FORMATS, i / 4 % FORMATS,
                            i / 2 % 2, i % 2);
    for (int shown = 0; shown < SHOWN; shown++)
        failed += judge_compared(shown);
    random_meshes_free(&meshes);
    printf("%d outside their limits, of %u mixes\n", failed, count);
    return failed != 0;
}
