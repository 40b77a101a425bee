/*
 * shades.c - what is prepared for the pixel loops: colour terms in the order in which loops load them; and shades,
 * which are a table over the diffuse intensity, outside the highlight, of finished pixels or of channels still to be
 * dithered.
 */
#include <string.h>

#include "triangle.h"

static int is_of(const struct shades *shades, const struct colour_terms *t, unsigned dither)
{
    int same = shades->fraction == t->fraction && shades->dither == dither;

    for (int k = 0; k < 3; k++)
        same &= shades->a[k] == t->a[k] && shades->b[k] == t->b[k];
    return same;
}

/* A channel, in levels, at a diffuse intensity, UQ1.15. */
static uint32_t shade_of(const struct colour_terms *t, int k, uint32_t diffuse)
{
    return clamped(t->a[k] + t->b[k] * (diffuse < 32768 ? diffuse : 32768), t->top[k]);
}

/*
 * *at: a channel with `bits` fraction bits, half a step after the segment begins, because intensities are cut to whole
 * steps; *step: what each step adds.
 */
static void segment_of(const struct colour_terms *t, int k, uint32_t diffuse, unsigned bits, uint32_t *at,
                       uint32_t *step)
{
    const uint32_t begin = shade_of(t, k, diffuse),
                   more = shade_of(t, k, diffuse + (1u << (15 - SEGMENT_BITS))) - begin;

    const unsigned down = t->fraction + SEGMENT_STEPS_BITS;

    *step = (uint32_t)((((uint64_t)more << bits) + (1u << (down - 1))) >> down);
    *at = (uint32_t)((uint64_t)(begin + (more >> (SEGMENT_STEPS_BITS + 1))) << bits >> t->fraction);
}

static COLD void make_segments(struct shades *shades, const struct colour_terms *t)
{
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        struct shade_segment *s = &shades->segment[i];
        const uint32_t diffuse = i << (15 - SEGMENT_BITS);
        uint32_t at, step;
        segment_of(t, 1, diffuse, 26, &s->green, &s->green_step);
        segment_of(t, 2, diffuse, 11, &at, &step);
        segment_of(t, 0, diffuse, 11, &s->red_blue, &s->red_blue_step);
        s->red_blue = (s->red_blue << 16) + at;
        s->red_blue_step = (s->red_blue_step << 16) + step;
    }
}

static COLD void make_pixels(struct shades *shades, const struct colour_terms *t, unsigned swap)
{
    for (int i = 0; i < SHADES_PIXELS; i++) {
        int32_t middle = (i - SHADES_GUARD) * (1 << (15 - SHADES_BITS)) + (1 << (14 - SHADES_BITS));
        uint32_t channel[3];
        for (int k = 0; k < 3; k++)
            channel[k] = shade_of(t, k, (uint32_t)max32(middle, 0));
        shades->pixel[i] = sheen_finished(t, 1, swap, channel);
    }
}

/* 1 if these colours can have shades: dithered ones need channels that are linear from end to end, not clamped. */
static int fit(const struct colour_terms *t, unsigned dither)
{
    const uint32_t little = 1u << (t->fraction - 8);
    int fit = 1;

    for (int k = 0; k < 3; k++)
        fit &= t->a[k] + t->b[k] * 32768u <= t->top[k] + little;
    return fit || !dither;
}

static void make(struct shades *shades, const struct colour_terms *t, unsigned swap, unsigned dither)
{
    SHEEN_TAP(SHADES_MADE, 1);
    if (dither)
        make_segments(shades, t);
    else
        make_pixels(shades, t, swap);
    memcpy(shades->a, t->a, sizeof t->a);
    memcpy(shades->b, t->b, sizeof t->b);
    shades->fraction = t->fraction;
    shades->dither = (uint8_t)dither;
}

COLD void sheen_loop_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                           const struct sheen_object *object, const struct sheen_pose *view)
{
    const struct colour_terms *t = &d->colour;
    const struct power *power = &d->power;
    const uint32_t half = d->dither ? 0 : 1u << (t->fraction - 1);
    struct loop_terms *q = &d->loop;

    (void)material;
    (void)format;
    (void)object;
    (void)view;
    for (int k = 0; k < 3; k++) {
        q->ab[2 * k] = t->a[k] + half;
        q->ab[2 * k + 1] = t->b[k];
        q->c[k] = t->c[k];
    }
    q->power_end = power->limit > 0 ? (power->limit << power->up) + POWER_GUARD : 0;
    q->power = power->table;
    q->usable = d->is_565 && t->fraction == LOOP_FRACTION && !d->pixel_ramp; /* these loops read no ramp */
}

COLD const struct shades *sheen_shades_of(const struct draw *d, struct shades *store, unsigned count, unsigned *taken)
{
    const struct colour_terms *terms = &d->colour;

    /* where a ramp makes areas of one colour, 1024 shades are too coarse */
    if (!d->is_565 || d->light.ramp != NULL || !fit(terms, d->dither))
        return NULL;
    for (unsigned i = 0; i < count; i++) {
        struct shades *s = &store[i];
        const int found = is_of(s, terms, d->dither); /* the first free one often matches, left from the last frame */
        if (i < *taken && !found)
            continue;
        if (!found)
            make(s, terms, d->swap, d->dither);
        *taken += i == *taken;
        return s;
    }
    return NULL;
}
