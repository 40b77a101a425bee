/*
 * test_texel_ends.c - triangles that end where a texel ends, in slow turns: no pixel may show the texel beyond, which
 * is at the opposite side of the picture if the texture repeats. It would come and go from frame to frame.
 *
 * A pixel is strange if its colour is neither that of one of the reference's pixels around it nor one that the
 * triangles there show within 0.8 px. The few that remain are slivers seen edge-on.
 */
#include <math.h>
#include <stdio.h>

#include "textured_scene.h"

enum {
    SIZE = 240,
    FRAMES = 20,
    CUBE = 1, /* index of textured_mesh_make() */
    SCREEN = 4,
    AROUND = 4, /* sampled places in each direction */
    MOST = 10   /* strange pixels of all frames of one mesh and texture; 28 to 1,187 if nothing is done about ends */
};

#define APART 0.2 /* px between two places */

/* Each texel has a colour of its own. */
static void make_texture(struct ref_texture *texture, uint16_t *texels, int width)
{
    *texture = (struct ref_texture){.width = width, .height = width, .texels = texels, .bits = 16};
    for (int i = 0; i < width * width; i++)
        texels[i] = (uint16_t)((unsigned)(i + 1) * 40503u);
}

static void scene_of(struct ref_scene *scene, const struct accuracy_mesh *mesh, const struct ref_texture *texture,
                     int frame, bool ortho)
{
    textured_view(scene, &mesh->reference, 0, TEXTURED_SCENE_UNLIT);
    ref_scene_orbit(scene, 20 + 0.5 * frame, 15 + 0.3 * frame, 0.2 * frame, 2.6);
    scene->fov = 40;
    scene->texture = texture;
    scene->width = scene->height = SIZE;
    scene->two_sided = true;
    if (ortho)
        accuracy_ortho(scene);
}

/* Whether the triangle seen at a pixel shows the value somewhere near (x, y). */
static bool shows_near(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, uint16_t value)
{
    for (int i = -AROUND; i <= AROUND; i++) {
        for (int j = -AROUND; j <= AROUND; j++) {
            double texels[2], color[3];
            if (!ref_inside(piece, x + i * APART, y + j * APART))
                continue;
            ref_texture_point(scene, piece, x + i * APART, y + j * APART, texels);
            if (ref_texture_color(scene->texture, texels, color) && ref_565(color) == value)
                return true;
        }
    }
    return false;
}

static bool is_strange(const struct ref_scene *scene, const struct ref_picture *picture, int x, int y, uint16_t value)
{
    const struct ref_pixel *centre = &picture->pixels[y * SIZE + x];

    for (int i = 0; i < 9; i++) {
        if (centre[(i / 3 - 1) * SIZE + i % 3 - 1].value == value)
            return false;
    }
    for (int i = 0; i < 9; i++) {
        const struct ref_pixel *p = &centre[(i / 3 - 1) * SIZE + i % 3 - 1];
        if (p->covered && shows_near(scene, &picture->pieces[p->piece], x + 0.5, y + 0.5, value))
            return false;
    }
    return true;
}

/* The number of strange pixels of a frame; -1 if it cannot be drawn. */
static int count_strange(const struct ref_scene *scene, const struct accuracy_mesh *mesh)
{
    static struct accuracy_shot shot;
    struct ref_picture picture;
    int strange = 0;

    if (ref_render(&picture, scene) != 0)
        return -1;
    if (accuracy_shoot(&shot, scene, &picture, mesh->mesh, 0) != SHEEN_OK)
        strange = -1;
    for (int at = SIZE + 1; at < SIZE * (SIZE - 1) - 1 && strange >= 0; at++)
        strange += at % SIZE != 0 && at % SIZE != SIZE - 1 &&
                   is_strange(scene, &picture, at % SIZE, at / SIZE, shot.values[at]);
    ref_picture_free(&picture);
    return strange;
}

/* 1 if too many pixels are strange. */
static int judge(const struct accuracy_mesh *mesh, int width, bool ortho)
{
    static uint16_t texels[16 * 16];
    struct ref_texture texture;
    int sum = 0, failed = 0;

    make_texture(&texture, texels, width);
    for (int frame = 0; frame < FRAMES && !failed; frame++) {
        struct ref_scene scene;
        scene_of(&scene, mesh, &texture, frame, ortho);
        int strange = count_strange(&scene, mesh);
        failed = strange < 0;
        sum += strange;
    }
    failed |= sum > MOST;
    printf("%s%s %2dx%-2d %4d strange pixels in %d frames%s\n", mesh->name, ortho ? ", ortho" : "", width, width, sum,
           FRAMES, failed ? ": FAILED" : "");
    return failed;
}

int main(void)
{
    static const int meshes[2] = {CUBE, SCREEN}, widths[3] = {2, 4, 16};
    int failed = 0;

    for (int i = 0; i < 2; i++) {
        struct accuracy_mesh mesh;
        if (textured_mesh_make(&mesh, meshes[i]) != 0)
            return 1;
        for (int k = 0; k < 6; k++)
            failed += judge(&mesh, widths[k % 3], k >= 3);
        accuracy_mesh_free(&mesh);
    }
    return failed != 0;
}
