/*
 * colour.c - from intensities to the target's channels.
 *
 * A pixel is rounded once, from base * I_ad + highlight * I_s. On 565 the factors of a level carry 9 fraction bits, one
 * less for each doubling of the intensities above 2.
 */
#include "pixel.h"

static uint32_t max_u32(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

/*
 * Grey is y = 0.2126 r + 0.7152 g + 0.0722 b, with weights in UQ0.16 whose sum is exactly 1.0.
 */
COLD void sheen_format_begin(struct pixel_format *format, const struct sheen_target *target)
{
    static const uint32_t weight[3] = {13933, 46871, 4732};
    static const uint8_t level_bits[] = {6, 6, 1, 4, 8};
    const uint16_t probe = 1;
    unsigned little_endian = *(const uint8_t *)&probe;

    format->grey = target->pixel > SHEEN_RGB565_LE;
    format->level_bits = level_bits[target->pixel];
    format->pixel_bits = (uint8_t)sheen_pixel_bits((enum sheen_pixel)target->pixel);
    format->swap = little_endian == (target->pixel == SHEEN_RGB565_BE);
    for (int k = 0; k < 3; k++)
        format->scale[k] = format->grey ? ((1u << format->level_bits) - 1) * weight[k] : (k == 1 ? 63u : 31u) << 16;
}

/* A byte of colour as UQ1.16, 255 = 1.0 exactly, within half a step. */
static APART uint32_t colour_share(uint8_t colour)
{
    return colour * 257u + (colour >> 7);
}

/* The largest factor of a channel; on grey their sum. */
static APART uint32_t most_of(const uint16_t factor[3], unsigned grey)
{
    uint32_t most = 0;

    for (int k = 0; k < 3; k++)
        most = grey ? most + factor[k] : max_u32(most, factor[k]);
    return most;
}

/* The intensity, UQ1.15, with which the factor gives `level`, which has the draw's fraction bits; at most 2047. */
static uint16_t intensity_of(uint32_t level, uint32_t factor)
{
    return (uint16_t)min32((int32_t)QUOTIENT(level, factor + 1), 2047);
}

/* Fills in low and high, unless there is no such range. */
static void diffuse_range(struct colour_terms *t)
{
    const uint32_t margin = 1u << (LOOP_FRACTION - 5);
    uint32_t low = 0, high = 32768;

    for (int k = 0; k < 3; k++) {
        uint32_t a = t->a[k], b = t->b[k], most = t->top[k] - margin;
        if (a > most) {
            return;
        } else if (b > 0) {
            low = max_u32(low, a < margin ? QUOTIENT(margin - a, b) + 1 : 0);
            high = (uint32_t)min32((int32_t)high, (int32_t)QUOTIENT(most - a, b));
        }
    }
    if (low < high) {
        t->low = (uint16_t)low;
        t->high = (uint16_t)high;
    }
}

void sheen_colour_reach(struct colour_terms *t, const struct pixel_format *format)
{
    t->diffuse_tolerance = intensity_of(1u << (t->unit_log2 - 3), most_of(t->b, format->grey));
    t->faint_specular = intensity_of(1u << (t->unit_log2 - 5), most_of(t->c, format->grey));
    t->low = t->high = NO_DIFFUSE_RANGE;
    if (!format->grey && t->fraction == LOOP_FRACTION)
        diffuse_range(t);
}

/*
 * The headroom h is the number of bits by which the brightest sum exceeds 1.0; fraction = 31 - level_bits - h keeps
 * every sum below 2^31, and the factors of UQ1.15 intensities, which have 15 bits less, below 2^16. Range: intensities
 * <= 4 + 4 * 4 + 4 * 4 = 36, with a ramp 52, so h <= 6 and fraction >= 17; scale * colour * intensity is 2^24 * 2^16 *
 * 2^22.
 */
COLD void sheen_colour_begin(struct colour_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                             sheen_q16_t diffuse_sum, sheen_q16_t specular_sum)
{
    static const uint8_t white[3] = {255, 255, 255};
    const int none = (m->highlight[0] | m->highlight[1] | m->highlight[2]) == 0; /* means white */
    const uint8_t *const colour[3] = {m->base, m->base, none ? white : m->highlight};
    const uint32_t intensity[3] = {(uint32_t)m->ambient, intensities(m->diffuse, diffuse_sum),
                                   intensities(m->specular, specular_sum)};
    uint64_t light[3][3]; /* ambient, diffuse, specular, by channel: UQ.32 */
    unsigned headroom = 0;

    for (int k = 0; k < 3; k++) {
        uint32_t most = 0; /* UQ.16 */
        for (int i = 0; i < 3; i++) {
            light[i][k] = ((uint64_t)format->scale[k] * colour_share(colour[i][k]) * intensity[i]) >> 16;
            most += (uint32_t)(light[i][k] >> 16);
        }
        while (most > (format->scale[k] + 256) << headroom) /* 1/256 level above the highest still rounds to it */
            headroom++;
    }
    t->clamp = headroom > 0;
    t->fraction = (uint8_t)(31u - format->level_bits - headroom);
    if (!format->grey && t->fraction > LOOP_FRACTION)
        t->fraction = LOOP_FRACTION;
    const unsigned drop = 32u - t->fraction;
    for (int k = 0; k < 3; k++) {
        t->a[k] = (uint32_t)(light[0][k] >> drop);
        t->b[k] = (uint16_t)(((uint32_t)(light[1][k] >> (drop + 14)) + 1) >> 1);
        t->c[k] = (uint16_t)(((uint32_t)(light[2][k] >> (drop + 14)) + 1) >> 1);
        t->top[k] = format->scale[k] << (16 - drop);
    }
    t->unit_log2 = (uint8_t)(t->fraction + format->level_bits - 6);
}

/*
 * The first of the power table's falling entries with which a specular factor `most` gives less than `faint`.
 * Range: most < 2^16; on grey, times 2^15, the sum is < 2^31.
 */
static uint32_t faint_entry(const struct power *power, uint32_t most, uint32_t faint)
{
    uint32_t low = 0, high = power->table != NULL ? SHEEN_POWER_ENTRIES : 0;

    while (low < high) {
        uint32_t middle = (low + high) / 2;
        if (most * (power->table[middle + 1] >> 16) < faint)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

COLD void sheen_power_end(struct power *power, const struct colour_terms *t, const struct pixel_format *format,
                          unsigned dither)
{
    const uint32_t least = 1u << (t->unit_log2 - 5), most = most_of(t->c, format->grey);
    const unsigned shift = POWER_STEP - 16u - power->up; /* an entry in Q2.13 */

    power->limit = faint_entry(power, most, faint_highlight(least, dither)) << shift << 16;
    power->faint = (uint16_t)(faint_entry(power, most, least) << shift);
}

uint16_t sheen_colour_pixel(const struct pixel_format *format, const uint8_t rgb[3])
{
    uint32_t channel[3], sum = 0; /* UQ8.16 */

    for (int k = 0; k < 3; k++) {
        channel[k] = mul_high(format->scale[k] << 8, colour_share(rgb[k]) << 8) + 0x8000u;
        sum += channel[k];
    }
    if (format->grey)
        return (uint16_t)((sum - 0x10000u) >> 16);
    return pixel_order((channel[0] >> 16) << 11 | (channel[1] >> 16) << 5 | channel[2] >> 16, format->swap);
}

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

/* The thresholds 2 B + 1, B being the 8x8 Bayer matrix built from [[0, 2], [3, 1]]. */
const uint8_t sheen_thresholds[9][8] = {
    {1, 65, 17, 81, 5, 69, 21, 85},       {97, 33, 113, 49, 101, 37, 117, 53},  {25, 89, 9, 73, 29, 93, 13, 77},
    {121, 57, 105, 41, 125, 61, 109, 45}, {7, 71, 23, 87, 3, 67, 19, 83},       {103, 39, 119, 55, 99, 35, 115, 51},
    {31, 95, 15, 79, 27, 91, 11, 75},     {127, 63, 111, 47, 123, 59, 107, 43}, {64, 64, 64, 64, 64, 64, 64, 64},
};

const uint8_t sheen_reversed_thresholds[9][8] = {
    {1, 5, 17, 21, 65, 69, 81, 85},       {7, 3, 23, 19, 71, 67, 87, 83},       {25, 29, 9, 13, 89, 93, 73, 77},
    {31, 27, 15, 11, 95, 91, 79, 75},     {97, 101, 113, 117, 33, 37, 49, 53},  {103, 99, 119, 115, 39, 35, 55, 51},
    {121, 125, 105, 109, 57, 61, 41, 45}, {127, 123, 111, 107, 63, 59, 47, 43}, {64, 64, 64, 64, 64, 64, 64, 64},
};

#define ROW(a, b, c, d, e, f, g, h)                                                                                    \
    THRESHOLD(a), THRESHOLD(b), THRESHOLD(c), THRESHOLD(d), THRESHOLD(e), THRESHOLD(f), THRESHOLD(g), THRESHOLD(h)
#define TWICE(...)                                                                                                     \
    {                                                                                                                  \
        ROW(__VA_ARGS__), ROW(__VA_ARGS__)                                                                             \
    }

const threshold_t sheen_dither_rows[8][16] = {
    TWICE(1, 65, 17, 81, 5, 69, 21, 85),   TWICE(97, 33, 113, 49, 101, 37, 117, 53),
    TWICE(25, 89, 9, 73, 29, 93, 13, 77),  TWICE(121, 57, 105, 41, 125, 61, 109, 45),
    TWICE(7, 71, 23, 87, 3, 67, 19, 83),   TWICE(103, 39, 119, 55, 99, 35, 115, 51),
    TWICE(31, 95, 15, 79, 27, 91, 11, 75), TWICE(127, 63, 111, 47, 123, 59, 107, 43),
};

#if FAST_LOOPS
void sheen_dither_begin(const struct tile *t, const threshold_t *thresholds[8])
{
    uint32_t at = (uint32_t)t->rect.x0 - (uint32_t)((uintptr_t)t->depth >> 1); /* the entry for column 0, modulo 8 */

    for (uint32_t y = (uint32_t)t->rect.y0, end = y + 8; y != end; y++, at -= t->pitch)
        thresholds[y & 7u] = &sheen_dither_rows[y & 7u][at & 7u];
}
#endif

/* From left to right, high bits first; a row ends on a whole byte. Writing never overtakes reading. */
void sheen_pack_grey(const struct pixel_format *format, uint8_t *pixels, unsigned width, unsigned rows)
{
    const unsigned bits = format->pixel_bits;
    const uint8_t *in = pixels;
    uint8_t *out = pixels;

    if (bits == 8)
        return;
    for (unsigned y = 0; y < rows; y++) {
        for (unsigned x = 0; x < width;) {
            unsigned byte = 0;
            for (unsigned filled = 0; filled < 8; filled += bits, x++)
                byte = byte << bits | (x < width ? *in++ : 0u);
            *out++ = (uint8_t)byte;
        }
    }
}

#if !FAST_LOOPS
void sheen_put_clamped(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                       uint32_t r, uint32_t g, uint32_t b)
{
    put_rounded(t, terms, threshold, at, r, g, b, t->format->grey, terms->fraction, t->format->swap);
}
#endif
