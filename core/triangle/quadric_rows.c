/*
 * quadric_rows.c - rows of intensities that are quadratic over a triangle (Bishop and Weimer, "Fast Phong Shading",
 * 1986; here through the corners and the middles of the edges): two additions each per pixel, no root, no quotient.
 *
 * If a highlight may fall on the triangle, 1 - R.V is the second quadric, and the power table is read per pixel.
 * Gouraud's intensities in perspective come the same way. Among draws with shades all loops give the same pixels, and
 * so they do among those without: which one is taken only changes the speed.
 */
#include "quadric_rows.h"

/* On M0+ a highlight's pixel is a function of its own, so that it has all the registers that it needs. */
#if defined(__ARM_ARCH_6M__)
#define PIXEL HOT static APART
#else
#define PIXEL SPECIALISED
#endif

/*
 * As lit_of. On M0+, where a maximum costs three instructions, it is left out if the highlight is whole: L.N is then
 * far from 0.
 */
#if defined(__ARM_ARCH_6M__)
SPECIALISED struct lit power_lit(const struct loop_terms *q, uint32_t f, uint32_t u)
{
    const int32_t light = asr32((int32_t)f, 15);
    const int shines = u < q->power_end;
    struct lit lit = {(uint32_t)light, shines ? power_entry(q->power, u) : 0};

    SHEEN_TAP(HIGHLIGHT, shines);
    if (shines && asr32(light, 12) > 0) /* light >= FADED */
        return lit;
    lit.diffuse = (uint32_t)max32(light, 0);
    if (shines)
        lit.specular = faded(lit.specular, lit.diffuse);
    return lit;
}
#else
SPECIALISED struct lit power_lit(const struct loop_terms *q, uint32_t f, uint32_t u)
{
    return lit_of(q, f, u, SECOND_POWER);
}
#endif

PIXEL uint32_t plain_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, const struct tile *t,
                           const uint16_t *depth)
{
    struct lit lit = power_lit(q, f, u);

    return loop_pixel(t, depth, q, lit.diffuse, u < q->power_end, lit.specular, 0);
}

/* The threshold is loaded last, or on M0+ before a call, so that fewer registers are in use. */
#if defined(__ARM_ARCH_6M__)
HOT static APART uint32_t pixel_by(const struct loop_terms *q, uint32_t f, uint32_t u, uint32_t threshold,
                                   const struct tile *t, const uint16_t *depth)
{
    struct lit lit = power_lit(q, f, u);

    return loop_pixel(t, depth, q, lit.diffuse, u < q->power_end, lit.specular, threshold);
}

SPECIALISED uint32_t dithered_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, const threshold_t *thresholds,
                                    const struct tile *t, const uint16_t *depth)
{
    return pixel_by(q, f, u, threshold_pair(thresholds, depth) << (LOOP_FRACTION - 11), t, depth);
}
#else
SPECIALISED uint32_t dithered_pixel(const struct loop_terms *q, uint32_t f, uint32_t u, const threshold_t *thresholds,
                                    const struct tile *t, const uint16_t *depth)
{
    const unsigned up = LOOP_FRACTION - 11;
    const struct lit lit = power_lit(q, f, u);
    struct loop_channels at = loop_channels(q, lit.diffuse, u < q->power_end, lit.specular);

    (void)t;
    OPAQUE_FIRST(at.b);
    uint32_t pair = threshold_pair(thresholds, depth);
    SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), at.r, at.g, at.b, LOOP_FRACTION);
    at.r += pair << up;
    OPAQUE(pair); /* keeps the shift in the addition */
    at.g += pair << up;
    OPAQUE(pair);
    at.b += pair << up;
    return clamped_565(at.r, at.g, at.b, 0);
}
#endif

/* 565 by the draw's loop terms: pixels from the one after `depth` up to `last`. thresholds: the row's. */
SPECIALISED void quick_run(const struct tile *t, const struct draw *d, uint16_t *depth, const uint16_t *last,
                           const threshold_t *thresholds, const struct shaded_run *run, enum second second,
                           unsigned dither, unsigned swap)
{
    const struct loop_terms *q = &d->loop;
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = run->dz, ddf = run->ddf, ddu = run->ddu;
    uint32_t z = run->z, f = run->f, df = run->df, u = run->u, du = run->du;

    do {
        depth++;
        if (nearer(t, depth, z)) {
            OPAQUE(q); /* its fields are loaded again: the registers are for what is stepped */
            uint32_t value;
            if (second == SECOND_POWER && dither) {
                value = dithered_pixel(q, f, u, thresholds, t, depth);
            } else if (second == SECOND_POWER) {
                value = plain_pixel(q, f, u, t, depth);
            } else {
                struct lit lit = lit_of(q, f, u, second);
                const uint32_t threshold = dither ? threshold_pair(thresholds, depth) << (LOOP_FRACTION - 11) : 0;
                value = loop_pixel(t, depth, q, lit.diffuse, lit.specular != 0, lit.specular, threshold);
            }
            *pixel_at(depth, to_pixel) = pixel_order(value, swap);
        }
        z += dz;
        f += df;
        df += ddf;
        if (second != SECOND_NONE) {
            u += du;
            du += ddu;
        }
    } while (depth != last);
}

