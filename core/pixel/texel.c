/*
 * texel.c - from intensities to light on texels.
 */
#include "pixel.h"

static const uint8_t highest[3] = {31, 63, 31};

/* A byte of colour, 255 = 1.0, times an intensity, Q.16: UQ.32. Range: 2^16 * 2^22. */
static APART uint64_t tinted(uint8_t colour, uint32_t intensity)
{
    return (uint64_t)(colour * 257u + (colour >> 7)) * intensity;
}

/* round(x / 2^n), 1 <= n <= 32; the result has to fit. */
static APART uint32_t round_off(uint64_t x, unsigned n)
{
    return ((uint32_t)(x >> (n - 1)) + 1) >> 1;
}

static void highlight_terms(struct texel_terms *t, const struct sheen_material *m, uint32_t specular)
{
    static const uint8_t full[3] = {255, 255, 255};
    const uint8_t *const colour = (m->highlight[0] | m->highlight[1] | m->highlight[2]) == 0 ? full : m->highlight;
    uint64_t c[3], most = 0; /* levels, UQ.32 */
    unsigned drop = 22;

    for (int k = 0; k < 3; k++) {
        c[k] = highest[k] * tinted(colour[k], specular);
        most = c[k] > most ? c[k] : most;
    }
    while (most >> drop > 0xfffe)
        drop++;
    for (int k = 0; k < 3; k++)
        t->c[k] = (uint16_t)round_off(c[k], drop);
    t->c_shift = (uint8_t)(47 - drop - BRIGHT_BITS);
    t->white = colour[0] == colour[1] && colour[0] == colour[2] && c[0] <= 31ull << 32;
    t->gloss = (uint16_t)(tinted(colour[0], specular) >> 17);
}

COLD int sheen_texture_valid(const struct sheen_texture *t)
{
    return t != NULL && t->texels != NULL && t->width_log2 <= 9 && t->height_log2 <= 9 &&
           (t->bits == 0 || t->bits == 16 || ((t->bits == 8 || t->bits == 4) && t->palette != NULL));
}

COLD int sheen_sphere_valid(const struct sheen_texture *t)
{
    return sheen_texture_valid(t) && (!t->bilinear || (t->clamp_u && t->clamp_v));
}

/*
 * fraction is 30 minus the bits by which the brightest light exceeds 1.0, so that sums stay below 2^31, b below 2^16.
 * Range: light <= 4 + 4 * 4 = 20, with a ramp 36; highlights 63 * 16 = 1008 levels.
 */
COLD void sheen_texel_begin(struct texel_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                            sheen_q16_t diffuse_sum, sheen_q16_t specular_sum)
{
    const uint32_t ambient = (uint32_t)m->ambient, diffuse = intensities(m->diffuse, diffuse_sum),
                   specular = intensities(m->specular, specular_sum);
    unsigned headroom = 0;

    for (int k = 0; k < 3; k++)
        while (tinted(m->base[k], ambient + diffuse) > 1ull << (32 + headroom))
            headroom++;
    t->texture = m->texture;
    t->fraction = (uint8_t)(30 - headroom);
    t->alike = 1;
    t->unlit = specular == 0;
    t->uv_packed =
        !m->texture->clamp_u && !m->texture->clamp_v && m->texture->width_log2 + m->texture->height_log2 <= 12;
    for (int k = 0; k < 3; k++) {
        t->a[k] = (uint32_t)(tinted(m->base[k], ambient) >> (2 + headroom));
        t->b[k] = (uint16_t)round_off(tinted(m->base[k], diffuse), 17 + headroom);
        t->alike &= t->a[k] == t->a[0] && t->b[k] == t->b[0];
        t->unlit &= t->a[k] == 1u << 30 && t->b[k] == 0;
        /* rounded up: below 2^15 */
        const uint32_t level =
            ((format->scale[k] << (15 - GREY_BITS)) + (1u << format->level_bits) - 1) >> format->level_bits;
        t->grey[k] = (uint16_t)QUOTIENT(level + highest[k] - 1u, highest[k]);
    }
    highlight_terms(t, m, specular);
}
