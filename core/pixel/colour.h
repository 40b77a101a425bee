/*
 * colour.h - private: light at a normal, and what it makes of a target's channels.
 */
#ifndef SHEEN_COLOUR_H
#define SHEEN_COLOUR_H

#include "../math/fixed.h"
#include "../sheen.h"

/* Lights and the eye in model space, so that dot products come straight from the mesh's normals. */
struct lighting {
    sheen_q30_t view[3];                        /* V */
    sheen_q30_t to[SHEEN_MAX_LIGHTS][3];        /* L */
    int32_t lv1[SHEEN_MAX_LIGHTS];              /* 1 + L.V, Q2.29 */
    uint16_t diffuse_weight[SHEEN_MAX_LIGHTS];  /* UQ1.15, their sum 1.0 */
    uint16_t specular_weight[SHEEN_MAX_LIGHTS]; /* likewise; 0: no highlight */
    sheen_q16_t diffuse_sum, specular_sum;      /* of the lights' intensities */
    uint8_t count;
};

/* Intensities relative to the most that the draw's lights can give. */
struct lit {
    uint32_t diffuse, specular; /* UQ1.15, 0..32768 */
};

int sheen_light_begin(struct lighting *l, const struct sheen_draw *draw);
void sheen_light_normal(const struct lighting *l, const struct sheen_material *m, const int16_t normal[3],
                        struct lit *out);

/* A material's power table, ready for a loop. */
struct power {
    const uint16_t *table;
    unsigned shift; /* 18..21: an entry is 2^shift of u in Q2.29 */
};

static inline struct power power_of(const struct sheen_material *m)
{
    struct power p = {m->power, 21u - m->power_shift};

    return p;
}

/*
 * s^n for u = 1 - s in Q2.29, u any int32: UQ1.15.
 * Range: index < 256; drop <= 32768 and the fraction < 2^16, so the product fits 32 bits unsigned.
 */
static inline uint32_t power_at(struct power p, int32_t u)
{
    uint32_t at = (uint32_t)max32(u, 0), index = at >> p.shift;

    if (index >= SHEEN_POWER_ENTRIES)
        return 0;
    uint32_t entry = p.table[index], drop = entry - p.table[index + 1];
    uint32_t fraction = (at >> (p.shift - 16u)) & 0xffffu;
    return entry - ((drop * fraction + 0x8000u) >> 16);
}

#define FADED (1 << 12) /* UQ1.15: at L.N = 1/8 and beyond a highlight is whole */

/*
 * A light's highlight at L.N = ln > 0, UQ1.15: s^n times min(1, 8 L.N), so that it ends at
 * L.N = 0 without a jump. Range: 2^15 * 2^12.
 */
static inline uint32_t highlight_at(struct power p, int32_t u, uint32_t ln)
{
    uint32_t power = power_at(p, u);

    return ln < FADED ? (power * ln + FADED / 2) >> 12 : power;
}

/* ---- colour: intensities -> channels of the target ---- */

/*
 * What a target's pixels are made of. On 565 the channels are red, green, blue
 * in levels; on grey they are the shares of red, green and blue in the level.
 */
struct pixel_format {
    uint32_t scale[3];  /* levels that 1.0 of red, green, blue gives, UQ8.16 */
    uint8_t level_bits; /* of the highest level: 6, 8, 4 or 1 */
    uint8_t grey;       /* a byte a pixel while drawing, packed before the push */
    uint8_t pixel_bits; /* in the target's memory */
    uint8_t swap;       /* 565 bytes change places between this machine and the target */
};

/*
 * A channel before rounding: a + b * diffuse + c * specular, unsigned with
 * `fraction` fraction bits, below 2^31 whatever the lights (see colour.c).
 */
struct colour_terms {
    uint32_t a[3];
    uint16_t b[3], c[3];
    uint32_t top[3]; /* a channel's value at 1.0, where it is clamped */
    uint8_t fraction;
    uint8_t clamp; /* some normal may give more */
};

static inline uint32_t colour_channel(const struct colour_terms *t, int k, const struct lit *lit)
{
    return t->a[k] + t->b[k] * lit->diffuse + t->c[k] * lit->specular;
}

/* A 565 value in the target's byte order. */
static inline uint16_t pixel_order(uint32_t value, unsigned swap)
{
    return (uint16_t)(swap ? (value << 8 | value >> 8) : value);
}

/*
 * What is added before the one rounding: thresholds (B + 1/2) / 64 of the 8x8
 * Bayer matrix, in 1/128, row y mod 8; the ninth row is 1/2 throughout, no dither.
 */
#define NO_DITHER 8
extern const uint8_t sheen_thresholds[9][8];

static inline const uint8_t *threshold_row(unsigned dither, int32_t y)
{
    return sheen_thresholds[dither ? (unsigned)y & 7u : NO_DITHER];
}

void sheen_format_begin(struct pixel_format *format, const struct sheen_target *target);
void sheen_colour_begin(struct colour_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                        const struct lighting *l);
/* A colour as it stands in a tile, rounded and not dithered: 565 in the target's order, or a grey level. */
uint16_t sheen_colour_bytes(const struct pixel_format *format, const uint8_t rgb[3]);
/* Grey levels of a tile, a byte each, to the target's packing, in place. */
void sheen_pack_grey(const struct pixel_format *format, uint8_t *pixels, unsigned width, unsigned rows);

#endif
