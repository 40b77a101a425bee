/*
 * shades.c - finished pixels over the diffuse intensity, for what lies outside the highlight.
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

static int shades_is_of(const struct shades *shades, const struct colour_terms *t)
{
    int same = shades->fraction == t->fraction;

    for (int k = 0; k < 3; k++)
        same &= shades->a[k] == t->a[k] && shades->b[k] == t->b[k];
    return same;
}

static void shades_make(struct shades *shades, const struct colour_terms *t, const struct pixel_format *format)
{
    SHEEN_TAP(SHADES_MADE, 1);
    for (int i = 0; i < SHADES_PIXELS; i++) {
        int32_t middle = (i - SHADES_GUARD) * (1 << (15 - SHADES_BITS)) + (1 << (14 - SHADES_BITS));
        uint32_t diffuse = (uint32_t)min32(max32(middle, 0), 1 << 15);
        uint32_t channel[3];
        for (int k = 0; k < 3; k++)
            channel[k] = clamped(t->a[k] + t->b[k] * diffuse, t->top[k]);
        shades->pixel[i] = sheen_finished(t, 1, format->swap, channel);
    }
    memcpy(shades->a, t->a, sizeof t->a);
    memcpy(shades->b, t->b, sizeof t->b);
    shades->fraction = t->fraction;
}

const struct shades_maker sheen_shades_maker = {shades_is_of, shades_make};
