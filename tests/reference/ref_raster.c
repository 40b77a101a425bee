/*
 * ref_raster.c - which triangle is seen at each pixel centre: the nearest in 16-bit depth; of equal ones the first
 * drawn. Coordinates are not snapped.
 */
#include <stdlib.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

/* A side of a piece, stored from the same end for both pieces that share it, so that rounding is the same in both. */
struct side {
    double x, y, dx, dy;
    bool turned; /* the piece's outline runs along this side in the other direction */
    bool owned;  /* centres on it belong to the piece: a top side (interior below) or a left side (interior right) */
};

/* Side k goes from corner k to the next one. */
struct outline {
    struct side side[3];
    double area; /* twice the signed area; > 0: clockwise as seen, because y runs down */
};

/* Twice the signed area of the triangle between the side and the point. */
static double side_at(const struct side *side, double x, double y)
{
    double e = side->dx * (y - side->y) - side->dy * (x - side->x);

    return side->turned ? -e : e;
}

static void outline_of(struct outline *outline, const struct ref_piece *p)
{
    for (int k = 0; k < 3; k++) {
        int a = k, b = (k + 1) % 3;
        bool turned = p->x[b] < p->x[a] || (p->x[b] == p->x[a] && p->y[b] < p->y[a]);
        if (turned) {
            a = b;
            b = k;
        }
        outline->side[k] = (struct side){p->x[a], p->y[a], p->x[b] - p->x[a], p->y[b] - p->y[a], turned, false};
    }
    outline->area = side_at(&outline->side[0], p->x[2], p->y[2]);
    for (int k = 0; k < 3; k++) {
        struct side *side = &outline->side[k];
        /* Walking clockwise as seen, a left side leads up and a top side to the right. */
        bool against = side->turned != (outline->area < 0);
        double dx = against ? -side->dx : side->dx, dy = against ? -side->dy : side->dy;
        side->owned = dy < 0 || (dy == 0 && dx > 0);
    }
}

/* Whether a point is inside, or on an owned side; then e[k] is side_at() of side k. */
static bool inside(const struct outline *outline, double x, double y, double e[3])
{
    for (int k = 0; k < 3; k++) {
        e[k] = side_at(&outline->side[k], x, y);
        double inwards = outline->area < 0 ? -e[k] : e[k];
        if (inwards < 0 || (inwards == 0 && !outline->side[k].owned))
            return false;
    }
    return true;
}

bool ref_inside(const struct ref_piece *p, double x, double y)
{
    struct outline outline;
    double e[3];

    outline_of(&outline, p);
    return inside(&outline, x, y, e);
}

double ref_side_distance(const struct ref_piece *p, int side, double x, double y)
{
    int a = side, b = (side + 1) % 3;
    double dx = p->x[b] - p->x[a], dy = p->y[b] - p->y[a], length = dx * dx + dy * dy;
    double t = length > 0 ? ((x - p->x[a]) * dx + (y - p->y[a]) * dy) / length : 0;

    t = ref_min(ref_max(t, 0), 1);
    return hypot(p->x[a] + t * dx - x, p->y[a] + t * dy - y);
}

/* Interpolates the corners' values `at` to the point that inside() computed e for. */
static double screen_linear(const struct outline *outline, const double e[3], const double at[3])
{
    return (e[1] * at[0] + e[2] * at[1] + e[0] * at[2]) / outline->area;
}

/* z in whole steps of depth, 0 being far. */
static int steps(double z)
{
    return (int)(REF_STEPS * ref_min(ref_max(z, 0), 1) + 0.5);
}

static int first_pixel(double low)
{
    return low <= 0 ? 0 : (int)low;
}

static int end_pixel(double high, int end)
{
    return high >= end ? end : high < 0 ? 0 : (int)high + 1;
}

static bool transparent(const struct ref_scene *scene, const struct ref_piece *p, double x, double y)
{
    double at[2], unused[3];

    if (!scene->texture)
        return false;
    ref_texture_point(scene, p, x, y, at);
    return !ref_texture_color(scene->texture, at, unused);
}

/* The pixels that a piece may cover. */
struct box {
    int x0, y0, x1, y1;
};

