/*
 * texel.c - intensities to light on texels.
 */
#include "pixel.h"

static const uint8_t highest[3] = {31, 63, 31};

/* Byte and intensities, Q.16, times: UQ.32. Range: 2^16 * 2^22. */
static uint64_t tinted(uint8_t colour, uint64_t intensity)
{
    return (colour * 257u + (colour >> 7)) * intensity;
}

static void highlight_terms(struct texel_terms *t, const struct sheen_material *m, uint64_t specular)
{
    int white = (m->highlight[0] | m->highlight[1] | m->highlight[2]) == 0;
    uint64_t c[3], most = 0; /* levels, UQ.32 */
    unsigned fraction = 10;

    for (int k = 0; k < 3; k++) {
        c[k] = highest[k] * tinted(white ? 255 : m->highlight[k], specular);
        most = c[k] > most ? c[k] : most;
    }
    while (most >> (32 - fraction) > 0xfffe)
        fraction--;
    for (int k = 0; k < 3; k++)
        t->c[k] = (uint16_t)((c[k] + (1ull << (31 - fraction))) >> (32 - fraction));
    t->c_shift = (uint8_t)(fraction + 15 - BRIGHT_BITS);
    t->white = m->highlight[0] == m->highlight[1] && m->highlight[0] == m->highlight[2] && c[0] <= 31ull << 32;
    t->gloss = (uint16_t)(tinted(white ? 255 : m->highlight[0], specular) >> 17);
}

int sheen_texture_valid(const struct sheen_texture *t)
{
    return t != NULL && t->texels != NULL && t->width_log2 <= 9 && t->height_log2 <= 9 &&
           (t->bits == 0 || t->bits == 16 || ((t->bits == 8 || t->bits == 4) && t->palette != NULL));
}

int sheen_sphere_valid(const struct sheen_texture *t)
{
    return sheen_texture_valid(t) && (!t->bilinear || (t->clamp_u && t->clamp_v));
}

/*
 * fraction: 30 less the bits by which the brightest light exceeds 1.0, so that sums stay below 2^31 and b below 2^16.
 * Range: light <= 4 + 4 * 4 = 20, by a ramp 36, highlights 63 * 16 = 1008 levels.
 */
void sheen_texel_begin(struct texel_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                       sheen_q16_t diffuse_sum, sheen_q16_t specular_sum)
{
    const uint64_t diffuse = ((uint64_t)m->diffuse * (uint64_t)diffuse_sum) >> 16;
    const uint64_t specular = ((uint64_t)m->specular * (uint64_t)specular_sum) >> 16;
    unsigned headroom = 0;

    for (int k = 0; k < 3; k++)
        while (tinted(m->base[k], (uint64_t)m->ambient + diffuse) > 1ull << (32 + headroom))
            headroom++;
    t->texture = m->texture;
    t->fraction = (uint8_t)(30 - headroom);
    t->alike = 1;
    t->unlit = specular == 0;
    t->packed = !m->texture->clamp_u && !m->texture->clamp_v && m->texture->width_log2 + m->texture->height_log2 <= 12;
    for (int k = 0; k < 3; k++) {
        t->a[k] = (uint32_t)(tinted(m->base[k], (uint64_t)m->ambient) >> (2 + headroom));
        t->b[k] = (uint16_t)((tinted(m->base[k], diffuse) + (1ull << (16 + headroom))) >> (17 + headroom));
        t->alike &= t->a[k] == t->a[0] && t->b[k] == t->b[0];
        t->unlit &= t->a[k] == 1u << 30 && t->b[k] == 0;
        const uint64_t one = (uint64_t)highest[k] << (16 + GREY_BITS); /* rounded up: below 2^15 */
        t->grey[k] = (uint16_t)((((uint64_t)format->scale[k] << (31 - format->level_bits)) + one - 1) / one);
    }
    highlight_terms(t, m, specular);
}
