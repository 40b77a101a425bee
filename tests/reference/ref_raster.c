/*
 * ref_raster.c - the triangle seen at each pixel centre, on real coordinates:
 * nothing is snapped. Nearest in 16-bit depth; on a tie the first drawn.
 */
#include <stdlib.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

/*
 * Twice the signed area of (a, b, q) on the screen; y runs down, so > 0 means clockwise as it is seen. Always
 * computed from the same end of an edge, so that both its triangles round alike.
 */
static double edge(const struct ref_piece *p, int a, int b, double x, double y)
{
    if (p->x[b] < p->x[a] || (p->x[b] == p->x[a] && p->y[b] < p->y[a]))
        return -edge(p, b, a, x, y);
    return (p->x[b] - p->x[a]) * (y - p->y[a]) - (p->y[b] - p->y[a]) * (x - p->x[a]);
}

/* Inside, or on a top edge (horizontal, interior below) or a left edge (interior to its right). */
bool ref_inside(const struct ref_piece *p, double x, double y)
{
    double area = edge(p, 0, 1, p->x[2], p->y[2]);

    for (int k = 0; k < 3; k++) {
        int a = k, b = (k + 1) % 3;
        double e = edge(p, a, b, x, y);
        double dx = p->x[b] - p->x[a], dy = p->y[b] - p->y[a];
        if (area < 0) {
            e = -e;
            dx = -dx;
            dy = -dy;
        }
        /* Walked clockwise as seen, a left edge goes up and a top edge to the right. */
        bool top_left = dy < 0 || (dy == 0 && dx > 0);
        if (e < 0 || (e == 0 && !top_left))
            return false;
    }
    return true;
}

double ref_side_distance(const struct ref_piece *p, int side, double x, double y)
{
    int a = side, b = (side + 1) % 3;
    double dx = p->x[b] - p->x[a], dy = p->y[b] - p->y[a], length = dx * dx + dy * dy;
    double t = length > 0 ? ((x - p->x[a]) * dx + (y - p->y[a]) * dy) / length : 0;

    t = fmin(fmax(t, 0), 1);
    return hypot(p->x[a] + t * dx - x, p->y[a] + t * dy - y);
}

static double screen_linear(const struct ref_piece *p, const double at[3], double x, double y)
{
    double area = edge(p, 0, 1, p->x[2], p->y[2]);

    return (edge(p, 1, 2, x, y) * at[0] + edge(p, 2, 0, x, y) * at[1] + edge(p, 0, 1, x, y) * at[2]) / area;
}

/* Whole steps, 0 far. */
static int z16(const struct ref_piece *p, double x, double y)
{
    return (int)floor(REF_STEPS * fmin(fmax(screen_linear(p, p->z, x, y), 0), 1) + 0.5);
}

static int first_pixel(double low)
{
    return low <= 0 ? 0 : (int)floor(low);
}

static int end_pixel(double high, int end)
{
    return high >= end ? end : high < 0 ? 0 : (int)floor(high) + 1 > end ? end : (int)floor(high) + 1;
}

static bool transparent(const struct ref_scene *scene, const struct ref_piece *p, double x, double y)
{
    double at[2], unused[3];

    if (!scene->texture)
        return false;
    ref_texture_point(scene, p, x, y, at);
    return !ref_texture_color(scene->texture, at, unused);
}

static void draw(struct ref_picture *picture, int *nearest, const struct ref_scene *scene, uint32_t index)
{
    const struct ref_piece *p = &picture->pieces[index];
    int x0 = first_pixel(fmin(p->x[0], fmin(p->x[1], p->x[2])));
    int y0 = first_pixel(fmin(p->y[0], fmin(p->y[1], p->y[2])));
    int x1 = end_pixel(fmax(p->x[0], fmax(p->x[1], p->x[2])), picture->width);
    int y1 = end_pixel(fmax(p->y[0], fmax(p->y[1], p->y[2])), picture->height);

    for (int y = y0; y < y1; y++) {
        for (int x = x0; x < x1; x++) {
            if (!ref_inside(p, x + 0.5, y + 0.5))
                continue;
            double depth = screen_linear(p, p->depth, x + 0.5, y + 0.5);
            double m = scene->ortho ? -depth : 1 / depth;
            int z = z16(p, x + 0.5, y + 0.5), *best = &nearest[y * picture->width + x];
            if (m >= scene->far || z <= *best || transparent(scene, p, x + 0.5, y + 0.5))
                continue;
            *best = z;
            picture->pixels[y * picture->width + x] = (struct ref_pixel){.covered = true,
                                                                         .back = p->back,
                                                                         .triangle = p->triangle,
                                                                         .polygon = p->polygon,
                                                                         .piece = index,
                                                                         .m = m,
                                                                         .z = screen_linear(p, p->z, x + 0.5, y + 0.5)};
        }
    }
}