static struct box box_of(const struct ref_picture *picture, const struct ref_piece *p)
{
    return (struct box){.x0 = first_pixel(ref_min(p->x[0], ref_min(p->x[1], p->x[2]))),
                        .y0 = first_pixel(ref_min(p->y[0], ref_min(p->y[1], p->y[2]))),
                        .x1 = end_pixel(ref_max(p->x[0], ref_max(p->x[1], p->x[2])), picture->width),
                        .y1 = end_pixel(ref_max(p->y[0], ref_max(p->y[1], p->y[2])), picture->height)};
}

/* The first pixel of row y, from x on, that is inside, with its e; x1 if there is none. */
static int next_inside(const struct outline *outline, int x, int x1, int y, double e[3])
{
    while (x < x1 && !inside(outline, x + 0.5, y + 0.5, e))
        x++;
    return x;
}

static void draw(struct ref_picture *picture, int *nearest, const struct ref_scene *scene, uint32_t index)
{
    const struct ref_piece *p = &picture->pieces[index];
    const struct box box = box_of(picture, p);
    struct outline outline;
    double e[3];

    outline_of(&outline, p);
    for (int y = box.y0; y < box.y1; y++) {
        int x = next_inside(&outline, box.x0, box.x1, y, e);
        for (; x < box.x1 && inside(&outline, x + 0.5, y + 0.5, e); x++) { /* a piece covers one run of a row */
            double depth = screen_linear(&outline, e, p->depth), z = screen_linear(&outline, e, p->z);
            double m = scene->ortho ? -depth : 1 / depth;
            int *best = &nearest[y * picture->width + x];
            if (m >= scene->far || steps(z) <= *best || transparent(scene, p, x + 0.5, y + 0.5))
                continue;
            *best = steps(z);
            picture->pixels[y * picture->width + x] = (struct ref_pixel){.covered = true,
                                                                         .back = p->back,
                                                                         .triangle = p->triangle,
                                                                         .polygon = p->polygon,
                                                                         .piece = index,
                                                                         .m = m,
                                                                         .z = z};
        }
    }
}

/* Marks pixels at which a transparent part of the piece lies in front of what is seen, and whether that is certain. */
static void look_through(struct ref_picture *picture, const int *nearest, const struct ref_scene *scene, uint32_t index)
{
    const struct ref_piece *p = &picture->pieces[index];
    const struct box box = box_of(picture, p);
    struct outline outline;
    double e[3], bound;

    outline_of(&outline, p);
    for (int y = box.y0; y < box.y1; y++) {
        int x = next_inside(&outline, box.x0, box.x1, y, e);
        for (; x < box.x1 && inside(&outline, x + 0.5, y + 0.5, e); x++) {
            struct ref_pixel *pixel = &picture->pixels[y * picture->width + x];
            double depth = screen_linear(&outline, e, p->depth);
            if ((pixel->covered && pixel->piece == index) ||
                steps(screen_linear(&outline, e, p->z)) <= nearest[y * picture->width + x] ||
                (scene->ortho ? -depth : 1 / depth) >= scene->far)
                continue;
            pixel->dropped = true;
            pixel->unsettled |= !ref_settled(scene, picture, p, x + 0.5, y + 0.5, &bound);
        }
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
    pixel->specular = ref_max(lit.specular[0], ref_max(lit.specular[1], lit.specular[2]));
    for (int k = 0; k < 3; k++)
        pixel->color[k] =
            ref_min(ref_max(base[k] * texel[k] * lit.diffuse[k] + scene->highlight[k] * lit.specular[k], 0), 1);
}

void ref_raster(struct ref_picture *picture, const struct ref_scene *scene)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    int *nearest = malloc(count * sizeof *nearest);

    if (!nearest)
        abort();
    for (size_t i = 0; i < count; i++)
        nearest[i] = 0; /* so a depth that was clamped to far, 0 steps, is not drawn */
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
    const uint16_t background = ref_value(scene, scene->background, 0, 0, true);
    for (int y = 0; y < scene->height; y++) {
        for (int x = 0; x < scene->width; x++) {
            struct ref_pixel *pixel = &picture->pixels[y * scene->width + x];
            pixel->value = background;
            memcpy(pixel->color, scene->background, sizeof pixel->color);
            if (!pixel->covered)
                continue;
            color(scene, picture, pixel, x, y);
            pixel->value = ref_fogged_value(scene, pixel->color, ref_fog_share(scene, pixel->z), x, y);
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
