/*
 * test_fog.c - fog, and pixels that stipple leaves out, against their definition (core/sheen.h) in double precision,
 * within the limits of accuracy.h. At the end faults are put in, and each must be refused.
 *
 *   test_fog [PREFIX]     one line per shading and kind; PREFIX: where to save pictures of what failed
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy_line.h"
#include "textured_scene.h"

/* The first four have the values of enum ref_shading. */
enum shown {
    TEXTURED = REF_SLERP + 1,
    TEXTURED_FLAT,
    BILINEAR,
    TEXTURED_POINTS,
    MATCAP,
    MATCAP_VERTEX,
    MATCAP_BILINEAR,
    FLAT_COLORED,
    GOURAUD_COLORED,
    FLAT_POINTS, /* with coloured point lights */
    GOURAUD_POINTS,
    SHOWN
};
static const char *const shading_name[SHOWN] = {"flat",
                                                "gouraud",
                                                "phong",
                                                "slerp",
                                                "textured",
                                                "textured flat",
                                                "bilinear",
                                                "textured points",
                                                "matcap",
                                                "matcap-vertex",
                                                "matcap bilinear",
                                                "flat colored",
                                                "gouraud colored",
                                                "flat points",
                                                "gouraud points"};
static const char *prefix;

static bool has_uv(int shown)
{
    return shown >= TEXTURED && shown <= TEXTURED_POINTS;
}

static bool is_matcap(int shown)
{
    return shown >= MATCAP && shown <= MATCAP_BILINEAR;
}

/* Shadings that share the code for bias and pattern with another shading; they are tested with fewer kinds. */
static bool is_variant(int shown)
{
    return (shown > TEXTURED && shown < MATCAP) || shown > MATCAP_VERTEX;
}

static bool is_flat(int shown)
{
    return shown == REF_FLAT || shown == TEXTURED_FLAT || shown == FLAT_COLORED || shown == FLAT_POINTS;
}

