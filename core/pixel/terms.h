/*
 * terms.h - private: terms: how intensities become channels of the target's pixels.
 */
#ifndef SHEEN_TERMS_H
#define SHEEN_TERMS_H

#include "intensity.h"

/*
 * A target's pixel format. On 565 the channels are red, green and blue in levels; on grey they are the contributions of
 * red, green and blue to the level.
 */
struct pixel_format {
    uint32_t scale[3];  /* the level for 1.0 of red, green, blue, UQ8.16 */
    uint8_t level_bits; /* bits of the highest level: 6, 8, 4 or 1 */
    uint8_t grey;       /* 1: grey; a byte per pixel while drawing, packed before the push */
    uint8_t pixel_bits; /* in the target's memory */
    uint8_t swap;       /* 1: this machine and the target have different byte orders of 565 */
};

/*
 * A channel before rounding is a + b * diffuse + c * specular, unsigned with `fraction` fraction bits, below 2^31
 * whatever the lights (see colour.c).
 */
#define NO_DIFFUSE_RANGE 0xffffu /* low and high if there is no such range */

struct colour_terms {
    uint8_t fraction;
    uint8_t clamp;     /* 1: with some normal a channel may exceed 1.0 */
    uint8_t unit_log2; /* a 64th of 1.0 of a channel is 2^unit_log2 */
    /* by sheen_colour_reach: */
    uint16_t faint_specular; /* the specular intensity, UQ1.15, of at most 1/32 of a 64th of 1.0; see faint_highlight */
    uint16_t diffuse_tolerance; /* the difference of diffuse intensities that gives at most 1/8 of a 64th */
    uint16_t low;               /* from this diffuse intensity to `high` all channels of 565 stay 1/32 level */
    uint16_t high;              /* below 1.0 and, unless they are constant, above 0 */
    uint32_t a[3];
    uint16_t b[3], c[3];
    uint32_t top[3]; /* a channel's value at 1.0, to which it is clamped */
};

/*
 * The same for the specialised loops on 565, with LOOP_FRACTION bits, in the order in which they are loaded: a and b of
 * each channel, then the c. Without dither a includes the 1/2 of the one rounding.
 */
#define LOOP_FRACTION 24 /* fraction bits of 565 channels that stay below 2.0 */

struct loop_terms {
    uint32_t ab[6], c[3];
    uint32_t power_end;    /* the power table's argument from which on there is no highlight */
    const uint32_t *power; /* the power table */
    uint8_t usable;        /* 1: 565, LOOP_FRACTION bits, no ramp, no fog: these loops suffice */
};

/*
 * How much a highlight may give and still be left out; least: what gives 1/32 level. When an area of one colour is
 * dithered, each 1/64 level of a channel changes 1/64 of its pixels: 3/256 level of green and half as much of red and
 * blue change 1.5 in 64.
 */
static inline uint32_t faint_highlight(uint32_t least, unsigned dither)
{
    return dither ? 3 * least >> 3 : least;
}

/*
 * Light on texels, for draws with a texture: channel k's light is a + b * diffuse, in [0, 36]; c * specular is added in
 * levels of 565.
 */
#define LIGHT_BITS 24  /* fraction bits of light, and of channels if light is at most 1.0 */
#define BRIGHT_BITS 19 /* fraction bits of channels if light may exceed 1.0 */
#define GREY_BITS 11   /* fraction bits of channels from which grey levels are made */

struct texel_terms {
    const struct sheen_texture *texture;
    uint32_t a[3];    /* with `fraction` bits; about 2^30 at most with b * 1.0 */
    uint16_t b[3];    /* with 15 bits less, for diffuse in UQ1.15 */
    uint16_t c[3];    /* c * specular, UQ1.15, is in levels / 2^(BRIGHT_BITS + c_shift) */
    uint16_t gloss;   /* what 1.0 of specular gives if the highlight is white, UQ1.15 */
    uint16_t grey[3]; /* a 565 level / 2^GREY_BITS of each channel in grey levels, with 31 - level_bits fraction bits */
    uint8_t fraction; /* 24..30 */
    uint8_t c_shift;
    uint8_t alike;     /* 1: light is the same in all channels */
    uint8_t white;     /* 1: the highlight is the same in all channels, at most 1.0 */
    uint8_t uv_packed; /* 1: both texel coordinates are stepped in one word: see texel_steps.h */
    uint8_t unlit;     /* 1: light is 1.0 everywhere, and there is no highlight */
};

/* Colours of lights, for draws that read them. */
struct tint_terms {
    uint32_t low[3]; /* by channel, what a ramp's `low` gives with white lights; `a` does not include it */
    uint8_t color[SHEEN_MAX_LIGHTS][3];
    uint8_t is_tinted;  /* 1: a light has a colour or is a point, so light is found by sheen_light_tinted */
    uint8_t point_mask; /* bit i is set if light i is a point light */
    int32_t reach;      /* units that raw 32768 of the posed mesh stands for, Q7.24; read if there are point lights */
    const struct sheen_points *points;   /* NULL: no point lights */
    const struct sheen_texture *texture; /* of shadings that have one */
};

/* A material's intensity, at most 4.0, times the sum of its lights' intensities; UQ.16, at most 16.0. */
static inline uint32_t intensities(sheen_q16_t of_material, sheen_q16_t of_lights)
{
    return mul_high((uint32_t)of_material << 12, (uint32_t)of_lights << 4);
}

/* x times a byte of colour, 255 = 1.0. */
static inline uint32_t by_colour(uint32_t x, uint8_t colour)
{
    return colour == 255 ? x : mul_high(x, colour * 0x01010101u);
}

static inline uint32_t clamped(uint32_t x, uint32_t top)
{
    return x > top ? top : x;
}

static inline uint32_t colour_channel(const struct colour_terms *t, int k, const struct lit *lit)
{
    return t->a[k] + t->b[k] * lit->diffuse + t->c[k] * lit->specular;
}

void sheen_format_begin(struct pixel_format *format, const struct sheen_target *target);
void sheen_colour_begin(struct colour_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                        sheen_q16_t diffuse_sum, sheen_q16_t specular_sum);
/* Fills in faint_specular, diffuse_tolerance, low and high, for set-ups that ask whether an intensity shows. */
void sheen_colour_reach(struct colour_terms *t, const struct pixel_format *format);
/* Sets `limit`, where a highlight gives less than faint_highlight, and `faint`, where it gives less than 1/32 level. */
void sheen_power_end(struct power *power, const struct colour_terms *t, const struct pixel_format *format,
                     unsigned dither);
/* Whether a texture is as sheen.h demands; t may be NULL. */
int sheen_texture_valid(const struct sheen_texture *t);
/* Whether it can be a matcap too: a bilinear one has to clamp, as the sphere's picture does not repeat. */
int sheen_sphere_valid(const struct sheen_texture *t);
void sheen_texel_begin(struct texel_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                       sheen_q16_t diffuse_sum, sheen_q16_t specular_sum);

#endif
