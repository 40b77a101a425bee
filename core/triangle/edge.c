/*
 * edge.c - where an edge crosses pixel rows, exactly.
 *
 * A crossing is a multiple of 1/(64 height) px, at least 2^-22. It is stepped in 2^-32 px from a start that lies
 * below it by more than nothing and by less than that: the column, the first centre at or right of the crossing, is
 * then one more than the whole part, in every row.
 */
#include "triangle.h"

/* 1 where a division is a call: courses of short edges then come from the reciprocal's table. Columns are the same. */
#ifndef SHEEN_NO_DIVIDER
#if defined(__ARM_ARCH_6M__) || (defined(__riscv) && !defined(__riscv_div))
#define SHEEN_NO_DIVIDER 1
#else
#define SHEEN_NO_DIVIDER 0
#endif
#endif

#define SHORT 2048 /* 1/64 px: width and height of a short edge */

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
    const uint32_t size = (uint32_t)height, wide = magnitude32(width);
    int32_t whole = width >= 0 ? (int32_t)(wide / size) : -(int32_t)((wide + size - 1) / size),
            part = width - whole * height;
    uint32_t high = ((uint32_t)part << 16) / size;
    uint32_t low = ((((uint32_t)part << 16) - high * size) << 16) / size;
    uint32_t part_of_px = high << 16 | low;
    int64_t start = (int64_t)(((uint64_t)(uint32_t)(rest * whole) << 32) + (uint64_t)part_of_px * (uint32_t)rest);
    struct course c = {asr64(start, SUBPIXEL_BITS) - 1, (int64_t)((uint64_t)(uint32_t)whole << 32 | part_of_px)};
    return c;
}

/* The same of a short edge, Q6.25 px. */
struct short_course {
    int32_t start, step;
};

/*
 * |width|, height < SHORT: 32 rows at most, off by less than 2^-18 px in all. `slope` comes near width / height in
 * Q.20, `more` is what it lacks, Q.25. Range: rest < height, or else the slope is below 2^25, so their product fits.
 */
static inline struct short_course course_of(int32_t slope, int32_t more, int32_t rest)
{
    struct short_course c;

    c.step = (int32_t)((uint32_t)slope * 32u + (uint32_t)more);
    slope += asr32(more, 5);
    c.start = asr32(rest * slope, SUBPIXEL_BITS) * 32 - 128;
    return c;
}

#if SHEEN_NO_DIVIDER
/*
 * With the seed of a reciprocal and one residual. Below 1 px of height there is one row at most and a slope that wraps
 * is not used.
 */
static inline struct short_course short_course(int32_t width, int32_t height, int32_t rest)
{
    unsigned up = 21; /* to 31 */
    uint32_t normal = (uint32_t)height << up;

    for (; (normal & 0x80000000u) == 0; normal <<= 1) /* shorter than the call that clz32 is here */
        up++;
    int32_t seed = (int32_t)reciprocal_seed(normal), product = width * seed;
    int32_t slope = up <= 27 ? asr32(product, 27 - up) : (int32_t)((uint32_t)product << (up - 27));
    int32_t left = (int32_t)(((uint32_t)width << 20) - (uint32_t)slope * (uint32_t)height);

    return course_of(slope, asr32(asr32(left, 2) * (seed >> 1), 39 - up), rest);
}
#else
static inline struct short_course short_course(int32_t width, int32_t height, int32_t rest)
{
    int32_t slope = width * (1 << 20) / height, left = width * (1 << 20) - slope * height;

    return course_of(slope, left * 32 / height, rest);
}
#endif

/* The edge's next `rows` columns, one at least, every second int16_t from *column on; returns where it goes on. */
static inline int64_t columns(int64_t at, int64_t step, int32_t rows, int16_t *column)
{
    do {
        *column = (int16_t)asr64(at, 32);
        column += 2;
        at += step;
        OPAQUE(rows); /* else gcc multiplies for what `at` becomes */
    } while (--rows != 0);
    return at;
}

