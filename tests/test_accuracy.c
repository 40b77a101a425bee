/*
 * test_accuracy.c - how close the integers come to the picture in double precision.
 *
 *   test_accuracy [all [PREFIX]]
 *
 * Every picture is judged by itself; a line sums up one mesh, view and shading: both sizes, perspective and
 * affine, shininess 8, 32 and 128; the light behind, strong highlights, cuts, dither and ramps besides. There the core
 * chooses how each triangle is shaded. Then each of the ways it chooses among is forced on all of the mesh's pictures
 * but the last four's, on every triangle that admits it (struct sheen_object's `way`), and has to keep the same
 * limits. Of a line's 12 pictures 4 are drawn, or all; PREFIX: each that fails is written as PPM files so called.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy_line.h"
#include "loaded_mesh.h"

static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};
static const char *prefix;
static bool draws_all;

/* The quick sample of a line has each shininess, both sizes, an affine picture and each case of `vary`. */
#define SAMPLED(i) ((i) == 0 || (i) == 2 || (i) == 7 || (i) == 9)

#define COARSE 100 /* triangles of a mesh whose highlights are as large as its triangles, at most */

/* What a line varies, besides meshes and views. */
enum variant {
    PLAIN,
    LIGHTS,
    ORTHO,
    BEHIND, /* the light, behind the mesh; full highlights */
    STRONG, /* full highlights of shininess 1, 4, 24, 128 */
    CUT,    /* by the near plane and the far one; every other picture magnified, by the guard band */
    DITHER,
    HALF, /* ramps: one light, several, the light behind, dithered, in turns */
    GAMMA,
    TOON,
    COLORS, /* of the vertices: one light, several, dithered, cut, in turns */
    TINTS,  /* of lights and ambient light, every other picture with the vertices'; by ramps too */
    POINTS, /* point lights with others, every other picture in white alone */
    VARIANTS
};
static const char *const variant_name[VARIANTS] = {"",     "lights", "ortho", "behind", "strong", "cut",   "dither",
                                                   "half", "gamma",  "toon",  "colors", "tints",  "points"};

/* The ways that are forced; `exact` is the way of triangles that do not admit the forced one. */
#define FORCED 12
static const struct forced {
    enum ref_shading shading;
    enum sheen_way way, exact;
    const char *name;
    bool colors; /* by the shader that has them */
} forced[FORCED] = {
    {REF_GOURAUD, SHEEN_WAY_GOURAUD_LINEAR, SHEEN_WAY_GOURAUD_QUOTIENT, "gouraud linear", false},
    {REF_GOURAUD, SHEEN_WAY_GOURAUD_QUADRATIC, SHEEN_WAY_GOURAUD_QUOTIENT, "gouraud quadratic", false},
    {REF_GOURAUD, SHEEN_WAY_GOURAUD_QUOTIENT, SHEEN_WAY_GOURAUD_QUOTIENT, "gouraud quotient", false},
    {REF_PHONG, SHEEN_WAY_PHONG_QUADRATIC, SHEEN_WAY_PHONG_ROOT, "phong quadratic", false},
    {REF_PHONG, SHEEN_WAY_PHONG_CELLS, SHEEN_WAY_PHONG_ROOT, "phong cells", false},
    {REF_PHONG, SHEEN_WAY_PHONG_ROOT, SHEEN_WAY_PHONG_ROOT, "phong root", false},
    {REF_SLERP, SHEEN_WAY_PHONG_QUADRATIC, SHEEN_WAY_SLERP_NORMALS, "slerp quadratic", false},
    {REF_SLERP, SHEEN_WAY_SLERP, SHEEN_WAY_SLERP_NORMALS, "slerp arcs", false},
    {REF_SLERP, SHEEN_WAY_SLERP_NORMALS, SHEEN_WAY_SLERP_NORMALS, "slerp normals", false},
    {REF_PHONG, SHEEN_WAY_PHONG_QUADRATIC, SHEEN_WAY_PHONG_LIGHTS, "phong colours", true},
    {REF_PHONG, SHEEN_WAY_PHONG_LIGHTS, SHEEN_WAY_PHONG_LIGHTS, "phong colours, root", true},
    {REF_SLERP, SHEEN_WAY_PHONG_QUADRATIC, SHEEN_WAY_SLERP_NORMALS, "slerp colours", true},
};

