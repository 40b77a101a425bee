/*
 * edge.c - where an edge crosses pixel rows, exactly.
 *
 * A crossing is a multiple of 1/(64 height) px, at least 2^-22. It is stepped in 2^-32 px from a start that lies
 * below it by more than nothing and by less than that: the column, the first centre at or right of the crossing, is
 * then one more than the whole part, in every row.
 */
#include "triangle.h"

/* 1 where a division is a call: steps of short edges then come from the reciprocal's table. Columns are the same. */
#ifndef SHEEN_NO_DIVIDER
#if defined(__ARM_ARCH_6M__) || (defined(__riscv) && !defined(__riscv_div))
#define SHEEN_NO_DIVIDER 1
#else
#define SHEEN_NO_DIVIDER 0
#endif
#endif

#define SHORT 2048 /* 1/64 px: width and height of what by_reciprocal takes */

/* Along an edge from its upper end, Q31.32 px: from there to its first row, and a row. */
struct course {
    int64_t start, step;
};

/*
 * width / height px a row, and `rest` / 64 of it. Both floors: a start is off by at most 2 * 2^-32 px and a row adds at
 * most 2^-32, 480 rows 2^-23. Range: height < 2^16, so a remainder times 2^16 fits 32 bits.
 */
static inline struct course by_division(int32_t width, int32_t height, int32_t rest)
{
    int32_t whole = width / height, part = width - whole * height;

    if (part < 0) {
        whole--;
        part += height;
    }
    uint32_t size = (uint32_t)height, high = ((uint32_t)part << 16) / size;
    uint32_t low = ((((uint32_t)part << 16) - high * size) << 16) / size;
    struct course c = {0, (int64_t)((uint64_t)(uint32_t)whole << 32 | high << 16 | low)};
    c.start = asr64(rest * c.step, SUBPIXEL_BITS) - 1;
    return c;
}

/*
 * The same for |width|, height < SHORT with the seed of a reciprocal and one residual, in 2^-25 px: 32 rows at most,
 * off by less than 2^-18 px in all. Below 1 px of height there is one row at most and a slope that wraps is not used.
 */
static inline struct course by_reciprocal(int32_t width, int32_t height, int32_t rest)
{
    unsigned up = clz32((uint32_t)height); /* 21..31 */
    int32_t seed = (int32_t)reciprocal_seed((uint32_t)height << up), product = width * seed;
    int32_t slope = up <= 27 ? asr32(product, 27 - up) : (int32_t)((uint32_t)product << (up - 27)); /* Q.20 */
    int32_t left = (int32_t)(((uint32_t)width << 20) - (uint32_t)slope * (uint32_t)height);
    int32_t more = asr32(asr32(left, 2) * (seed >> 1), 39 - up); /* Q.25 */
    int32_t step = (int32_t)((uint32_t)slope * 32u + (uint32_t)more);

    slope += asr32(more, 5);
    int32_t start = rest * asr32(slope, 6) + (rest * (slope & 63) >> 6); /* Q.20, below 32 px */
    struct course c = {(int64_t)(start * 32 - 128) * 128, (int64_t)step * 128};
    return c;
}

/* The edge's next `rows` columns, every second int16_t from *column on; returns where it goes on. */
static inline int64_t columns(int64_t at, int64_t step, int32_t rows, int16_t *column)
{
    for (int16_t *end = column + 2 * rows; column != end; column += 2) {
        *column = (int16_t)asr64(at, 32);
        at += step;
        OPAQUE(column); /* else gcc multiplies for what `at` becomes */
    }
    return at;
}

void sheen_edge_begin(struct edge *e, const int32_t upper[2], const int32_t lower[2], const struct edge_rows *to,
                      int16_t *column)
{
    int32_t width = lower[0] - upper[0], height = lower[1] - upper[1];
    int32_t first = first_centre(upper[1]), end = first_centre(lower[1]), from = max32(first, to->row);
    int32_t rest = first * SUBPIXEL_ONE + SUBPIXEL_HALF - upper[1]; /* 0..63 */

    e->first = (int16_t)first;
    e->end = (int16_t)end;
    if (from >= end)
        return;
    struct course c = SHEEN_NO_DIVIDER && height < SHORT && (uint32_t)(width + SHORT - 1) < 2 * SHORT - 1
                          ? by_reciprocal(width, height, rest)
                          : by_division(width, height, rest);
    c.start += (int64_t)(upper[0] + SUBPIXEL_HALF) * (1 << 26); /* the whole part is the column */
    if (from != first)
        c.start += (from - first) * c.step;
    if (from < to->end)
        c.start = columns(c.start, c.step, min32(end, to->end) - from, column + 2 * (from - to->row));
    if (end > to->end) {
        e->at = c.start;
        e->step = c.step;
    }
}

void sheen_edge_go_on(struct edge *e, const struct edge_rows *to, int16_t *column)
{
    int32_t from = max32(e->first, to->row), rows = min32(e->end, to->end) - from;

    if (rows > 0)
        e->at = columns(e->at, e->step, rows, column + 2 * (from - to->row));
}
