/*
 * test_colored.c - colours at the corners: what test_accuracy's limits refuse, and what does not depend on colours.
 *
 * The core's picture of a scene against the reference's with a fault in it; how close the core comes without one is
 * test_accuracy's.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "accuracy.h"

enum fault {
    SWAPPED,
    LATE,
    COARSE,
    NO_FAULT,
    FAULTS
};

static const char *const fault_name[FAULTS] = {"red and blue exchanged", "multiplied elsewhere", "colours of 5 bits",
                                               "none"};

static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};

#define ICOSAHEDRON 6 /* of accuracy_mesh_make */
#define BALL 7

static void set_scene(struct ref_scene *scene, const struct accuracy_mesh *mesh, enum ref_shading shading)
{
    accuracy_view(scene, &mesh->reference, 1);
    scene->shading = shading;
    scene->width = scene->height = 240;
    scene->base[0] = scene->base[1] = scene->base[2] = 1;
    scene->colored = true;
}

static void spoil(struct ref_mesh *mesh, enum fault fault)
{
    for (size_t c = 0; c < mesh->corner_count; c++) {
        double *color = mesh->color[c], red = color[0];
        if (fault == SWAPPED) {
            color[0] = color[2];
            color[2] = red;
        }
        for (int k = 0; fault == COARSE && k < 3; k++)
            color[k] = floor(31 * color[k] + 0.5) / 31;
    }
}

/* Light without colours times colours, at the pixel; where that is right, the highlight too. */
static void colour_late(struct ref_picture *picture, const struct ref_scene *scene)
{
    struct ref_scene plain = *scene;

    plain.colored = false;
    for (size_t i = 0; i < picture->piece_count; i++) {
        struct ref_piece *p = &picture->pieces[i];
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++)
                p->lit[k].diffuse[j] /= p->color[k][j];
    }
    for (int i = 0; i < picture->width * picture->height; i++) {
        struct ref_pixel *pixel = &picture->pixels[i];
        const struct ref_piece *p = &picture->pieces[pixel->piece];
        const int x = i % picture->width, y = i / picture->width;
        struct ref_lit lit;
        double b[3];
        if (!pixel->covered)
            continue;
        ref_weights(scene, p, x + 0.5, y + 0.5, b);
        ref_shade(&plain, p, x + 0.5, y + 0.5, &lit);
        for (int k = 0; k < 3; k++) {
            double color = b[0] * p->color[0][k] + b[1] * p->color[1][k] + b[2] * p->color[2][k];
            pixel->color[k] = lit.diffuse[k] * color +
                              scene->highlight[k] * lit.specular[k] * (scene->shading == REF_GOURAUD ? 1 : color);
        }
        pixel->value = ref_value(scene, pixel->color, x, y, false);
    }
}

/* 1 where the limits do not tell. */
static int judge_fault(enum fault fault, enum ref_shading shading)
{
    static struct accuracy_shot shot;
    struct accuracy_mesh mesh;
    struct ref_scene scene;
    struct ref_picture picture;
    int kept = fault != NO_FAULT;

    if (accuracy_mesh_make(&mesh, ICOSAHEDRON, false) != 0)
        return 1;
    set_scene(&scene, &mesh, shading);
    spoil(&mesh.reference, fault);
    if (ref_render(&picture, &scene) == 0) {
        if (fault == LATE)
            colour_late(&picture, &scene);
        if (accuracy_shoot(&shot, &scene, &picture, mesh.mesh, 0) == SHEEN_OK)
            kept = accuracy_kept(&shot.score, scene.shading, ACCURACY_COMPARED);
        ref_picture_free(&picture);
    }
    const int wrong = kept == (fault != NO_FAULT);
    printf("%s, fault %s: %ld of %ld equal, worst %d, %s%s\n", shading_name[shading], fault_name[fault],
           shot.score.equal, shot.score.compared, shot.score.worst, kept ? "kept" : "refused", wrong ? ": WRONG" : "");
    accuracy_mesh_free(&mesh);
    return wrong;
}

/* Of two core's pictures: pixels that differ. */
static int differing(const struct accuracy_shot *a, const struct accuracy_shot *b, const struct ref_scene *scene)
{
    int differ = 0;

    for (int i = 0; i < scene->width * scene->height; i++)
        differ += a->values[i] != b->values[i];
    return differ;
}

