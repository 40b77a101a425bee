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

static void any_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step)
{
    const uint8_t *threshold = threshold_row(r->t->dither, r->y);
    uint32_t offset = (uint32_t)(r->depth - r->t->depth), x = (uint32_t)r->x, end = x + (uint32_t)r->count;

    for (; x != end; x++, offset++) {
        any_pixel(r, offset, threshold[x & 7u], &at);
        step_on(&at, step);
    }
}

/* ---- nearest texels of 565 that repeat ---- */

/* Light of 1.0 at the most, so that no channel leaves its place in the texel; threshold in 1/128. */
SPECIALISED uint32_t lit_texel(uint32_t texel, uint32_t light, uint32_t threshold)
{
    const unsigned up = LIGHT_BITS - 7;
    uint32_t r = (texel & 0xf800u) * light + (threshold << (up + 11));
    uint32_t g = (texel & 0x07e0u) * light + (threshold << (up + 5)), b = (texel & 31u) * light + (threshold << up);

    return (r >> LIGHT_BITS & 0xf800u) | (g >> LIGHT_BITS & 0x07e0u) | b >> LIGHT_BITS;
}

/* u and v, times the width, are masked to the texel's bytes. */
SPECIALISED void nearest_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step, unsigned lit,
                             unsigned dither, unsigned swap)
{
    const struct sheen_texture *t = r->d->texel.texture;
    const uint8_t *texels = t->texels, *threshold = threshold_row(dither, r->y);
    const unsigned width = t->width_log2;
    const uint32_t columns = ((1u << width) - 1) << 1, rows = ((1u << t->height_log2) - 1) << (width + 1);
    const uint32_t dz = step->z, du = step->u, dv = step->v << width, dlight = step->light;
    const intptr_t to_pixel = r->t->to_pixel;
    uint16_t *depth = r->depth, *end = depth + r->count;
    uint32_t z = at.z, u = at.u, v = at.v << width, light = at.light, x = (uint32_t)r->x;

    do {
        if (nearer(r->t, depth, z)) {
            uint32_t texel = *(const uint16_t *)(const void *)(texels + ((u >> 15 & columns) | (v >> 15 & rows)));
            if (lit)
                texel = lit_texel(texel, light >> (LIGHT_PLANE_BITS - LIGHT_BITS), dither ? threshold[x & 7u] : 64);
            *pixel_at(depth, to_pixel) = pixel_order(texel, swap);
        }
        z += dz;
        u += du;
        v += dv;
        light += dlight;
        x++;
    } while (++depth != end);
}

SPECIALISED void nearest_as(const struct texel_run *r, struct texel_at at, const struct texel_at *step, unsigned lit,
                            unsigned dither)
{
    r->t->format->swap ? nearest_run(r, at, step, lit, dither, 1) : nearest_run(r, at, step, lit, dither, 0);
}

void sheen_textured_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step)
{
    if (!FAST_LOOPS || r->pixels == TEXTURED_ANY)
        any_run(r, at, step);
    else if (r->pixels == TEXTURED_UNLIT)
        nearest_as(r, at, step, 0, 0);
    else
        r->t->dither ? nearest_as(r, at, step, 1, 1) : nearest_as(r, at, step, 1, 0);
}
