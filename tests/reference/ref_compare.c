/*
 * ref_compare.c - where a picture may be compared with the reference, and how close it is there.
 *
 * The core snaps vertices and so moves edges by a fraction of a pixel. Inside a smooth surface that changes nothing
 * visible; at a crease, at a silhouette or where surfaces meet it does. So a pixel counts only if its 3x3 neighbourhood
 * lies on one smooth surface and, because a jump of light is an edge too, on one tread of a toon ramp's stairs.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

#define DEPTH_JUMP 0.02

/* A triangle's side between two welded corners, the smaller id first. */
struct side {
    uint32_t from, to;
    uint32_t triangle;
    double normals[2][3]; /* at from, at to */
    double uv[2][2], color[2][3];
};

static int side_order(const void *a, const void *b)
{
    const struct side *p = a, *q = b;

    if (p->from != q->from)
        return p->from < q->from ? -1 : 1;
    if (p->to != q->to)
        return p->to < q->to ? -1 : 1;
    return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

static uint32_t root_of(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

static size_t list_sides(const struct ref_picture *picture, const struct ref_mesh *mesh, struct side *sides)
{
    size_t count = 0;

    for (size_t i = 0; i < picture->piece_count; i++) {
        const struct ref_piece *piece = &picture->pieces[i];
        if (i > 0 && piece->triangle == picture->pieces[i - 1].triangle)
            continue;
        const struct ref_triangle *t = &mesh->triangles[piece->triangle];
        for (int k = 0; k < 3; k++) {
            uint32_t a = t->corner[k], b = t->corner[(k + 1) % 3];
            if (mesh->weld[a] > mesh->weld[b]) {
                uint32_t swap = a;
                a = b;
                b = swap;
            }
            struct side *s = &sides[count++];
            *s = (struct side){.from = mesh->weld[a], .to = mesh->weld[b], .triangle = piece->triangle};
            for (int c = 0; c < 3; c++) {
                s->normals[0][c] = piece->back ? -mesh->normal[a][c] : mesh->normal[a][c];
                s->normals[1][c] = piece->back ? -mesh->normal[b][c] : mesh->normal[b][c];
            }
            for (int c = 0; c < 2 && mesh->uv; c++) {
                s->uv[0][c] = mesh->uv[a][c];
                s->uv[1][c] = mesh->uv[b][c];
            }
            for (int c = 0; c < 3 && mesh->color; c++) {
                s->color[0][c] = mesh->color[a][c];
                s->color[1][c] = mesh->color[b][c];
            }
        }
    }
    qsort(sides, count, sizeof *sides, side_order);
    return count;
}

static bool equal_corners(const struct side *p, const struct side *q)
{
    for (int e = 0; e < 2; e++) {
        for (int c = 0; c < 3; c++) {
            if (fabs(p->normals[e][c] - q->normals[e][c]) > 1e-6)
                return false;
        }
        if (memcmp(p->uv[e], q->uv[e], sizeof p->uv[e]) != 0 ||
            memcmp(p->color[e], q->color[e], sizeof p->color[e]) != 0)
            return false;
    }
    return true;
}

/* surface[t]: equal for drawn triangles that are joined through shared edges; flat: for triangles of one polygon. */
static int find_surfaces(const struct ref_picture *picture, const struct ref_scene *scene, uint32_t *surface)
{
    const struct ref_mesh *mesh = scene->mesh;

    for (size_t t = 0; t < mesh->triangle_count; t++)
        surface[t] = scene->shading == REF_FLAT ? mesh->triangles[t].polygon : (uint32_t)t;
    if (scene->shading == REF_FLAT)
        return 0;
    struct side *sides = malloc((3 * mesh->triangle_count + 1) * sizeof *sides);
    if (!sides)
        return -1;
    size_t count = list_sides(picture, mesh, sides);
    for (size_t i = 1; i < count; i++) {
        const struct side *p = &sides[i - 1], *q = &sides[i];
        if (p->from == q->from && p->to == q->to && equal_corners(p, q))
            surface[root_of(surface, p->triangle)] = root_of(surface, q->triangle);
    }
    for (size_t t = 0; t < mesh->triangle_count; t++)
        surface[t] = root_of(surface, (uint32_t)t);
    free(sides);
    return 0;
}

/* A seam: the neighbour's triangle, extended to this pixel, shows another place of the texture there. */
static bool is_seam(const struct ref_scene *scene, const struct ref_picture *picture, const struct ref_pixel *pixel,
                    const struct ref_pixel *beside, double x, double y)
{
    double at[2], other[2];

    if (!scene->texture || beside->piece == pixel->piece)
        return false;
    ref_texture_point(scene, &picture->pieces[pixel->piece], x, y, at);
    ref_texture_point(scene, &picture->pieces[beside->piece], x, y, other);
    return fabs(at[0] - other[0]) > 1 || fabs(at[1] - other[1]) > 1;
}

static bool comparable(const struct ref_scene *scene, const struct ref_picture *picture, const uint32_t *surface, int x,
                       int y)
{
    const struct ref_pixel *centre = &picture->pixels[y * picture->width + x];
    double low = centre->m, high = centre->m;

    if (x == 0 || y == 0 || x == picture->width - 1 || y == picture->height - 1)
        return false;
    for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
            const struct ref_pixel *p = centre + dy * picture->width + dx;
            if (!p->covered || p->tread < 0 ||
                (p->triangle != centre->triangle && surface[p->triangle] != surface[centre->triangle]) ||
                p->tread != centre->tread || is_seam(scene, picture, centre, p, x + 0.5, y + 0.5))
                return false;
            low = ref_min(low, p->m);
            high = ref_max(high, p->m);
        }
    }
    return high <= low * (1 + DEPTH_JUMP);
}

