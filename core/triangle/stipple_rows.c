/*
 * stipple_rows.c - opacity without blending: of a draw's pixels some are left out, by an ordered pattern. While its
 * rows are drawn nothing is nearer than what stands at those; then their depth is put back. Any shading's rows do.
 */
#include "stipple.h"

#define NEAREST 65535 /* nothing is nearer */

/* A depth is kept and covered, or put back. */
SPECIALISED void swap_depth(uint16_t *depth, uint16_t *kept, int back)
{
    if (back) {
        *depth = *kept;
    } else {
        *kept = *depth;
        *depth = NEAREST;
    }
}

/* count px, 8 apart. */
SPECIALISED uint16_t *swap_column(uint16_t *depth, uint16_t *kept, int32_t count, int back)
{
    for (; count >= 4; count -= 4, depth += 32, kept += 4) {
        swap_depth(depth, kept, back);
        swap_depth(depth + 8, kept + 1, back);
        swap_depth(depth + 16, kept + 2, back);
        swap_depth(depth + 24, kept + 3, back);
    }
    for (; count > 0; count--, depth += 8, kept++)
        swap_depth(depth, kept, back);
    return kept;
}

/* What a row leaves out of `width` px from `depth` on; left_out: a bit a px of 8, again and again. */
SPECIALISED uint16_t *swap_row(uint16_t *depth, uint16_t *kept, int32_t width, uint32_t left_out, int back)
{
    if (width > 16) {
        left_out &= 0xffu;
        for (int32_t x = 0; left_out != 0; x++, left_out >>= 1)
            if (left_out & 1u)
                kept = swap_column(depth + x, kept, (width + 7 - x) >> 3, back);
        return kept;
    }
    SHEEN_TAP(NARROW, back ? 0 : width);
    for (const uint16_t *end = depth + width; depth != end; depth++, left_out = left_out >> 1 | left_out << 31)
        if (left_out & 1u)
            swap_depth(depth, kept++, back);
    return kept;
}

SPECIALISED void swap_rows(struct stippled_rows *r, const struct tile *t, const struct draw *d, int back)
{
    const struct span *span = r->span;
    uint16_t *kept = r->depth, *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)t->pitch - t->rect.x0;

    for (int32_t y = t->first_row, end = y + (int32_t)t->rows; y < end; y++, span++, line += t->pitch) {
        const uint32_t left_out = 0x01010101u * d->left_out[y & 7], turn = (uint32_t)span->x0 & 7u;
        SHEEN_TAP(STRIP_ROW, !back);
        if (left_out != 0)
            kept = swap_row(line + span->x0, kept, span->x1 - span->x0, left_out >> turn | left_out << (31 - turn) << 1,
                            back);
    }
    SHEEN_TAP(HIDDEN, back ? 0 : kept - r->depth);
}

/* Columns at a time: rows of them have room, and of cells some. */
static int32_t strip_of(const struct setup *s)
{
    const int32_t half = s->draw->stippled == STIPPLED_HALF;

    return s->way == SHEEN_WAY_PHONG_CELLS ? 16 << half : KEPT_DEPTHS << half;
}

/* Depths that a row may leave out, at the most. */
static int32_t kept_of(const struct draw *d, int32_t width, unsigned left_out)
{
    if (left_out == 0)
        return 0;
    return d->stippled == STIPPLED_HALF ? (width + 1) >> 1 : width;
}

/* The next rows of the strip, one below the other, as many as there is room for. */
static unsigned take_rows(struct stippled_rows *r, struct tile *t, const struct setup *s, int32_t strip)
{
    int32_t room = KEPT_DEPTHS;
    unsigned count = 0;

    t->first_row = (int16_t)(r->first_row + (int32_t)r->row);
    for (; r->row < r->rows && count < STIPPLED_ROWS; r->row++) {
        const struct span whole = r->whole[r->row];
        struct span span = {(int16_t)max32(whole.x0, r->x), (int16_t)min32(whole.x1, r->x + strip)};
        const unsigned left_out = s->draw->left_out[(t->first_row + (int32_t)count) & 7];
        if (left_out == 0xffu || span.x0 >= span.x1)
            span.x1 = span.x0;
        room -= kept_of(s->draw, span.x1 - span.x0, left_out);
        if (room < 0)
            break;
        r->span[count++] = span;
    }
    return count;
}

static void take_triangle(struct stippled_rows *r, const struct tile *t)
{
    const struct span *span = t->spans, *end = span + t->rows;

    r->whole = span;
    r->first_row = t->first_row;
    r->rows = t->rows;
    r->row = 0;
    r->x = INT16_MAX;
    r->end = INT16_MIN;
    for (; span != end; span++)
        if (span->x0 < span->x1) {
            r->x = min32(r->x, span->x0);
            r->end = max32(r->end, span->x1);
        }
}

static int stipple_hide(struct stippled_rows *r, struct tile *t, const struct setup *s)
{
    const int32_t strip = strip_of(s);

    if (t->spans != r->span) {
        take_triangle(r, t);
        r->x &= -strip;
        t->spans = r->span;
        t->thresholds = sheen_reversed_thresholds;
    } else {
        swap_rows(r, t, s->draw, 1);
    }
    if (r->row == r->rows) {
        r->x += strip;
        r->row = 0;
    }
    if (r->x >= r->end) {
        t->spans = r->whole;
        t->thresholds = sheen_thresholds;
        return 0;
    }
    t->rows = (uint16_t)take_rows(r, t, s, strip);
    SHEEN_TAP(STRIP, 1);
    swap_rows(r, t, s->draw, 0);
    return 1;
}

/* Columns, a bit each, that a row leaves out. */
static int stipple_begin(struct draw *d, const struct sheen_object *o)
{
    if (o->transparency > 64 || o->phase > 7)
        return SHEEN_ERR_ARGUMENT;
    for (unsigned y = 0; y < 8; y++) {
        unsigned columns = 0;
        for (unsigned x = 0; x < 8; x++)
            columns |= (unsigned)(sheen_thresholds[y][(x + o->phase) & 7u] > 2u * (64u - o->transparency)) << x;
        d->left_out[y] = (uint8_t)columns;
    }
    d->stippled = o->transparency > 32 ? STIPPLED_MORE : STIPPLED_HALF;
    if (d->dither)
        take_general_loops(d);
    return SHEEN_OK;
}

const struct sheen_stipple sheen_stipple = {stipple_begin, stipple_hide};
