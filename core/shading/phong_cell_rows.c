/*
 * phong_cell_rows.c - pixels of cells by squares of 4 px whose channels are exact at their corners and linear between.
 */
#include "phong.h"

/* A quarter of what `to` has more. */
SPECIALISED uint32_t quarter(uint32_t from, uint32_t to)
{
    return (uint32_t)asr32((int32_t)((to >> 1) - (from >> 1)), 1);
}

/* A square's next row: values at its left end, what the next pixel has more, and what the next row. */
struct square {
    uint32_t z, red_blue, green, step_red_blue, step_green;
    uint32_t down_z, down_red_blue, down_green, more_red_blue, more_green;
};

/* threshold: 1/128 level, or 0 where rounding is in the words. */
SPECIALISED void square_pixel(const struct tile *t, uint16_t *depth, intptr_t to_pixel, uint32_t z, struct corner at,
                              uint32_t threshold, unsigned swap)
{
    if (nearer(t, depth, z)) {
        if (threshold != 0) {
            SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), at.red_blue >> 16, at.green >> 15, at.red_blue & 0xffffu,
                           11);
            at.red_blue += (threshold << 20) + (threshold << 4);
            at.green += threshold << 19;
        }
        uint32_t value = ((at.red_blue >> 27) << 6 | at.green >> 26) << 5 | (at.red_blue << 16) >> 27;
        *(uint16_t *)(void *)((char *)depth + to_pixel) = pixel_order(value, swap);
    }
}

/* Pixels n..end of the row of 4; all of it: 0, 4. depth, thresholds: of the first of the 4; NULL: no dither. */
SPECIALISED void square_row(const struct tile *t, uint16_t *depth, int32_t n, int32_t end, uint32_t dz,
                            struct square *s, const uint8_t *thresholds, unsigned swap)
{
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t da = s->step_red_blue, db = s->step_green;
    struct corner at = {s->red_blue, s->green};
    uint32_t z = s->z;

    s->z = z + s->down_z;
    s->red_blue = at.red_blue + s->down_red_blue;
    s->green = at.green + s->down_green;
    s->step_red_blue = da + s->more_red_blue;
    s->step_green = db + s->more_green;
    if (n <= 0 && end >= 4) {
        for (int i = 0; i < 4; i++) {
            square_pixel(t, depth + i, to_pixel, z, at, thresholds != NULL ? thresholds[i] : 0, swap);
            z += dz;
            at.red_blue += da;
            at.green += db;
        }
        return;
    }
    n = max32(n, 0);
    z += (uint32_t)n * dz;
    at.red_blue += (uint32_t)n * da;
    at.green += (uint32_t)n * db;
    for (end = min32(end, 4); n < end; n++) {
        square_pixel(t, depth + n, to_pixel, z, at, thresholds != NULL ? thresholds[n] : 0, swap);
        z += dz;
        at.red_blue += da;
        at.green += db;
    }
}

SPECIALISED void square_rows(const struct tile *t, const struct square_line *l, int32_t x, const struct corner top[2],
                             const struct corner bottom[2], unsigned dither, unsigned swap)
{
    const struct plane *depth = l->depth;
    uint32_t y = (uint32_t)l->y;
    const uint32_t i = y & 3u;
    struct square square = {plane_at(depth, x, l->y),
                            top[0].red_blue,
                            top[0].green,
                            quarter(top[0].red_blue, top[1].red_blue),
                            quarter(top[0].green, top[1].green),
                            depth->dy,
                            quarter(top[0].red_blue, bottom[0].red_blue),
                            quarter(top[0].green, bottom[0].green),
                            quarter(bottom[0].red_blue, bottom[1].red_blue),
                            quarter(bottom[0].green, bottom[1].green)};
    struct square *s = &square;
    uint16_t *line = t->depth + (int32_t)tile_offset(t, x, l->y);
    const struct span *span = l->span, *last = span + (l->end - l->y);

    s->more_red_blue = (uint32_t)asr32((int32_t)(s->more_red_blue - s->step_red_blue), 2);
    s->more_green = (uint32_t)asr32((int32_t)(s->more_green - s->step_green), 2);
    s->red_blue += i * s->down_red_blue;
    s->green += i * s->down_green;
    s->step_red_blue += i * s->more_red_blue;
    s->step_green += i * s->more_green;
    for (; span != last; span++, line += t->pitch) {
        const uint8_t *thresholds = dither ? &sheen_thresholds[y & 7u][x & 4] : NULL;
        OPAQUE(s); /* stays in memory: the pixels take all registers */
        square_row(t, line, span->x0 - x, span->x1 - x, depth->dx, s, thresholds, swap);
        y++;
    }
}

SPECIALISED void squares(const struct tile *t, const struct square_line *l, unsigned dither, unsigned swap)
{
    for (int32_t i = 0; i < l->count; i++)
        square_rows(t, l, l->x + 4 * i, l->top + i, l->bottom + i, dither, swap);
}

void sheen_phong_squares(const struct tile *t, const struct square_line *l)
{
    if (FAST_LOOPS && !t->dither)
        t->format->swap ? squares(t, l, 0, 1) : squares(t, l, 0, t->format->swap);
    else
        squares(t, l, t->dither, t->format->swap);
}
