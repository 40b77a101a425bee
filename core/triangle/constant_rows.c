/*
 * constant_rows.c - rows of one colour per triangle (lecture, "Uniform Shading"), finished at set-up or dithered per
 * pixel.
 */
#include "triangle.h"

SPECIALISED void constant_rows(const struct tile *t, const struct constant_setup *s, unsigned grey)
{
    const struct plane depth = s->s.depth;
    const struct span *span = t->spans, *spans_end = span + t->rows;
    const uint16_t pixel = s->pixel, pitch = t->pitch;
    const intptr_t to_pixel = t->to_pixel;
    uint32_t z_row = depth.base + (uint32_t)t->first_row * depth.dy;
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)pitch - t->rect.x0;

    do {
        const int32_t x = span->x0;
        uint16_t *at = line + x;
        const uint16_t *end = line + span->x1;
        uint32_t z = z_row + (uint32_t)x * depth.dx;
        for (; at < end; at++, z += depth.dx) {
            OPAQUE(end); /* else gcc computes each row's count of pixels first */
            if (!nearer(t, at, z))
                continue;
            if (grey)
                ((uint8_t *)t->pixels)[at - t->depth] = (uint8_t)pixel;
            else
                *pixel_at(at, to_pixel) = pixel;
        }
        line += pitch;
        z_row += depth.dy;
        span = next_span(span);
    } while (span != spans_end);
}

HOT void sheen_constant_rows(const struct tile *t, const struct setup *s)
{
    if (FAST_LOOPS && !t->format->grey)
        constant_rows(t, (const struct constant_setup *)s, 0);
    else
        constant_rows(t, (const struct constant_setup *)s, t->format->grey);
}

#if FAST_LOOPS
/* 565 with the frame's own thresholds. Here and below the set-up is planes without steps. */
SPECIALISED void packed_constant_rows(const struct tile *t, const struct linear_setup *s, unsigned swap)
{
    const struct plane *c = s->channel;
    const unsigned fraction = s->s.draw->colour.fraction, down = fraction - 11;
    const uint32_t dz = s->s.depth.dx;
    /* cut to 1/2048 level, of which thresholds are multiples, so no sum reaches a level that it would not uncut */
    struct packed colour = {(c[0].base >> down << 16) + (c[2].base >> down), c[1].base << (26 - fraction)};
    const intptr_t to_pixel = t->to_pixel;

    OPAQUE(colour.red_blue); /* else gcc makes it again for each row */
    OPAQUE(colour.green);
    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        const threshold_t *thresholds = t->dither_rows[y & 7];
        uint16_t *depth = t->depth + tile_offset(t, x, y);
        const uint16_t *end = depth + (x1 - x);
        uint32_t z = plane_at(&s->s.depth, x, y);
        do {
            if (nearer(t, depth, z))
                *pixel_at(depth, to_pixel) = dithered_565(t, depth, colour, threshold_pair(thresholds, depth), swap);
            z += dz;
        } while (++depth != end);
    }
}
#endif

#if FAST_LOOPS
static COLD void unswapped_constant_rows(const struct tile *t, const struct linear_setup *s)
{
    packed_constant_rows(t, s, 0);
}
#endif

static COLD void general_constant_rows(const struct tile *t, const struct linear_setup *s)
{
    const struct colour_terms *terms = &s->s.draw->colour;
    const struct span *span = t->spans, *end = span + t->rows;

    for (int32_t y = t->first_row; span != end; span++, y++) {
        const struct rounding rounding = rounding_of(t, terms, y);
        uint32_t at = tile_offset(t, span->x0, y), z = plane_at(&s->s.depth, span->x0, y);
        for (int32_t x = span->x0; x < span->x1; x++, at++, z += s->s.depth.dx)
            if (nearer(t, t->depth + at, z))
                put_clamped(t, terms, (uint32_t)rounding.threshold[(uint32_t)x & 7u] << rounding.shift, at,
                            s->channel[0].base, s->channel[1].base, s->channel[2].base, t->format->grey,
                            terms->fraction, t->format->swap);
    }
}

HOT void sheen_dithered_constant_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *planes = (const struct linear_setup *)s;

#if FAST_LOOPS
    if (s->special_loop) {
        if (t->format->swap)
            packed_constant_rows(t, planes, 1);
        else
            unswapped_constant_rows(t, planes);
        return;
    }
#endif
    general_constant_rows(t, planes);
}
