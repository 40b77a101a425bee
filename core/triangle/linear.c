/*
 * linear.c - set-up of what is linear on the screen (lecture, "Gouraud Shading").
 */
#include "triangle.h"

SETUP_FITS(struct linear_setup);
SETUP_FITS(struct ramp_setup);

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
    uint32_t weight = c->at.v[0]->z + (screen->weight_offset >> screen->weight_shift);
    return most >> 6 <= (weight >> 6) * unit;
}

void sheen_setup_ramp(struct setup *s, const struct gradients *g, const uint32_t diffuse[3])
{
    struct ramp_setup *r = (struct ramp_setup *)s;
    int32_t d1 = (int32_t)(diffuse[1] - diffuse[0]), d2 = (int32_t)(diffuse[2] - diffuse[0]);

    s->rows = sheen_ramp_rows;
    r->diffuse = sheen_plane(g, (diffuse[0] << 15) + ((uint32_t)RAMP_GUARD << (30 - RAMP_BITS)), d1, d2, 15);
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

/*
 * channel: by component and corner. A difference is cut to 15 bits, 2^-10 level. fast: no sum with a threshold leaves
 * a word's field, whatever the planes have rounded, below 1/32 level.
 */
void sheen_setup_linear(struct setup *s, const struct gradients *g, uint32_t channel[3][3])
{
    struct linear_setup *l = (struct linear_setup *)s;
    const struct colour_terms *terms = &s->draw->colour;
    const uint32_t margin = s->draw->dither ? 1u << (terms->fraction - 5) : 0;

    for (int i = 0; i < 3; i++) {
        const uint32_t *f = channel[i];
        l->channel[i] = sheen_plane(g, f[0], cut_difference(f[1], f[0]), cut_difference(f[2], f[0]), 16);
    }
    s->fast = s->draw->is_565 && !sheen_channels_leave(terms, channel, margin);
    s->rows = sheen_linear_rows;
}