/* A fog, given relative to the scene's near and far planes. */
struct range {
    double from, to; /* as fractions of the way from near to far; below 0 or above 1: beyond the planes */
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

/*
 * 95 % of the pixels must be equal; the share within one step and the worst pixel are limited per shading, in fog the
 * worst by one step more. Bilinear shadings are judged by what their texels allow.
 */
static bool kept(const struct ref_score *s, int shading, bool fog)
{
    const struct accuracy_limit *limit = &accuracy_limits[shading >= TEXTURED ? REF_GOURAUD : shading];
    const double compared = (double)s->compared;

    if (shading == BILINEAR || shading == MATCAP_BILINEAR)
        return (double)s->calm_equal >= ACCURACY_BILINEAR * (double)s->calm && s->beyond == 0 && s->dropped_drawn == 0;
    return s->equal >= (fog ? fmin(limit->equal, ACCURACY_FOGGED) : limit->equal) * compared &&
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
    const bool calm = shading == BILINEAR || shading == MATCAP_BILINEAR;
    const double of = (double)(calm ? s->calm : s->compared),
                 equal = of > 0 ? (double)(calm ? s->calm_equal : s->equal) / of : 1;
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

static enum ref_shading shading_of(int shown)
{
    return is_flat(shown)       ? REF_FLAT
           : shown <= REF_SLERP ? (enum ref_shading)shown
           : is_matcap(shown)   ? REF_PHONG
                                : REF_GOURAUD;
}

/* Colours of vertices, and coloured point lights. */
static void set_colors(struct ref_scene *scene, int shown, int i)
{
    scene->colored = shown == FLAT_COLORED || shown == GOURAUD_COLORED || i % 2;
    if (shown < FLAT_POINTS)
        return;
    accuracy_more_lights(scene);
    accuracy_tints(scene);
    accuracy_points(scene);
    scene->diffuse = 1.6;
}

static int view_of(struct ref_scene *scene, struct accuracy_mesh *mesh, int shown, int i)
{
    static const enum textured_light light[] = {TEXTURED_SCENE_GOURAUD, TEXTURED_SCENE_FLAT, TEXTURED_SCENE_GLOSSY,
                                                TEXTURED_SCENE_POINTS};
    const bool coarse = is_flat(shown) || (i % 3 == 0 && shown <= REF_SLERP);

    if (has_uv(shown)) {
        if (textured_mesh_make(mesh, i % 3) != 0)
            return -1;
        textured_view(scene, &mesh->reference, i % TEXTURED_VIEWS, light[shown - TEXTURED]);
        return 0;
    }
    if (accuracy_mesh_make(mesh, i % ACCURACY_SHAPES, coarse) != 0)
        return -1;
    accuracy_view(scene, &mesh->reference, i / 2 % ACCURACY_VIEWS);
    scene->shading = shading_of(shown);
    if (is_matcap(shown))
        scene->texels = shown == MATCAP_VERTEX ? REF_TEXELS_CORNER_NORMALS : REF_TEXELS_NORMAL;
    if (shown >= FLAT_COLORED)
        set_colors(scene, shown, i);
    else if (i % 7 == 6)
        accuracy_more_lights(scene);
    return 0;
}

enum kind {
    FOG,
    BIASED, /* by depth bias, which moves pixels in the fog too */
    LEFT_OUT,
    BOTH,
    HELD, /* with a bias that would move corners beyond a plane, where they are clamped */
    KINDS
};

static const char *const kind_name[KINDS] = {"fog", "biased", "left out", "both", "held"};

/* A picture with transparent texels, or one of the core's matcap spheres. */
static struct ref_texture texture_of(int shading, int i)
{
    static const struct sheen_texture *const sphere[] = {&sheen_matcap_chrome, &sheen_matcap_glaze, &sheen_matcap_clay,
                                                         &sheen_matcap_jade};
    struct ref_texture texture = *textured_picture(i % 2);

    texture.keyed = i % 3 == 2;
    texture.key = texture.texels[0];
    if (is_matcap(shading))
        texture = (struct ref_texture){.width = 1 << sphere[i % 4]->width_log2,
                                       .height = 1 << sphere[i % 4]->height_log2,
                                       .texels = sphere[i % 4]->texels,
                                       .clamp = {true, true}};
    texture.bits = 16;
    texture.bilinear = shading == BILINEAR || shading == MATCAP_BILINEAR;
    return texture;
}

/*
 * Moves one plane as near to a mesh of radius 1 as possible without cutting what faces the eye, and sets the largest
 * bias towards that plane.
 */
static void hold(struct ref_scene *scene, bool to_near)
{
    scene->bias = to_near ? 4095 : -4096;
    if (to_near)
        scene->near = scene->distance - 1;
    else
        scene->far = scene->distance + 0.1;
}

static int judge(int shading, enum kind kind)
{
    struct fog_line line = {.equal = 1};
    int failed = 0;

    for (int i = 0; i < (has_uv(shading) ? 10 : 16); i++) {
        struct ref_texture texture = texture_of(shading, i);
        struct accuracy_mesh mesh;
        struct ref_scene scene;
        if (kind == HELD && i > 8 && i < 15) /* only balls do not reach beyond the far plane */
            continue;
        if (view_of(&scene, &mesh, shading, i) != 0)
            return 1;
        scene.texture = has_uv(shading) || is_matcap(shading) ? &texture : NULL;
        if (i % 5 == 3)
            accuracy_ortho(&scene);
        scene.affine = i % 5 == 4;
        /* Dithered matcaps: a lid has a single colour, which may happen to lie on a rounding boundary. */
        scene.dither = i % 2 || shading == MATCAP_BILINEAR;
        if (kind == HELD)
            hold(&scene, i < 8);
        if (kind != LEFT_OUT)
            set_fog(&scene, &ranges[i % 4]);
        if (kind == BIASED)
            scene.bias = i % 2 ? 900 - 20 * i : 30 * i - 900;
        if (kind == LEFT_OUT || kind == BOTH) {
            scene.left_out = 4 + 13 * i % 56;
            scene.phase = i % 8;
        }
        failed += judge_picture(&line, &scene, mesh.mesh, shading);
        accuracy_mesh_free(&mesh);
    }
    printf("%-15s %-8s %2d pictures %5.1f %% compared %6.2f %% equal, worst %d, %ld of %ld left out are drawn\n",
           shading_name[shading], kind_name[kind], line.pictures, 100 * (double)line.compared / (double)line.covered,
           100 * line.equal, line.worst, line.dropped_drawn, line.dropped);
    if ((double)line.compared < ACCURACY_COMPARED * (double)line.covered) {
        printf("  FAILED too little was compared\n");
        failed++;
    }
    return failed;
}

/* At full fog everything vanishes in a background of the fog's colour, in every format, dithered too. */
static int judge_full(int shown)
{
    static struct accuracy_shot shot;
    static const int levels[] = {0, 2, 16, 256};
    static const double color[3] = {77 / 255.0, 123 / 255.0, 201 / 255.0};
    long drawn = 0, seams = 0;

    for (int i = 0; i < 8; i++) {
        struct ref_texture texture = texture_of(shown, i);
        struct accuracy_mesh mesh;
        struct ref_scene scene;
        struct ref_picture picture;
        if (view_of(&scene, &mesh, shown, i) != 0)
            return 1;
        scene.texture = has_uv(shown) || is_matcap(shown) ? &texture : NULL;
        scene.levels = levels[i % 4];
        scene.dither = i < 4;
        scene.fog = true;
        scene.fog_from = 0.5 * scene.near;
        scene.fog_to = scene.near;
        memcpy(scene.fog_color, color, sizeof color);
        memcpy(scene.background, color, sizeof color);
        if (ref_render(&picture, &scene) != 0)
            return 1;
        const int status = accuracy_shoot(&shot, &scene, &picture, mesh.mesh, 0);
        seams += status < 0;
        drawn += shot.stats.frame.drawn;
        for (int at = 0; at < scene.width * scene.height; at++)
            seams += shot.values[at] != ref_value(&scene, color, 0, 0, true);
        ref_picture_free(&picture);
        accuracy_mesh_free(&mesh);
    }
    printf("%-15s full fog: %ld triangles, %ld pixels show%s\n", shading_name[shown], drawn, seams,
           seams > 0 || drawn == 0 ? "  FAILED" : "");
    return seams > 0 || drawn == 0;
}

enum fault {
    IN_M,
    PHASE,
    UNBIASED,
    HELD_LATE,
    FAULTS
};

static const char *const fault_name[FAULTS] = {"fog linear in m", "another phase", "fog without the bias",
                                               "a bias held at the pixel"};

/* Recomputes the picture as if the biased depth were clamped at each pixel instead of at the corners. */
static void hold_pixels(struct ref_picture *picture, const struct ref_scene *scene)
{
    for (int i = 0; i < picture->width * picture->height; i++) {
        struct ref_pixel *pixel = &picture->pixels[i];
        const double z = ref_nearness(scene, pixel->m) + (double)scene->bias / REF_STEPS;
        if (pixel->covered)
            pixel->value = ref_fogged_value(scene, pixel->color, ref_fog_share(scene, fmin(fmax(z, 0), 1)),
                                            i % picture->width, i / picture->width);
    }
}

/* Proves that the comparison detects faults: a picture that differs from the reference's must be refused. */
static int judge_fault(enum fault fault)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;
    struct accuracy_mesh mesh;
    struct ref_scene scene;
    bool is_kept = true;

    if (view_of(&scene, &mesh, REF_GOURAUD, 0) != 0)
        return 1;
    if (fault == HELD_LATE)
        hold(&scene, true);
    set_fog(&scene, &ranges[fault == HELD_LATE]); /* the fog for HELD_LATE begins in front of the near plane */
    scene.left_out = fault == PHASE ? 32 : 0;
    scene.fog_in_m = fault == IN_M;
    if (ref_render(&picture, &scene) == 0) {
        scene.bias = fault == UNBIASED ? 900 : scene.bias;
        if (fault == HELD_LATE)
            hold_pixels(&picture, &scene);
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
    for (int shading = 0; shading < SHOWN; shading++)
        for (int kind = 0; kind < KINDS; kind++)
            if (kind == HELD ? shading == REF_GOURAUD || shading == MATCAP
                             : kind == FOG || kind == BOTH || !is_variant(shading))
                failed += judge(shading, (enum kind)kind);
    for (int shown = 0; shown < SHOWN; shown++)
        failed += judge_full(shown);
    for (int fault = 0; fault < FAULTS; fault++)
        failed += judge_fault((enum fault)fault);
    printf("%d pictures outside their limits\n", failed);
    return failed != 0;
}
