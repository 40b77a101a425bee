/*
 * fog.h - private: colours that blend into a fog's colour with the depth.
 */
#ifndef SHEEN_FOG_H
#define SHEEN_FOG_H

#include "triangle.h"

/*
 * A view's fog, for one frame. At z, UQ16.16 of z16, its share of a colour is (start - (z >> shift)) / reach, clamped
 * to 0..1. Channels are in levels with 16 - level_bits fraction bits, so that all are below 2^16.
 */
struct fog_terms {
    const struct sheen_fog_mixer *mixer;
    int32_t start;
    uint16_t reach;    /* from start to end: 2^15..2^16 - 1 */
    uint16_t scale;    /* 2^30 / reach, rounded up */
    uint16_t level[3]; /* the fog's colour, whole levels; on grey targets the first alone */
    uint8_t shift;     /* 9..31 */
    uint8_t is_565;    /* 1: the target's pixels are 565 */
};

struct texel_run;
struct texel_at;
struct normal_run;

/* Functions that a struct sheen_fog points to, so that only programs with fog link them. */
struct sheen_fog_mixer {
    /* SHEEN_ERR_ARGUMENT if start and end are not in order or are less than 256 steps of z16 apart. */
    int (*begin)(struct fog_terms *terms, const struct sheen_fog *fog, const struct projection *p,
                 const struct pixel_format *format);
    void (*draw)(struct draw *d, const struct fog_terms *terms); /* turns *d into a draw under fog */
    /* Called after the shading's set-up, to have fog in its rows. */
    void (*setup)(struct setup *s);
    /* Called in place of general_run, sheen_normal_run and any_run, with a ramp or without. */
    void (*shaded_run)(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                       struct shaded_run *run, unsigned second);
    void (*normal_run)(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                       const struct normal_run *run);
    void (*texel_run)(const struct texel_run *r, const struct texel_at *from);
    /*
     * Blends *pixel, a line's pixel as stored in a tile, with the fog at z, which is Q16.8 of z16 and grows by z_step
     * per pixel; returns how many of the next `steps` pixels get the same value, 1 or more.
     */
    int32_t (*line_run)(const struct fog_terms *fog, const struct pixel_format *format, int32_t z, int32_t z_step,
                        int32_t steps, uint16_t *pixel);
};

void sheen_fogged_shaded_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                             struct shaded_run *run, unsigned second);
void sheen_fogged_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                             const struct normal_run *run);
void sheen_fogged_texel_run(const struct texel_run *r, const struct texel_at *from);

/* The fog's share at z, UQ2.14. Range: 2^16 * 2^15. */
SPECIALISED int32_t fog_share(const struct fog_terms *fog, uint32_t z)
{
    const int32_t deep = fog->start - (int32_t)(z >> fog->shift);

    return (int32_t)((uint32_t)min32(max32(deep, 0), fog->reach) * fog->scale >> 16);
}

/* A channel blended with the fog's level by the fog's share. Range: |level - channel| < 2^16. */
SPECIALISED uint32_t fogged(uint32_t channel, uint32_t level, int32_t share)
{
    return channel + (uint32_t)asr32(((int32_t)level - (int32_t)channel) * share, 14);
}

/* Fog, then the one rounding: channels have 16 - level_bits fraction bits and are at most 1.0; threshold in 1/128. */
SPECIALISED void put_fogged(const struct tile *t, const struct fog_terms *fog, uint32_t at, uint32_t z, uint32_t r,
                            uint32_t g, uint32_t b, uint32_t threshold, unsigned grey)
{
    const unsigned fraction = grey ? 16u - t->format->level_bits : 10;
    const int32_t share = fog_share(fog, z);

    threshold <<= fraction - 7;
    if (grey) {
        ((uint8_t *)t->pixels)[at] = (uint8_t)((fogged(r + g + b, fog->level[0], share) + threshold) >> fraction);
        return;
    }
    r = fogged(r, fog->level[0], share) + threshold;
    g = fogged(g, fog->level[1], share) + threshold;
    b = fogged(b, fog->level[2], share) + threshold;
    ((uint16_t *)t->pixels)[at] = fast_pixel(r, g, b, 10, t->format->swap);
}

/* The same for channels with the draw's fraction, which are clamped here. */
SPECIALISED void put_fogged_terms(const struct tile *t, const struct draw *d, uint32_t at, uint32_t z, uint32_t r,
                                  uint32_t g, uint32_t b, uint32_t threshold, unsigned grey)
{
    const struct colour_terms *terms = &d->colour;
    const unsigned down = terms->fraction - (16u - t->format->level_bits);

    put_fogged(t, d->fog, at, z, clamped(r, terms->top[0]) >> down, clamped(g, terms->top[1]) >> down,
               clamped(b, terms->top[2]) >> down, threshold, grey);
}

SPECIALISED void put_fogged_lit(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at,
                                int32_t x, uint32_t z, const struct lit *lit)
{
    const struct colour_terms *terms = &d->colour;

    put_fogged_terms(t, d, at, z, colour_channel(terms, 0, lit), colour_channel(terms, 1, lit),
                     colour_channel(terms, 2, lit), rounding.threshold[(uint32_t)x & 7u], t->format->grey);
}

#endif
