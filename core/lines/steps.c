/*
 * steps.c - a line made ready to be stepped along its longer side.
 */
#include "lines.h"

/* numerator * reciprocal >> down, seed: the reciprocal, UQ1.15; within 2^-14 of exact. Range: |numerator| < 2^16. */
static inline int32_t slope_of(int32_t numerator, uint32_t seed, unsigned down)
{
    int32_t slope = (int32_t)(magnitude32(numerator) * seed >> down);

    return numerator < 0 ? -slope : slope;
}

/* A vertex's depth with the draw's bias, held in range as for triangles' corners. */
static int32_t biased_z(const struct line_tile *t, const struct vertex *v)
{
    return t->depth_bias == 0 ? v->z : max32(DEPTH_FAR, min32(v->z + t->depth_bias, DEPTH_FAR + DEPTH_RANGE));
}

/*
 * Steps are at pixels' centres, from the line's end of lower coordinate on. Range: a centre lies before the other end,
 * so what the steps add up to stays below the line's own extent and 2^-14 of that: 2^10 px in Q.16, z16 in Q.8.
 */
HOT int sheen_line_begin(struct steps *s, const struct line_tile *t, const struct line *line)
{
    const struct vertex *a = &t->vertex[line->from], *b = &t->vertex[line->to];
    const struct sheen_rect rect = t->tile->rect;
    int32_t dx = b->x - a->x, dy = b->y - a->y, low = t->tile->centre_x, side = t->tile->centre_y;
    int32_t from = rect.x0, to = rect.x1, along, across, size;

    SHEEN_TAP(LINE_BAND, 1);
    s->steep = magnitude32(dy) >= magnitude32(dx);
    size = s->steep ? dy : dx;
    if (size == 0)
        return 0;
    s->low_inside = s->steep ? dy < 0 : dx > 0;
    if (size < 0) {
        a = b;
        dx = -dx;
        dy = -dy;
        size = -size;
    }
    if (s->steep) {
        along = a->y + side;
        across = a->x + low;
        from = t->y0;
        to = t->y1;
    } else {
        along = a->x + low;
        across = a->y + side;
    }
    s->first = first_centre(along);
    s->end = min32(first_centre(along + size), to);
    if (max32(s->first, from) >= s->end)
        return 0;
    int32_t rest = s->first * SUBPIXEL_ONE + SUBPIXEL_HALF - along, skipped = max32(from - s->first, 0);
    const struct vertex *other = a == b ? &t->vertex[line->from] : b;
    const int32_t z = biased_z(t, a);
    const unsigned up = clz32((uint32_t)size);
    const uint32_t seed = reciprocal_seed((uint32_t)size << up);
    s->across_step = slope_of(s->steep ? dx : dy, seed, 31 - up);
    s->z_step = slope_of(biased_z(t, other) - z, seed, 33 - up);
    s->across =
        across * (1 << (16 - SUBPIXEL_BITS)) + asr32(s->across_step * rest, SUBPIXEL_BITS) + s->across_step * skipped;
    s->z = z * 256 + asr32(s->z_step * rest, SUBPIXEL_BITS) + s->z_step * skipped;
    s->first += skipped;
    return 1;
}
