/*
 * gouraud.c - makes planes or quadrics from intensities at the corners, and chooses
 * among linear on the screen, quadratic, and Blinn's quotient.
 */
#include "../triangle/quadric.h"
#include "../triangle/quotient.h"
#include "shading.h"

SETUP_FITS(struct quadric_setup);

#define GOURAUD_LEAN 65536 /* 1/m changes along an edge by at most 1/4 of its mean */

/* The largest difference between corners in the channel that changes most, in 1/1024 of 1.0, at most 0xffff. */
static uint32_t difference_of(const struct colour_terms *terms, const int32_t d[2])
{
    uint32_t most = magnitude32(d[0]);

    most = magnitude32(d[1]) > most ? magnitude32(d[1]) : most;
    most = magnitude32(d[1] - d[0]) > most ? magnitude32(d[1] - d[0]) : most;
    most = (most << 1 >> (terms->unit_log2 - 19)) + 1;
    return most > 0xffff ? 0xffff : most;
}

/*
 * A quadric through the edges' middles is off by about dI (q - 1)^2 / 32, where dI is the difference and q - 1 the
 * lean. Range: difference < 2^16 in 1/1024 of 1.0, lean <= 2^16.
 */
static int quadratic_will_do(const int32_t lean[3], uint32_t difference)
{
    uint32_t most = (magnitude32(lean[0]) | magnitude32(lean[1]) | magnitude32(lean[2])) >> 2;

    return difference * (most * most >> 16) >> 20 == 0;
}

/*
 * Returns 0 if planes need steps of 31 bits (wide), the triangle is too small or a needle, or 1/m is too uneven.
 * difference: as difference_of returns it.
 */
HOT static APART int quadratic(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                               const struct lit lit[3], uint32_t difference)
{
    struct quadric_setup *q = (struct quadric_setup *)s;
    const int32_t diffuse[3] = {(int32_t)lit[0].diffuse, (int32_t)lit[1].diffuse, (int32_t)lit[2].diffuse};
    const int32_t specular[3] = {(int32_t)lit[0].specular, (int32_t)lit[1].specular, (int32_t)lit[2].specular};
    struct quadric_steps steps;
    int32_t lean[3];

    if (g->wide || !sheen_leans(lean, c, GOURAUD_LEAN) || !quadratic_will_do(lean, difference) ||
        !sheen_quadric_steps(&steps, g))
        return 0;
    sheen_take_quadric_rows(s, g, (specular[0] | specular[1] | specular[2]) != 0 ? SECOND_SPECULAR : SECOND_NONE);
    sheen_space_quadric(&q->diffuse, &steps, lean, diffuse);
    if (s->detail != SECOND_NONE)
        sheen_space_quadric(&q->second, &steps, lean, specular);
    return 1;
}

/*
 * The channels at the corners, and in d the differences of corners 1 and 2 to corner 0, in steps of 2^16: of the
 * channel that changes most, which with a highlight may be another than for diffuse light alone; on grey of their sum.
 */
static void corner_channels(const struct draw *draw, const struct lit lit[3], uint32_t channel[3][3], int32_t d[2])
{
    uint32_t most = 0;

    d[0] = d[1] = 0;
    for (int i = 0; i < 3; i++) {
        uint32_t *f = channel[i];
        f[0] = colour_channel(&draw->colour, i, &lit[0]);
        f[1] = colour_channel(&draw->colour, i, &lit[1]);
        f[2] = colour_channel(&draw->colour, i, &lit[2]);
        int32_t d1 = cut_difference(f[1], f[0]), d2 = cut_difference(f[2], f[0]);
        uint32_t both = magnitude32(d1) + magnitude32(d2);
        if (!draw->is_565) {
            d[0] += d1;
            d[1] += d2;
        } else if (both > most) {
            most = both;
            d[0] = d1;
            d[1] = d2;
        }
    }
}

/* Interpolates channels: for a highlight, or if neither shades nor the diffuse intensity alone suffice. */
HOT static APART void glossy(struct setup *s, struct surface_corners *c, const struct gradients *g,
                             const struct lit lit[3])
{
    const struct draw *draw = s->draw;
    const struct colour_terms *terms = &draw->colour;
    uint32_t channel[3][3];
    int32_t d[2];

    corner_channels(draw, lit, channel, d);
    if (way_wanted(draw, SHEEN_WAY_GOURAUD_LINEAR) && sheen_straight(c, d[0], d[1], 3u << terms->unit_log2 >> 20)) {
        sheen_setup_linear(s, g, channel);
        return;
    }
    sheen_weigh(c);
    s->way = SHEEN_WAY_GOURAUD_QUADRATIC;
    if (!way_wanted(draw, SHEEN_WAY_GOURAUD_QUADRATIC) || !quadratic(s, c, g, lit, difference_of(terms, d)))
        sheen_setup_quotient(s, c, g, channel);
}

HOT static void gouraud_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    const struct draw *d = s->draw;
    struct lit lit[3];
    uint32_t specular = corners_lit(s, c, c->at.normal, lit);

    if (g == NULL) {
        struct lit mean = {QUOTIENT(lit[0].diffuse + lit[1].diffuse + lit[2].diffuse, 3u),
                           QUOTIENT(lit[0].specular + lit[1].specular + lit[2].specular, 3u)};
        sheen_setup_constant(s, &mean);
        return;
    }
    s->way = SHEEN_WAY_GOURAUD_LINEAR;
    if (specular > faint_highlight(d->colour.faint_specular, d->dither)) {
        glossy(s, c, g, lit);
        return;
    }
    int32_t d1 = (int32_t)(lit[1].diffuse - lit[0].diffuse), d2 = (int32_t)(lit[2].diffuse - lit[0].diffuse);
    int straight = way_wanted(d, SHEEN_WAY_GOURAUD_LINEAR) && sheen_straight(c, d1, d2, d->colour.diffuse_tolerance);
    if (straight && d->shades != NULL && !d->dither)
        sheen_setup_shades(s, g, lit[0].diffuse, d1, d2);
    else if (!straight || !sheen_setup_diffuse(s, g, lit[0].diffuse, d1, d2))
        glossy(s, c, g, lit);
}

/* A vertex keeps its intensities. */
static void gouraud_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit;

    light_normal(&d->light, &d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

static void gouraud_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                          const struct sheen_object *object, const struct sheen_pose *view)
{
    sheen_loop_begin(d, material, format, object, view);
    sheen_colour_reach(&d->colour, format);
}

const struct sheen_shader sheen_gouraud = {.begin = gouraud_begin,
                                           .light = gouraud_light,
                                           .setup = gouraud_setup,
                                           .quads = QUADS_LIT,
                                           .find_shades = sheen_shades_of,
                                           .needs_normals = 1,
                                           .corners = OF_MESH(normals)};
