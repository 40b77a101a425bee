/*
 * ref_project.c - scenes, and a triangle's path from model space to the screen.
 */
#include <stdlib.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

#define DEGREE (3.14159265358979323846 / 180)

void ref_scene_orbit(struct ref_scene *scene, double yaw, double pitch, double roll, double distance)
{
    double cy = cos(yaw * DEGREE), sy = sin(yaw * DEGREE), cp = cos(pitch * DEGREE), sp = sin(pitch * DEGREE);
    double cr = cos(roll * DEGREE), sr = sin(roll * DEGREE);
    /* Rx(pitch) * Ry(yaw), then Rz(roll) from the left. */
    double xy[9] = {cy, 0, sy, sp * sy, cp, -sp * cy, -cp * sy, sp, cp * cy};

    for (int k = 0; k < 3; k++) {
        scene->rotation[k] = cr * xy[k] - sr * xy[3 + k];
        scene->rotation[3 + k] = sr * xy[k] + cr * xy[3 + k];
        scene->rotation[6 + k] = xy[6 + k];
    }
    scene->scale = 1;
    scene->translation[0] = scene->translation[1] = 0;
    scene->translation[2] = -distance;
    scene->distance = distance;
    scene->near = fmax(distance - 1.05, 0.05);
    scene->far = distance + 1.05;
}

void ref_scene_default(struct ref_scene *scene, const struct ref_mesh *mesh)
{
    *scene = (struct ref_scene){
        .mesh = mesh,
        .width = 320,
        .height = 240,
        .fov = 40,
        .shading = REF_PHONG,
        .light_count = 1,
        .light = {{-0.5, 0.7, 0.5}},
        .ambient = 0.1,
        .diffuse = 0.6,
        .specular = 0.3,
        .shininess = 32,
        .base = {0xc8 / 255.0, 0xa0 / 255.0, 0x50 / 255.0},
        .highlight = {1, 1, 1},
        .background = {0, 0, 0x20 / 255.0},
        .ambient_color = {1, 1, 1},
    };
    for (int i = 0; i < 3 * REF_MAX_LIGHTS; i++)
        scene->light_color[i / 3][i % 3] = 1;
    ref_scene_orbit(scene, 30, 20, 0, 3);
}

/* A corner while its triangle is clipped; clipping interpolates all of its fields linearly in space. */
struct corner {
    double eye[3], normal[3], uv[2], color[3];
    struct ref_lit lit;
};

#define MAX_CUT 8 /* a triangle against five planes */

static struct corner between(const struct corner *a, const struct corner *b, double t)
{
    struct corner c;

    ref_lerp(a->eye, b->eye, t, c.eye);
    ref_lerp(a->normal, b->normal, t, c.normal);
    ref_lerp(a->color, b->color, t, c.color);
    ref_lerp(a->lit.diffuse, b->lit.diffuse, t, c.lit.diffuse);
    ref_lerp(a->lit.specular, b->lit.specular, t, c.lit.specular);
    for (int i = 0; i < 2; i++)
        c.uv[i] = (1 - t) * a->uv[i] + t * b->uv[i];
    return c;
}

/* Keep the part of a polygon with plane . (eye, 1) >= 0. Returns the number of corners left. */
static int cut(struct corner *polygon, int count, const double plane[4])
{
    struct corner kept[MAX_CUT + 1];
    int made = 0;

    for (int i = 0; i < count; i++) {
        const struct corner *a = &polygon[i], *b = &polygon[(i + 1) % count];
        double da = ref_dot(plane, a->eye) + plane[3], db = ref_dot(plane, b->eye) + plane[3];

        if (da >= 0)
            kept[made++] = *a;
        if ((da < 0) != (db < 0)) {
            /* From the end inside to the end outside, so that both neighbours cut a shared edge at the same point. */
            kept[made++] = da >= 0 ? between(a, b, da / (da - db)) : between(b, a, db / (db - da));
        }
    }
    memcpy(polygon, kept, (size_t)made * sizeof *kept);
    return made;
}

static double focal(const struct ref_scene *scene)
{
    return scene->height / 2.0 / tan(scene->fov / 2 * DEGREE);
}

static int cut_all(const struct ref_scene *scene, struct corner *polygon)
{
    double near_plane[4] = {0, 0, -1, -scene->near};
    int count = cut(polygon, 3, near_plane);

    /*
     * Nothing outside the guard band is visible, so clipping there would not matter, except to slerp: its arcs run
     * between corners, so its shading depends on where a triangle is cut.
     */
    for (int side = 0; scene->shading == REF_SLERP && side < 4 && count >= 3; side++) {
        /* guard * m +- f * coordinate >= 0, where m = -z or, under ortho, the constant distance */
        double plane[4] = {0, 0, -REF_GUARD_PX, 0};
        if (scene->ortho) {
            plane[2] = 0;
            plane[3] = REF_GUARD_PX * scene->distance;
        }
        plane[side / 2] = side % 2 ? -focal(scene) : focal(scene);
        count = cut(polygon, count, plane);
    }
    return count;
}