/* What lies in front of what is seen is transparent there: is that for sure? */
static void look_through(struct ref_picture *picture, const int *nearest, const struct ref_scene *scene, uint32_t index)
{
    const struct ref_piece *p = &picture->pieces[index];

    for (int i = 0; i < picture->width * picture->height; i++) {
        double x = i % picture->width + 0.5, y = i / picture->width + 0.5, bound;
        if (!ref_inside(p, x, y) || (picture->pixels[i].covered && picture->pixels[i].piece == index))
            continue;
        double depth = screen_linear(p, p->depth, x, y);
        if (z16(p, x, y) <= nearest[i] || (scene->ortho ? -depth : 1 / depth) >= scene->far)
            continue;
        picture->pixels[i].dropped = true;
        if (!ref_settled(scene, picture, p, x, y, &bound))
            picture->pixels[i].unsettled = true;
    }
}

static void color(const struct ref_scene *scene, const struct ref_picture *picture, struct ref_pixel *pixel, int x,
                  int y)
{
    const double *base = scene->mesh->base ? scene->mesh->base[pixel->polygon] : scene->base;
    double at[2], texel[3] = {1, 1, 1};
    struct ref_lit lit = {{1, 1, 1}, {0, 0, 0}};

    if (scene->texture) {
        ref_texture_point(scene, &picture->pieces[pixel->piece], x + 0.5, y + 0.5, at);
        (void)ref_texture_color(scene->texture, at, texel);
    }
    if (scene->texels != REF_TEXELS_UV) {
        ref_color(scene, &picture->pieces[pixel->piece], x + 0.5, y + 0.5, lit.diffuse);
    } else {
        ref_shade(scene, &picture->pieces[pixel->piece], x + 0.5, y + 0.5, &lit);
        pixel->tread = ref_tread(scene, &picture->pieces[pixel->piece], x + 0.5, y + 0.5);
    }
    pixel->specular = fmax(lit.specular[0], fmax(lit.specular[1], lit.specular[2]));
    for (int k = 0; k < 3; k++)
        pixel->color[k] = fmin(fmax(base[k] * texel[k] * lit.diffuse[k] + scene->highlight[k] * lit.specular[k], 0), 1);
}

void ref_raster(struct ref_picture *picture, const struct ref_scene *scene)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    int *nearest = malloc(count * sizeof *nearest);

    if (!nearest)
        abort();
    for (size_t i = 0; i < count; i++)
        nearest[i] = 0; /* what is held to far is not seen */
    for (size_t i = 0; i < picture->piece_count; i++)
        draw(picture, nearest, scene, (uint32_t)i);
    for (size_t i = 0; i < picture->piece_count && scene->texture && scene->texture->keyed; i++)
        look_through(picture, nearest, scene, (uint32_t)i);
    free(nearest);
}

int ref_render(struct ref_picture *picture, const struct ref_scene *scene)
{
    *picture = (struct ref_picture){.width = scene->width, .height = scene->height};
    picture->pixels = calloc((size_t)scene->width * (size_t)scene->height, sizeof *picture->pixels);
    if (!picture->pixels || ref_project(picture, scene) != 0) {
        ref_picture_free(picture);
        return -1;
    }
    ref_raster(picture, scene);
    for (int y = 0; y < scene->height; y++) {
        for (int x = 0; x < scene->width; x++) {
            struct ref_pixel *pixel = &picture->pixels[y * scene->width + x];
            if (pixel->covered)
                color(scene, picture, pixel, x, y);
            else
                memcpy(pixel->color, scene->background, sizeof pixel->color);
            pixel->value = pixel->covered ? ref_fogged_value(scene, pixel->color, ref_fog_share(scene, pixel->z), x, y)
                                          : ref_value(scene, pixel->color, x, y, true);
        }
    }
    return 0;
}

void ref_picture_free(struct ref_picture *picture)
{
    free(picture->pixels);
    free(picture->pieces);
    *picture = (struct ref_picture){0};
}
