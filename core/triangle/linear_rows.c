/*
 * linear_rows.c - rows of colours that are linear on the screen (lecture, "Gouraud Shading").
 *
 * Outside the highlight a colour is a function of the diffuse intensity alone, so that one number is stepped and
 * finished pixels come from the draw's shades. Otherwise the channels are stepped, in levels, because a colour is
 * linear in the intensities; they are rounded once per pixel.
 */
#include "thumb_runs.h"

/* ---- one number and finished pixels ---- */

SPECIALISED void shades_pixel(const struct tile *t, uint16_t *depth, intptr_t to_pixel, struct shades_at *at,
                              struct shades_at step, const uint16_t *shades)
{
    if (nearer(t, depth, at->z))
        *pixel_at(depth, to_pixel) = shades[at->f >> (30 - SHADES_BITS)];
    at->z += step.z;
    at->f += step.f;
}

HOT void sheen_shades_rows(const struct tile *t, const struct setup *s)
{
    const struct shades_setup *r = (const struct shades_setup *)s;
    const uint16_t *shades = s->draw->shades->pixel;
    const struct plane depth = s->depth, diffuse = r->diffuse;
    const struct shades_at step = {depth.dx, diffuse.dx};
    const struct span *span = t->spans, *end = span + t->rows;
    const uint16_t pitch = t->pitch;
    const intptr_t to_pixel = t->to_pixel;
    uint32_t y = (uint32_t)t->first_row, z = depth.base + y * depth.dy, f = diffuse.base + y * diffuse.dy;
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)pitch - t->rect.x0;

    do {
        const int32_t x = span->x0;
        uint16_t *pixel = line + x;
        const uint16_t *last = line + span->x1;
        struct shades_at at = {z + (uint32_t)x * step.z, f + (uint32_t)x * step.f};
        for (; pixel < last; pixel++) {
            OPAQUE(last); /* else gcc computes each row's count of pixels first */
            shades_pixel(t, pixel, to_pixel, &at, step, shades);
        }
        line += pitch;
        z += depth.dy;
        f += diffuse.dy;
        span = next_span(span);
    } while (span != end);
}

#if THUMB_LOOPS
HOT void sheen_wide_shades_rows(const struct tile *t, const struct setup *s)
{
    const struct shades_setup *r = (const struct shades_setup *)s;
    struct thumb_shades run = {
        .step = {s->depth.dx, r->diffuse.dx}, .to_pixel = t->to_pixel, .shades = s->draw->shades->pixel};
    const struct span *span = t->spans;

    for (int32_t y = t->first_row, end = y + t->rows; y != end; y++, span++) {
        run.depth = t->depth + tile_offset(t, span->x0, y);
        run.count = span->x1 - span->x0;
        run.at.z = plane_at(&s->depth, span->x0, y);
        run.at.f = plane_at(&r->diffuse, span->x0, y);
        if (run.count > 0)
            thumb_shades_run(&run);
    }
}
#endif

/* ---- three channels in two words ---- */

SPECIALISED void packed_rows(const struct tile *t, const struct packed_setup *s, unsigned dither, unsigned swap)
{
    const struct packed_way way = {.to_pixel = t->to_pixel, .dither = dither, .swap = swap};
    const struct span *span = t->spans, *end = span + t->rows;
    int32_t y = t->first_row;
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)t->pitch - t->rect.x0;

    do {
        int32_t x = span->x0, count = span->x1 - x;
        OPAQUE(s); /* its fields are loaded again: the pixel loop needs the registers */
        if (count > 0) {
            const threshold_t *thresholds = DITHER_ROW(t, line, y);
            OPAQUE(thresholds); /* loaded early: later no registers are free */
            const struct packed_at step = {s->s.depth.dx, {s->red_blue.dx, s->green.dx}};
            const struct packed_at at = {plane_at(&s->s.depth, x, y),
                                         {plane_at(&s->red_blue, x, y), plane_at(&s->green, x, y)}};
            packed_run(t, line + x, count, at, step, way, thresholds);
        }
        line += t->pitch;
        y++;
    } while (++span != end);
}

static COLD void any_packed_rows(const struct tile *t, const struct packed_setup *s)
{
    packed_rows(t, s, t->dither, t->format->swap);
}

/* Specialised loops, here and below, are for the byte order of a panel's bus only. */
HOT void sheen_packed_rows(const struct tile *t, const struct setup *s)
{
    const struct packed_setup *p = (const struct packed_setup *)s;

    if (!FAST_LOOPS || !t->format->swap)
        any_packed_rows(t, p);
    else if (t->dither)
        packed_rows(t, p, 1, 1);
    else
        packed_rows(t, p, 0, 1);
}

/* packed_run, in assembly where that pays. */
SPECIALISED void long_run(const struct tile *t, uint16_t *depth, int32_t count, const struct packed_at *at,
                          const struct packed_at *step, const uint16_t *line, int32_t y, unsigned dither, unsigned swap)
{
#if THUMB_LOOPS
    if (swap && !dither) {
        const struct thumb_packed run = {*step, depth, count, t->to_pixel, *at};
        thumb_packed_run(&run);
        return;
    }
#endif
    const struct packed_way way = {.to_pixel = t->to_pixel, .dither = dither, .swap = swap};
    packed_run(t, depth, count, *at, *step, way, DITHER_ROW(t, line, y));
}

