/*
 * linear_rows.c - colours that are linear on the screen (lecture, "Gouraud Shading").
 *
 * Outside the highlight a colour is a function of the diffuse intensity alone: one number is stepped and finished
 * pixels come from the draw's ramp. Else colour is linear in the intensities, so the channels are stepped, in levels,
 * and rounded once a pixel.
 */
#include "triangle.h"

/* ---- one number and a ramp ---- */

/* A run of pixels on the way: what is stepped lies in registers. */
static inline void ramp_run(const struct tile *t, uint16_t *depth, uint32_t count, uint32_t z, uint32_t dz, uint32_t f,
                            uint32_t df, const uint16_t *ramp)
{
    const uint16_t *end = depth + count;
    const intptr_t to_pixel = t->to_pixel;

    do {
        if (nearer(t, depth, z))
            *(uint16_t *)(void *)((char *)depth + to_pixel) = ramp[f >> (30 - RAMP_BITS)];
        depth++;
        z += dz;
        f += df;
    } while (depth != end);
}

void sheen_ramp_rows(const struct tile *t, const struct setup *s)
{
    const struct ramp_setup *r = (const struct ramp_setup *)s;
    const uint16_t *ramp = s->draw->ramp;
    const struct plane depth = s->depth, diffuse = r->diffuse;
    const struct span *span = t->spans, *end = span + t->rows;
    uint32_t y = (uint32_t)t->first_row, z = depth.base + y * depth.dy, f = diffuse.base + y * diffuse.dy;
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)t->pitch - t->rect.x0;

    do {
        int32_t x = span->x0, count = span->x1 - x;
        if (count > 0)
            ramp_run(t, line + x, (uint32_t)count, z + (uint32_t)x * depth.dx, depth.dx, f + (uint32_t)x * diffuse.dx,
                     diffuse.dx, ramp);
        line += t->pitch;
        z += depth.dy;
        f += diffuse.dy;
    } while (++span != end);
}

/* ---- three channels in two words ---- */

/* Of the thresholds' 1/128 levels. */
SPECIALISED struct packed pack_threshold(uint32_t threshold)
{
    struct packed p = {(threshold << 20) + (threshold << 4), threshold << 19};

    return p;
}

/* Blue's whole levels come down to bits 0 to 4; what red leaves above bit 15 is cut. */
SPECIALISED uint16_t packed_pixel(struct packed p, unsigned swap)
{
    uint32_t red_blue = p.red_blue & 0xf800f800u;

    return pixel_order((red_blue >> 16 | red_blue >> 11 | (p.green >> 26) << 5) & 0xffffu, swap);
}

/* What a run takes along. */
struct packed_step {
    uint32_t z;
    struct packed colour;
};

/* thresholds: of the row, NULL: none, rounding is in the words. x: where the run begins. */
SPECIALISED void packed_run(const struct tile *t, uint16_t *depth, uint32_t x, uint32_t count, uint32_t z,
                            struct packed at, const struct packed_step *step, const uint8_t *thresholds, unsigned swap)
{
    const uint16_t *end = depth + count;
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = step->z, red_blue = step->colour.red_blue, green = step->colour.green;

    do {
        if (nearer(t, depth, z)) {
            struct packed p = at;
            if (thresholds != NULL) {
                struct packed threshold = pack_threshold(thresholds[x & 7u]);
                p.red_blue += threshold.red_blue;
                p.green += threshold.green;
            }
            *(uint16_t *)(void *)((char *)depth + to_pixel) = packed_pixel(p, swap);
        }
        depth++;
        x++;
        z += dz;
        at.red_blue += red_blue;
        at.green += green;
    } while (depth != end);
}

SPECIALISED void packed_rows(const struct tile *t, const struct packed_setup *s, unsigned dither, unsigned swap)
{
    const struct plane depth = s->s.depth, red_blue = s->red_blue, green = s->green;
    const struct packed_step step = {depth.dx, {red_blue.dx, green.dx}};
    const struct span *span = t->spans, *end = span + t->rows;
    uint32_t y = (uint32_t)t->first_row, z = depth.base + y * depth.dy;
    struct packed at = {red_blue.base + y * red_blue.dy, green.base + y * green.dy};
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)t->pitch - t->rect.x0;

    do {
        int32_t x = span->x0, count = span->x1 - x;
        uint32_t ux = (uint32_t)x;
        const struct packed first = {at.red_blue + ux * red_blue.dx, at.green + ux * green.dx};
        if (count > 0)
            packed_run(t, line + x, ux, (uint32_t)count, z + ux * depth.dx, first, &step,
                       dither ? threshold_row(1, (int32_t)y) : NULL, swap);
        line += t->pitch;
        y++;
        z += depth.dy;
        at.red_blue += red_blue.dy;
        at.green += green.dy;
    } while (++span != end);
}

void sheen_packed_rows(const struct tile *t, const struct setup *s)
{
    const struct packed_setup *p = (const struct packed_setup *)s;

    if (t->dither)
        packed_rows(t, p, 1, t->format->swap);
    else if (FAST_LOOPS && t->format->swap)
        packed_rows(t, p, 0, 1);
    else
        packed_rows(t, p, 0, t->format->swap);
}

/* Wide triangles: packed anew every COLUMN px. */
SPECIALISED void column_rows(const struct tile *t, const struct linear_setup *l, unsigned dither, unsigned swap)
{
    const struct plane *c = l->channel;
    const unsigned fraction = l->s.draw->colour.fraction;
    const uint32_t steps[3] = {c[0].dx, c[1].dx, c[2].dx}, half = dither ? 0 : 1u << (fraction - 1);
    const struct packed_step step = {l->s.depth.dx, pack_channels(steps, fraction)};

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        const uint8_t *thresholds = dither ? threshold_row(1, y) : NULL;
        while (x < x1) {
            int32_t end = min32(x1, (x | (COLUMN - 1)) + 1);
            uint32_t channel[3] = {plane_at(&c[0], x, y) + half, plane_at(&c[1], x, y) + half,
                                   plane_at(&c[2], x, y) + half};
            packed_run(t, t->depth + tile_offset(t, x, y), (uint32_t)x, (uint32_t)(end - x),
                       plane_at(&l->s.depth, x, y), pack_channels(channel, fraction), &step, thresholds, swap);
            x = end;
        }
    }
}

/* ---- any format, clamped ---- */

/* As put_general, with its constants in registers: bytes may be anything's, so stores would have them read again. */
SPECIALISED void clamped_rows(const struct tile *t, const struct linear_setup *l, unsigned grey)
{
    const struct colour_terms *terms = &l->s.draw->colour;
    const struct plane *c = l->channel;
    const unsigned fraction = terms->fraction, swap = t->format->swap;

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

void sheen_linear_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *l = (const struct linear_setup *)s;

    if (!s->fast && FAST_LOOPS && !t->format->grey)
        clamped_rows(t, l, 0);
    else if (!s->fast)
        clamped_rows(t, l, t->format->grey);
    else if (t->dither)
        column_rows(t, l, 1, t->format->swap);
    else if (FAST_LOOPS && t->format->swap)
        column_rows(t, l, 0, 1);
    else
        column_rows(t, l, 0, t->format->swap);
}
