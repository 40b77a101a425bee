/*
 * shade_flat.c - one intensity a polygon (lecture, "Uniform Shading").
 */
#include "shade.h"

void sheen_shade_flat(const struct tile *t, const struct setup *s)
{
    uint16_t pixel = (uint16_t)s->shade.pixel;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y);
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                *pixels = pixel;
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += s->depth.dx;
        } while (--count > 0);
    }
}
