/*
 * phong_cell_rows.c - pixels of cells in squares of 4 px whose channels are exact at the corners and linear between.
 */
#include "../triangle/packed_rows.h"
#include "phong.h"

/* Channels where row y crosses the square's side above a lower corner. */
SPECIALISED struct packed side_at(const struct square_corner *corner, int32_t y)
{
    const uint32_t below = 4u - ((uint32_t)y & 3u);
    struct packed side = {corner->at.red_blue - below * corner->down.red_blue,
                          corner->at.green - below * corner->down.green};

    return side;
}

HOT void sheen_part_of_square(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y)
{
    const struct square_corner *corner = l->corner + ((x - l->x) >> 2);
    const struct packed left = side_at(corner, y);
    const struct packed_at step = {l->depth->dx, packed_quarter(left, side_at(corner + 1, y))};
    const uint32_t n = (uint32_t)x & 3u;
    const struct packed_at at = {plane_at(l->depth, x, y),
                                 {left.red_blue + n * step.colour.red_blue, left.green + n * step.colour.green}};
    const struct packed_way way = {.to_pixel = t->to_pixel, .dither = t->dither, .swap = t->format->swap};
    uint16_t *const depth = t->depth + tile_offset(t, x, y);

    packed_run(t, depth, x1 - x, at, step, way, DITHER_ROW(t, depth - x, y));
}

#if FAST_LOOPS
/* Steps once per pixel, because there are no registers for sums made in advance. */
SPECIALISED void square_pixel(const struct tile *t, uint16_t *depth, struct packed_at *at, const struct packed_at *step,
                              const struct packed_way *way, const threshold_t *thresholds)
{
    packed_pixel(t, depth, at, step, way, thresholds, !way->dither);
    OPAQUE(at->z);
    OPAQUE(at->colour.red_blue);
    OPAQUE(at->colour.green);
}

/* One row of whole squares, `count` px from column x on, in a panel's byte order. */
SPECIALISED void squares_run(const struct tile *t, const struct square_line *l, int32_t x, int32_t count, int32_t y,
                             unsigned dither)
{
    const struct packed_way way = {.to_pixel = t->to_pixel, .dither = dither, .swap = 1};
    const threshold_t *thresholds = t->dither_rows[y & 7];
    const struct square_corner *corner = l->corner + ((x - l->x) >> 2);
    struct packed_at at = {plane_at(l->depth, x, y), side_at(corner, y)}, step = {l->depth->dx, {0, 0}};
    uint16_t *depth = t->depth + tile_offset(t, x, y);
    const uint16_t *end = depth + count;

    do {
        const struct packed next = side_at(++corner, y);
        step.colour = packed_quarter(at.colour, next);
        square_pixel(t, depth, &at, &step, &way, thresholds);
        square_pixel(t, depth + 1, &at, &step, &way, thresholds);
        square_pixel(t, depth + 2, &at, &step, &way, thresholds);
        square_pixel(t, depth + 3, &at, &step, &way, thresholds);
        depth += 4;
        at.colour = next;
    } while (depth != end);
}

SPECIALISED int whole_squares(const struct tile *t, const struct square_line *l, unsigned dither)
{
    const struct span *span = l->span;
    int32_t ends = 0;

    for (int32_t y = l->y; y < l->end; y++, span++) {
        const int32_t x = max32(span->x0, l->x), x1 = min32(span->x1, l->x1);
        const int32_t first = (x + 3) & ~3, count = (x1 & ~3) - first;
        SHEEN_TAP(SQUARE_ROW, x < x1);
        ends |= x | x1;
        if (count > 0)
            squares_run(t, l, first, count, y, dither);
    }
    return (ends & 3) == 0;
}

HOT int sheen_whole_squares(const struct tile *t, const struct square_line *l)
{
    return t->dither ? whole_squares(t, l, 1) : whole_squares(t, l, 0);
}
#endif
