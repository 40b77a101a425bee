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

/*
 * Red and blue share a word: 2^16 red + blue, each UQ5.11, as an exact sum, so that what blue borrows red
 * gives back; green is UQ6.26. Steps of 11 fraction bits are off by 2^-12 a px: every COLUMN px the run is made anew.
 */
#define COLUMN 32

struct packed {
    uint32_t red_blue, green;
};

SPECIALISED struct packed pack(const uint32_t channel[3], unsigned fraction)
{
    const unsigned down = fraction - 11;
    const int32_t red = (int32_t)channel[0] + (1 << (down - 1)), blue = (int32_t)channel[2] + (1 << (down - 1));
    struct packed p = {((uint32_t)asr32(red, down) << 16) + (uint32_t)asr32(blue, down), channel[1] << (26 - fraction)};

    return p;
}

/* Of the thresholds' 1/128 levels. */
SPECIALISED struct packed pack_threshold(uint32_t threshold)
{
    struct packed p = {(threshold << 20) + (threshold << 4), threshold << 19};

    return p;
}

SPECIALISED uint16_t packed_pixel(struct packed p, unsigned swap)
{
    return pixel_order((p.red_blue >> 27) << 11 | (p.green >> 26) << 5 | (p.red_blue >> 11 & 31u), swap);
}

/* thresholds: of the row, NULL: none, rounding is in the words. x: where the run begins. */
SPECIALISED void packed_run(const struct tile *t, uint16_t *depth, uint32_t x, uint32_t count, uint32_t z, uint32_t dz,
                            struct packed at, struct packed step, const uint8_t *thresholds, unsigned swap)
{
    const uint16_t *end = depth + count;
    const intptr_t to_pixel = t->to_pixel;

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
        at.red_blue += step.red_blue;
        at.green += step.green;
    } while (depth != end);
}

SPECIALISED void packed_rows(const struct tile *t, const struct linear_setup *l, unsigned dither, unsigned swap)
{
    const struct plane *c = l->channel;
    const unsigned fraction = l->s.draw->colour.fraction;
    const uint32_t steps[3] = {c[0].dx, c[1].dx, c[2].dx}, half = dither ? 0 : 1u << (fraction - 1);
    const struct packed step = pack(steps, fraction);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        const uint8_t *thresholds = dither ? threshold_row(1, y) : NULL;
        while (x < x1) {
            int32_t end = min32(x1, (x | (COLUMN - 1)) + 1);
            uint32_t channel[3] = {plane_at(&c[0], x, y) + half, plane_at(&c[1], x, y) + half,
                                   plane_at(&c[2], x, y) + half};
            packed_run(t, t->depth + tile_offset(t, x, y), (uint32_t)x, (uint32_t)(end - x),
                       plane_at(&l->s.depth, x, y), l->s.depth.dx, pack(channel, fraction), step, thresholds, swap);
            x = end;
        }
    }
}

/* ---- any format ---- */

static void general_rows(const struct tile *t, const struct linear_setup *l)
{
    const struct colour_terms *terms = &l->s.draw->colour;
    const struct plane *c = l->channel;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        struct rounding rounding = rounding_of(t, terms, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&l->s.depth, x, y);
        uint32_t channel[3] = {plane_at(&c[0], x, y), plane_at(&c[1], x, y), plane_at(&c[2], x, y)};
        for (; x < x1; x++, at++, z += l->s.depth.dx) {
            if (nearer(t, t->depth + at, z))
                put_general(t, terms, rounding, at, x, not_negative(channel[0]), not_negative(channel[1]),
                            not_negative(channel[2]));
            for (int k = 0; k < 3; k++)
                channel[k] += c[k].dx;
        }
    }
}

void sheen_linear_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *l = (const struct linear_setup *)s;

    if (!s->fast)
        general_rows(t, l);
    else if (t->dither)
        packed_rows(t, l, 1, t->format->swap);
    else if (FAST_LOOPS && t->format->swap)
        packed_rows(t, l, 0, 1);
    else
        packed_rows(t, l, 0, t->format->swap);
}
