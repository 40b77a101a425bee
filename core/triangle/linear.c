/*
 * linear.c - set-up of channels and intensities that are linear on the screen (lecture, "Gouraud Shading").
 */
#include <string.h>

#include "../pixel/thumb.h"
#include "triangle.h"

SETUP_FITS(struct linear_setup);
SETUP_FITS(struct packed_setup);
SETUP_FITS(struct shades_setup);

/*
 * Interpolation that is linear on the screen in place of in space is off by at most dI (sqrt q - 1) / (sqrt q + 1) <=
 * dI (q - 1) / 4, where q is the ratio of the weights at an edge's ends. Differences of z16 are those of weights >>
 * weight_shift. Range: |d| <= 64000 (on grey, the sum of three channels), |z| <= 65020, so products fit 32 bits; unit <
 * 2^13; a weight >> weight_shift is below 2^25 unless far - near is less than 1/516 of far. Then the last product may
 * wrap, and a slower way than needed is taken.
 */
HOT int sheen_straight(const struct surface_corners *c, int32_t d1, int32_t d2, uint32_t unit)
{
    const struct screen *screen = c->screen;
    int32_t z1 = c->at.v[1]->z - c->at.v[0]->z, z2 = c->at.v[2]->z - c->at.v[0]->z;
    uint32_t most = magnitude32(d1) * magnitude32(z1), second = magnitude32(d2) * magnitude32(z2);
    uint32_t third = magnitude32(d2 - d1) * magnitude32(z2 - z1);

    if (screen->flat_weight)
        return 1;
    most = most > second ? most : second;
    most = most > third ? most : third;
    uint32_t least = c->at.v[0]->z + (uint32_t)min32(0, min32(z1, z2)) + z16_weight_offset(screen);
    return most >> 6 <= (least >> 6) * unit;
}

/* 1 if steps with 11 fraction bits suffice: they do for 64 px, as corners may lie on both sides of corner 0. */
static int packable(const struct gradients *g)
{
    return g->bits <= SUBPIXEL_BITS + PACKED_RUN_BITS;
}

HOT void sheen_setup_shades(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2)
{
    struct shades_setup *r = (struct shades_setup *)s;

    s->detail = !packable(g);
    s->rows = THUMB_LOOPS && s->detail ? sheen_wide_shades_rows : sheen_shades_rows;
    sheen_plane(&r->diffuse, g, (diffuse << 15) + ((uint32_t)SHADES_GUARD << (30 - SHADES_BITS)), d1, d2, 15);
}

/* 1 if some corner's channel is within `margin` of 0 or 1.0, or beyond; for a constant channel, only if beyond. */
HOT int sheen_channels_leave(const struct colour_terms *terms, uint32_t channel[3][3], uint32_t margin)
{
    int leave = 0;

    for (int i = 0; i < 3; i++) {
        const uint32_t *f = channel[i];
        uint32_t least = f[0] < f[1] ? f[0] : f[1], most = f[0] < f[1] ? f[1] : f[0];
        least = f[2] < least ? f[2] : least;
        most = f[2] > most ? f[2] : most;
        uint32_t in = least == most ? 0 : margin;
        leave |= least < in || most > terms->top[i] - in;
    }
    return leave;
}

/*
 * c: planes of the channels with `fraction` bits, modulo 2^32. red, blue: these channels at the origin pixel, where
 * they are exact whatever band is drawn. They are packed relative to MIDDLE, from which they are less than 2^31 away
 * except on needles so thin that they contain no pixel's centre.
 */
#define MIDDLE 16u /* level */

SPECIALISED void pack_planes(struct packed_setup *p, const struct gradients *g, const struct plane c[3],
                             unsigned fraction, uint32_t red, uint32_t blue)
{
    const int32_t x = g->origin[0], y = g->origin[1];
    const unsigned up = 26 - fraction;
    const uint32_t early = p->s.draw->dither ? 0 : 1u << 10; /* half a level */
    struct plane *rb = &p->red_blue;

    rb->dx = pack_red_blue(c[0].dx, c[2].dx, fraction);
    rb->dy = pack_red_blue(c[0].dy, c[2].dy, fraction);
    rb->base = pack_red_blue(red - (MIDDLE << fraction), blue - (MIDDLE << fraction), fraction) +
               ((MIDDLE << 11) + early) * 0x10001u - (uint32_t)x * rb->dx - (uint32_t)y * rb->dy;
    p->green = (struct plane){(c[1].base << up) + (early << 15), c[1].dx << up, c[1].dy << up};
    p->s.special_loop = 1;
    p->s.rows = sheen_packed_rows;
}

/* A channel's plane from the intensity's plane `l`; it has 2 more fraction bits than the draw's channels. */
SPECIALISED struct plane diffuse_channel(const struct colour_terms *terms, int k, const struct plane *l)
{
    const uint32_t b = terms->b[k];

    return (struct plane){4 * terms->a[k] + b * l->base, b * l->dx, b * l->dy};
}

/*
 * Makes the diffuse intensity's plane in units of 2^-17, and the channels' planes from that. The intensity may change
 * by up to 1/4 per pixel; between `low` and `high` no channel comes near 0 or 1.0. Range: the origin pixel's centre is
 * at most half a pixel each way beyond the triangle, so red and blue are within -8 and 39 levels there.
 */
HOT int sheen_setup_diffuse(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2)
{
    const struct colour_terms *terms = &s->draw->colour;
    const uint32_t low = terms->low, range = (uint32_t)terms->high - low;
    struct plane l, c[3];

    if (!packable(g) || diffuse - low > range || diffuse + (uint32_t)d1 - low > range ||
        diffuse + (uint32_t)d2 - low > range)
        return 0;
    sheen_plane(&l, g, diffuse << 2, d1, d2, 2);
    if (l.dx + 32768u > 65535u || l.dy + 32768u > 65535u)
        return 0;
    c[0] = diffuse_channel(terms, 0, &l);
    c[1] = diffuse_channel(terms, 1, &l);
    c[2] = diffuse_channel(terms, 2, &l);
    const uint32_t at = plane_at(&l, g->origin[0], g->origin[1]);
    pack_planes((struct packed_setup *)s, g, c, LOOP_FRACTION + 2, 4 * terms->a[0] + terms->b[0] * at,
                4 * terms->a[2] + terms->b[2] * at);
    return 1;
}

/*
 * channel: by component and corner. Differences are cut to 15 bits, 2^-10 level. special_loop is for channels whose sum
 * with a threshold never leaves its field of a word, even with the planes' rounding, which is below 1/32 level.
 */
HOT void sheen_setup_linear(struct setup *s, const struct gradients *g, uint32_t channel[3][3])
{
    const struct colour_terms *terms = &s->draw->colour;
    struct plane plane[3];
    const uint32_t margin = s->draw->dither ? 1u << (terms->fraction - 5) : 0;

    SHEEN_TAP(CHANNELS, 1);
    UNROLLED
    for (int i = 0; i < 3; i++) {
        const uint32_t *f = channel[i];
        sheen_plane(&plane[i], g, f[0], cut_difference(f[1], f[0]), cut_difference(f[2], f[0]), 16);
    }
    s->special_loop = s->draw->is_565 && !sheen_channels_leave(terms, channel, margin);
    if (s->special_loop && packable(g)) {
        pack_planes((struct packed_setup *)s, g, plane, terms->fraction,
                    plane_at(&plane[0], g->origin[0], g->origin[1]), plane_at(&plane[2], g->origin[0], g->origin[1]));
        return;
    }
    memcpy(((struct linear_setup *)s)->channel, plane, sizeof plane);
    s->rows = sheen_linear_rows;
}
