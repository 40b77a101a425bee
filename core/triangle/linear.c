/*
 * linear.c - set-up of what is linear on the screen (lecture, "Gouraud Shading").
 */
#include <string.h>

#include "triangle.h"

SETUP_FITS(struct linear_setup);
SETUP_FITS(struct packed_setup);
SETUP_FITS(struct shades_setup);

/*
 * Linear on the screen in place of in space is off by at most dI (sqrt q - 1) / (sqrt q + 1) <= dI (q - 1) / 4, q the
 * ratio of the weights at an edge's ends. Of weights, z16 differs by what they do, >> weight_shift.
 * Range: |d| <= 2^15, |z| < 2^16, unit < 2^11; a weight >> weight_shift is below 2^25.
 */
int sheen_straight(const struct surface_corners *c, int32_t d1, int32_t d2, uint32_t unit)
{
    const struct screen *screen = c->screen;
    int32_t z1 = c->at.v[1]->z - c->at.v[0]->z, z2 = c->at.v[2]->z - c->at.v[0]->z;
    uint32_t most = magnitude32(d1) * magnitude32(z1), second = magnitude32(d2) * magnitude32(z2);
    uint32_t third = magnitude32(d2 - d1) * magnitude32(z2 - z1);

    if (screen->flat_weight)
        return 1;
    most = most > second ? most : second;
    most = most > third ? most : third;
    uint32_t least =
        c->at.v[0]->z + (uint32_t)min32(0, min32(z1, z2)) + (screen->weight_offset >> screen->weight_shift);
    return most >> 6 <= (least >> 6) * unit;
}

void sheen_setup_shades(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2)
{
    struct shades_setup *r = (struct shades_setup *)s;

    s->rows = sheen_shades_rows;
    r->diffuse = sheen_plane(g, (diffuse << 15) + ((uint32_t)SHADES_GUARD << (30 - SHADES_BITS)), d1, d2, 15);
}

/* 1 where a corner's channel lies within `margin` of 1.0 or beyond, or of 0, unless it is the same at all corners. */
int sheen_channels_leave(const struct colour_terms *terms, uint32_t channel[3][3], uint32_t margin)
{
    unsigned leave = 0;

    for (int i = 0; i < 3; i++) {
        const uint32_t *f = channel[i];
        if (f[0] == f[1] && f[0] == f[2] && f[0] <= terms->top[i])
            continue;
        for (int k = 0; k < 3; k++)
            leave |= f[k] < margin || f[k] > terms->top[i] - margin;
    }
    return leave != 0;
}

/* Steps of 11 fraction bits do for 64 px, a row of thresholds for COLUMN: corners lie on both sides of corner 0. */
static int packable(const struct draw *d, const struct gradients *g)
{
    const int32_t x1 = g->to1[0], x2 = g->to2[0];

    return g->bits <= SUBPIXEL_BITS + COLUMN_BITS &&
           (!d->dither || max32(max32(x1, x2), 0) - min32(min32(x1, x2), 0) < COLUMN * SUBPIXEL_ONE);
}

/* value: of the channels at the origin pixel; dx, dy: their steps. Exact there, whatever band is drawn. */
static void pack_planes(struct packed_setup *p, const struct gradients *g, uint32_t value[3], const uint32_t dx[3],
                        const uint32_t dy[3])
{
    const struct draw *d = p->s.draw;
    const unsigned fraction = d->colour.fraction;
    const uint32_t x = (uint32_t)g->origin[0], y = (uint32_t)g->origin[1];

    for (int i = 0; i < 3; i++)
        value[i] += d->dither ? 0 : 1u << (fraction - 1);
    const struct packed at = pack_channels(value, fraction), by_x = pack_channels(dx, fraction);
    const struct packed by_y = pack_channels(dy, fraction);
    p->red_blue.dx = by_x.red_blue;
    p->red_blue.dy = by_y.red_blue;
    p->red_blue.base = at.red_blue - x * by_x.red_blue - y * by_y.red_blue;
    p->green.dx = by_x.green;
    p->green.dy = by_y.green;
    p->green.base = at.green - x * by_x.green - y * by_y.green;
    p->s.fast = 1;
    p->s.rows = sheen_packed_rows;
}

/*
 * The intensity in 2^-17, from which the channels follow: a step counts up to 1/4 a px, and between `low` and `high` no
 * channel comes near 0 or 1.0.
 */
int sheen_setup_diffuse(struct setup *s, const struct gradients *g, uint32_t diffuse, int32_t d1, int32_t d2)
{
    const struct colour_terms *terms = &s->draw->colour;
    const uint32_t low = terms->low, range = (uint32_t)terms->high - low;
    uint32_t value[3], dx[3], dy[3];

    if (!packable(s->draw, g) || diffuse - low > range || diffuse + (uint32_t)d1 - low > range ||
        diffuse + (uint32_t)d2 - low > range)
        return 0;
    struct plane l = sheen_plane(g, diffuse << 2, d1, d2, 2);
    if (l.dx + 32768u > 65535u || l.dy + 32768u > 65535u)
        return 0;
    int32_t at = (int32_t)plane_at(&l, g->origin[0], g->origin[1]), whole = asr32(at, 2), rest = at & 3;
    for (int i = 0; i < 3; i++) {
        int32_t b = terms->b[i];
        value[i] = terms->a[i] + (uint32_t)(b * whole) + (uint32_t)(b * rest >> 2);
        dx[i] = (uint32_t)asr32(b * (int32_t)l.dx, 2);
        dy[i] = (uint32_t)asr32(b * (int32_t)l.dy, 2);
    }
    pack_planes((struct packed_setup *)s, g, value, dx, dy);
    return 1;
}

/*
 * channel: by component and corner. A difference is cut to 15 bits, 2^-10 level. fast: no sum with a threshold leaves
 * a word's field, whatever the planes have rounded, below 1/32 level.
 */
void sheen_setup_linear(struct setup *s, const struct gradients *g, uint32_t channel[3][3])
{
    const struct colour_terms *terms = &s->draw->colour;
    struct plane plane[3];
    const uint32_t margin = s->draw->dither ? 1u << (terms->fraction - 5) : 0;

    SHEEN_TAP(CHANNELS, 1);
    for (int i = 0; i < 3; i++) {
        const uint32_t *f = channel[i];
        plane[i] = sheen_plane(g, f[0], cut_difference(f[1], f[0]), cut_difference(f[2], f[0]), 16);
    }
    s->fast = s->draw->is_565 && !sheen_channels_leave(terms, channel, margin);
    if (s->fast && packable(s->draw, g)) {
        const uint32_t dx[3] = {plane[0].dx, plane[1].dx, plane[2].dx}, dy[3] = {plane[0].dy, plane[1].dy, plane[2].dy};
        uint32_t value[3];
        for (int i = 0; i < 3; i++)
            value[i] = plane_at(&plane[i], g->origin[0], g->origin[1]);
        pack_planes((struct packed_setup *)s, g, value, dx, dy);
        return;
    }
    memcpy(((struct linear_setup *)s)->channel, plane, sizeof plane);
    s->rows = sheen_linear_rows;
}