static int steps_apart(int levels, uint16_t a, uint16_t b)
{
    if (levels)
        return abs(a - b);
    int r = abs((a >> 11) - (b >> 11)), g = abs((a >> 5 & 63) - (b >> 5 & 63)), l = abs((a & 31) - (b & 31));

    return r > g ? (r > l ? r : l) : g > l ? g : l;
}

static void judge(struct ref_score *score, const struct ref_scene *scene, const struct ref_pixel *pixel, uint16_t value,
                  int x, int y, double bound)
{
    int apart = steps_apart(scene->levels, pixel->value, value);

    score->compared++;
    score->equal += apart == 0;
    score->within_one += apart <= 1;
    score->beyond += apart > bound;
    score->calm += bound <= 1 + REF_CALM;
    score->calm_equal += bound <= 1 + REF_CALM && apart == 0;
    if (pixel->specular > 1.0 / 63) {
        score->highlight++;
        score->highlight_equal += apart == 0;
    }
    if (apart > score->worst) {
        score->worst = apart;
        score->worst_x = x;
        score->worst_y = y;
        score->cause = pixel->triangle;
    }
}

/* Without a texture every pixel is settled, and *bound is 1 step. */
static bool settled(const struct ref_scene *scene, const struct ref_picture *picture, const struct ref_pixel *pixel,
                    int x, int y, double *bound)
{
    *bound = 1;
    return !scene->texture ||
           (!pixel->unsettled && ref_settled(scene, picture, &picture->pieces[pixel->piece], x + 0.5, y + 0.5, bound));
}

/* Nothing but transparent texels at this pixel and its eight neighbours. */
static bool seen_through(const struct ref_picture *picture, int x, int y)
{
    const struct ref_pixel *centre = &picture->pixels[y * picture->width + x];

    if (centre->covered || !centre->dropped || centre->unsettled || x == 0 || y == 0 || x == picture->width - 1 ||
        y == picture->height - 1)
        return false;
    for (int i = 0; i < 9; i++) {
        const struct ref_pixel *p = centre + (i / 3 - 1) * picture->width + i % 3 - 1;
        if (p->covered || !p->dropped)
            return false;
    }
    return true;
}

/* Whether the stipple pattern leaves this pixel out. */
static bool is_left_out(const struct ref_scene *scene, int x, int y)
{
    return scene->left_out > 0 && ref_bayer8((x + scene->phase) & 7, y & 7) >= 64 - scene->left_out;
}

int ref_compare(struct ref_score *score, const struct ref_scene *scene, const struct ref_picture *picture,
                const uint16_t *values)
{
    uint32_t *surface = malloc((scene->mesh->triangle_count + 1) * sizeof *surface);

    if (!surface || find_surfaces(picture, scene, surface) != 0) {
        free(surface);
        return -1;
    }
    for (int y = 0; y < picture->height; y++) {
        for (int x = 0; x < picture->width; x++) {
            const struct ref_pixel *pixel = &picture->pixels[y * picture->width + x];
            double bound;
            if (pixel->covered && is_left_out(scene, x, y)) {
                score->dropped++;
                score->dropped_drawn +=
                    values[y * picture->width + x] != ref_value(scene, scene->background, x, y, true);
                continue;
            }
            score->covered += pixel->covered;
            if (seen_through(picture, x, y)) {
                score->dropped++;
                score->dropped_drawn += values[y * picture->width + x] != pixel->value;
            }
            if (!pixel->covered || !comparable(scene, picture, surface, x, y))
                continue;
            score->comparable++;
            if (settled(scene, picture, pixel, x, y, &bound))
                judge(score, scene, pixel, values[y * picture->width + x], x, y, bound);
        }
    }
    free(surface);
    return 0;
}
