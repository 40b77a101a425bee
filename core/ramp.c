/*
 * ramp.c - materials: the power table, and intensities to channels of the target.
 *
 * A pixel is rounded once, from base * I_ad + highlight * I_s with at least 9
 * fraction bits a level.
 */
#include "stages.h"

/* a * b for UQ0.32 factors, 1.0 held as 0xffffffff. */
static uint32_t multiply(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b + a + b) >> 32);
}

/* s^n by repeated squaring, UQ0.32; error below n * 2^-32. */
static uint32_t power_of(uint32_t s, unsigned n)
{
    uint32_t result = UINT32_MAX;

    for (; n > 0; n >>= 1) {
        if ((n & 1u) != 0)
            result = multiply(result, s);
        s = multiply(s, s);
    }
    return result;
}

static int in_range(sheen_q16_t x)
{
    return x >= 0 && x <= 4 << 16;
}

/*
 * The table spans u = 1 - s from 0 to 2^-shift, the smallest power of two below
 * which s^n stays under 2^-16. Linear between entries it is off by at most
 * (n / 256 / 2^shift)^2 / 8 = 5e-4 of the highlight.
 */
int sheen_material_prepare(struct sheen_material *m)
{
    if (!in_range(m->ambient) || !in_range(m->diffuse) || !in_range(m->specular) || m->shininess < 1 ||
        m->shininess > 128)
        return SHEEN_ERR_ARGUMENT;

    unsigned shift = 0;
    while (shift < 3 && power_of(UINT32_MAX - (UINT32_MAX >> (shift + 1)), m->shininess) < 1u << 16)
        shift++;
    m->power_shift = (uint8_t)shift;
    for (uint32_t i = 0; i < SHEEN_POWER_ENTRIES; i++) {
        uint32_t power = power_of(UINT32_MAX - (i << (24 - shift)), m->shininess);
        m->power[i] = (uint16_t)(power >= 0xffff8000u ? 0xffffu : (power + 0x8000u) >> 16);
    }
    m->power[SHEEN_POWER_ENTRIES] = 0;
    return SHEEN_OK;
}

/* levels * colour / 255 * intensity, UQ.25. Range: 63 * 255 * 2^20 * 2^9 < 2^44. */
static uint64_t levels(int k, uint8_t colour, uint64_t intensity)
{
    return ((top_level(k) * colour * intensity << 9) + 127) / 255;
}

/*
 * The headroom h is the number of bits by which the brightest sum exceeds the
 * highest level; fraction = 25 - h keeps every sum below 2^31, and the factors
 * of UQ1.15 intensities, with 15 bits less, below 2^16.
 * Range: intensities <= 4 + 4 * 4 + 4 * 4 = 36, so h <= 6 and fraction >= 19.
 */
void sheen_colour_begin(struct colour_terms *t, const struct sheen_material *m, const struct lighting *l)
{
    uint64_t a[3], b[3], c[3];
    unsigned headroom = 0;

    t->clamp = 0;
    for (int k = 0; k < 3; k++) {
        a[k] = levels(k, m->base[k], (uint64_t)m->ambient);
        b[k] = levels(k, m->base[k], ((uint64_t)m->diffuse * (uint64_t)l->diffuse_sum) >> 16);
        c[k] = levels(k, m->highlight[k], ((uint64_t)m->specular * (uint64_t)l->specular_sum) >> 16);
        uint64_t most = a[k] + b[k] + c[k], top = ((uint64_t)top_level(k) << 25) + (1u << 17);
        t->clamp |= most > top; /* 1/256 level above the highest still rounds to it */
        while (most > top << headroom)
            headroom++;
    }
    t->fraction = (uint8_t)(25 - headroom);
    for (int k = 0; k < 3; k++) {
        t->a[k] = (uint32_t)(a[k] >> headroom);
        t->b[k] = (uint16_t)((b[k] + (1u << (14 + headroom))) >> (15 + headroom));
        t->c[k] = (uint16_t)((c[k] + (1u << (14 + headroom))) >> (15 + headroom));
    }
}

unsigned sheen_swapped(const struct sheen_target *target)
{
    const uint16_t probe = 1;
    unsigned little = *(const uint8_t *)&probe;

    return little == (target->pixel == SHEEN_RGB565_BE);
}

/* One rounding: floor(level + 1/2), held at the highest level. */
uint16_t sheen_colour_pixel(const uint32_t channel[3], unsigned fraction, unsigned swap)
{
    uint32_t level[3];

    for (int k = 0; k < 3; k++) {
        level[k] = (channel[k] + (1u << (fraction - 1))) >> fraction;
        if (level[k] > top_level(k))
            level[k] = top_level(k);
    }
    return pixel_order(level[0] << 11 | level[1] << 5 | level[2], swap);
}

uint16_t sheen_colour_bytes(const uint8_t rgb[3], unsigned swap)
{
    const uint32_t channel[3] = {(rgb[0] * 31u << 16) / 255, (rgb[1] * 63u << 16) / 255, (rgb[2] * 31u << 16) / 255};

    return sheen_colour_pixel(channel, 16, swap);
}
