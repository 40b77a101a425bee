/*
 * linear_rows.c - channels that are linear on the screen (lecture, "Gouraud Shading").
 *
 * Colour is linear in the intensities, so the three channels are interpolated,
 * in levels, and rounded once a pixel.
 */
#include "triangle.h"

/* A run of 565 pixels without clamp or dither; rounding is in the channels. */
static void linear_run(const struct tile *t, uint32_t at, uint32_t count, uint32_t z, const struct linear_setup *l,
                       const uint32_t start[3])
{
    uint16_t *pixels = (uint16_t *)t->pixels + at, *end = pixels + count, *depth = t->depth + at;
    const struct plane *c = l->channel;
    const uint32_t dz = l->s.depth.dx, dr = c[0].dx, dg = c[1].dx, db = c[2].dx;
    const unsigned fraction = l->s.draw->colour.fraction, swap = t->format->swap;
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
                               const struct linear_setup *l, uint32_t channel[3])
{
    const struct colour_terms *terms = &l->s.draw->colour;
    struct rounding rounding = rounding_of(t, terms, y);

    for (; x < x1; x++, at++, z += l->s.depth.dx) {
        if (nearer(t, t->depth + at, z))
            put_general(t, terms, rounding, at, x, not_negative(channel[0]), not_negative(channel[1]),
                        not_negative(channel[2]));
        for (int k = 0; k < 3; k++)
            channel[k] += l->channel[k].dx;
    }
}

void sheen_linear_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *l = (const struct linear_setup *)s;
    const struct plane *c = l->channel;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t channel[3] = {plane_at(&c[0], x, y), plane_at(&c[1], x, y), plane_at(&c[2], x, y)};
        if (FAST_LOOPS && s->fast)
            linear_run(t, at, (uint32_t)(x1 - x), z, l, channel);
        else
            linear_run_general(t, at, x, x1, y, z, l, channel);
    }
}
