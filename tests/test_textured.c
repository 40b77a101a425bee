/*
 * test_textured.c - textures against their definition (core/sheen.h) in double precision, within the limits of
 * accuracy.h. At the end faults are put in, and each must be refused.
 *
 *   test_textured [all [PREFIX]]     one line per mesh, texture and light, a third of them or all; PREFIX: where to
 *                                    save pictures of what failed
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy_line.h"
#include "textured_scene.h"

static const char *const light_name[] = {"unlit",  "flat",        "gouraud", "glossy", "lights",
                                         "colors", "flat colors", "tints",   "points", "flat points"};
static const char *const picture_name[] = {"tiles", "noise", "marble", "sixteen"};
static const char *prefix;
static bool draws_all;
static int lines; /* how many lines were asked for so far */

/* Sums over the pictures of a line; `equal` is the lowest share. */
struct textured_line {
    double equal;
    long covered, comparable, compared, calm, beyond, dropped, dropped_drawn;
    int pictures, worst;
    uint64_t setups, quotients;
};

static double part_of(long part, long whole)
{
    return whole > 0 ? (double)part / (double)whole : 1;
}

static double lower(double a, double b)
{
    return a < b ? a : b;
}

static int score_line(struct textured_line *line, const struct accuracy_shot *shot, const struct ref_scene *scene)
{
    const struct ref_score *s = &shot->score;
    const double equal = part_of(s->calm_equal, s->calm);
    const struct ref_texture *t = scene->texture;
    const double least = t->bilinear ? ACCURACY_BILINEAR : accuracy_limits[REF_GOURAUD].equal;

    line->covered += s->covered;
    line->comparable += s->comparable;
    line->compared += s->compared;
    line->calm += s->calm;
    line->equal = lower(line->equal, equal);
    line->beyond += s->beyond;
    line->dropped += s->dropped;
    line->dropped_drawn += s->dropped_drawn;
    line->worst = s->worst > line->worst ? s->worst : line->worst;
    line->pictures++;
    line->setups += shot->stats.frame.setups;
    line->quotients += shot->stats.by_way[SHEEN_WAY_TEXTURED_QUOTIENT];
    if (equal >= least && s->beyond == 0 && s->dropped_drawn == 0)
        return 0;
    printf("  FAILED %s%s%s%s%s%s%s %d bits, picture %d: %ld covered, %ld comparable, %ld compared, %ld of "
           "%ld calm ones equal, %ld beyond, worst %d at (%d, %d), %ld of %ld drawn\n",
           t->bilinear ? "bilinear" : "nearest", scene->affine ? " affine" : "", scene->ortho ? " ortho" : "",
           scene->dither ? " dither" : "", t->keyed ? " key" : "", t->clamp[0] ? " clamp u" : "",
           t->clamp[1] ? " clamp v" : "", t->bits, line->pictures, s->covered, s->comparable, s->compared,
           s->calm_equal, s->calm, s->beyond, s->worst, s->worst_x, s->worst_y, s->dropped_drawn, s->dropped);
    return 1;
}

static int judge_picture(struct textured_line *line, const struct ref_scene *scene, const struct sheen_mesh *mesh)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;

    if (ref_render(&picture, scene) != 0)
        return 1;
    int status = accuracy_shoot(&shot, scene, &picture, mesh, 0);
    int failed = status < 0 || score_line(line, &shot, scene);
    if (status < 0)
        printf("  FAILED %s\n", sheen_strerror(status));
    if (failed && prefix)
        accuracy_write_difference(prefix, scene, &picture, &shot);
    ref_picture_free(&picture);
    return failed;
}

