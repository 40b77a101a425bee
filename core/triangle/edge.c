/*
 * edge.c - where edges cross pixel rows, exactly: the spans of a triangle.
 *
 * A crossing is a multiple of 1/(64 height) px, and that is at least 2^-22. Edges are stepped in units of 2^-32 px from
 * a start that lies below the exact crossing by more than 0 and less than 1/(64 height) px. So in every row the integer
 * part, after 1/2 px is added, is the column: the first one whose centre is at or right of the crossing.
 */
#include "triangle.h"

/* 1 if division is a library call: courses of short edges then use the reciprocal table. The columns are the same. */
#ifndef SHEEN_NO_DIVIDER
#if defined(__ARM_ARCH_6M__) || (defined(__riscv) && !defined(__riscv_div))
#define SHEEN_NO_DIVIDER 1
#else
#define SHEEN_NO_DIVIDER 0
#endif
#endif

#define SHORT 2048 /* 1/64 px: a short edge has a height below SHORT and a width from -SHORT to below SHORT */

/* An edge's x where it crosses its first row, and the step per row; Q31.32 px. */
struct course {
    int64_t start, step;
};

/* x * 2^n, 1 <= n <= 31, as two shifts; for the plain expression gcc emits more. */
static inline int64_t shifted64(int32_t x, unsigned n)
{
    return (int64_t)((uint64_t)(uint32_t)asr32(x, 32 - n) << 32 | (uint32_t)x << n);
}

/*
 * The course of an edge that begins at x, 1/64 px: width / height px per row, and `rest` / 64 of that down to the
 * first row's centre. Both are rounded down: a start is off by at most 2 * 2^-32 px and each row adds at most 2^-32,
 * 480 rows 2^-23. Range: height < 2^16, so a remainder times 2^16 fits 32 bits.
 */
static inline struct course by_division(int32_t x, int32_t width, int32_t height, int32_t rest)
{
    const uint32_t size = (uint32_t)height, wide = magnitude32(width);
    int32_t whole = width >= 0 ? (int32_t)QUOTIENT(wide, size) : -(int32_t)QUOTIENT(wide + size - 1, size),
            part = width - whole * height;
    uint32_t high = QUOTIENT((uint32_t)part << 16, size);
    uint32_t low = QUOTIENT((((uint32_t)part << 16) - high * size) << 16, size);
    uint32_t part_of_px = high << 16 | low;
    int64_t start = (int64_t)(((uint64_t)(uint32_t)(rest * whole) << 32) + (uint64_t)part_of_px * (uint32_t)rest);
    struct course c = {shifted64(x + SUBPIXEL_HALF, 26) + asr64(start, SUBPIXEL_BITS) - 1,
                       (int64_t)((uint64_t)(uint32_t)whole << 32 | part_of_px)};
    return c;
}

/*
 * The same for a short edge, which has at most 32 rows: off by less than 2^-18 px in all. slope: nearly width / height,
 * Q.20; more: what it lacks, Q.25. Range: rest < height, or else the slope is below 2^25, so their product fits; |x| <
 * 2^17 - 2^12, so a start in Q.20 fits.
 */
static inline struct course course_of(int32_t x, int32_t slope, int32_t more, int32_t rest)
{
    const int32_t step = (int32_t)((uint32_t)slope * 32u + (uint32_t)more);
    const int32_t start = (x + SUBPIXEL_HALF) * (1 << 14) + asr32(rest * (slope + asr32(more, 5)), SUBPIXEL_BITS) - 4;
    const struct course c = {shifted64(start, 12), shifted64(step, 7)};

    return c;
}

#if SHEEN_NO_DIVIDER
/*
 * By a reciprocal's seed of 16 bits and one residual. An edge less than 1 px high has at most one row, so its step,
 * which may wrap, is not used.
 */
static inline struct course short_course(int32_t x, int32_t width, int32_t height, int32_t rest)
{
    unsigned down = 10; /* 10..0 */
    uint32_t normal = (uint32_t)height << (31 - down);

    for (; (normal & 0x80000000u) == 0; normal <<= 1) /* shorter than calling clz32, which is no instruction here */
        down--;
    int32_t seed = (int32_t)reciprocal_seed(normal), slope = asr32(width * seed * 16, down);
    int32_t left = (int32_t)(((uint32_t)width << 20) - (uint32_t)slope * (uint32_t)height);

    return course_of(x, slope, asr32(asr32(left, 2) * (seed >> 1), down + 8), rest);
}
#else
static inline struct course short_course(int32_t x, int32_t width, int32_t height, int32_t rest)
{
    int32_t slope = width * (1 << 20) / height, left = width * (1 << 20) - slope * height;

    return course_of(x, slope, left * 32 / height, rest);
}
#endif