/* The lines of one mesh and shading: with the ways that the shading chose, and with forced ones. */
struct mesh_lines {
    struct accuracy_line chosen, by_force[FORCED];
};

static uint64_t took[FORCED], allowed[FORCED]; /* set-ups of all meshes */
static struct accuracy_line lowest[4];         /* by shading: the line that holds the lowest equal share, as chosen */
static char lowest_mesh[4][24];

/* Without perspective linear is exact and the only way; Phong and slerp have one with several lights and no colours. */
static bool has_ways(const struct ref_scene *scene, const struct forced *f)
{
    if (scene->shading > REF_GOURAUD && f->colors != scene->colored)
        return false;
    if (f->colors)
        return true;
    if (f->shading == REF_PHONG || f->shading == REF_SLERP)
        return scene->light_count == 1;
    return f->way == SHEEN_WAY_GOURAUD_LINEAR || !(scene->affine || scene->ortho);
}

/* True where no triangle took a way that it should not: one colour is for those too flat, or out of the light. */
static bool obeyed(const struct core_stats *stats, const struct forced *f, const struct ref_scene *scene)
{
    bool right = true;

    for (int way = 0; way < SHEEN_WAYS; way++) {
        bool flat_weight =
            way == SHEEN_WAY_GOURAUD_LINEAR; /* a triangle at right angles to the view: linear is exact */
        bool needle = (f->shading == REF_PHONG || f->colors) &&
                      way == SHEEN_WAY_PHONG_LIGHTS; /* what N.N, or a quadric, would be off for */
        if (way != SHEEN_WAY_FLAT && way != (int)f->way && way != (int)f->exact && !flat_weight && !needle)
            right = right && stats->by_way[way] == 0;
    }
    if (!right)
        printf("  FAILED %s: ways that were not asked for, %dx%d n %.0f\n", f->name, scene->width, scene->height,
               scene->shininess);
    return right;
}

static int draw_and_add(struct accuracy_line *line, struct accuracy_shot *shot, const struct ref_scene *scene,
                        const struct ref_picture *picture, const struct sheen_mesh *mesh, int view, unsigned way)
{
    int status = accuracy_shoot(shot, scene, picture, mesh, way);

    if (status < 0) {
        printf("  FAILED not drawn: %s\n", sheen_strerror(status));
        return 1;
    }
    int failed = accuracy_line_add(line, shot, scene, view);
    if (failed && prefix)
        accuracy_write_difference(prefix, scene, picture, shot);
    return failed;
}

/* One picture, chosen and, where asked for, forced. Pictures that failed. */
static int judge(struct accuracy_line *line, struct mesh_lines *lines, const struct ref_scene *scene,
                 const struct sheen_mesh *mesh, int view, bool forcing)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;
    int failed;

    if (ref_render(&picture, scene) != 0) {
        printf("  FAILED out of memory\n");
        return 1;
    }
    failed = draw_and_add(line, &shot, scene, &picture, mesh, view, 0);
    lines->chosen.setups += shot.stats.frame.setups;
    for (int way = 0; way < SHEEN_WAYS; way++)
        lines->chosen.by_way[way] += shot.stats.by_way[way];
    for (int i = 0; forcing && i < FORCED; i++) {
        const struct forced *f = &forced[i];
        if (f->shading != scene->shading || !has_ways(scene, f))
            continue;
        failed += draw_and_add(&lines->by_force[i], &shot, scene, &picture, mesh, view, 1 + f->way);
        failed += !obeyed(&shot.stats, f, scene);
    }
    ref_picture_free(&picture);
    return failed;
}

static const double behind[3] = {-0.6, 0.3, -0.7};

static void vary_ramp(struct ref_scene *scene, enum ref_ramp ramp, int i)
{
    scene->ramp = ramp;
    scene->ambient += 0.0065; /* a tread's colour would lie on the edge between two levels, a matter of luck */
    if (i % 4 == 1)
        accuracy_more_lights(scene);
    if (i % 4 == 2)
        memcpy(scene->light[0], behind, sizeof behind);
    scene->dither = i % 4 == 3;
}

static void vary_colors(struct ref_scene *scene, int i)
{
    scene->colored = true;
    scene->base[0] = scene->base[1] = scene->base[2] = 1;
    if (i % 4 == 1)
        accuracy_more_lights(scene);
    scene->dither = i % 4 == 2;
    if (i % 4 == 3) {
        scene->near = scene->distance - 0.8;
        scene->two_sided = true;
        scene->width = scene->height = 320; /* enough that is not near the cut */
    }
}

