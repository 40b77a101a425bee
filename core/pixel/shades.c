/*
 * shades.c - outside the highlight: finished pixels over the diffuse intensity, or channels that are to be dithered.
 */
#include <string.h>

#include "pixel.h"

uint16_t sheen_finished(const struct colour_terms *t, unsigned is_565, unsigned swap, const uint32_t channel[3])
{
    const unsigned fraction = t->fraction;
    const uint32_t half = 1u << (fraction - 1);

    if (!is_565)
        return (uint16_t)((channel[0] + channel[1] + channel[2] + half) >> fraction);
    return pixel_order(((channel[0] + half) >> fraction) << 11 | ((channel[1] + half) >> fraction) << 5 |
                           (channel[2] + half) >> fraction,
                       swap);
}

static int shades_is_of(const struct shades *shades, const struct colour_terms *t, unsigned dither)
{
    int same = shades->fraction == t->fraction && shades->dither == dither;

    for (int k = 0; k < 3; k++)
        same &= shades->a[k] == t->a[k] && shades->b[k] == t->b[k];
    return same;
}

/* Levels at an intensity, UQ1.15. */
static uint32_t shade_of(const struct colour_terms *t, int k, uint32_t diffuse)
{
    return clamped(t->a[k] + t->b[k] * (diffuse < 32768 ? diffuse : 32768), t->top[k]);
}

/*
 * A channel with `bits` fraction bits where a segment begins and half a step on, as what an intensity has more than its
 * step is cut; and its step.
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

static int shades_fit(const struct colour_terms *t, unsigned dither)
{
    const uint32_t little = 1u << (t->fraction - 8);
    int fit = 1;

    for (int k = 0; k < 3; k++)
        fit &= t->a[k] + t->b[k] * 32768u <= t->top[k] + little;
    return fit || !dither;
}

static void shades_make(struct shades *shades, const struct colour_terms *t, const struct pixel_format *format,
                        unsigned dither)
{
    SHEEN_TAP(SHADES_MADE, 1);
    if (dither)
        make_segments(shades, t);
    else
        make_pixels(shades, t, format->swap);
    memcpy(shades->a, t->a, sizeof t->a);
    memcpy(shades->b, t->b, sizeof t->b);
    shades->fraction = t->fraction;
    shades->dither = (uint8_t)dither;
}

const struct shades_maker sheen_shades_maker = {shades_fit, shades_is_of, shades_make};