/* All views, then one affine and one orthographic; dither, ramp, bits, clamping and key vary with `turn`. */
static int judge_textured(const struct accuracy_mesh *mesh, int picture, enum textured_light light, bool bilinear,
                          int turn)
{
    struct textured_line line = {.equal = 1};
    int failed = 0;

    if (!draws_all && lines++ % 3 != 0)
        return 0;
    for (int i = 0; i < TEXTURED_VIEWS + 2; i++, turn++) {
        struct ref_texture texture = *textured_picture(picture);
        struct ref_scene scene;
        textured_view(&scene, &mesh->reference, i < TEXTURED_VIEWS ? i : 1, light);
        scene.affine = i == TEXTURED_VIEWS;
        scene.texture = &texture;
        scene.dither = turn % 3 == 1;
        scene.ramp = light == TEXTURED_SCENE_UNLIT || turn % 3 < 2 ? REF_LAMBERT : turn % 2 ? REF_GAMMA : REF_HALF;
        texture.bilinear = bilinear;
        texture.bits = picture == 3 ? 4 << turn % 3 : picture == 2 ? 16 : 8 << turn % 2;
        texture.clamp[0] = turn % 5 == 2;
        texture.clamp[1] = turn % 5 > 2;
        texture.keyed = turn % 4 == 3 && picture != 2;
        texture.key = texture.texels[turn % 7];
        if (i == TEXTURED_VIEWS + 1)
            accuracy_ortho(&scene);
        failed += judge_picture(&line, &scene, mesh->mesh);
    }
    const double compared = part_of(line.compared, line.covered);
    if (compared < ACCURACY_COMPARED) {
        printf("  FAILED too little was compared\n");
        failed++;
    }
    printf("%-10s %-8s %-11s %-8s %5.1f %% compared %5.1f %% settled %5.1f %% calm %6.2f %% equal, %ld beyond, worst "
           "%d, %ld of %ld "
           "drawn, %3.0f %% quotients\n",
           mesh->name, picture_name[picture], light_name[light], bilinear ? "bilinear" : "nearest", 100 * compared,
           100 * part_of(line.compared, line.comparable), 100 * part_of(line.calm, line.compared), 100 * line.equal,
           line.beyond, line.worst, line.dropped_drawn, line.dropped,
           100 * part_of((long)line.quotients, (long)line.setups));
    return failed;
}

/* ---- the test of the test ---- */

enum fault {
    FLIPPED,
    SHIFTED,
    AFFINE,
    TWICE,
    CUT,
    NO_FAULT, /* the scene of CUT without the fault */
    LATE,
    TINTED,
    ON_SCREEN,
    COLORED,
    FAULTS
};

static const char *const fault_name[FAULTS] = {"v upwards",
                                               "1/8 texel to the right",
                                               "affine",
                                               "rounded to a byte first",
                                               "lit where the planes cut",
                                               "none",
                                               "colours multiplied after interpolation",
                                               "highlight times texel",
                                               "light linear on the screen",
                                               "none, with colours"};

/* Lights the corners that cutting made by their own normals instead of interpolating the light. */
static void light_cut_corners(struct ref_picture *picture, const struct ref_scene *scene)
{
    static const double nowhere[3] = {0, 0, 0}; /* there are no point lights */

    for (size_t i = 0; i < picture->piece_count; i++) {
        struct ref_piece *p = &picture->pieces[i];
        for (int k = 0; k < 3; k++) {
            double n[3] = {p->normal[k][0], p->normal[k][1], p->normal[k][2]};
            double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            /* not new: a new corner's normal, interpolated between different unit normals, is shorter */
            if (length > 1 - 1e-9)
                continue;
            for (int j = 0; j < 3; j++)
                n[j] /= length;
            ref_light(scene, nowhere, n, &p->lit[k]);
        }
    }
}

/* Takes the vertices' colours out of the light, to multiply the interpolated colours at each pixel instead. */
static void take_colors(struct ref_picture *picture)
{
    for (size_t i = 0; i < picture->piece_count; i++)
        for (int k = 0; k < 9; k++)
            picture->pieces[i].lit[k / 3].diffuse[k % 3] /= picture->pieces[i].color[k / 3][k % 3];
}

static void faulty_light(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y,
                         enum fault fault, struct ref_lit *lit)
{
    struct ref_scene as = *scene;
    double color[3];

    as.affine |= fault == ON_SCREEN;
    ref_shade(&as, piece, x, y, lit);
    ref_color(scene, piece, x, y, color);
    for (int k = 0; k < 3 && fault == LATE; k++)
        lit->diffuse[k] *= color[k];
}

/* Recomputes the picture from its pieces' light as it is now, or with a fault. */
static void colour_again(struct ref_picture *picture, const struct ref_scene *scene, enum fault fault)
{
    for (int i = 0; i < picture->width * picture->height; i++) {
        struct ref_pixel *pixel = &picture->pixels[i];
        const struct ref_piece *piece = &picture->pieces[pixel->piece];
        const int x = i % picture->width, y = i / picture->width;
        double at[2], texel[3];
        struct ref_lit lit;
        if (!pixel->covered)
            continue;
        ref_texture_point(scene, piece, x + 0.5, y + 0.5, at);
        (void)ref_texture_color(scene->texture, at, texel);
        faulty_light(scene, piece, x + 0.5, y + 0.5, fault, &lit);
        for (int k = 0; k < 3; k++) {
            double gloss = scene->highlight[k] * lit.specular[k] * (fault == TINTED ? texel[k] : 1);
            double c = scene->base[k] * texel[k] * lit.diffuse[k] + gloss;
            pixel->color[k] = fault == TWICE ? floor(255 * fmin(c, 1) + 0.5) / 255 : c;
        }
        pixel->value = ref_value(scene, pixel->color, x, y, false);
    }
}