/* The colour at f, Q1.30, which is cut to whole steps within its segment. */
SPECIALISED struct packed segment_colour(const struct shade_segment *segments, uint32_t f)
{
    const uint32_t lit = not_negative(f) >> (30 - SEGMENT_BITS - SEGMENT_STEPS_BITS);
    const uint32_t n = lit & ((1u << SEGMENT_STEPS_BITS) - 1);
    const struct shade_segment *at = &segments[lit >> SEGMENT_STEPS_BITS];
    struct packed colour, step;

    OPAQUE_FIRST(at); /* one address for all four loads */
    colour.red_blue = at->red_blue;
    step.red_blue = at->red_blue_step;
    OPAQUE_BOTH(colour.red_blue, step.red_blue); /* two in one load */
#if !defined(__ARM_ARCH_6M__)                    /* on ARMv6-M all four in one */
    colour.red_blue += n * step.red_blue;
    step.red_blue = 0;
    OPAQUE_BOTH(colour.red_blue, at);
#endif
    colour.green = at->green;
    step.green = at->green_step;
    OPAQUE_BOTH(colour.green, step.green);
    return (struct packed){colour.red_blue + n * step.red_blue, colour.green + n * step.green};
}

/* The pixel in a word's high half. As above, the threshold is loaded last, or before a call. */
#if defined(__ARM_ARCH_6M__)
HOT static APART uint32_t segment_by(const struct shade_segment *segments, uint32_t f, uint32_t pair,
                                     const struct tile *t, const uint16_t *depth)
{
    return dithered_high(t, depth, segment_colour(segments, f), pair);
}

SPECIALISED uint32_t segment_pixel(const struct shade_segment *segments, uint32_t f, const threshold_t *thresholds,
                                   const struct tile *t, const uint16_t *depth)
{
    return segment_by(segments, f, threshold_pair(thresholds, depth), t, depth);
}
#else
SPECIALISED uint32_t segment_pixel(const struct shade_segment *segments, uint32_t f, const threshold_t *thresholds,
                                   const struct tile *t, const uint16_t *depth)
{
    struct packed colour = segment_colour(segments, f);

    OPAQUE_FIRST(colour.green);
    return dithered_high(t, depth, colour, threshold_pair(thresholds, depth));
}
#endif

/* The number of the shade for L.N, Q1.30; negative ones become 0. */
SPECIALISED uint32_t shade_at(uint32_t f)
{
#if defined(__ARM_ARCH_6M__)
    int32_t at = asr32((int32_t)f, 30 - SHADES_BITS), sign = asr32(at, 31);

    OPAQUE(sign); /* clearing by the sign saves an instruction */
    return (uint32_t)(at & ~sign);
#else
    return not_negative(f) >> (30 - SHADES_BITS);
#endif
}

/* Pixels from the draw's shades, by L.N alone. */
SPECIALISED void cosine_shades_run(const struct tile *t, const struct shades *shades, uint16_t *depth,
                                   const uint16_t *last, const threshold_t *thresholds, const struct shaded_run *run,
                                   unsigned dither, unsigned swap)
{
    const uint16_t *pixels = shades->pixel + SHADES_GUARD;
    const intptr_t to_pixel = t->to_pixel;
    const uint32_t dz = run->dz, ddf = run->ddf;
    uint32_t z = run->z, f = run->f, df = run->df;

    OPAQUE(pixels); /* the guard is added once, here */
    do {
        depth++;
        if (nearer(t, depth, z))
            *pixel_at(depth, to_pixel) = dither
                                             ? high_order(segment_pixel(shades->segment, f, thresholds, t, depth), swap)
                                             : pixels[shade_at(f)];
        z += dz;
        f += df;
        df += ddf;
    } while (depth != last);
}

#if FAST_LOOPS
/* In the machine's byte order one loop serves plain and dithered pixels. */
HOT static APART void unswapped_power_run(const struct tile *t, const struct draw *d, uint16_t *depth,
                                          const uint16_t *last, const threshold_t *thresholds,
                                          const struct shaded_run *run)
{
    quick_run(t, d, depth, last, thresholds, run, SECOND_POWER, t->dither, 0);
}
#endif

static COLD void general_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                             struct shaded_run *run, unsigned second)
{
    general_loop(t, d, at, x, x1, y, run, (enum second)second, 0, 0);
}

/* 1 if pixels come from the draw's shades: it has some, and there is no highlight. */
static int shades_will_do(const struct draw *d, enum second second)
{
    return second == SECOND_NONE && d->shades != NULL;
}

