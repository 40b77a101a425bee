/*
 * quadric_rows.c - intensities that are quadratic over a triangle (Bishop and Weimer, "Fast Phong Shading", 1986; here
 * through the corners and the middles of the edges): two adds a pixel each, no root, no quotient.
 *
 * Where a highlight may fall, 1 - R.V is the second quadric and the power table follows a pixel. Gouraud's intensities
 * in perspective come the same way. Every loop gives the same pixels; which is taken is a matter of speed.
 */
#include "quadric.h"

/* Intensities at a pixel. */
SPECIALISED struct lit lit_of(const struct loop_terms *q, uint32_t f, uint32_t u, enum second second)
{
    struct lit lit = {not_negative(f) >> 15, 0};

    if (second == SECOND_SPECULAR)
        lit.specular = not_negative(u) >> 15;
    else if (second == SECOND_POWER && u < q->power_end)
        lit.specular = faded(power_entry(q->power, u), lit.diffuse);
    return lit;
}

/* 565 with the loop's terms; `plain`: neither dithered nor in this machine's order. */
SPECIALISED void quick_run(const struct tile *t, const struct draw *d, uint16_t *depth, int32_t x, int32_t x1,
                           const uint8_t *thresholds, const struct shaded_run *run, enum second second, int plain)
{
    const struct loop_terms *q = &d->loop;
    const intptr_t to_pixel = (char *)t->pixels - (char *)t->depth;
    const uint32_t dz = run->dz, ddf = run->ddf, ddu = run->ddu;
    const unsigned swap = t->format->swap;
    uint32_t z = run->z, f = run->f, df = run->df, u = run->u, du = run->du;

    do {
        if (nearer(t, depth, z)) {
            OPAQUE(q); /* the loop's numbers have the registers */
            struct lit lit = lit_of(q, f, u, second);
            uint32_t threshold = plain || thresholds == NULL ? 0 : (uint32_t)thresholds[x & 7] << (LOOP_FRACTION - 7);
            uint32_t value = loop_pixel(t, depth, q, lit.diffuse, lit.specular, threshold);
            *(uint16_t *)(void *)((char *)depth + to_pixel) = pixel_order(value, plain ? 1 : swap);
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

/* The draw's ramp: L.N alone, not dithered. */
SPECIALISED void cosine_ramp_run(const struct tile *t, const uint16_t *ramp, uint16_t *depth, int32_t count,
                                 const struct shaded_run *run)
{
    const intptr_t to_pixel = (char *)t->pixels - (char *)t->depth;
    const uint32_t dz = run->dz, ddf = run->ddf;
    const uint16_t *end = depth + count;
    uint32_t z = run->z, f = run->f, df = run->df;

    do {
        if (nearer(t, depth, z))
            *(uint16_t *)(void *)((char *)depth + to_pixel) = ramp[not_negative(f) >> (30 - RAMP_BITS)];
        depth++;
        z += dz;
        f += df;
        df += ddf;
    } while (depth != end);
}

/* Any format, clamp and dither. */
static APART void general_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                              const struct shaded_run *from, enum second second)
{
    struct rounding rounding = rounding_of(t, &d->colour, y);
    struct shaded_run run = *from;

    for (; x < x1; x++, at++) {
        if (nearer(t, t->depth + at, run.z)) {
            struct lit lit = lit_of(&d->loop, run.f, run.u, second);
            put_general(t, &d->colour, rounding, at, x, colour_channel(&d->colour, 0, &lit),
                        colour_channel(&d->colour, 1, &lit), colour_channel(&d->colour, 2, &lit));
        }
        run.z += run.dz;
        run.f += run.df;
        run.df += run.ddf;
        run.u += run.du;
        run.du += run.ddu;
    }
}

/* Which loop a draw's pixels go through. */
enum loop {
    LOOP_RAMP,
    LOOP_PLAIN,
    LOOP_QUICK,
    LOOP_GENERAL
};

static enum loop loop_of(const struct tile *t, const struct draw *d, enum second second)
{
    if (second == SECOND_NONE && d->ramp != NULL)
        return LOOP_RAMP;
    if (!d->loop.usable)
        return LOOP_GENERAL;
    return second == SECOND_POWER && !t->dither && t->format->swap ? LOOP_PLAIN : LOOP_QUICK;
}

SPECIALISED void run_by(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                        const struct shaded_run *run, enum second second, enum loop loop)
{
    uint32_t at = tile_offset(t, x, y);

    if (loop == LOOP_RAMP)
        cosine_ramp_run(t, d->ramp + RAMP_GUARD, t->depth + at, x1 - x, run);
    else if (loop == LOOP_PLAIN)
        quick_run(t, d, t->depth + at, x, x1, NULL, run, SECOND_POWER, 1);
    else if (loop == LOOP_QUICK)
        quick_run(t, d, t->depth + at, x, x1, t->dither ? threshold_row(1, y) : NULL, run, second, 0);
    else
        general_run(t, d, at, x, x1, y, run, second);
}

struct quadric sheen_quadric_from(const struct quadric *q, int32_t n)
{
    const uint32_t y = (uint32_t)n;
    struct quadric r = {
        q->base + y * q->dy + pairs(n) * q->dyy, q->dx + y * q->dxy, q->dy + y * q->dyy, q->dxx, q->dxy, q->dyy};

    return r;
}

SPECIALISED void rows_by(const struct tile *t, const struct quadric_setup *q, enum second second, enum loop loop)
{
    struct quadric f = sheen_quadric_from(&q->diffuse, t->first_row - q->y), u = {0, 0, 0, 0, 0, 0};
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
            const int32_t n = x - q->x;
            const uint32_t across = (uint32_t)n, pair = pairs(n);
            struct shaded_run run = {plane_at(&q->s.depth, x, y),
                                     q->s.depth.dx,
                                     stepped->base + across * stepped->dx + pair * stepped->dxx,
                                     stepped->dx + across * stepped->dxx,
                                     stepped->dxx,
                                     0,
                                     0,
                                     0};
            if (second != SECOND_NONE) {
                run.u = second_stepped->base + across * second_stepped->dx + pair * second_stepped->dxx;
                run.du = second_stepped->dx + across * second_stepped->dxx;
                run.ddu = second_stepped->dxx;
            }
            run_by(t, d, x, x1, y, &run, second, loop);
        }
        quadric_down(stepped);
        if (second != SECOND_NONE)
            quadric_down(second_stepped);
    }
}

#if FAST_LOOPS
static APART void ramp_rows(const struct tile *t, const struct quadric_setup *q)
{
    rows_by(t, q, SECOND_NONE, LOOP_RAMP);
}

static APART void plain_rows(const struct tile *t, const struct quadric_setup *q)
{
    rows_by(t, q, SECOND_POWER, LOOP_PLAIN);
}
#endif

static APART void any_rows(const struct tile *t, const struct quadric_setup *q, enum second second, enum loop loop)
{
    rows_by(t, q, second, loop);
}

void sheen_quadric_rows(const struct tile *t, const struct setup *s)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;
    const enum second second = (enum second)s->detail;
    const enum loop loop = loop_of(t, s->draw, second);

#if FAST_LOOPS
    if (loop == LOOP_RAMP) {
        ramp_rows(t, q);
        return;
    }
    if (loop == LOOP_PLAIN) {
        plain_rows(t, q);
        return;
    }
#endif
    any_rows(t, q, second, loop);
}

void sheen_shaded_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      const struct shaded_run *run, enum second second)
{
    run_by(t, d, x, x1, y, run, second, loop_of(t, d, second));
}