/* The core's picture of one scene must be refused against the reference's picture of a different one. */
static int judge_fault(enum fault fault)
{
    static struct accuracy_shot shot;
    struct ref_texture texture = *textured_picture(0);
    struct textured_line line = {.equal = 1};
    struct accuracy_mesh mesh;
    struct ref_scene scene;
    struct ref_picture picture;
    const bool is_cut = fault == CUT || fault == NO_FAULT, is_right = fault == NO_FAULT || fault == COLORED;
    int kept = !is_right;

    if (textured_mesh_make(&mesh, is_cut || fault >= ON_SCREEN ? 4 : 1) != 0)
        return 1;
    textured_view(&scene, &mesh.reference, is_cut || fault >= ON_SCREEN ? 3 : 1,
                  fault >= LATE ? TEXTURED_SCENE_COLORS : TEXTURED_SCENE_GOURAUD);
    if (is_cut) /* the near plane cuts in the middle of the screen */
        scene.near = 1.2;
    scene.texture = &texture;
    scene.affine = fault == AFFINE;
    for (size_t c = 0; c < mesh.reference.corner_count; c++) {
        double *uv = mesh.reference.uv[c];
        uv[0] += fault == SHIFTED ? 0.125 / texture.width : 0;
        uv[1] = fault == FLIPPED ? 1 - uv[1] : uv[1];
    }
    if (ref_render(&picture, &scene) == 0) {
        scene.affine = false;
        if (fault == CUT)
            light_cut_corners(&picture, &scene);
        if (fault == LATE)
            take_colors(&picture);
        if (is_cut || fault == TWICE || fault >= LATE)
            colour_again(&picture, &scene, fault);
        if (accuracy_shoot(&shot, &scene, &picture, mesh.mesh, 0) == SHEEN_OK)
            kept = !score_line(&line, &shot, &scene);
        ref_picture_free(&picture);
    }
    const int wrong = kept != is_right;
    printf("fault, %s: %s%s\n", fault_name[fault], kept ? "kept" : "refused", wrong ? ": WRONG" : "");
    accuracy_mesh_free(&mesh);
    return wrong;
}

/* ---- two forms of one texture ---- */

/* Texels of 565 have loops of their own, palettes do not; both must give the same picture. */
static int judge_forms(void)
{
    static struct accuracy_shot wide, narrow;
    struct ref_texture texture = *textured_picture(0);
    struct accuracy_mesh mesh;
    struct ref_picture picture;
    int differ = 0;

    if (textured_mesh_make(&mesh, 2) != 0)
        return 1;
    for (int i = 0; i < 2 * 2 * TEXTURED_VIEWS; i++) {
        struct ref_scene scene;
        textured_view(&scene, &mesh.reference, i / 4, i & 1 ? TEXTURED_SCENE_GOURAUD : TEXTURED_SCENE_UNLIT);
        scene.texture = &texture;
        scene.dither = i >> 1 & 1;
        if (ref_render(&picture, &scene) != 0)
            return 1;
        texture.bits = 16;
        differ += accuracy_shoot(&wide, &scene, &picture, mesh.mesh, 0) != SHEEN_OK;
        texture.bits = 8;
        differ += accuracy_shoot(&narrow, &scene, &picture, mesh.mesh, 0) != SHEEN_OK;
        differ += memcmp(wide.values, narrow.values, sizeof wide.values) != 0;
        ref_picture_free(&picture);
    }
    printf("565 and palettes: %d of %d pictures differ\n", differ, 4 * TEXTURED_VIEWS);
    accuracy_mesh_free(&mesh);
    return differ;
}

/*
 * A wall that near plane and guard band cut, with uv in steps of 1 / 2^bits of the picture. Fills in the target and
 * counts the triangles that were cut; 0 or a negative code.
 */
