/*
 * quadric_rows.c - intensities that are quadratic over a triangle (Bishop and Weimer, "Fast Phong Shading", 1986; here
 * through the corners and the middles of the edges): two adds a pixel each, no root, no quotient.
 *
 * Where a highlight may fall, 1 - R.V is the second quadric and the power table follows a pixel. Gouraud's intensities
 * in perspective come the same way. Every loop gives the same pixels; which is taken is a matter of speed.
 */
#include "quadric_rows.h"

/* On M0+ a pixel in a highlight is a function of its own: it has the registers that it takes. */
#if defined(__ARM_ARCH_6M__)
#define PIXEL static APART
#else
#define PIXEL SPECIALISED
#endif

PIXEL uint32_t plain_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, const struct tile *t,
                           const uint16_t *depth)
{
    struct lit lit = lit_of(q, f, u, SECOND_POWER);

    return loop_pixel(t, depth, q, lit.diffuse, lit.specular, 0);
}

PIXEL uint32_t dithered_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, uint32_t threshold,
                              const struct tile *t, const uint16_t *depth)
{
    struct lit lit = lit_of(q, f, u, SECOND_POWER);

    return loop_pixel(t, depth, q, lit.diffuse, lit.specular, threshold);
}

/* 565 with the loop's terms; thresholds: of the row. */
SPECIALISED void quick_run(const struct tile *t, const struct draw *d, uint16_t *depth, int32_t count,
                           const threshold_t *thresholds, const struct shaded_run *run, enum second second,
                           unsigned dither, unsigned swap)
{
    const struct loop_terms *q = &d->loop;
    const intptr_t to_pixel = t->to_pixel;
    const uint16_t *end = depth + count;
    const uint32_t dz = run->dz, ddf = run->ddf, ddu = run->ddu;
    uint32_t z = run->z, f = run->f, df = run->df, u = run->u, du = run->du;

    do {
        if (nearer(t, depth, z)) {
            OPAQUE(q); /* the loop's numbers have the registers */
            uint32_t value, threshold = dither ? threshold_pair(thresholds, depth) << (LOOP_FRACTION - 11) : 0;
            if (second == SECOND_POWER && dither) {
                value = dithered_pixel(q, f, u, threshold, t, depth);
            } else if (second == SECOND_POWER) {
                value = plain_pixel(q, f, u, t, depth);
            } else {
                struct lit lit = lit_of(q, f, u, second);
                value = loop_pixel(t, depth, q, lit.diffuse, lit.specular, threshold);
            }
            *pixel_at(depth, to_pixel) = pixel_order(value, swap);
        }
        depth++;
        z += dz;
        f += df;
        df += ddf;
        if (second != SECOND_NONE) {
            u += du;
            du += ddu;
        }
    } while (depth != end);
}

/* f: Q1.30, its steps within a segment are cut. */
PIXEL uint32_t segment_pixel(const struct shade_segment *segments, uint32_t f, uint32_t pair, const struct tile *t,
                             const uint16_t *depth)
{
    const uint32_t lit = not_negative(f) >> (30 - SEGMENT_BITS - SEGMENT_STEPS_BITS);
    const uint32_t n = lit & ((1u << SEGMENT_STEPS_BITS) - 1);
    const struct shade_segment *at = &segments[lit >> SEGMENT_STEPS_BITS];
    OPAQUE(at); /* one address for all that is loaded */
    struct shade_segment s = *at;
    OPAQUE_BOTH(s.red_blue, s.red_blue_step); /* two in one load */
    OPAQUE_BOTH(s.green, s.green_step);

    return dithered_565(t, depth, (struct packed){s.red_blue + n * s.red_blue_step, s.green + n * s.green_step}, pair,
                        0);
}

/* The draw's shades: L.N alone. */
SPECIALISED void cosine_shades_run(const struct tile *t, const struct shades *shades, uint16_t *depth, int32_t count,
                                   const threshold_t *thresholds, const struct shaded_run *run, unsigned dither,
                                   unsigned swap)
{
    const uint16_t *pixels = shades->pixel + SHADES_GUARD;
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = run->dz, ddf = run->ddf;
    const uint16_t *end = depth + count;
    uint32_t z = run->z, f = run->f, df = run->df;

    do {
        if (nearer(t, depth, z))
            *pixel_at(depth, to_pixel) =
                dither
                    ? pixel_order(segment_pixel(shades->segment, f, threshold_pair(thresholds, depth), t, depth), swap)
                    : pixels[not_negative(f) >> (30 - SHADES_BITS)];
        depth++;
        z += dz;
        f += df;
        df += ddf;
    } while (depth != end);
}

static APART void general_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                              struct shaded_run *run, unsigned second)
{
    general_loop(t, d, at, x, x1, y, run, (enum second)second, 0, 0);
}

