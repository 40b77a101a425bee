/*
 * quotient.h - private: channels that are linear in space (lecture, "Fixing Distortion"): Blinn's I/m over 1/m, a
 * reciprocal per pixel.
 */
#ifndef SHEEN_QUOTIENT_H
#define SHEEN_QUOTIENT_H

#include "fog.h"
#include "triangle.h"

struct quotient_setup {
    struct setup s;
    struct plane channel[3]; /* times weight, with the draw's fraction bits */
    struct plane weight;     /* UQ0.32 */
};

/* Planes of weight and channels times weight. channel: by component and corner; the corners MUST be weighed. */
void sheen_setup_quotient(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                          uint32_t channel[3][3]);
/* channels.c: the same, or linear on the screen or one colour if that is accurate enough; g NULL: the corners' mean. */
void sheen_setup_channels(struct setup *s, struct surface_corners *c, const struct gradients *g,
                          uint32_t channel[3][3]);
void sheen_quotient_rows(const struct tile *t, const struct setup *s);

/* Scales a weight up to [1/2, 1) and returns by how many bits: at most 1 if the ratio over the triangle is <= 2. */
SPECIALISED unsigned weight_up(uint32_t *weight)
{
    uint32_t w = *weight | 1u;
    unsigned up = 0;

    while ((w & 0x80000000u) == 0) {
        w <<= 1;
        up++;
    }
    *weight = w;
    return up;
}

/*
 * A channel from its product with weight: that product's top 16 bits times 1/weight, UQ1.15. Range: the quotient is
 * below 2^31 at the corners; rounding adds less than 2^17.
 */
SPECIALISED uint32_t quotient(uint32_t channel, unsigned up, uint32_t one_over)
{
    return (((not_negative(channel) << up) + (1u << 14)) >> 15) * one_over;
}

SPLIT void quotient_rows(const struct tile *t, const struct quotient_setup *q, int is_fogged)
{
    const struct setup *s = &q->s;
    const struct plane *c = q->channel, *weight = &q->weight;
    const uint32_t dr = c[0].dx, dg = c[1].dx, db = c[2].dx, dw = weight->dx, dz = s->depth.dx;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &s->draw->colour, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y), w = plane_at(weight, x, y);
        uint32_t r = plane_at(&c[0], x, y), g = plane_at(&c[1], x, y), b = plane_at(&c[2], x, y);
        for (; x < x1; x++, at++, z += dz, w += dw, r += dr, g += dg, b += db) {
            if (!nearer(t, t->depth + at, z))
                continue;
            uint32_t v = w;
            unsigned up = weight_up(&v);
            uint32_t one_over = reciprocal_seed(v);
            uint32_t red = quotient(r, up, one_over), green = quotient(g, up, one_over),
                     blue = quotient(b, up, one_over);
            if (is_fogged)
                put_fogged_terms(t, s->draw, at, z, red, green, blue, rounding.threshold[(uint32_t)x & 7u],
                                 t->format->grey);
            else
                put_general(t, &s->draw->colour, rounding, at, x, red, green, blue);
        }
    }
}

#endif