static int shoot_wall(struct memory_target *target, const struct sheen_shader *shader, unsigned bits, uint32_t *cut)
{
    static const int16_t corners[] = {32767, -32767, 0, 32767, 32767, 0, 32767, 32767, -32767, 32767, -32767, -32767};
    static const int16_t normals[] = {-32767, 0, 0, -32767, 0, 0, -32767, 0, 0, -32767, 0, 0};
    static const uint8_t triangles[] = {0, 2, 3, 0, 1, 2};
    const int16_t one = (int16_t)(1 << bits), two = (int16_t)(2 << bits);
    const int16_t uvs[] = {(int16_t)-one, two, (int16_t)-one, 0, one, 0, one, two};
    const struct sheen_mesh mesh = {.positions = corners,
                                    .normals = normals,
                                    .indices = triangles,
                                    .index_bytes = 1,
                                    .vertices = 4,
                                    .triangles = 2,
                                    .scale = SHEEN_Q24(1),
                                    .uvs = uvs,
                                    .uv_bits = (uint8_t)bits};
    static const uint16_t texels[4] = {0xffff, 0x001f, 0xf800, 0x07e0};
    const struct sheen_texture tiles = {.texels = texels, .width_log2 = 1, .height_log2 = 1};
    const struct sheen_material material = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1), .texture = &tiles};
    const struct sheen_object wall = {.mesh = &mesh, .material = &material, .shader = shader};
    const struct sheen_config config = {.target = &target->target,
                                        .max_vertices = 4,
                                        .max_triangles = 40,
                                        .max_clipped = 40,
                                        .clipper = &sheen_clipper};
    struct sheen_view view = {.z_near = SHEEN_Q24(0.1), .z_far = SHEEN_Q24(9), .fov = SHEEN_DEGREES(100)};
    struct sheen_stats stats;
    struct core_frame f;

    sheen_pose_orbit(&view.pose, SHEEN_DEGREES(10), 0, SHEEN_DEGREES(6), 0);
    int error = core_frame_make(&f, &config);
    if (error < 0)
        return error;
    error = sheen_render(f.frame, &view, &wall, 1);
    sheen_frame_stats(f.frame, &stats);
    *cut = stats.clipped;
    core_frame_free(&f);
    return error;
}

/* Cut triangles show the same whatever the steps of a mesh's uv are, as long as its own uv are the same numbers. */
static int judge_steps(void)
{
    static const struct sheen_shader *const shader[2] = {&sheen_textured, &sheen_textured_flat};
    static const unsigned bits[4] = {13, 0, 3, 10};
    int differ = 0;

    for (int i = 0; i < 2; i++) {
        struct memory_target target[4];
        for (int k = 0; k < 4; k++) {
            uint32_t cut = 0;
            if (memory_target_init(&target[k], 320, 240, SHEEN_RGB565_LE) != 0 ||
                shoot_wall(&target[k], shader[i], bits[k], &cut) != SHEEN_OK || cut != 2)
                return 1;
            differ += memcmp(target[k].memory, target[0].memory, target[0].row_bytes * 240) != 0;
        }
        for (int k = 0; k < 4; k++)
            memory_target_free(&target[k]);
    }
    printf("steps of uv: %d of 8 pictures of cut triangles differ\n", differ);
    return differ;
}

/* ---- what sheen_draw refuses ---- */

static int draw_about(const struct sheen_object *object, const struct sheen_target *target)
{
    const struct sheen_config config = {.target = target, .max_vertices = 100, .max_triangles = 100};
    const struct sheen_view view = {.fov = 0};
    struct core_frame f;

    if (core_frame_make(&f, &config) < 0)
        return -1;
    int status = sheen_render(f.frame, &view, object, 1);
    int about = status == SHEEN_OK ? 0 : (int)sheen_frame_about(f.frame, NULL);
    core_frame_free(&f);
    return about;
}

/* A bilinear matcap must clamp in both directions. */
static int judge_matcaps(struct sheen_object *object, struct sheen_material *material,
                         const struct sheen_target *target)
{
    static const struct sheen_shader *const shader[4] = {&sheen_matcap, &sheen_matcap_vertex, &sheen_matcap_colored,
                                                         &sheen_matcap_vertex_colored};
    const struct sheen_texture *const good = material->texture;
    struct sheen_texture texture = *good;
    int wrong = 0;

    material->texture = &texture;
    for (unsigned i = 0; i < 4 * 8; i++) {
        object->shader = shader[i / 8];
        texture.bilinear = i & 1;
        texture.clamp_u = i >> 1 & 1;
        texture.clamp_v = i >> 2 & 1;
        const enum sheen_subject right =
            (i & 7) == 1 || (i & 7) == 3 || (i & 7) == 5 ? SHEEN_ABOUT_TEXTURE : SHEEN_ABOUT_NOTHING;
        wrong += draw_about(object, target) != (int)right;
    }
    material->texture = good;
    return wrong;
}