static void vary_tints(struct ref_scene *scene, int i)
{
    vary_colors(scene, i);
    accuracy_more_lights(scene);
    accuracy_tints(scene);
    scene->colored = i % 2;
    if (i >= 9)
        scene->ramp = i == 9 ? REF_GAMMA : REF_HALF;
}

static void vary_points(struct ref_scene *scene, int i)
{
    if (i % 2)
        vary_tints(scene, i);
    else
        vary_colors(scene, i);
    accuracy_more_lights(scene);
    scene->colored = i % 4 > 1;
    scene->diffuse = 1.6;
    accuracy_points(scene);
}

static void vary(struct ref_scene *scene, enum variant variant, int i)
{
    static const double shininess[4] = {1, 4, 24, 128};

    switch (variant) {
    case LIGHTS:
        accuracy_more_lights(scene);
        break;
    case ORTHO:
        accuracy_ortho(scene);
        break;
    case BEHIND:
        memcpy(scene->light[0], behind, sizeof behind);
        scene->specular = 1;
        break;
    case STRONG:
        scene->shininess = shininess[i % 4];
        scene->specular = 1;
        break;
    case CUT:
        scene->near = scene->distance - 0.9;
        scene->far = scene->distance - 0.1;
        if (i % 2)
            scene->fov = 14;
        break;
    case DITHER:
        scene->dither = true;
        break;
    case HALF:
        vary_ramp(scene, REF_HALF, i);
        break;
    case GAMMA:
        vary_ramp(scene, REF_GAMMA, i);
        break;
    case TOON:
        vary_ramp(scene, REF_TOON, i);
        break;
    case COLORS:
        vary_colors(scene, i);
        break;
    case TINTS:
        vary_tints(scene, i);
        break;
    case POINTS:
        vary_points(scene, i);
        break;
    default:
        break;
    }
}

/* A line of the table: 12 pictures, or what stands for them. */
static int judge_line(struct mesh_lines *lines, const struct accuracy_mesh *mesh, int view, enum ref_shading shading,
                      enum variant variant)
{
    static const double shininess[3] = {8, 32, 128};
    struct accuracy_line line;
    char what[32];
    int failed = 0;

    accuracy_line_begin(&line);
    if (variant == CUT)
        line.least_compared = 0.1; /* much of what is left lies at the cut */
    if (variant == TOON)
        line.least_compared = 0.2; /* around its jumps, which are edges; four lights have twelve */
    for (int i = 0; i < 12; i++) {
        struct ref_scene scene;
        if (!draws_all && !SAMPLED(i))
            continue;
        accuracy_view(&scene, &mesh->reference, view);
        scene.shading = shading;
        scene.shininess = shininess[i % 3];
        scene.affine = i / 3 % 2;
        scene.width = i / 6 ? 240 : 320;
        vary(&scene, variant, i);
        failed += judge(&line, lines, &scene, mesh->mesh, view, variant <= ORTHO || variant == COLORS);
    }
    snprintf(what, sizeof what, "%d %s", view, variant_name[variant]);
    accuracy_line_print(&line, mesh->name, what, shading_name[shading]);
    if (line.equal < lowest[shading].equal) {
        lowest[shading] = line;
        snprintf(lowest_mesh[shading], sizeof lowest_mesh[shading], "%s", mesh->name);
    }
    return failed;
}

static void print_ways(const struct mesh_lines *lines, const struct accuracy_mesh *mesh, enum ref_shading shading)
{
    for (int i = 0; i < FORCED; i++) {
        const struct accuracy_line *line = &lines->by_force[i];
        char what[32];
        if (forced[i].shading != shading || line->setups == 0)
            continue;
        snprintf(what, sizeof what, "%5.1f %%", 100 * accuracy_line_share(line, forced[i].way));
        accuracy_line_print(line, mesh->name, what, forced[i].name);
        took[i] += line->by_way[forced[i].way];
        allowed[i] += line->setups;
    }
    if (shading == REF_GOURAUD || shading == REF_PHONG) {
        printf("%-14s %s, as chosen: ", mesh->name, shading_name[shading]);
        accuracy_line_print_ways(&lines->chosen);
        printf("\n");
    }
}