static void to_screen(const struct ref_scene *scene, const struct corner *c, struct ref_piece *piece, int k)
{
    double m = -c->eye[2], by = scene->ortho ? scene->distance : m, f = focal(scene);

    piece->x[k] = scene->width / 2.0 + f * c->eye[0] / by;
    piece->y[k] = scene->height / 2.0 - f * c->eye[1] / by;
    piece->w[k] = scene->ortho ? 1 : 1 / m;
    piece->depth[k] = scene->ortho ? -m : 1 / m;
    piece->z[k] = ref_nearness(scene, m);
    if (scene->bias != 0)
        piece->z[k] = fmin(fmax(piece->z[k] + (double)scene->bias / REF_STEPS, 0), 1);
    memcpy(piece->normal[k], c->normal, sizeof piece->normal[k]);
    piece->lit[k] = c->lit;
    memcpy(piece->color[k], c->color, sizeof piece->color[k]);
    memcpy(piece->uv[k], c->uv, sizeof piece->uv[k]);
}

static double signed_area(const struct ref_piece *p)
{
    return (p->x[1] - p->x[0]) * (p->y[2] - p->y[0]) - (p->x[2] - p->x[0]) * (p->y[1] - p->y[0]);
}

static void turn_normal(const struct ref_scene *scene, const double model[3], bool back, double eye[3])
{
    for (int k = 0; k < 3; k++) {
        eye[k] = ref_dot(scene->rotation + 3 * k, model);
        if (back)
            eye[k] = -eye[k];
    }
}

/* Whether the eye is behind the triangle's plane. Decided on the whole triangle, before it is clipped. */
static bool is_back(const struct ref_scene *scene, const struct corner *c)
{
    double u[3], v[3], n[3], to_eye[3];

    for (int k = 0; k < 3; k++) {
        u[k] = c[1].eye[k] - c[0].eye[k];
        v[k] = c[2].eye[k] - c[0].eye[k];
        to_eye[k] = scene->ortho ? (k == 2) : -c[0].eye[k];
    }
    ref_cross(u, v, n);
    return ref_dot(n, to_eye) < 0;
}

static void to_eye(const struct ref_scene *scene, const double model[3], double eye[3])
{
    for (int k = 0; k < 3; k++)
        eye[k] = scene->scale * ref_dot(scene->rotation + 3 * k, model) + scene->translation[k];
}

static void make_corners(const struct ref_scene *scene, const struct ref_triangle *t, struct corner *c, bool *back)
{
    const struct ref_mesh *mesh = scene->mesh;
    double center[3];

    for (int k = 0; k < 3; k++)
        to_eye(scene, mesh->position[t->corner[k]], c[k].eye);
    to_eye(scene, mesh->center[t->polygon], center);
    *back = is_back(scene, c);
    for (int k = 0; k < 3; k++) {
        const double *normal =
            scene->shading == REF_FLAT ? mesh->polygon_normal[t->polygon] : mesh->normal[t->corner[k]];
        turn_normal(scene, normal, *back, c[k].normal);
        ref_light(scene, scene->shading == REF_FLAT ? center : c[k].eye, c[k].normal, &c[k].lit);
        for (int i = 0; i < 3; i++) {
            c[k].color[i] = mesh->color ? mesh->color[t->corner[k]][i] : 1;
            c[k].lit.diffuse[i] *= scene->colored ? c[k].color[i] : 1;
        }
        for (int i = 0; i < 2; i++)
            c[k].uv[i] = mesh->uv ? mesh->uv[t->corner[k]][i] : 0;
    }
}

static void find_span(struct ref_picture *picture, const struct ref_mesh *mesh)
{
    for (int i = 0; i < 2 && mesh->uv; i++) {
        double low = mesh->uv[0][i], high = low;
        for (size_t c = 1; c < mesh->corner_count; c++) {
            low = fmin(low, mesh->uv[c][i]);
            high = fmax(high, mesh->uv[c][i]);
        }
        picture->uv_span[i] = high - low;
    }
}

int ref_project(struct ref_picture *picture, const struct ref_scene *scene)
{
    const struct ref_mesh *mesh = scene->mesh;
    size_t room = mesh->triangle_count * (MAX_CUT - 2);

    picture->pieces = malloc(room * sizeof *picture->pieces);
    picture->piece_count = 0;
    if (!picture->pieces)
        return -1;
    find_span(picture, mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        struct corner polygon[MAX_CUT + 1];
        bool back;

        make_corners(scene, &mesh->triangles[i], polygon, &back);
        if (back && !scene->two_sided)
            continue;
        int count = cut_all(scene, polygon);
        for (int k = 1; k + 1 < count; k++) {
            struct ref_piece *piece = &picture->pieces[picture->piece_count];
            to_screen(scene, &polygon[0], piece, 0);
            to_screen(scene, &polygon[k], piece, 1);
            to_screen(scene, &polygon[k + 1], piece, 2);
            piece->triangle = (uint32_t)i;
            piece->polygon = mesh->triangles[i].polygon;
            piece->back = back;
            if (signed_area(piece) != 0)
                picture->piece_count++;
        }
    }
    return 0;
}
