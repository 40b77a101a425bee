/*
 * colored_texels_rows.c - any texture and target, light and highlight by channel.
 */
#include "colored_texels.h"
#include "fog.h"

/* A pixel's texels are `nearest` or about (u, v): their share of 1.0, UQ0.15. */
SPECIALISED void texel_shares(const struct sheen_texture *t, uint32_t u, uint32_t v, uint32_t nearest,
                              uint32_t share[3])
{
    const uint32_t sum = t->bilinear ? any_mixed(t, u + TO_MIDDLE, v + TO_MIDDLE, nearest) : spread(nearest) << 5;

    share[0] = (sum >> 11 & 1023u) * 1057 >> 5; /* 31 * 32 is 32767 */
    share[1] = (sum >> 21) * 33288 >> 11;       /* 63 * 32 */
    share[2] = (sum & 1023u) * 1057 >> 5;
}

/* Range: channels below 2^31 keep 16 bits, so that products stay there too. */
SPECIALISED void put_colored(const struct colored_run *r, uint32_t at, int32_t x, uint32_t z, const uint32_t share[3],
                             const uint32_t channel[6])
{
    uint32_t c[3];

    for (int k = 0; k < 3; k++) {
        c[k] = (not_negative(channel[k]) >> 15) * share[k];
        if (r->values > 5)
            c[k] += not_negative(channel[3 + k]);
    }
    if (r->d->fog != NULL)
        put_fogged_terms(r->t, r->d, at, z, c[0], c[1], c[2], threshold_row(r->t, r->t->dither, r->y)[(uint32_t)x & 7u],
                         r->t->format->grey);
    else
        put_general(r->t, &r->d->colour, rounding_of(r->t, &r->d->colour, r->y), at, x, c[0], c[1], c[2]);
}

void sheen_colored_run(struct colored_run r, const uint32_t from[TEXEL_VALUES], const uint32_t step[TEXEL_VALUES])
{
    const struct sheen_texture *t = r.d->tint.texture;
    uint32_t value[TEXEL_VALUES];

    for (unsigned i = 0; i < r.values; i++)
        value[i] = from[i];
    for (; r.count > 0; r.count--, r.x++, r.offset++, r.z += r.dz) {
        if (r.z >> 16 > r.t->depth[r.offset]) {
            const uint32_t nearest = texel_value(t, asr32((int32_t)value[0], 16), asr32((int32_t)value[1], 16));
            uint32_t share[3];
            if (!(t->keyed && nearest == t->key)) {
                (void)nearer(r.t, r.t->depth + r.offset, r.z);
                texel_shares(t, value[0], value[1], nearest, share);
                put_colored(&r, r.offset, r.x, r.z, share, value + 2);
            }
        }
        for (unsigned i = 0; i < r.values; i++)
            value[i] += step[i];
    }
}
