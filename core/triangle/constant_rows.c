/*
 * constant_rows.c - one colour a triangle (lecture, "Uniform Shading").
 */
#include "triangle.h"

void sheen_constant_rows(const struct tile *t, const struct setup *s)
{
    const struct constant_setup *constant = (const struct constant_setup *)s;
    const uint32_t *channel = constant->channel;
    const uint16_t pixel = pixel_order(constant->value, t->format->swap);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &s->draw->colour, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        for (; x < x1; x++, at++, z += s->depth.dx) {
            if (!nearer(t, t->depth + at, z))
                continue;
            if (FAST_LOOPS && s->fast)
                ((uint16_t *)t->pixels)[at] = pixel;
            else
                put_general(t, &s->draw->colour, rounding, at, x, channel[0], channel[1], channel[2]);
        }
    }
}