/* The same along a short edge, from column `whole` on. */
static inline int32_t short_columns(int32_t at, int32_t step, int32_t whole, int32_t rows, int16_t *column)
{
    const int16_t *end = column + 2 * rows;

    do {
        *column = (int16_t)(whole + asr32(at, 25));
        column += 2;
        at = (int32_t)((uint32_t)at + (uint32_t)step);
        OPAQUE(column);
    } while (column != end);
    return at;
}

/* An edge on its way. */
struct edge_job {
    int32_t x, width, height, rest; /* from the upper end, 1/64 px; rest: down to its first row, 0..63 */
    int32_t skipped, rows;          /* rows before `to`, and in it */
    int16_t *column;
};

/* Its columns; what is left goes to *e, NULL: nothing is. */
static inline void long_edge(const struct edge_job *j, struct edge *e)
{
    struct course c = by_division(j->width, j->height, j->rest);

    c.start += (int64_t)(j->x + SUBPIXEL_HALF) * (1 << 26); /* the whole part is the column */
    if (j->skipped != 0)
        c.start += j->skipped * c.step;
    if (j->rows > 0)
        c.start = columns(c.start, c.step, j->rows, j->column);
    if (e != NULL) {
        e->at = c.start;
        e->step = c.step;
    }
}

static inline void short_edge(const struct edge_job *j, struct edge *e)
{
    struct short_course c = short_course(j->width, j->height, j->rest);
    int32_t x = j->x + SUBPIXEL_HALF, whole = asr32(x, SUBPIXEL_BITS);

    c.start += (x & (SUBPIXEL_ONE - 1)) << 19;
    c.start += j->skipped * c.step;
    if (j->rows > 0)
        c.start = short_columns(c.start, c.step, whole, j->rows, j->column);
    if (e != NULL) {
        e->at = (int64_t)whole * ((int64_t)1 << 32);
        e->step = (int64_t)c.step * 128;
        if (j->rows > 0) { /* from its last row: below that 32 bits may be too few */
            e->at += e->step;
            c.start = (int32_t)((uint32_t)c.start - (uint32_t)c.step);
        }
        e->at += (int64_t)c.start * 128;
    }
}

/*
 * The edge from `upper` down to `lower`: its columns in `to`, and *e for what is left of them. whole: `to` has all rows
 * of the triangle; *e then is not used.
 */
static inline void edge_begin(struct edge *e, const struct screen_corner *upper, const struct screen_corner *lower,
                              const struct edge_rows *to, int16_t *column)
{
    int32_t first = upper->row, end = lower->row, row = to->row;
    struct edge_job j = {upper->x, lower->x - upper->x, lower->y - upper->y, 0, 0, end - first, NULL};

    if (to->whole) {
        e = NULL;
    } else {
        e->first = (int16_t)first;
        e->end = (int16_t)end;
        j.skipped = max32(row - first, 0);
        j.rows = min32(end, to->end) - first - j.skipped;
    }
    if (end <= first + j.skipped)
        return;
    j.rest = first * SUBPIXEL_ONE + SUBPIXEL_HALF - upper->y;
    j.column = column + 2 * (first + j.skipped - row);
    if (j.height < SHORT && (uint32_t)(j.width + SHORT - 1) < 2 * SHORT - 1)
        short_edge(&j, e);
    else
        long_edge(&j, e);
}

/* Clockwise corners: an edge that goes down bounds the right, one that goes up the left. */
unsigned sheen_edges_begin(struct edge edge[3], const struct screen_corner at[3], const struct edge_rows *to,
                           struct span *spans)
{
    const struct screen_corner *from = &at[2];
    unsigned right = 0;

    for (unsigned k = 0; k < 3; k++) { /* edges 20, 01, 12 */
        const struct screen_corner *end = &at[k];
        unsigned down = end->y > from->y;
        right |= down << k;
        edge_begin(&edge[k], down ? from : end, down ? end : from, to, down ? &spans->x1 : &spans->x0);
        from = end;
    }
    return right;
}

void sheen_edge_go_on(struct edge *e, const struct edge_rows *to, int16_t *column)
{
    int32_t from = max32(e->first, to->row), rows = min32(e->end, to->end) - from;

    if (rows > 0)
        e->at = columns(e->at, e->step, rows, column + 2 * (from - to->row));
}
