/*
 * textured_rows.c - texels in the place of a base colour.
 */
#include "textured.h"

SPECIALISED void step_on(struct texel_at *at, const struct texel_at *step)
{
    at->z += step->z;
    at->u += step->u;
    at->v += step->v;
    at->light += step->light;
    at->specular += step->specular;
}

/* ---- any texture, light and target ---- */

/* 0..mask: held there, or what is left of a division. */
SPECIALISED uint32_t address(int32_t i, unsigned size_log2, unsigned clamp)
{
    const int32_t most = (1 << size_log2) - 1;

    return (uint32_t)(clamp ? max32(0, min32(i, most)) : i & most);
}

/* The texel that holds (i, j), 565. */
SPECIALISED uint32_t texel_value(const struct sheen_texture *t, int32_t i, int32_t j)
{
    uint32_t n = address(j, t->height_log2, t->clamp_v) << t->width_log2 | address(i, t->width_log2, t->clamp_u);

    if (t->bits == 8)
        return t->palette[((const uint8_t *)t->texels)[n]];
    if (t->bits == 4)
        return t->palette[(uint32_t)((const uint8_t *)t->texels)[n >> 1] >> (4 * (n & 1u)) & 15u];
    return ((const uint16_t *)t->texels)[n];
}

/* Channels in 1/32 level: red and blue in one word, 2^16 red + blue, and green. */
struct filtered {
    uint32_t red_blue, green;
};

SPECIALISED void add_texel(struct filtered *sum, uint32_t texel, uint32_t share)
{
    sum->red_blue += ((texel >> 11) << 16 | (texel & 31u)) * share;
    sum->green += (texel >> 5 & 63u) * share;
}

/* The four texels about (u, v) by shares of 1/32; those that are transparent count as `nearest`. */
SPECIALISED void bilinear(const struct sheen_texture *t, const struct texel_at *at, uint32_t nearest,
                          struct filtered *sum)
{
    const int32_t u = (int32_t)(at->u - 0x8000u + 0x400u), v = (int32_t)(at->v - 0x8000u + 0x400u);
    const uint32_t a = (uint32_t)u >> 11 & 31u, b = (uint32_t)v >> 11 & 31u, both = (a * b + 16) >> 5;
    const uint32_t share[4] = {32 - a - b + both, a - both, b - both, both};

    for (int k = 0; k < 4; k++) {
        uint32_t texel = texel_value(t, asr32(u, 16) + (k & 1), asr32(v, 16) + (k >> 1));
        add_texel(sum, t->keyed && texel == t->key ? nearest : texel, share[k]);
    }
}

/* Light of channel k with LIGHT_BITS. */
SPECIALISED uint32_t channel_light(const struct texel_terms *terms, const struct texel_at *at, int k)
{
    if (terms->alike)
        return at->light >> (LIGHT_PLANE_BITS - LIGHT_BITS);
    const int32_t diffuse = asr32((int32_t)at->light, 15);
    const uint32_t half = 1u << (terms->fraction - LIGHT_BITS - 1);
    return (terms->a[k] + half + (uint32_t)(terms->b[k] * diffuse)) >> (terms->fraction - LIGHT_BITS);
}

/* The one rounding of channels in levels of 565, LIGHT_BITS of fraction; threshold in 1/128. */
SPECIALISED void put_texel(const struct texel_run *r, uint32_t at, const uint32_t channel[3], uint32_t threshold)
{
    const struct pixel_format *format = r->t->format;
    const uint16_t *grey = r->d->texel.grey;
    const unsigned fraction = 31u - format->level_bits;

    if (format->grey) {
        uint32_t level = 0;
        for (int k = 0; k < 3; k++)
            level += (channel[k] >> (LIGHT_BITS - GREY_BITS)) * grey[k];
        level = clamped(level, ((1u << format->level_bits) - 1) << fraction) + (threshold << (fraction - 7));
        ((uint8_t *)r->t->pixels)[at] = (uint8_t)(level >> fraction);
        return;
    }
    threshold <<= LIGHT_BITS - 7;
    ((uint16_t *)r->t->pixels)[at] =
        pixel_order((channel[0] + threshold) >> LIGHT_BITS << 11 | (channel[1] + threshold) >> LIGHT_BITS << 5 |
                        (channel[2] + threshold) >> LIGHT_BITS,
                    format->swap);
}

SPECIALISED void any_pixel(const struct texel_run *r, uint32_t offset, uint32_t threshold, const struct texel_at *at)
{
    static const uint32_t top[3] = {31u << LIGHT_BITS, 63u << LIGHT_BITS, 31u << LIGHT_BITS};
    const struct texel_terms *terms = &r->d->texel;
    const struct sheen_texture *t = terms->texture;
    const uint32_t specular = not_negative(at->specular) >> 15;
    struct filtered sum = {0, 0};
    uint32_t channel[3], nearest = texel_value(t, asr32((int32_t)at->u, 16), asr32((int32_t)at->v, 16));

    if (at->z >> 16 <= r->t->depth[offset] || (t->keyed && nearest == t->key) ||
        !nearer(r->t, r->t->depth + offset, at->z))
        return;
    if (t->bilinear)
        bilinear(t, at, nearest, &sum);
    else
        add_texel(&sum, nearest, 32);
    channel[0] = sum.red_blue >> 16;
    channel[1] = sum.green;
    channel[2] = sum.red_blue & 0xffffu;
    for (int k = 0; k < 3; k++)
        channel[k] = clamped(
            (channel[k] * channel_light(terms, at, k) >> 5) + (terms->c[k] * specular >> terms->c_shift), top[k]);
    put_texel(r, offset, channel, threshold);
}

void sheen_textured_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step)
{
    const uint8_t *threshold = threshold_row(r->t->dither, r->y);
    uint32_t offset = (uint32_t)(r->depth - r->t->depth), x = (uint32_t)r->x, end = x + (uint32_t)r->count;

    for (; x != end; x++, offset++) {
        any_pixel(r, offset, threshold[x & 7u], &at);
        step_on(&at, step);
    }
}
