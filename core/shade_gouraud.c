/*
 * shade_gouraud.c - linear interpolation of intensities (lecture, "Gouraud
 * Shading"), perspective-correct by Blinn's I/m over 1/m.
 *
 * Colour is linear in the intensities, so the three channels are interpolated,
 * in levels, and rounded once a pixel.
 */
#include "newton.h"
#include "shade.h"

SPECIALISED void linear_rows(const struct tile *t, const struct setup *s, int clamp, unsigned swap)
{
    const struct plane *c = s->shade.gouraud.channel;
    const uint32_t dr = c[0].dx, dg = c[1].dx, db = c[2].dx, dz = s->depth.dx;
    const unsigned fraction = s->draw->colour.fraction;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y);
        uint32_t r = plane_at(&c[0], x0, y), g = plane_at(&c[1], x0, y), b = plane_at(&c[2], x0, y);
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                *pixels = pixel_of(r, g, b, fraction, clamp, swap);
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += dz;
            r += dr;
            g += dg;
            b += db;
        } while (--count > 0);
    }
}

void sheen_shade_gouraud_linear(const struct tile *t, const struct setup *s)
{
    if (s->clamp)
        linear_rows(t, s, 1, t->swap);
    else if (t->swap)
        linear_rows(t, s, 0, 1);
    else
        linear_rows(t, s, 0, 0);
}

/*
 * A channel times weight, over the weight. x: 16 top bits, r: UQ1.15 of 1/weight.
 * Range: the quotient is below 2^31 at the corners; rounding adds less than 2^17.
 */
SPECIALISED uint32_t quotient(uint32_t x, uint32_t r, uint32_t half)
{
    return ((not_negative(x) + (1u << 14)) >> 15) * r + half;
}

SPECIALISED void quotient_rows(const struct tile *t, const struct setup *s, unsigned swap)
{
    const struct plane *c = s->shade.gouraud.channel, *weight = &s->shade.gouraud.weight;
    const uint32_t dr = c[0].dx, dg = c[1].dx, db = c[2].dx, dw = weight->dx, dz = s->depth.dx;
    const unsigned fraction = s->draw->colour.fraction;
    const uint32_t half = 1u << (fraction - 1);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y), w = plane_at(weight, x0, y);
        uint32_t r = plane_at(&c[0], x0, y), g = plane_at(&c[1], x0, y), b = plane_at(&c[2], x0, y);
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                uint32_t up = 0, v = w | 1u; /* the weight brought up to [1/2, 1): once at the most where q <= 2 */
                while ((v & 0x80000000u) == 0) {
                    v <<= 1;
                    up++;
                }
                uint32_t one_over = reciprocal_seed(v);
                *pixels = pixel_of(quotient(r << up, one_over, half), quotient(g << up, one_over, half),
                                   quotient(b << up, one_over, half), fraction, 1, swap);
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += dz;
            w += dw;
            r += dr;
            g += dg;
            b += db;
        } while (--count > 0);
    }
}

void sheen_shade_gouraud_quotient(const struct tile *t, const struct setup *s)
{
    if (t->swap)
        quotient_rows(t, s, 1);
    else
        quotient_rows(t, s, 0);
}