/* Pictures that failed. */
static int judge_mesh(const struct accuracy_mesh *mesh, enum ref_shading shading)
{
    struct mesh_lines lines;
    int failed = 0;

    accuracy_line_begin(&lines.chosen);
    for (int i = 0; i < FORCED; i++)
        accuracy_line_begin(&lines.by_force[i]);
    for (int view = 0; view < ACCURACY_VIEWS; view++)
        failed += judge_line(&lines, mesh, view, shading, PLAIN);
    failed += judge_line(&lines, mesh, 1, shading, LIGHTS);
    failed += judge_line(&lines, mesh, 0, shading, ORTHO);
    failed += judge_line(&lines, mesh, 0, shading, BEHIND);
    failed += judge_line(&lines, mesh, 2, shading, DITHER);
    failed += judge_line(&lines, mesh, 0, shading, HALF);
    failed += judge_line(&lines, mesh, 1, shading, GAMMA);
    failed += judge_line(&lines, mesh, 2, shading, TOON);
    if (shading != REF_SLERP) /* which the definition exempts where triangles were cut */
        failed += judge_line(&lines, mesh, 1, shading, CUT);
    if (shading != REF_FLAT && mesh->reference.triangle_count <= COARSE)
        failed += judge_line(&lines, mesh, 1, shading, STRONG);
    if (mesh->reference.color)
        failed += judge_line(&lines, mesh, 1, shading, COLORS) + judge_line(&lines, mesh, 2, shading, TINTS);
    if (shading <= REF_GOURAUD && mesh->reference.color)
        failed += judge_line(&lines, mesh, 0, shading, POINTS);
    print_ways(&lines, mesh, shading);
    return failed;
}

/* The command's own way: its reader, normals, splitting and numbers against the reference's. Flat: if coarse. */
static int judge_loaded(const char *name, enum ref_shading first)
{
    struct accuracy_mesh mesh;
    struct loaded_mesh loaded;
    int failed = 0;

    if (loaded_mesh_make(&loaded, name) != 0)
        return 1;
    mesh = (struct accuracy_mesh){.name = loaded.name, .reference = loaded.reference, .mesh = &loaded.quantised.mesh};
    for (int shading = (int)first; shading <= REF_SLERP; shading++)
        failed += judge_mesh(&mesh, (enum ref_shading)shading);
    loaded_mesh_free(&loaded);
    return failed;
}

static int judge_shape(int index)
{
    int failed = 0;

    for (int shading = REF_FLAT; shading <= REF_SLERP; shading++) {
        struct accuracy_mesh mesh;
        if (accuracy_mesh_make(&mesh, index, shading == REF_FLAT) != 0) {
            fprintf(stderr, "test_accuracy: shape %d could not be made\n", index);
            return 1;
        }
        failed += judge_mesh(&mesh, (enum ref_shading)shading);
        accuracy_mesh_free(&mesh);
    }
    return failed;
}

/* A way that hardly a triangle admits has not been tried. */
static int judge_shares(void)
{
    int failed = 0;

    for (int i = 0; i < FORCED; i++) {
        printf("forced %-18s taken by %8llu of %8llu set-ups\n", forced[i].name, (unsigned long long)took[i],
               (unsigned long long)allowed[i]);
        if (took[i] < allowed[i] / 100) {
            printf("  FAILED too few for a test\n");
            failed++;
        }
    }
    return failed;
}

int main(int argc, char **argv)
{
    static const char *const loaded[] = {"builtin:teapot", "builtin:sphere", "builtin:torus", "data/egg.obj"};
    int failed = 0;

    draws_all = argc > 1 && strcmp(argv[1], "all") == 0;
    prefix = argc > 2 ? argv[2] : NULL;
    for (int i = 0; i < 4; i++)
        accuracy_line_begin(&lowest[i]);
    accuracy_line_heading();
    for (size_t i = 0; i < sizeof loaded / sizeof *loaded; i++)
        failed += judge_loaded(loaded[i], REF_GOURAUD);
    failed += judge_loaded("data/star.obj", REF_FLAT);
    for (int index = 0; index < ACCURACY_SHAPES; index++)
        failed += judge_shape(index);
    failed += judge_shares();
    for (int i = 0; i < 4; i++)
        printf("lowest equal share of %-8s %.2f %%: %s, %s\n", shading_name[i], 100 * lowest[i].equal, lowest_mesh[i],
               lowest[i].lowest);
    printf("%d pictures outside their limits\n", failed);
    return failed != 0;
}
