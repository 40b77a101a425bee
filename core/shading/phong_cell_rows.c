/*
 * phong_cell_rows.c - pixels of cells by squares of 4 px whose channels are exact at their corners and linear between.
 */
#include "phong.h"

/* A quarter of what `to` has more. */
SPECIALISED uint32_t quarter(uint32_t from, uint32_t to)
{
    return (uint32_t)asr32((int32_t)((to >> 1) - (from >> 1)), 1);
}

/* On the line between two corners, in row `i` of the 4. */
SPECIALISED struct corner side_of_square(const struct corner *top, const struct corner *bottom, uint32_t i)
{
    struct corner at = {top->red_blue + i * quarter(top->red_blue, bottom->red_blue),
                        top->green + i * quarter(top->green, bottom->green)};

    return at;
}

/* What changes along a row of a square, and its steps. */
struct square_at {
    uint32_t z;
    struct corner colour;
};

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

/* Where a row is: corners above and below the square's left end, and what stands in its next pixel. */
struct square_row {
    const struct corner *top, *bottom;
    uint32_t i; /* of the 4 rows */
    struct square_at at;
    uint16_t *depth, *pixel;
    const uint8_t *thresholds; /* of the row, NULL: no dither */
};

/* To the next square; returns the corner at its left, on the line between top and bottom. */
SPECIALISED struct corner square_begin(struct square_row *r, struct square_at *step)
{
    const struct corner at = r->at.colour, next = side_of_square(++r->top, ++r->bottom, r->i);

    step->colour.red_blue = quarter(at.red_blue, next.red_blue);
    step->colour.green = quarter(at.green, next.green);
    return next;
}

/* Pixels x to before x1, within a square, in any byte order. */
static APART void part_of_square(const struct tile *t, struct square_row *r, struct square_at step, int32_t x,
                                 int32_t x1)
{
    const unsigned swap = t->format->swap;
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

/* From a column that begins a square on, those before x1 - 3; returns the next column. */
SPECIALISED int32_t whole_squares(const struct tile *t, struct square_row *row, struct square_at step, int32_t x,
                                  int32_t x1, unsigned dither)
{
    struct square_row r = *row;

    r.thresholds = dither ? r.thresholds : NULL;
    for (; x + 4 <= x1; x += 4)
        whole_square(t, &r, step, x);
    *row = r;
    return x;
}

static APART int32_t plain_squares(const struct tile *t, struct square_row *r, struct square_at step, int32_t x,
                                   int32_t x1)
{
    return whole_squares(t, r, step, x, x1, 0);
}

static APART int32_t dithered_squares(const struct tile *t, struct square_row *r, struct square_at step, int32_t x,
                                      int32_t x1)
{
    return whole_squares(t, r, step, x, x1, 1);
}

/* Columns x to before x1 of row y, which the squares have. */
static void squares_row(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y)
{
    const int32_t first = (x - l->x) >> 2;
    const struct square_at step = {.z = l->depth->dx};
    uint16_t *depth = t->depth + tile_offset(t, x, y);
    struct square_row r = {.top = l->top + first,
                           .bottom = l->bottom + first,
                           .i = (uint32_t)y & 3u,
                           .depth = depth,
                           .pixel = pixel_at(depth, t->to_pixel),
                           .thresholds = t->dither ? sheen_thresholds[y & 7] : NULL};

    r.at = (struct square_at){plane_at(l->depth, x, y), side_of_square(r.top, r.bottom, r.i)};
    while (x < x1) {
        if (FAST_LOOPS && (x & 3) == 0 && x + 4 <= x1 && t->format->swap) {
            x = t->dither ? dithered_squares(t, &r, step, x, x1) : plain_squares(t, &r, step, x, x1);
        } else {
            const int32_t end = min32((x | 3) + 1, x1);
            part_of_square(t, &r, step, x, end);
            x = end;
        }
    }
}

void sheen_phong_squares(const struct tile *t, const struct square_line *l)
{
    const struct span *span = l->span;

    for (int32_t y = l->y; y < l->end; y++, span++) {
        const int32_t x = max32(span->x0, l->x), x1 = min32(span->x1, l->x + 4 * l->count);
        if (x < x1)
            squares_row(t, l, x, x1, y);
    }
}
