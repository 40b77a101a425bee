/*
 * ramp.c - finished pixels over the diffuse intensity, for what lies outside the highlight.
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

int sheen_ramp_is_of(const struct ramp *ramp, const struct colour_terms *t)
{
    int same = ramp->fraction == t->fraction;

    for (int k = 0; k < 3; k++)
        same &= ramp->a[k] == t->a[k] && ramp->b[k] == t->b[k];
    return same;
}

void sheen_ramp_make(struct ramp *ramp, const struct colour_terms *t, const struct pixel_format *format)
{
    SHEEN_TAP(RAMP_MADE, 1);
    for (int i = 0; i < RAMP_PIXELS; i++) {
        int32_t middle = (i - RAMP_GUARD) * (1 << (15 - RAMP_BITS)) + (1 << (14 - RAMP_BITS));
        uint32_t diffuse = (uint32_t)min32(max32(middle, 0), 1 << 15);
        uint32_t channel[3];
        for (int k = 0; k < 3; k++)
            channel[k] = clamped(t->a[k] + t->b[k] * diffuse, t->top[k]);
        ramp->pixel[i] = sheen_finished(t, 1, format->swap, channel);
    }
    memcpy(ramp->a, t->a, sizeof t->a);
    memcpy(ramp->b, t->b, sizeof t->b);
    ramp->fraction = t->fraction;
}
