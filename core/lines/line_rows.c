/*
 * line_rows.c - lines 1 px wide where the triangles do not hide them.
 */
#include "lines.h"

/* Steps of z16 that a line may lie behind what is there and still be seen: what both are rounded by. */
#define CLOSE 16

/*
 * Depth at the pixel that is crossed, `own`, and at its neighbours across. A contour is seen where what lies beyond it
 * is not in front. Any other edge is seen from triangles on both sides: one of the three is not in front of it by more
 * than the slope there, which a valley's differences tell.
 */
SPECIALISED int line_is_seen(int32_t z, int32_t own, int32_t low, int32_t high)
{
    int32_t rise = max32(max32(low, high) - own, 0);

    return min32(own, min32(low, high)) <= z + CLOSE + rise;
}

SPECIALISED void line_rows(const struct line_tile *lt, const struct steps *s, uint16_t pixel, int contour, int steep)
{
    const struct tile *t = lt->tile;
    const struct sheen_rect rect = t->rect;
    const uint32_t pitch = t->pitch, next = steep ? 1 : pitch;
    const int32_t begin = steep ? rect.x0 : lt->y0, end = steep ? rect.x1 : lt->y1;
    const int32_t lowest = steep ? rect.x0 : rect.y0, highest = (steep ? rect.x1 : rect.y1) - 1;
    int32_t across = s->across, z = s->z;

    SHEEN_TAP(LINE_STEP, s->end - s->first);
    for (int32_t i = s->first; i < s->end; i++, across += s->across_step, z += s->z_step) {
        int32_t pixel_across = asr32(across, 16), edge_z = asr32(z, 8), seen;
        if (pixel_across < begin || pixel_across >= end)
            continue;
        uint32_t at = steep ? tile_offset(t, pixel_across, i) : tile_offset(t, i, pixel_across);
        int32_t own = t->depth[at], low = pixel_across > lowest ? t->depth[at - next] : own;
        int32_t high = pixel_across < highest ? t->depth[at + next] : own;
        if (contour) { /* the pixel beyond: this one where its centre is */
            int centre_high = (across & 0xffff) < 0x8000;
            int32_t beyond = s->low_inside ? (centre_high ? own : high) : (centre_high ? low : own);
            seen = beyond <= edge_z + CLOSE;
        } else {
            seen = line_is_seen(edge_z, own, low, high);
        }
        if (!seen)
            continue;
        if (t->format->grey)
            ((uint8_t *)t->pixels)[at] = (uint8_t)pixel;
        else
            ((uint16_t *)t->pixels)[at] = pixel;
    }
}

void sheen_line_rows(const struct line_tile *t, const struct steps *s, uint16_t pixel, int contour)
{
    if (s->steep)
        line_rows(t, s, pixel, contour, 1);
    else
        line_rows(t, s, pixel, contour, 0);
}