/* Without colours it is Gouraud's picture, but for what rounds elsewhere; Gouraud does not read colours. */
static int judge_without(void)
{
    static struct accuracy_shot plain, colored, unread;
    struct accuracy_mesh mesh;
    struct ref_picture picture;
    struct ref_scene scene;

    if (accuracy_mesh_make(&mesh, BALL, false) != 0)
        return 1;
    set_scene(&scene, &mesh, REF_GOURAUD);
    if (ref_render(&picture, &scene) != 0)
        return 1;
    const uint8_t *colors = mesh.own.mesh.colors;
    scene.colored = false;
    int failed = accuracy_shoot(&unread, &scene, &picture, mesh.mesh, 0) < 0;
    mesh.own.mesh.colors = NULL;
    failed |= accuracy_shoot(&plain, &scene, &picture, mesh.mesh, 0) < 0;
    scene.colored = true;
    failed |= accuracy_shoot(&colored, &scene, &picture, mesh.mesh, 0) < 0;
    mesh.own.mesh.colors = colors;
    const int read = differing(&plain, &unread, &scene), off = differing(&plain, &colored, &scene);
    printf("without colours: %d of %d pixels are not Gouraud's; %d where Gouraud has them at hand\n", off,
           scene.width * scene.height, read);
    ref_picture_free(&picture);
    accuracy_mesh_free(&mesh);
    return failed || read != 0 || off > scene.width * scene.height / 100;
}

/* Lit by ambient light alone, corners of one colour: every pixel has it. */
static int judge_one_colour(const struct sheen_shader *shader)
{
    static const int16_t positions[12] = {-32767, -32767, 0, 32767, -32767, 0, 32767, 32767, 0, -32767, 32767, 0};
    static const int16_t normals[12] = {0, 0, 32767, 0, 0, 32767, 0, 0, 32767, 0, 0, 32767};
    static const uint8_t indices[6] = {0, 1, 2, 0, 2, 3},
                         colors[12] = {255, 128, 0, 255, 128, 0, 255, 128, 0, 255, 128, 0};
    const struct sheen_mesh mesh = {.positions = positions,
                                    .normals = normals,
                                    .indices = indices,
                                    .colors = colors,
                                    .index_bytes = 1,
                                    .vertices = 4,
                                    .triangles = 2,
                                    .scale = SHEEN_Q24(1)};
    const struct sheen_material material = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1)};
    const struct sheen_object object = {
        .mesh = &mesh, .material = &material, .shader = shader, .pose = {.translation = {0, 0, -SHEEN_Q24(2)}}};
    const struct sheen_view view = {.fov = SHEEN_DEGREES(40)};
    struct memory_target target;
    struct core_frame f;
    int wrong = 0;

    if (memory_target_init(&target, 40, 40, SHEEN_RGB565_LE) != 0)
        return 1;
    const struct sheen_config config = {.target = &target.target, .max_vertices = 4, .max_triangles = 2};
    if (core_frame_make(&f, &config) < 0)
        return 1;
    wrong += sheen_render(f.frame, &view, &object, 1) != SHEEN_OK;
    for (int i = 0; i < 1600; i++)
        wrong += memory_target_pixel(&target, i % 40, i / 40) != (31u << 11 | 32u << 5); /* 63 * 128 / 255 = 31.6 */
    core_frame_free(&f);
    memory_target_free(&target);
    printf("one colour: %d pixels are wrong\n", wrong);
    return wrong != 0;
}

int main(void)
{
    int failed = 0;

    for (int shading = REF_GOURAUD; shading <= REF_SLERP; shading++)
        for (int fault = 0; fault < FAULTS; fault++)
            failed += judge_fault((enum fault)fault, (enum ref_shading)shading);
    failed += judge_without();
    failed += judge_one_colour(&sheen_flat_colored);
    failed += judge_one_colour(&sheen_gouraud_colored);
    failed += judge_one_colour(&sheen_phong_colored);
    failed += judge_one_colour(&sheen_slerp_colored);
    printf("%d failed\n", failed);
    return failed != 0;
}