/*
 * Writes the edge's next `rows` columns, at least one, to every second int16_t from *column on, which is one side of
 * the spans. Returns the edge's x in the row after them.
 */
static inline int64_t columns(int64_t at, int64_t step, int32_t rows, int16_t *column)
{
    const int16_t *end = column + 2 * rows;

    do {
        *column = (int16_t)asr64(at, 32);
        column += 2;
        at += step;
        OPAQUE(column); /* else gcc computes the final `at` by a multiplication */
    } while (column != end);
    return at;
}

/* On M0+ an edge is a function of its own, so that it has all the registers that it needs. */
#if defined(__ARM_ARCH_6M__)
#define EDGE HOT static APART
#else
#define EDGE static inline
#endif

/*
 * Sets up the edge from `upper` down to `lower`: writes its columns in the rows of `to`, and to *e what later rows
 * need. to->whole: `to` has all rows of the triangle, so *e is not used.
 */
EDGE void edge_begin(struct edge *e, const struct screen_corner *upper, const struct screen_corner *lower,
                     const struct edge_rows *to, int16_t *column)
{
    const int32_t first = upper->row, end = lower->row, width = lower->x - upper->x, height = lower->y - upper->y;
    int32_t row = first, rows = end - first;

    if (!to->whole) {
        e->first = (int16_t)first;
        e->end = (int16_t)end;
        row = max32(first, to->row);
        rows = min32(end, to->end) - row;
    }
    if (end <= row)
        return;
    const int32_t rest = first * SUBPIXEL_ONE + SUBPIXEL_HALF - upper->y; /* 0..63: to the first row\'s centre */
    const int32_t x = upper->x;
    struct course c;
    if ((uint32_t)((width + SHORT) | height * 2) < 2 * SHORT)
        c = short_course(x, width, height, rest);
    else
        c = by_division(x, width, height, rest);
    if (row != first)
        c.start += (row - first) * c.step;
    if (rows > 0)
        c.start = columns(c.start, c.step, rows, column + 2 * (row - to->row));
    if (!to->whole) {
        e->at = halves_of(c.start);
        e->step = halves_of(c.step);
    }
}

/* Corners run clockwise, so an edge that goes down bounds the right and one that goes up the left. */
HOT unsigned sheen_edges_begin(struct edge *edge, const struct screen_corner *at, const struct edge_rows *to,
                               struct span *spans)
{
    const struct screen_corner *from = &at[2], *const last = from;
    unsigned right = 0;

    for (const struct screen_corner *end = at - to->quad;; from = end++, edge++) {
        const struct screen_corner *upper = end, *lower = from;
        int16_t *column = &spans->x0;
        right >>= 1;
        if (end->y > from->y) {
            upper = from;
            lower = end;
            column = &spans->x1;
            right |= 8u;
        }
#if !defined(__ARM_ARCH_6M__)
        OPAQUE_BOTH(upper, lower);
#endif
        edge_begin(edge, upper, lower, to, column);
        if (end == last)
            return right;
    }
}

/* ---- later rows ---- */

HOT void sheen_clip_spans(struct span *spans, unsigned rows, struct sheen_rect rect)
{
    for (unsigned row = 0; row < rows; row++) {
        spans[row].x0 = (int16_t)max32(spans[row].x0, rect.x0);
        spans[row].x1 = (int16_t)min32(spans[row].x1, rect.x1);
    }
}

void sheen_spans_back(struct setup *s, int32_t row)
{
    const int32_t end = s->row;
    int32_t top = end;

    struct edge *e = s->edge;

    for (unsigned right = s->right; right != 1; right >>= 1, e++) {
        int64_t at = whole_of(e->at);
        for (int32_t rows = min32(e->end, end) - max32(e->first, row); rows > 0; rows--) {
            at -= whole_of(e->step);
            OPAQUE(rows); /* else gcc multiplies */
        }
        e->at = halves_of(at);
        top = min32(top, e->first);
    }
    s->row = (int16_t)max32(row, top);
}

HOT unsigned sheen_spans(struct setup *s, struct sheen_rect rect, struct span *spans)
{
    const int32_t row = s->row, end = min32(s->end_row, rect.y1);
    struct edge *e = s->edge;

    if (row >= end)
        return 0;
    for (unsigned right = s->right; right != 1; right >>= 1, e++) {
        const int32_t first = max32(e->first, row), rows = min32(e->end, end) - first;
        struct span *span = spans + (first - row);
        if (rows > 0)
            e->at = halves_of(columns(whole_of(e->at), whole_of(e->step), rows, right & 1 ? &span->x1 : &span->x0));
    }
    s->row = (int16_t)end;
    if (s->needs_clipping)
        sheen_clip_spans(spans, (unsigned)(end - row), rect);
    return (unsigned)(end - row);
}
