/*
 * ref_texture.c - texels at a point of the screen, and whether they are settled there (ref_settled).
 */
#include <math.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

#define BROAD 1024.0 /* if the mesh spans more texels than this, rounding of its uv exceeds 1/16 texel */

static int address(int i, int size, bool clamp)
{
    if (clamp)
        return i < 0 ? 0 : i >= size ? size - 1 : i;
    return (i % size + size) % size;
}

uint16_t ref_texel(const struct ref_texture *t, int i, int j)
{
    return t->texels[address(j, t->height, t->clamp[1]) * t->width + address(i, t->width, t->clamp[0])];
}

static void colour_of(uint16_t value, double color[3])
{
    color[0] = (value >> 11) / 31.0;
    color[1] = (value >> 5 & 63) / 63.0;
    color[2] = (value & 31) / 31.0;
}

/* Where the picture of a sphere shows this normal: 0..1 across and down. */
static void on_sphere(const double normal[3], double uv[2])
{
    uv[0] = (1 + normal[0]) / 2;
    uv[1] = (1 - normal[1]) / 2;
}

static void matcap_point(const struct ref_scene *scene, const struct ref_piece *piece, const double b[3], double uv[2])
{
    double normal[3] = {0, 0, 0};

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            normal[k] += b[i] * piece->normal[i][k];
    if (scene->texels == REF_TEXELS_NORMAL && ref_normalize(normal) < 1e-12)
        normal[0] = normal[1] = normal[2] = 0;
    on_sphere(normal, uv); /* linear in x and y, so this also interpolates the corners' coordinates */
    for (int i = 0; i < 2; i++)
        uv[i] = fmin(fmax(uv[i], 0), 1);
}

void ref_texture_point(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y,
                       double texels[2])
{
    const double size[2] = {scene->texture->width, scene->texture->height};
    double b[3], uv[2];

    ref_weights(scene, piece, x, y, b);
    for (int i = 0; i < 2; i++)
        uv[i] = b[0] * piece->uv[0][i] + b[1] * piece->uv[1][i] + b[2] * piece->uv[2][i];
    if (scene->texels != REF_TEXELS_UV)
        matcap_point(scene, piece, b, uv);
    for (int i = 0; i < 2; i++)
        texels[i] = size[i] * uv[i];
}

static uint16_t nearest(const struct ref_texture *t, const double at[2])
{
    return ref_texel(t, (int)floor(at[0]), (int)floor(at[1]));
}

/* The four texels of a bilinear look-up, transparent ones replaced, and the shares of the right and lower texels. */
static void four(const struct ref_texture *t, const double at[2], uint16_t value[4], double share[2])
{
    int first[2];

    for (int i = 0; i < 2; i++) {
        first[i] = (int)floor(at[i] - 0.5);
        share[i] = at[i] - 0.5 - first[i];
    }
    for (int k = 0; k < 4; k++) {
        value[k] = ref_texel(t, first[0] + (k & 1), first[1] + (k >> 1));
        if (t->keyed && value[k] == t->key)
            value[k] = nearest(t, at);
    }
}

bool ref_texture_color(const struct ref_texture *t, const double at[2], double color[3])
{
    uint16_t value[4];
    double share[2];

    if (t->keyed && nearest(t, at) == t->key)
        return false;
    if (!t->bilinear) {
        colour_of(nearest(t, at), color);
        return true;
    }
    four(t, at, value, share);
    memset(color, 0, 3 * sizeof *color);
    for (int k = 0; k < 4; k++) {
        double part = (k & 1 ? share[0] : 1 - share[0]) * (k >> 1 ? share[1] : 1 - share[1]), c[3];
        colour_of(value[k], c);
        for (int i = 0; i < 3; i++)
            color[i] += part * c[i];
    }
    return true;
}

/* |dU/dx| + |dU/dy|, and the same for V. */
static void slopes(const struct ref_scene *scene, const struct ref_piece *piece, double x, double y, double slope[2])
{
    const double h = 1e-3;
    double at[4][2];

    ref_texture_point(scene, piece, x - h, y, at[0]);
    ref_texture_point(scene, piece, x + h, y, at[1]);
    ref_texture_point(scene, piece, x, y - h, at[2]);
    ref_texture_point(scene, piece, x, y + h, at[3]);
    for (int i = 0; i < 2; i++)
        slope[i] = (fabs(at[1][i] - at[0][i]) + fabs(at[3][i] - at[2][i])) / (2 * h);
}

/* The largest difference between these texels in one channel, in its steps; on grey targets in grey levels. */
static double largest_difference(const struct ref_scene *scene, const uint16_t *value, int count)
{
    static const double steps[3] = {31, 63, 31}, weight[3] = {0.2126, 0.7152, 0.0722};
    double most = 0, grey = 0;

    for (int k = 0; k < 3; k++) {
        double low = 1, high = 0;
        for (int i = 0; i < count; i++) {
            double color[3];
            colour_of(value[i], color);
            low = fmin(low, color[k]);
            high = fmax(high, color[k]);
        }
        most = fmax(most, steps[k] * (high - low));
        grey += weight[k] * (high - low);
    }
    return scene->levels ? (scene->levels - 1) * grey : most;
}

bool ref_settled(const struct ref_scene *scene, const struct ref_picture *picture, const struct ref_piece *piece,
                 double x, double y, double *bound)
{
    const struct ref_texture *t = scene->texture;
    const int size[2] = {t->width, t->height};
    double at[2], z[2], share[2];
    uint16_t seen[4], used[16];

    ref_texture_point(scene, piece, x, y, at);
    slopes(scene, piece, x, y, z);
    for (int i = 0; i < 2; i++) {
        z[i] = fmax(1, picture->uv_span[i] * size[i] / BROAD) / 16 + z[i] / 16;
        if (!(z[i] <= 0.5))
            return false;
    }
    for (int k = 0; k < 4; k++) {
        const double moved[2] = {at[0] + (k & 1 ? z[0] : -z[0]), at[1] + (k >> 1 ? z[1] : -z[1])};
        seen[k] = nearest(t, moved);
        four(t, moved, used + 4 * k, share);
    }
    *bound = 1;
    if (t->bilinear) {
        *bound = 1 + (z[0] + z[1]) * largest_difference(scene, used, 16);
        for (int k = 1; k < 4; k++)
            if (t->keyed && (seen[k] == t->key) != (seen[0] == t->key))
                return false;
        return true;
    }
    return seen[0] == seen[1] && seen[0] == seen[2] && seen[0] == seen[3];
}