/* 1 where there is a loop of its own: without highlight, and with one. */
static int shades_will_do(const struct draw *d, enum second second)
{
    return second == SECOND_NONE && d->shades != NULL;
}

void sheen_shaded_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      struct shaded_run *run, enum second second)
{
    const uint32_t at = tile_offset(t, x, y);
    const threshold_t *thresholds = t->dither_rows[y & 7];

    if (second == SECOND_NONE)
        run->u = run->du = run->ddu = 0; /* a specular intensity of none */
    if (shades_will_do(d, second))
        t->dither ? cosine_shades_run(t, d->shades, t->depth + at, x1 - x, thresholds, run, 1, t->format->swap)
                  : cosine_shades_run(t, d->shades, t->depth + at, x1 - x, thresholds, run, 0, 0);
    else if (FAST_LOOPS && d->is_565 && d->loop.usable && second == SECOND_POWER)
        t->dither ? quick_run(t, d, t->depth + at, x1 - x, thresholds, run, SECOND_POWER, 1, t->format->swap)
                  : quick_run(t, d, t->depth + at, x1 - x, thresholds, run, SECOND_POWER, 0, t->format->swap);
    else if (FAST_LOOPS && d->is_565 && d->loop.usable)
        quick_run(t, d, t->depth + at, x1 - x, thresholds, run, SECOND_SPECULAR, t->dither, t->format->swap);
    else
        (d->fog       ? d->fog->mixer->shaded_run
         : d->by_ramp ? d->light.ramp->reader->shaded_run
                      : general_run)(t, d, at, x, x1, y, run, second);
}

#if FAST_LOOPS
SPECIALISED void own_rows(const struct tile *t, const struct quadric_setup *q, enum second second, unsigned dither)
{
    const struct draw *d = q->s.draw;
    struct quadric stepped[2]; /* a row: L.N, and the second */
    int32_t y = t->first_row;

    stepped[0] = sheen_quadric_from(&q->diffuse, y - q->y);
    if (second != SECOND_NONE)
        stepped[1] = sheen_quadric_from(&q->second, y - q->y);
    for (const struct span *span = t->spans, *end = span + t->rows; span != end; span++, y++) {
        int32_t x = span->x0, x1 = span->x1;
        struct quadric *at = stepped;
        OPAQUE(at); /* it stays in memory: the pixels' loop takes all registers */
        if (x < x1) {
            const threshold_t *thresholds = dither && second != SECOND_NONE ? t->dither_rows[y & 7] : NULL;
            OPAQUE(thresholds); /* early: what loads them needs registers, too */
            struct shaded_run run = {plane_at(&q->s.depth, x, y), q->s.depth.dx, 0, 0, 0, 0, 0, 0};
            quadric_run(&at[0], x - q->x, &run.f, &run.df, &run.ddf);
            if (second != SECOND_NONE)
                quadric_run(&at[1], x - q->x, &run.u, &run.du, &run.ddu);
            if (second != SECOND_NONE)
                quick_run(t, d, t->depth + tile_offset(t, x, y), x1 - x, thresholds, &run, second, dither, 1);
            else
                cosine_shades_run(t, d->shades, t->depth + tile_offset(t, x, y), x1 - x, t->dither_rows[y & 7], &run,
                                  dither, 1);
        }
        at = stepped;
        OPAQUE(at);
        quadric_down(&at[0]);
        if (second != SECOND_NONE)
            quadric_down(&at[1]);
    }
}

static APART void cosine_shades_rows(const struct tile *t, const struct quadric_setup *q)
{
    own_rows(t, q, SECOND_NONE, 0);
}

static APART void plain_rows(const struct tile *t, const struct quadric_setup *q)
{
    own_rows(t, q, SECOND_POWER, 0);
}

static APART void dithered_rows(const struct tile *t, const struct quadric_setup *q)
{
    own_rows(t, q, SECOND_NONE, 1);
}

static APART void dithered_power_rows(const struct tile *t, const struct quadric_setup *q)
{
    own_rows(t, q, SECOND_POWER, 1);
}

/* Loops of their own are in the order of a panel's bus. */
int sheen_quadric_own_rows(const struct tile *t, const struct quadric_setup *q)
{
    const enum second second = (enum second)q->s.detail;

    if (t->format->swap && shades_will_do(q->s.draw, second))
        t->dither ? dithered_rows(t, q) : cosine_shades_rows(t, q);
    else if (t->format->swap && q->s.draw->is_565 && q->s.draw->loop.usable && second == SECOND_POWER)
        t->dither ? dithered_power_rows(t, q) : plain_rows(t, q);
    else
        return 0;
    return 1;
}
#endif
