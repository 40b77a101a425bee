/*
 * phong_cell_rows.c - pixels of cells by squares of 4 px whose channels are exact at their corners and linear between.
 */
#include "phong.h"

/* threshold: 1/128 level, or 0 where rounding is in the words. */
SPECIALISED void square_pixel(const struct tile *t, uint16_t *depth, uint16_t *pixel, struct square_at *at,
                              const struct square_at *step, uint32_t threshold, unsigned swap)
{
    if (nearer(t, depth, at->z)) {
        struct corner c = at->colour;
        if (threshold != 0) {
            SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), c.red_blue >> 16, c.green >> 15, c.red_blue & 0xffffu, 11);
            c.red_blue += (threshold << 20) + (threshold << 4);
            c.green += threshold << 19;
        }
        *pixel = pixel_order(((c.red_blue >> 27) << 6 | c.green >> 26) << 5 | (c.red_blue << 16) >> 27, swap);
    }
    at->z += step->z;
    at->colour.red_blue += step->colour.red_blue;
    at->colour.green += step->colour.green;
}

/* To the next square; returns the corner at its left, on the line between top and bottom. */
SPECIALISED struct corner square_begin(struct square_row *r, struct square_at *step)
{
    const struct corner at = r->at.colour, next = side_of_square(++r->top, ++r->bottom, r->i);

    step->colour.red_blue = quarter(at.red_blue, next.red_blue);
    step->colour.green = quarter(at.green, next.green);
    return next;
}

void sheen_part_of_square(const struct tile *t, struct square_row *r, int32_t x, int32_t x1)
{
    const unsigned swap = t->format->swap;
    struct square_at step = {.z = r->dz};
    const struct corner next = square_begin(r, &step);
    const uint32_t n = (uint32_t)x & 3u;

    r->at.colour.red_blue += n * step.colour.red_blue;
    r->at.colour.green += n * step.colour.green;
    for (; x < x1; x++)
        square_pixel(t, r->depth++, r->pixel++, &r->at, &step, r->thresholds != NULL ? r->thresholds[x & 7] : 0, swap);
    r->at.colour = next;
}

/* In the order of a panel's bus. */
SPECIALISED void whole_square(const struct tile *t, struct square_row *r, struct square_at step, int32_t x)
{
    const struct corner next = square_begin(r, &step);
    const uint8_t *threshold = r->thresholds != NULL ? r->thresholds + (x & 4) : NULL;

    square_pixel(t, r->depth, r->pixel, &r->at, &step, threshold != NULL ? threshold[0] : 0, 1);
    square_pixel(t, r->depth + 1, r->pixel + 1, &r->at, &step, threshold != NULL ? threshold[1] : 0, 1);
    square_pixel(t, r->depth + 2, r->pixel + 2, &r->at, &step, threshold != NULL ? threshold[2] : 0, 1);
    square_pixel(t, r->depth + 3, r->pixel + 3, &r->at, &step, threshold != NULL ? threshold[3] : 0, 1);
    r->depth += 4;
    r->pixel += 4;
    r->at.colour = next;
}

SPECIALISED int32_t whole_squares(const struct tile *t, struct square_row *row, int32_t x, int32_t x1, unsigned dither)
{
    const struct square_at step = {.z = row->dz};
    struct square_row r = *row;

    r.thresholds = dither ? r.thresholds : NULL;
    for (; x + 4 <= x1; x += 4)
        whole_square(t, &r, step, x);
    *row = r;
    return x;
}

int32_t sheen_whole_squares(const struct tile *t, struct square_row *r, int32_t x, int32_t x1)
{
    return t->dither ? whole_squares(t, r, x, x1, 1) : whole_squares(t, r, x, x1, 0);
}
