/*
 * ref_shade.c - the four shadings at a point of the screen.
 *
 * To interpolate linearly in space: if b are the corners' barycentric coordinates on the screen and w = 1/m at the
 * corners, the coordinates in space are b w / sum(b w) (Blinn's I/m over 1/m).
 */
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

void ref_weights(const struct ref_scene *scene, const struct ref_piece *p, double x, double y, double b[3])
{
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        int u = (k + 1) % 3, v = (k + 2) % 3;
        b[k] = (p->x[v] - p->x[u]) * (y - p->y[u]) - (p->y[v] - p->y[u]) * (x - p->x[u]);
        if (!scene->affine)
            b[k] *= p->w[k];
        sum += b[k];
    }
    for (int k = 0; k < 3; k++)
        b[k] /= sum;
}

void ref_slerp(const double a[3], const double b[3], double t, double out[3])
{
    double cross[3];

    ref_cross(a, b, cross);
    double sine = ref_length(cross), cosine = ref_dot(a, b), angle = atan2(sine, cosine);
    if (sine < 1e-12) { /* equal or opposite: no plane to turn in */
        memcpy(out, cosine > 0 || t < 0.5 ? a : b, 3 * sizeof *out);
        return;
    }
    for (int k = 0; k < 3; k++)
        out[k] = (sin((1 - t) * angle) * a[k] + sin(t * angle) * b[k]) / sine;
}

/* Where the scanline crosses an edge: x, weight and normal there. */
struct crossing {
    double x, w, normal[3];
};

static double in_space(const struct ref_scene *scene, double t, double w1, double w2)
{
    return scene->affine ? t : t * w2 / ((1 - t) * w1 + t * w2);
}

static void cross_edge(const struct ref_scene *scene, const struct ref_piece *p, int a, int b, double y,
                       struct crossing *out)
{
    double t = (y - p->y[a]) / (p->y[b] - p->y[a]), na[3], nb[3];

    memcpy(na, p->normal[a], sizeof na);
    memcpy(nb, p->normal[b], sizeof nb);
    ref_normalize(na); /* at a corner made by clipping it is shorter */
    ref_normalize(nb);
    out->x = (1 - t) * p->x[a] + t * p->x[b];
    out->w = (1 - t) * p->w[a] + t * p->w[b];
    ref_slerp(na, nb, in_space(scene, t, p->w[a], p->w[b]), out->normal);
}

/* Interpolates the normal along great arcs: along two edges, then along the row. */
static void slerp_normal(const struct ref_scene *scene, const struct ref_piece *p, double x, double y, double normal[3])
{
    struct crossing side[2] = {{.x = 0}, {.x = 0}};
    int found = 0;

    for (int k = 0; k < 3 && found < 2; k++) {
        int a = k, b = (k + 1) % 3;
        if (p->y[a] > p->y[b]) {
            a = b;
            b = k;
        }
        if (p->y[a] <= y && y < p->y[b])
            cross_edge(scene, p, a, b, y, &side[found++]);
    }
    struct crossing *left = &side[0], *right = &side[1];
    if (left->x > right->x) {
        left = &side[1];
        right = &side[0];
    }
    double width = right->x - left->x, t = width > 0 ? (x - left->x) / width : 0;
    ref_slerp(left->normal, right->normal, in_space(scene, t, left->w, right->w), normal);
}

/* Phong's and slerp's normal at a point of the screen: of unit length, or zero. */
static void normal_at(const struct ref_scene *scene, const struct ref_piece *p, double x, double y, double normal[3])
{
    double b[3];

    normal[0] = normal[1] = normal[2] = 0;
    if (scene->shading == REF_SLERP) {
        slerp_normal(scene, p, x, y, normal);
        return;
    }
    ref_weights(scene, p, x, y, b);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            normal[k] += b[i] * p->normal[i][k];
    }
    if (ref_normalize(normal) < 1e-12)
        normal[0] = normal[1] = normal[2] = 0;
}

void ref_color(const struct ref_scene *scene, const struct ref_piece *p, double x, double y, double color[3])
{
    double b[3];

    color[0] = color[1] = color[2] = 1;
    if (!scene->colored)
        return;
    ref_weights(scene, p, x, y, b);
    for (int k = 0; k < 3; k++)
        color[k] = b[0] * p->color[0][k] + b[1] * p->color[1][k] + b[2] * p->color[2][k];
}

void ref_shade(const struct ref_scene *scene, const struct ref_piece *p, double x, double y, struct ref_lit *lit)
{
    static const double anywhere[3] = {0, 0, 0}; /* Phong and slerp have no point lights */
    double b[3], normal[3], color[3];

    if (scene->shading == REF_FLAT || scene->shading == REF_GOURAUD) {
        ref_weights(scene, p, x, y, b);
        for (int k = 0; k < 3; k++) {
            lit->diffuse[k] = b[0] * p->lit[0].diffuse[k] + b[1] * p->lit[1].diffuse[k] + b[2] * p->lit[2].diffuse[k];
            lit->specular[k] =
                b[0] * p->lit[0].specular[k] + b[1] * p->lit[1].specular[k] + b[2] * p->lit[2].specular[k];
        }
        return;
    }
    normal_at(scene, p, x, y, normal);
    ref_light(scene, anywhere, normal, lit);
    ref_color(scene, p, x, y, color);
    for (int k = 0; k < 3; k++)
        lit->diffuse[k] *= color[k];
}

int ref_tread(const struct ref_scene *scene, const struct ref_piece *p, double x, double y)
{
    double normal[3];
    int tread = 0;

    if (scene->ramp != REF_TOON || scene->shading == REF_FLAT || scene->shading == REF_GOURAUD)
        return 0;
    normal_at(scene, p, x, y, normal);
    for (int i = 0; i < scene->light_count; i++) {
        double to[3] = {scene->light[i][0], scene->light[i][1], scene->light[i][2]};
        ref_normalize(to);
        double thirds = 3 * ref_ramp(scene, ref_dot(to, normal));
        if (fabs(thirds - floor(thirds + 0.5)) > 1e-9)
            return -1;
        tread = 4 * tread + (int)floor(thirds + 0.5);
    }
    return tread;
}
