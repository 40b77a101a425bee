/*
 * stipple_rows.c - opacity without blending: some of a draw's pixels are left out, in an ordered pattern. While its
 * rows are drawn, the depths of the pixels left out are saved and set to NEAREST, so that they fail the depth test;
 * then they are restored. This works with the rows of any shading.
 */
#include "stipple.h"

#define NEAREST 65535 /* nothing is nearer */

/* Saves a depth in *kept and sets it to NEAREST, or restores it. */
SPECIALISED void swap_depth(uint16_t *depth, uint16_t *kept, int back)
{
    if (back) {
        *depth = *kept;
    } else {
        *kept = *depth;
        *depth = NEAREST;
    }
}

SPECIALISED void swap_four(uint16_t *depth, uint16_t *kept, int32_t apart, int back)
{
    swap_depth(depth, kept, back);
    swap_depth(depth + apart, kept + 1, back);
    swap_depth(depth + 2 * apart, kept + 2, back);
    swap_depth(depth + 3 * apart, kept + 3, back);
}

/* swap_depth of every `apart`-th pixel from *depth to before `end`; returns where the next depth is kept. */
SPECIALISED uint16_t *swap_every(uint16_t *depth, uint16_t *kept, const uint16_t *end, int32_t apart, int back)
{
    if (FAST_LOOPS && apart == 2)
        for (; depth < end - 15 * apart; depth += 16 * apart, kept += 16) {
            OPAQUE(depth); /* so that one address serves all */
            OPAQUE(kept);
            swap_four(depth, kept, apart, back);
            swap_four(depth + 4 * apart, kept + 4, apart, back);
            swap_four(depth + 8 * apart, kept + 8, apart, back);
            swap_four(depth + 12 * apart, kept + 12, apart, back);
        }
    for (; depth < end - 3 * apart; depth += 4 * apart, kept += 4) {
        OPAQUE(depth);
        OPAQUE(kept);
        swap_four(depth, kept, apart, back);
    }
    for (; depth < end; depth += apart) {
        swap_depth(depth, kept++, back);
        OPAQUE(kept);
    }
    return kept;
}

/* If half of the pixels are left out: every second one, those at odd columns if `odd` is odd. */
SPECIALISED uint16_t *swap_second(uint16_t *line, uint16_t *kept, struct span span, uint32_t odd, int back)
{
    const int32_t x = span.x0 + (int32_t)(((uint32_t)span.x0 + odd) & 1u);

    return swap_every(line + x, kept, line + span.x1, 2, back);
}

/* left_out: a bit per column, x & 7. */
SPECIALISED uint16_t *swap_any(uint16_t *line, uint16_t *kept, struct span span, uint32_t left_out, int back)
{
    const int32_t turn = span.x0 & 7, width = span.x1 - span.x0;
    uint16_t *depth = line + span.x0;

    left_out = (left_out | left_out << 8) >> turn & 0xffu; /* bit 0: the span's first pixel, then every 8th */
    if (width > 16) {
        const uint16_t *end = depth + width;
        for (; left_out != 0; depth++, left_out >>= 1)
            if (left_out & 1u)
                kept = swap_every(depth, kept, end, 8, back);
        return kept;
    }
    SHEEN_TAP(NARROW, back || left_out == 0 ? 0 : width);
    left_out |= left_out << 8;
    for (int32_t x = 0; x < width; x++)
        if (left_out >> x & 1u)
            swap_depth(depth + x, kept++, back);
    return kept;
}

SPECIALISED void swap_rows(struct stippled_rows *r, const struct tile *t, const struct draw *d, int back)
{
    const struct span *span = r->span, *end = span + t->rows;
    const int32_t pitch = t->pitch;
    uint16_t *kept = r->depth, *line = t->depth + (t->first_row - t->rect.y0) * pitch - t->rect.x0;
    uint32_t y = (uint32_t)t->first_row;

    SHEEN_TAP(STRIP_ROW, back ? 0 : t->rows);
    if (d->stippled == STIPPLED_SECOND) {
        y += d->left_out[0] + 1u;
        do {
            kept = swap_second(line, kept, *span, y++, back);
            line += pitch;
            span = next_span(span);
        } while (span != end);
    } else {
        do {
            kept = swap_any(line, kept, *span, d->left_out[y++ & 7u], back);
            line += pitch;
            span = next_span(span);
        } while (span != end);
    }
    SHEEN_TAP(HIDDEN, back ? 0 : kept - r->depth);
}

/* A strip's width: the depths of one of its rows fit KEPT_DEPTHS, and for cells those of several rows. */
static int32_t strip_of(const struct setup *s)
{
    const int32_t half = s->draw->stippled != STIPPLED_MORE;

    return s->way == SHEEN_WAY_PHONG_CELLS ? 16 << half : KEPT_DEPTHS << half;
}

/*
 * Takes the next rows of columns x to before x1, as many as there is room for; returns how many. half: 1 if at most
 * half of a row's pixels are left out.
 */
SPECIALISED unsigned take_rows(struct stippled_rows *r, struct tile *t, const struct draw *d, int32_t x, int32_t x1,
                               int32_t half)
{
    const struct span *whole = r->whole + r->row, *end = whole + min32((int32_t)(r->rows - r->row), STIPPLED_ROWS);
    struct span *span = r->span;
    int32_t room = KEPT_DEPTHS, y = r->first_row + (int32_t)r->row;

    t->first_row = (int16_t)y;
    for (; whole != end; whole++, span++, y++) {
        const int32_t from = max32(whole->x0, x);
        const int32_t to = half == 0 && d->left_out[y & 7] == 0xffu ? from : max32(min32(whole->x1, x1), from);
        room -= (to - from + half) >> half;
        if (room < 0)
            break;
        *span = (struct span){(int16_t)from, (int16_t)to};
    }
    r->row = (unsigned)(whole - r->whole);
    return (unsigned)(span - r->span);
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

HOT static int stipple_hide(struct stippled_rows *r, struct tile *t, const struct setup *s)
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
    t->rows = (uint16_t)(s->draw->stippled != STIPPLED_MORE ? take_rows(r, t, s->draw, r->x, r->x + strip, 1)
                                                            : take_rows(r, t, s->draw, r->x, r->x + strip, 0));
    SHEEN_TAP(STRIP, 1);
    swap_rows(r, t, s->draw, 0);
    return 1;
}

/* Makes left_out: per row, a bit for each column that is left out. */
static COLD int stipple_begin(struct draw *d, const struct sheen_object *o)
{
    if (o->transparency > 64 || o->phase > 7)
        return SHEEN_ERR_ARGUMENT;
    for (unsigned y = 0; y < 8; y++) {
        unsigned columns = 0;
        for (unsigned x = 0; x < 8; x++)
            columns |= (unsigned)(sheen_thresholds[y][(x + o->phase) & 7u] > 2u * (64u - o->transparency)) << x;
        d->left_out[y] = (uint8_t)columns;
    }
    d->stippled = o->transparency > 32 ? STIPPLED_MORE : o->transparency == 32 ? STIPPLED_SECOND : STIPPLED_HALF;
    if (d->dither)
        take_general_loops(d);
    return SHEEN_OK;
}

const struct sheen_stipple sheen_stipple = {stipple_begin, stipple_hide};