/* Wide triangles: channels are packed again every PACKED_RUN px. */
SPECIALISED void column_rows(const struct tile *t, const struct linear_setup *l, unsigned dither, unsigned swap)
{
    const struct plane *c = l->channel;
    const unsigned fraction = l->s.draw->colour.fraction;
    const uint32_t steps[3] = {c[0].dx, c[1].dx, c[2].dx}, half = dither ? 0 : 1u << (fraction - 1);
    const struct packed_at step = {l->s.depth.dx, pack_channels(steps, fraction)};
    const struct span *span = t->spans;

    for (int32_t y = t->first_row, end = y + t->rows; y != end; y++, span++) {
        int32_t x = span->x0, left = span->x1 - x;
        uint32_t channel[3] = {plane_at(&c[0], x, y) + half, plane_at(&c[1], x, y) + half,
                               plane_at(&c[2], x, y) + half};
        struct packed_at at = {plane_at(&l->s.depth, x, y), {0, 0}};
        uint16_t *depth = t->depth + tile_offset(t, x, y);
        const uint16_t *line = depth - x;
        for (int32_t n = PACKED_RUN - (x & (PACKED_RUN - 1)); left > 0; left -= n, n = PACKED_RUN) {
            n = min32(n, left);
            at.colour = pack_channels(channel, fraction);
            long_run(t, depth, n, &at, &step, line, y, dither, swap);
            depth += n;
            at.z += (uint32_t)n * step.z;
            for (int k = 0; k < 3; k++)
                channel[k] += (uint32_t)n * steps[k];
        }
    }
}

static COLD void any_column_rows(const struct tile *t, const struct linear_setup *l)
{
    column_rows(t, l, t->dither, FAST_LOOPS ? 0 : t->format->swap);
}

/* ---- any format, clamped ---- */

/* As put_general with its constants in locals: a byte store may alias anything and would have them loaded again. */
static COLD void clamped_rows(const struct tile *t, const struct linear_setup *l)
{
    const struct colour_terms *terms = &l->s.draw->colour;
    const struct plane *c = l->channel;
    const unsigned fraction = terms->fraction, swap = t->format->swap, grey = t->format->grey;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        const struct rounding rounding = rounding_of(t, terms, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&l->s.depth, x, y);
        uint32_t r = plane_at(&c[0], x, y), g = plane_at(&c[1], x, y), b = plane_at(&c[2], x, y);
        for (; x < x1; x++, at++, z += l->s.depth.dx, r += c[0].dx, g += c[1].dx, b += c[2].dx) {
            if (!nearer(t, t->depth + at, z))
                continue;
            uint32_t threshold = (uint32_t)rounding.threshold[(uint32_t)x & 7u] << rounding.shift;
            put_clamped(t, terms, threshold, at, not_negative(r), not_negative(g), not_negative(b), grey, fraction,
                        swap);
        }
    }
}

#if FAST_LOOPS
/* 565 with LOOP_FRACTION bits: clamped after the shift to whole levels, which some cores do in one instruction. */
SPECIALISED void clamped_565_rows(const struct tile *t, const struct linear_setup *l, unsigned dither)
{
    const struct plane *c = l->channel;
    const uint32_t dz = l->s.depth.dx, dr = c[0].dx, dg = c[1].dx, db = c[2].dx;
    const uint32_t half = dither ? 0 : 1u << (LOOP_FRACTION - 1);
    const intptr_t to_pixel = t->to_pixel;
    const struct span *span = t->spans;

    for (int32_t y = t->first_row, end_row = y + t->rows; y != end_row; y++, span++) {
        const int32_t x = span->x0;
        const threshold_t *thresholds = t->dither_rows[y & 7];
        uint16_t *at = t->depth + tile_offset(t, x, y);
        const uint16_t *end = at + (span->x1 - x);
        uint32_t z = plane_at(&l->s.depth, x, y), threshold = 0;
        uint32_t r = plane_at(&c[0], x, y) + half, g = plane_at(&c[1], x, y) + half, b = plane_at(&c[2], x, y) + half;
        for (; at < end; at++, z += dz, r += dr, g += dg, b += db) {
            if (!nearer(t, at, z))
                continue;
            if (dither) {
                threshold = threshold_pair(thresholds, at) << (LOOP_FRACTION - 11);
                SHEEN_TEST_TAP(t, (uint32_t)(at - t->depth), not_negative(r), not_negative(g), not_negative(b),
                               LOOP_FRACTION);
            }
            const uint32_t pixel = clamped_565(r + threshold, g + threshold, b + threshold, 1);
            *pixel_at(at, to_pixel) = pixel_order(pixel, 1);
        }
    }
}
#endif

HOT void sheen_linear_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *l = (const struct linear_setup *)s;
    const unsigned own = FAST_LOOPS && t->format->swap;

#if FAST_LOOPS
    if (!s->special_loop && own && s->draw->is_565 && s->draw->colour.fraction == LOOP_FRACTION) {
        if (t->dither)
            clamped_565_rows(t, l, 1);
        else
            clamped_565_rows(t, l, 0);
        return;
    }
#endif
    if (!s->special_loop)
        clamped_rows(t, l);
    else if (!own)
        any_column_rows(t, l);
    else if (t->dither)
        column_rows(t, l, 1, 1);
    else
        column_rows(t, l, 0, 1);
}
