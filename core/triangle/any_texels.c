/*
 * any_texels.c - runs of any texture, under any light and fog, on any target.
 */
#include "fog.h"
#include "texel_steps.h"

/* The light on channel k, with `fraction` bits. */
SPECIALISED uint32_t channel_light(const struct texel_terms *terms, uint32_t light, int k, unsigned fraction)
{
    if (terms->alike)
        return light >> (LIGHT_BITS - fraction);
    return (terms->a[k] + terms->b[k] * (light >> (LIGHT_BITS - 15))) >> (terms->fraction - fraction);
}

SPECIALISED uint32_t channel_highlight(const struct texel_terms *terms, uint32_t specular, int k, unsigned fraction)
{
    if (terms->white)
        return (k == 1 ? 63 : 31) * (specular >> (LIGHT_BITS - fraction));
    return terms->c[k] * (specular >> (LIGHT_BITS - 15)) >> terms->c_shift;
}

/* The one rounding of channels in levels of 565; threshold in 1/128. */
SPECIALISED void put_texel(const struct texel_run *r, uint32_t at, const uint32_t channel[3], uint32_t threshold,
                           unsigned fraction)
{
    const struct pixel_format *format = r->t->format;
    const uint16_t *grey = r->d->texel.grey;
    const unsigned grey_fraction = 31u - format->level_bits;

    if (format->grey) {
        uint32_t level = 0;
        for (int k = 0; k < 3; k++)
            level += (channel[k] >> (fraction - GREY_BITS)) * grey[k];
        level = clamped(level, ((1u << format->level_bits) - 1) << grey_fraction) + (threshold << (grey_fraction - 7));
        ((uint8_t *)r->t->pixels)[at] = (uint8_t)(level >> grey_fraction);
        return;
    }
    threshold <<= fraction - 7;
    ((uint16_t *)r->t->pixels)[at] =
        pixel_order((channel[0] + threshold) >> fraction << 11 | (channel[1] + threshold) >> fraction << 5 |
                        (channel[2] + threshold) >> fraction,
                    format->swap);
}

SPECIALISED void put_fogged_texel(const struct texel_run *r, uint32_t at, uint32_t z, const uint32_t channel[3],
                                  uint32_t threshold, unsigned fraction)
{
    const struct pixel_format *format = r->t->format;
    const uint16_t *grey = r->d->texel.grey;

    if (format->grey) {
        uint32_t level = 0, most = ((1u << format->level_bits) - 1) << (31u - format->level_bits);
        for (int k = 0; k < 3; k++)
            level += (channel[k] >> (fraction - GREY_BITS)) * grey[k];
        put_fogged(r->t, r->d->fog, at, z, clamped(level, most) >> 15, 0, 0, threshold, 1);
        return;
    }
    put_fogged(r->t, r->d->fog, at, z, channel[0] >> (fraction - 10), channel[1] >> (fraction - 10),
               channel[2] >> (fraction - 10), threshold, 0);
}

/* A channel, in 1/32 level, times light. If light may exceed 1.0, 4 of its bits are cut so that the product fits. */
SPECIALISED uint32_t under_light(const struct texel_run *r, uint32_t channel, uint32_t light)
{
    if (r->special_loop == TEXTURED_ANY)
        return channel * ((light + 8) >> 4) >> 1;
    return r->d->texel.texture->bilinear ? channel * (light >> 5) : (channel >> 5) * light;
}

/* Draws a pixel: its texel is `nearest`, or bilinear a mix of the four around (u, v). */
SPLIT void any_colour(const struct texel_run *r, uint32_t offset, uint32_t threshold, const struct texel_at *at,
                      uint32_t nearest, int is_fogged)
{
    const struct texel_terms *terms = &r->d->texel;
    const unsigned fraction = r->special_loop == TEXTURED_ANY ? BRIGHT_BITS : LIGHT_BITS;
    const uint32_t sum =
        terms->texture->bilinear ? any_mixed(terms->texture, at->u, at->v, nearest) : spread(nearest) << 5;
    const uint32_t light = not_negative(at->light), specular = not_negative(at->specular);
    uint32_t channel[3] = {sum >> 11 & 1023u, sum >> 21, sum & 1023u};

    for (int k = 0; k < 3; k++)
        channel[k] = clamped(under_light(r, channel[k], channel_light(terms, light, k, fraction)) +
                                 channel_highlight(terms, specular, k, fraction),
                             (k == 1 ? 63u : 31u) << fraction);
    if (is_fogged)
        put_fogged_texel(r, offset, at->z, channel, threshold, fraction);
    else
        put_texel(r, offset, channel, threshold, fraction);
}

SPLIT void any_loop(const struct texel_run *r, const struct texel_at *from, int is_fogged)
{
    const struct texel_terms *terms = &r->d->texel;
    const struct sheen_texture *t = terms->texture;
    const unsigned width = t->width_log2;
    const uint8_t *threshold = threshold_row(r->t, r->t->dither, r->y);
    const uint32_t middle = t->bilinear ? TO_MIDDLE : 0;
    struct texel_at at = {from->z, from->u + middle, from->v + middle, from->light, from->specular};
    uint32_t offset = (uint32_t)(r->depth - r->t->depth), x = (uint32_t)r->x, packed = packed_at(&at, width);

    for (int32_t i = 1; i <= r->count; i++, x++, offset++) {
        if (terms->uv_packed) {
            at.u = packed << (16 - PACKED_BITS);
            at.v = packed >> (PACKED_BITS + width) << (16 - PACKED_BITS);
        }
        uint32_t nearest = texel_value(t, asr32((int32_t)(at.u - middle), 16), asr32((int32_t)(at.v - middle), 16));
        if (at.z >> 16 > r->t->depth[offset] && !(t->keyed && nearest == t->key)) {
            (void)nearer(r->t, r->t->depth + offset, at.z);
            any_colour(r, offset, threshold[x & 7u], &at, nearest, is_fogged);
        }
        at.z += r->step.z;
        at.u += r->step.u;
        at.v += r->step.v;
        at.light += r->step.light;
        at.specular += r->step.specular;
        packed += r->packed_step + (i % TEXEL_PART == 0 ? r->mend : 0);
    }
}

void sheen_any_texels(const struct texel_run *r, const struct texel_at *from)
{
    any_loop(r, from, 0);
}

void sheen_fogged_any_texels(const struct texel_run *r, const struct texel_at *from)
{
    any_loop(r, from, 1);
}
