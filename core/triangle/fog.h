/*
 * fog.h - private: colours that go over to a fog's with the depth.
 */
#ifndef SHEEN_FOG_H
#define SHEEN_FOG_H

#include "triangle.h"

/*
 * A view's fog, a frame long. At z, UQ16.16 of z16, its share of a colour is (start - (z >> shift)) / reach, held at 0
 * and 1. Channels are in levels, with level_bits less than 16 fraction bits, so that all are below 2^16.
 */
struct fog_terms {
    const struct sheen_fog_mixer *mixer;
    int32_t start;
    uint16_t reach;    /* from start to end: 2^15..2^16 - 1 */
    uint16_t scale;    /* 2^30 / reach, rounded up */
    uint16_t level[3]; /* of its colour, whole ones; greys: the first alone */
    uint8_t shift;     /* 9..31 */
    uint8_t is_565;    /* the target's pixels are */
};

struct texel_run;
struct texel_at;
struct normal_run;

/* What a struct sheen_fog points to, so that it is linked where there is one. */
struct sheen_fog_mixer {
    /* SHEEN_ERR_ARGUMENT where start and end are not in order or less than 256 steps of z16 apart. */
    int (*begin)(struct fog_terms *terms, const struct sheen_fog *fog, const struct projection *p,
                 const struct pixel_format *format);
    void (*draw)(struct draw *d, const struct fog_terms *terms); /* makes *d one that is fogged */
    void (*setup)(struct setup *s);                              /* after its shading's: its rows */
    /* In place of general_run, sheen_normal_run and any_run, with a ramp or without. */
    void (*shaded_run)(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                       struct shaded_run *run, unsigned second);
    void (*normal_run)(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                       const struct normal_run *run);
    void (*texel_run)(const struct texel_run *r, const struct texel_at *from);
    /*
     * A line's pixel, as it stands in a tile, goes over to the fog at z, which is Q16.8 of z16 and grows by z_step;
     * returns how many of the next `steps`, 1 or more, have the same pixel.
     */
    int32_t (*line_run)(const struct fog_terms *fog, const struct pixel_format *format, int32_t z, int32_t z_step,
                        int32_t steps, uint16_t *pixel);
};

void sheen_fogged_shaded_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                             struct shaded_run *run, unsigned second);
void sheen_fogged_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                             const struct normal_run *run);
void sheen_fogged_texel_run(const struct texel_run *r, const struct texel_at *from);

/* UQ2.14. Range: 2^16 * 2^15. */
SPECIALISED int32_t fog_share(const struct fog_terms *fog, uint32_t z)
{
    const int32_t deep = fog->start - (int32_t)(z >> fog->shift);

    return (int32_t)((uint32_t)min32(max32(deep, 0), fog->reach) * fog->scale >> 16);
}

/* Range: |level - channel| < 2^16. */
SPECIALISED uint32_t fogged(uint32_t channel, uint32_t level, int32_t share)
{
    return channel + (uint32_t)asr32(((int32_t)level - (int32_t)channel) * share, 14);
}

/* The one rounding of channels with 16 - level_bits fraction bits, each at most 1.0; threshold in 1/128. */
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

/* The same of channels with the draw's fraction, clamped here. */
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
