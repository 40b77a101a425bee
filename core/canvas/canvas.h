/*
 * canvas.h - private to core/canvas: filling a rectangle, clipping, and the size of an entry.
 */
#ifndef CANVAS_H
#define CANVAS_H

#include "../sheen_canvas.h"

/* Set the part of `rect` that is inside the canvas to the entry; wide: entries are uint16_t, else bytes. */
void sheen_canvas_entries(const struct sheen_canvas *canvas, int wide, struct sheen_rect rect, uint16_t entry);

static inline int canvas_is_wide(enum sheen_pixel pixel)
{
    return pixel <= SHEEN_RGB565_LE;
}

/* The intersection of two rectangles; empty if x0 >= x1 or y0 >= y1. */
static inline struct sheen_rect canvas_clip(struct sheen_rect a, struct sheen_rect b)
{
    return (struct sheen_rect){a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0, a.x1 < b.x1 ? a.x1 : b.x1,
                               a.y1 < b.y1 ? a.y1 : b.y1};
}

static inline int16_t canvas_edge(int32_t value)
{
    return (int16_t)(value < -32767 ? -32767 : value > 32767 ? 32767 : value);
}

#endif
