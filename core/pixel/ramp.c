/*
 * ramp.c - finished pixels over the diffuse intensity, for what lies outside the highlight.
 */
#include <string.h>

#include "pixel.h"

/* Of an entry's middle: channels as colour_channel has them, clamped and rounded. */
static uint16_t ramp_pixel(const struct colour_terms *t, uint32_t diffuse)
{
    const uint32_t half = 1u << (t->fraction - 1);
    uint32_t level[3];

    for (int k = 0; k < 3; k++) {
        uint32_t channel = t->a[k] + t->b[k] * diffuse;
        level[k] = ((channel < t->top[k] ? channel : t->top[k]) + half) >> t->fraction;
    }
    return (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
}

int sheen_ramp_is_of(const struct ramp *ramp, const struct colour_terms *t)
{
    return ramp->fraction == t->fraction && memcmp(ramp->a, t->a, sizeof t->a) == 0 &&
           memcmp(ramp->b, t->b, sizeof t->b) == 0;
}

void sheen_ramp_make(struct ramp *ramp, const struct colour_terms *t, const struct pixel_format *format)
{
    for (int i = 0; i < RAMP_PIXELS; i++) {
        int32_t middle = (i - RAMP_GUARD) * (1 << (15 - RAMP_BITS)) + (1 << (14 - RAMP_BITS));
        uint32_t diffuse = (uint32_t)min32(max32(middle, 0), 1 << 15);
        ramp->pixel[i] = pixel_order(ramp_pixel(t, diffuse), format->swap);
    }
    memcpy(ramp->a, t->a, sizeof t->a);
    memcpy(ramp->b, t->b, sizeof t->b);
    ramp->fraction = t->fraction;
}