static int judge_arguments(void)
{
    static const uint8_t numbers[1] = {0};
    static const uint16_t white[1] = {0xffff};
    const struct sheen_texture good = {.texels = white};
    struct sheen_texture bad[6] = {good, good, good, good, good, good};
    struct sheen_material material = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1), .texture = &good};
    struct memory_target target;
    struct accuracy_mesh mesh;
    int wrong = 0;

    if (textured_mesh_make(&mesh, 1) != 0 || memory_target_init(&target, 16, 16, SHEEN_RGB565_LE) != 0)
        return 1;
    struct sheen_object object = {.mesh = &mesh.own.mesh, .material = &material, .shader = &sheen_textured};
    object.pose = (struct sheen_pose){.translation = {0, 0, -SHEEN_Q24(3)}};
    bad[0].texels = NULL;
    bad[1].width_log2 = 10;
    bad[2].height_log2 = 10;
    bad[3].bits = 2;
    bad[4] = (struct sheen_texture){.texels = numbers, .bits = 8};
    bad[5] = (struct sheen_texture){.texels = numbers, .bits = 4};
    wrong += draw_about(&object, &target.target) != 0;
    for (int i = 0; i < 6; i++) {
        material.texture = &bad[i];
        wrong += draw_about(&object, &target.target) != SHEEN_ABOUT_TEXTURE;
    }
    material.texture = NULL;
    wrong += draw_about(&object, &target.target) != SHEEN_ABOUT_TEXTURE;
    material.texture = &good;
    mesh.own.mesh.uv_bits = 16;
    wrong += draw_about(&object, &target.target) != SHEEN_ABOUT_UVS;
    mesh.own.mesh.uv_bits = 15;
    mesh.own.mesh.uvs = NULL;
    wrong += draw_about(&object, &target.target) != SHEEN_ABOUT_UVS;
    mesh.own.mesh.uvs = mesh.own.uvs;
    wrong += judge_matcaps(&object, &material, &target.target);
    object.shader = &sheen_textured;
    mesh.own.mesh.normals = NULL;
    wrong += draw_about(&object, &target.target) != SHEEN_ABOUT_NORMALS;
    object.shader = &sheen_textured_flat;
    wrong += draw_about(&object, &target.target) != 0;
    printf("arguments: %d answers that are wrong\n", wrong);
    memory_target_free(&target);
    accuracy_mesh_free(&mesh);
    return wrong;
}

int main(int argc, char **argv)
{
    int failed = 0, faults = 0, turn = 0;

    draws_all = argc > 1 && strcmp(argv[1], "all") == 0;
    prefix = argc > 2 ? argv[2] : NULL;
    for (int index = 0; index < TEXTURED_MESHES; index++) {
        struct accuracy_mesh mesh;
        if (textured_mesh_make(&mesh, index) != 0) {
            fprintf(stderr, "test_textured: mesh %d could not be made\n", index);
            return 1;
        }
        for (int light = 0; light < TEXTURED_SCENE_ALL; light++) {
            if (textured_is_flat((enum textured_light)light) && (index == 2 || index == 3))
                continue; /* too fine to be judged polygon by polygon */
            for (int picture = 0; picture < TEXTURED_PICTURES; picture++, turn++)
                failed += judge_textured(&mesh, picture, (enum textured_light)light, picture == 2, turn);
            if (light == TEXTURED_SCENE_GOURAUD) /* pictures of high contrast are drawn bilinear too */
                for (int picture = 0; picture < TEXTURED_PICTURES; picture++)
                    failed += picture == 2 ? 0 : judge_textured(&mesh, picture, TEXTURED_SCENE_GOURAUD, true, turn);
        }
        accuracy_mesh_free(&mesh);
    }
    for (int fault = 0; fault < FAULTS; fault++)
        faults += judge_fault((enum fault)fault);
    faults += judge_forms();
    faults += judge_steps();
    faults += judge_arguments();
    printf("%d pictures outside their limits\n", failed);
    return failed + faults != 0;
}
