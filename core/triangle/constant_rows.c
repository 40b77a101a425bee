/*
 * constant_rows.c - one colour a triangle (lecture, "Uniform Shading"), finished at set-up.
 */
#include "triangle.h"

SPECIALISED void constant_rows(const struct tile *t, const struct constant_setup *s, unsigned grey)
{
    const struct plane depth = s->s.depth;
    const struct span *span = t->spans, *end = span + t->rows;
    uint32_t z = depth.base + (uint32_t)t->first_row * depth.dy;
    uint32_t line = (uint32_t)(t->first_row - t->rect.y0) * t->pitch - (uint32_t)t->rect.x0;
    const uint16_t pixel = s->pixel;

    do {
        int32_t x = span->x0, count = span->x1 - x;
        uint32_t at_z = z + (uint32_t)x * depth.dx;
        for (uint32_t at = line + (uint32_t)x; count > 0; count--, at++, at_z += depth.dx) {
            if (!nearer(t, t->depth + at, at_z))
                continue;
            if (grey)
                ((uint8_t *)t->pixels)[at] = (uint8_t)pixel;
            else
                ((uint16_t *)t->pixels)[at] = pixel;
        }
        line += t->pitch;
        z += depth.dy;
    } while (++span != end);
}

void sheen_constant_rows(const struct tile *t, const struct setup *s)
{
    if (FAST_LOOPS && !t->format->grey)
        constant_rows(t, (const struct constant_setup *)s, 0);
    else
        constant_rows(t, (const struct constant_setup *)s, t->format->grey);
}
