/*
 * quadric_rows.c - intensities that are quadratic over a triangle (Bishop and Weimer, "Fast Phong Shading", 1986; here
 * through the corners and the middles of the edges): two adds a pixel each, no root, no quotient.
 *
 * Where a highlight may fall, 1 - R.V is the second quadric and the power table follows a pixel. Gouraud's intensities
 * in perspective come the same way. Every loop gives the same pixels; which is taken is a matter of speed.
 */
#include "quadric_rows.h"

/* A pixel in a highlight that is not dithered. On M0+ a function of its own has the registers that it takes. */
#if defined(__ARM_ARCH_6M__)
static APART
#else
SPECIALISED
#endif
    uint32_t
    plain_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, const struct tile *t, const uint16_t *depth)
{
    struct lit lit = lit_of(q, f, u, SECOND_POWER);

    return pixel_order(loop_pixel(t, depth, q, lit.diffuse, lit.specular, 0), 1);
}

/* 565 with the loop's terms; `plain`: neither dithered nor in this machine's order. */
SPECIALISED void quick_run(const struct tile *t, const struct draw *d, uint16_t *depth, int32_t x, int32_t x1,
                           const uint8_t *thresholds, const struct shaded_run *run, enum second second, int plain)
{
    const struct loop_terms *q = &d->loop;
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = run->dz, ddf = run->ddf, ddu = run->ddu;
    const unsigned swap = t->format->swap;
    uint32_t z = run->z, f = run->f, df = run->df, u = run->u, du = run->du;

    do {
        if (nearer(t, depth, z)) {
            OPAQUE(q); /* the loop's numbers have the registers */
            uint32_t value;
            if (plain) {
                value = plain_pixel(q, f, u, t, depth);
            } else {
                struct lit lit = lit_of(q, f, u, second);
                uint32_t threshold = thresholds == NULL ? 0 : (uint32_t)thresholds[x & 7] << (LOOP_FRACTION - 7);
                value = pixel_order(loop_pixel(t, depth, q, lit.diffuse, lit.specular, threshold), swap);
            }
            *(uint16_t *)(void *)((char *)depth + to_pixel) = (uint16_t)value;
        }
        depth++;
        z += dz;
        f += df;
        df += ddf;
        if (second != SECOND_NONE) {
            u += du;
            du += ddu;
        }
    } while (++x != x1);
}

/* The draw's shades: L.N alone, not dithered. */
SPECIALISED void cosine_shades_run(const struct tile *t, const uint16_t *shades, uint16_t *depth, int32_t count,
                                   const struct shaded_run *run)
{
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = run->dz, ddf = run->ddf;
    const uint16_t *end = depth + count;
    uint32_t z = run->z, f = run->f, df = run->df;

    do {
        if (nearer(t, depth, z))
            *(uint16_t *)(void *)((char *)depth + to_pixel) = shades[not_negative(f) >> (30 - SHADES_BITS)];
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

    if (shades_will_do(d, second))
        cosine_shades_run(t, d->shades + SHADES_GUARD, t->depth + at, x1 - x, run);
    else if (FAST_LOOPS && d->loop.usable)
        quick_run(t, d, t->depth + at, x, x1, t->dither ? threshold_row(t, 1, y) : NULL, run, second, 0);
    else
        (d->fog       ? d->fog->mixer->shaded_run
         : d->by_ramp ? d->light.ramp->reader->shaded_run
                      : general_run)(t, d, at, x, x1, y, run, second);
}

#if FAST_LOOPS
SPECIALISED void own_rows(const struct tile *t, const struct quadric_setup *q, enum second second, int dither)
{
    struct quadric f = sheen_quadric_from(&q->diffuse, t->first_row - q->y), u = f;
    struct quadric *stepped = &f, *second_stepped = &u;
    const struct draw *d = q->s.draw;
    int32_t y = t->first_row;

    if (second != SECOND_NONE)
        u = sheen_quadric_from(&q->second, t->first_row - q->y);
    for (const struct span *span = t->spans, *end = span + t->rows; span != end; span++, y++) {
        int32_t x = span->x0, x1 = span->x1;
        OPAQUE(stepped); /* what is stepped a row stays in memory: the pixels' loop takes all registers */
        OPAQUE(second_stepped);
        if (x < x1) {
            struct shaded_run run = {plane_at(&q->s.depth, x, y), q->s.depth.dx, 0, 0, 0, 0, 0, 0};
            quadric_run(stepped, x - q->x, &run.f, &run.df, &run.ddf);
            if (second != SECOND_NONE)
                quadric_run(second_stepped, x - q->x, &run.u, &run.du, &run.ddu);
            if (dither)
                quick_run(t, d, t->depth + tile_offset(t, x, y), x, x1, threshold_row(t, 1, y), &run, second, 0);
            else if (second == SECOND_NONE)
                cosine_shades_run(t, d->shades + SHADES_GUARD, t->depth + tile_offset(t, x, y), x1 - x, &run);
            else
                quick_run(t, d, t->depth + tile_offset(t, x, y), x, x1, NULL, &run, second, 1);
        }
        quadric_down(stepped);
        if (second != SECOND_NONE)
            quadric_down(second_stepped);
    }
}

static int plain_will_do(const struct tile *t, const struct draw *d, enum second second)
{
    return second == SECOND_POWER && d->loop.usable && !t->dither && t->format->swap;
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

int sheen_quadric_own_rows(const struct tile *t, const struct quadric_setup *q)
{
    const enum second second = (enum second)q->s.detail;

    if (plain_will_do(t, q->s.draw, second))
        plain_rows(t, q);
    else if (shades_will_do(q->s.draw, second))
        cosine_shades_rows(t, q);
    else if (t->dither && q->s.draw->loop.usable && second == SECOND_NONE)
        dithered_rows(t, q);
    else if (t->dither && q->s.draw->loop.usable && second == SECOND_POWER)
        dithered_power_rows(t, q);
    else
        return 0;
    return 1;
}
#endif
