/*
 * colored_texels_rows.c - runs of texels with light and highlight per channel, for any texture and target.
 */
#include "colored_texels.h"
#include "fog.h"

/* texel: spread, its channels in levels / 2^down. Range: light times a full texel is below 2^31. */
SPECIALISED void put_colored(const struct colored_run *r, uint32_t at, int32_t x, uint32_t z, uint32_t texel,
                             unsigned down, const uint32_t value[TEXEL_VALUES])
{
    uint32_t c[3] = {(value[2] >> down) * (texel >> 11 & 1023u), (value[3] >> down) * (texel >> 21),
                     (value[4] >> down) * (texel & 1023u)};

    for (int k = 0; k < 3 && r->values > 5; k++)
        c[k] += value[5 + k];
    if (r->d->fog != NULL)
        put_fogged_terms(r->t, r->d, at, z, c[0], c[1], c[2], threshold_row(r->t, r->t->dither, r->y)[(uint32_t)x & 7u],
                         r->t->format->grey);
    else
        put_general(r->t, &r->d->colour, rounding_of(r->t, &r->d->colour, r->y), at, x, c[0], c[1], c[2]);
}

static APART void any_colored_run(const struct colored_run *r)
{
    const struct sheen_texture *t = r->d->tint.texture;
    uint32_t *value = r->from, z = r->z, offset = r->offset;
    int32_t x = r->x;

    for (int32_t left = r->count; left > 0; left--, x++, offset++, z += r->dz) {
        if (z >> 16 > r->t->depth[offset]) {
            const uint32_t nearest = texel_value(t, asr32((int32_t)value[0], 16), asr32((int32_t)value[1], 16));
            if (!(t->keyed && nearest == t->key)) {
                (void)nearer(r->t, r->t->depth + offset, z);
                if (t->bilinear)
                    put_colored(r, offset, x, z, any_mixed(t, value[0] + TO_MIDDLE, value[1] + TO_MIDDLE, nearest), 5,
                                value);
                else
                    put_colored(r, offset, x, z, spread(nearest), 0, value);
            }
        }
        for (unsigned i = 0; i < r->values; i++)
            value[i] += r->step[i];
    }
}

#if FAST_LOOPS

/*
 * For 565 textures that repeat, nearest and without key, on 565 targets with LOOP_FRACTION and without fog. If not
 * glossy, no channel exceeds 1.0.
 */
SPECIALISED void plain_colored(const struct colored_run *r, unsigned glossy)
{
    const struct sheen_texture *t = r->d->tint.texture;
    const struct rounding rounding = rounding_of(r->t, &r->d->colour, r->y);
    const unsigned width = t->width_log2, swap = r->t->format->swap;
    const uint32_t columns = (1u << width) - 1, rows = ((1u << t->height_log2) - 1) << width;
    const uint32_t *from = r->from, *by = r->step, *top = r->d->colour.top;
    const uint16_t *texels = t->texels;
    const intptr_t to_pixel = r->t->to_pixel;
    uint16_t *depth = r->t->depth + r->offset;
    const uint16_t *end = depth + r->count;
    uint32_t z = r->z, u = from[0], v = from[1], red = from[2], green = from[3], blue = from[4];
    uint32_t gloss[3] = {0, 0, 0}, x = (uint32_t)r->x;

    for (int k = 0; k < 3 && glossy; k++)
        gloss[k] = from[5 + k];
    for (; depth != end; depth++, x++) {
        if (nearer(r->t, depth, z)) {
            const uint32_t texel = texels[(v >> (16 - width) & rows) | (u >> 16 & columns)];
            const uint32_t up = (uint32_t)rounding.threshold[x & 7u] << (LOOP_FRACTION - 7);
            uint32_t c[3] = {(texel >> 11) * red, (texel >> 5 & 63u) * green, (texel & 31u) * blue};
            for (int k = 0; k < 3 && glossy; k++)
                c[k] = clamped(c[k] + gloss[k], top[k]);
            *pixel_at(depth, to_pixel) = fast_pixel(c[0] + up, c[1] + up, c[2] + up, LOOP_FRACTION, swap);
        }
        z += r->dz;
        u += by[0];
        v += by[1];
        red += by[2];
        green += by[3];
        blue += by[4];
        for (int k = 0; k < 3 && glossy; k++)
            gloss[k] += by[5 + k];
    }
}

HOT static APART void matt_colored_run(const struct colored_run *r)
{
    plain_colored(r, 0);
}

static APART void glossy_colored_run(const struct colored_run *r)
{
    plain_colored(r, 1);
}

void sheen_colored_run(const struct colored_run *r)
{
    if (!r->plain)
        any_colored_run(r);
    else if (r->values > 5)
        glossy_colored_run(r);
    else
        matt_colored_run(r);
}

#else

void sheen_colored_run(const struct colored_run *r)
{
    any_colored_run(r);
}

#endif
