/*
 * gouraud_rows.c - linear interpolation of intensities (lecture, "Gouraud
 * Shading"), perspective-correct by Blinn's I/m over 1/m.
 *
 * Colour is linear in the intensities, so the three channels are interpolated,
 * in levels, and rounded once a pixel.
 */
#include "../math/newton.h"
#include "../triangle/rows.h"

/* A run of 565 pixels without clamp or dither; rounding is in the channels. */
static void linear_run(const struct tile *t, uint32_t at, uint32_t count, uint32_t z, const struct setup *s,
                       const uint32_t start[3])
{
    uint16_t *pixels = (uint16_t *)t->pixels + at, *end = pixels + count, *depth = t->depth + at;
    const struct plane *c = s->shade.gouraud.channel;
    const uint32_t dz = s->depth.dx, dr = c[0].dx, dg = c[1].dx, db = c[2].dx;
    const unsigned fraction = s->draw->colour.fraction, swap = t->format->swap;
    uint32_t r = start[0], g = start[1], b = start[2];

    do {
        if (nearer(t, depth, z))
            *pixels = fast_pixel(r, g, b, fraction, swap);
        depth++;
        z += dz;
        r += dr;
        g += dg;
        b += db;
    } while (++pixels != end);
}

/* A run in any format. */
static void linear_run_general(const struct tile *t, uint32_t at, int32_t x, int32_t x1, int32_t y, uint32_t z,
                               const struct setup *s, uint32_t channel[3])
{
    const struct colour_terms *terms = &s->draw->colour;
    struct rounding rounding = rounding_of(t, terms, y);

    for (; x < x1; x++, at++, z += s->depth.dx) {
        if (nearer(t, t->depth + at, z))
            put_general(t, terms, rounding, at, x, not_negative(channel[0]), not_negative(channel[1]),
                        not_negative(channel[2]));
        for (int k = 0; k < 3; k++)
            channel[k] += s->shade.gouraud.channel[k].dx;
    }
}

void sheen_shade_gouraud_linear(const struct tile *t, const struct setup *s)
{
    const struct plane *c = s->shade.gouraud.channel;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t channel[3] = {plane_at(&c[0], x, y), plane_at(&c[1], x, y), plane_at(&c[2], x, y)};
        if (FAST_LOOPS && s->fast)
            linear_run(t, at, (uint32_t)(x1 - x), z, s, channel);
        else
            linear_run_general(t, at, x, x1, y, z, s, channel);
    }
}

/* The weight brought up to [1/2, 1) by a power of two: once at the most where the ratio over the triangle is <= 2. */
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
 * A channel times weight, over the weight: 16 top bits times UQ1.15 of 1/weight.
 * Range: the quotient is below 2^31 at the corners; rounding adds less than 2^17.
 */
SPECIALISED uint32_t quotient(uint32_t channel, unsigned up, uint32_t one_over)
{
    return (((not_negative(channel) << up) + (1u << 14)) >> 15) * one_over;
}

void sheen_shade_gouraud_quotient(const struct tile *t, const struct setup *s)
{
    const struct plane *c = s->shade.gouraud.channel, *weight = &s->shade.gouraud.weight;
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
            put_general(t, &s->draw->colour, rounding, at, x, quotient(r, up, one_over), quotient(g, up, one_over),
                        quotient(b, up, one_over));
        }
    }
}