HOT void sheen_shaded_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                          struct shaded_run *run, enum second second)
{
    const uint32_t at = tile_offset(t, x, y);
    const threshold_t *thresholds = DITHER_ROW(t, t->depth + at - x, y);
    uint16_t *before = t->depth + at - 1, *last = before + (x1 - x);

    if (second == SECOND_NONE)
        run->u = run->du = run->ddu = 0; /* no specular intensity */
    if (shades_will_do(d, second))
        FAST_LOOPS && !t->dither
            ? cosine_shades_run(t, d->shades, before, last, thresholds, run, 0, 0)
            : cosine_shades_run(t, d->shades, before, last, thresholds, run, FAST_LOOPS || t->dither, t->format->swap);
#if FAST_LOOPS
    else if (d->is_565 && d->loop.usable && second == SECOND_POWER && !d->swap)
        unswapped_power_run(t, d, before, last, thresholds, run);
    else if (d->is_565 && d->loop.usable && second == SECOND_POWER)
        t->dither ? quick_run(t, d, before, last, thresholds, run, SECOND_POWER, 1, 1)
                  : quick_run(t, d, before, last, thresholds, run, SECOND_POWER, 0, 1);
#endif
    else
        (d->fog          ? d->fog->mixer->shaded_run
         : d->pixel_ramp ? d->light.ramp->reader->shaded_run
                         : general_run)(t, d, at, x, x1, y, run, second);
}

#if FAST_LOOPS
/* What is stepped per row, at column 0: the depth before it, z and the quadrics; and what runs need besides. */
struct row_walk {
    uint16_t *line;
    uint32_t z, dx, dy;
    const struct draw *draw;
    struct quadric f, u;
};

SPECIALISED void own_rows(const struct tile *t, const struct setup *s, enum second second, unsigned dither)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;
    const struct span *span = t->spans, *end = span + t->rows;
    int32_t y = t->first_row;
    struct row_walk walk;

    walk.line = t->depth + (y - t->rect.y0) * (int32_t)t->pitch - t->rect.x0 - 1;
    walk.z = plane_at(&s->depth, 0, y);
    walk.dx = s->depth.dx;
    walk.dy = s->depth.dy;
    walk.draw = s->draw;
    sheen_quadric_from(&walk.f, &q->diffuse, -q->x, y - q->y);
    if (second != SECOND_NONE)
        sheen_quadric_from(&walk.u, &q->second, -q->x, y - q->y);
    do {
        const int32_t x = span->x0, x1 = span->x1;
        struct row_walk *at = &walk;
        OPAQUE(at); /* it stays in memory, because the pixel loop needs all registers */
        if (x < x1) {
            const threshold_t *thresholds = dither ? t->dither_rows[y & 7] : NULL;
            uint16_t *line = at->line;
            uint32_t z = at->z, dx = at->dx;
            OPAQUE_BOTH(line, z);
            struct shaded_run run = {z + (uint32_t)x * dx, dx, 0, 0, 0, 0, 0, 0};
            quadric_run(&at->f, x, &run.f, &run.df, &run.ddf);
            if (second != SECOND_NONE) {
                quadric_run(&at->u, x, &run.u, &run.du, &run.ddu);
                quick_run(t, at->draw, line + x, line + x1, thresholds, &run, second, dither, 1);
            } else {
                cosine_shades_run(t, at->draw->shades, line + x, line + x1, thresholds, &run, dither, 1);
            }
        }
        at = &walk;
        OPAQUE(at);
        at->line += t->pitch;
        at->z += at->dy;
        quadric_down(&at->f);
        if (second != SECOND_NONE)
            quadric_down(&at->u);
        y++;
        span++;
        OPAQUE(span);
    } while (span != end);
}

HOT static void plain_shades_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_NONE, 0);
}

HOT static void plain_power_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_POWER, 0);
}

HOT static void dithered_shades_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_NONE, 1);
}

HOT static void dithered_power_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_POWER, 1);
}

HOT static void plain_specular_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_SPECULAR, 0);
}

HOT static void dithered_specular_rows(const struct tile *t, const struct setup *s)
{
    own_rows(t, s, SECOND_SPECULAR, 1);
}
#endif

/* Specialised loops are for the byte order of a panel's bus only. */
HOT void sheen_take_quadric_rows(struct setup *s, const struct gradients *g, enum second second)
{
    struct quadric_setup *q = (struct quadric_setup *)s;

    q->x = (int16_t)g->origin[0];
    q->y = (int16_t)g->origin[1];
    s->detail = (uint8_t)second;
    s->rows = sheen_quadric_rows;
#if FAST_LOOPS
    const struct draw *d = s->draw;
    if (d->swap && shades_will_do(d, second))
        s->rows = d->dither ? dithered_shades_rows : plain_shades_rows;
    else if (d->swap && d->is_565 && d->loop.usable && second == SECOND_POWER)
        s->rows = d->dither ? dithered_power_rows : plain_power_rows;
    else if (d->swap && d->is_565 && d->loop.usable && second == SECOND_SPECULAR)
        s->rows = d->dither ? dithered_specular_rows : plain_specular_rows;
#endif
}
