/*
 * line_rows.c - lines 1 px wide, drawn where the triangles do not hide them.
 */
#include "lines.h"

/* Steps of z16 that a line may lie behind the tile's depth and still be seen, because both are rounded. */
#define CLOSE 16

/*
 * Whether an edge that is no contour is seen. own: the depth at the crossed pixel; low, high: at its neighbours on
 * either side of the line. The triangles on both sides are visible, so one of the three depths is not in front of the
 * line by more than the slope there, which is how far a neighbour rises above `own` in a valley.
 */
SPECIALISED int line_is_seen(int32_t z, int32_t own, int32_t low, int32_t high)
{
    int32_t rise = max32(max32(low, high) - own, 0);

    return min32(own, min32(low, high)) <= z + rise;
}

/*
 * A contour is seen if the pixel beyond it is not in front of it: the neighbour, or the crossed pixel itself if its
 * centre lies beyond. `place` is the pixel's row or column, counted from the first that is drawn on; the tile has
 * `wide` of them from `lowest` on.
 */
SPECIALISED void line_rows(const struct line_tile *lt, const struct steps *s, uint32_t pixel, int contour, int steep)
{
    const struct tile *t = lt->tile;
    const int32_t pitch = (int32_t)t->pitch, next = steep ? 1 : pitch, lowest = steep ? 0 : -lt->apron;
    const int32_t wide = steep ? t->rect.x1 - t->rect.x0 : t->rect.y1 - t->rect.y0;
    const int32_t size = steep ? wide : (int32_t)lt->rows, stride = steep ? pitch : 1;
    const int32_t out = s->low_inside ? 1 : -1, grey = t->format->grey;
    int32_t across = s->across - (steep ? t->rect.x0 : lt->y0) * 65536, z = s->z + CLOSE * 256;
    int32_t start = lt->apron * pitch + (s->first - (steep ? lt->y0 : t->rect.x0)) * stride;
    const int32_t end = start + (s->end - s->first) * stride;

    SHEEN_TAP(LINE_STEP, s->end - s->first);
    for (; start < end; start += stride, across += s->across_step, z += s->z_step) {
        const int32_t place = asr32(across, 16);
        if ((uint32_t)place >= (uint32_t)size)
            continue;
        SHEEN_TAP(LINE_PIXEL, 1);
        const int32_t at = start + (steep ? place : place * pitch);
        const uint16_t *depth = t->depth + at;
        if (contour) {
            const int inside = ((across & 0x8000) == 0) == (out < 0); /* the pixel's centre is inside */
            if (inside && (uint32_t)(place + out - lowest) < (uint32_t)wide)
                depth += out < 0 ? -next : next;
            if (depth[0] > asr32(z, 8))
                continue;
        } else {
            const int32_t own = depth[0];
            if (own > asr32(z, 8)) { /* rare */
                const int32_t low = place > lowest ? depth[-next] : own;
                const int32_t high = place - lowest < wide - 1 ? depth[next] : own;
                if (!line_is_seen(asr32(z, 8), own, low, high))
                    continue;
            }
        }
        if (grey)
            ((uint8_t *)t->pixels)[at] = (uint8_t)pixel;
        else
            ((uint16_t *)t->pixels)[at] = (uint16_t)pixel;
    }
}

HOT void sheen_line_rows(const struct line_tile *t, const struct steps *s, uint16_t pixel, int contour)
{
    if (contour && s->steep)
        line_rows(t, s, pixel, 1, 1);
    else if (contour)
        line_rows(t, s, pixel, 1, 0);
    else if (s->steep)
        line_rows(t, s, pixel, 0, 1);
    else
        line_rows(t, s, pixel, 0, 0);
}
