/*
 * normal.h - private: pixels lit from normals of any length by any number of lights, with a root per pixel.
 */
#ifndef SHEEN_NORMAL_H
#define SHEEN_NORMAL_H

#include "fog.h"

/* The range of N.N in the root table: UQ1.31 from 1/4 to 1 + 1/512. */
#define ROOT_LOWEST (1u << 29)
#define ROOT_RANGE ((3u << 29) + (1u << 22))
#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* Stores a pixel in any format, clamped and dithered; in builds for size it is not inlined. */
#if FAST_LOOPS
SPECIALISED void put_any(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                         const struct lit *lit)
{
    put_general(t, &d->colour, rounding, at, x, colour_channel(&d->colour, 0, lit), colour_channel(&d->colour, 1, lit),
                colour_channel(&d->colour, 2, lit));
}
#else
#define put_any sheen_put_any
void sheen_put_any(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                   const struct lit *lit);
#endif

SPECIALISED void put_lit(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                         struct lit lit)
{
    if (FAST_LOOPS && d->loop.usable) {
        uint32_t threshold = t->dither ? (uint32_t)rounding.threshold[x & 7] << rounding.shift : 0;
        ((uint16_t *)t->pixels)[at] =
            pixel_order(loop_pixel(t, t->depth + at, &d->loop, lit.diffuse, lit.specular != 0, lit.specular, threshold),
                        t->format->swap);
    } else {
        put_any(t, d, rounding, at, x, &lit);
    }
}

/* Dot product of a unit normal, or a shorter one, and a unit vector in Q1.30: Q0.15, 1.0 as 32767. */
static inline int32_t cosine_of(const int16_t normal[3], const int32_t v[3])
{
    int32_t dot = dot_q29(normal, v); /* 1.0 is 32767 * 2^14 */

    dot = asr32(dot + asr32(dot, 15) + (1 << 13), 14);
    return min32(max32(dot, -32767), 32767);
}

/* The difference of two numbers in Q0.30, in steps of 2^-14; |f - f0| <= 2^31 - 2^16. */
static inline int32_t cut_cosine(int32_t f, int32_t f0)
{
    return asr32(asr32(f, 1) - asr32(f0, 1) + (1 << 14), 15);
}

/*
 * weighted.c: the corners' weights, UQ0.15, up to 1.0; the plane of a cosine, or of a component of N, that is x at the
 * corners, Q0.15, times weight: Q1.30.
 */
void sheen_corner_weights(struct surface_corners *c, int32_t w[3]);
struct plane sheen_weighted_plane(const struct gradients *g, const int32_t w[3], const int32_t x[3]);

/* Pixels along which the normal, times any factor, is linear: values at the first one, and steps per pixel. */
struct normal_run {
    uint32_t z, dz;
    uint32_t n[3], dn[3]; /* Q1.30, modulo 2^32 */
};

/* normal_rows.c, for light without a ramp: draws columns x to x1 - 1, x < x1. */
void sheen_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      const struct normal_run *run);
/* A struct sheen_ramp_reader's normal_run. */
void sheen_normal_run_by_ramp(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                              const struct normal_run *run);

static inline void draw_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                                   const struct normal_run *run)
{
    (d->fog          ? d->fog->mixer->normal_run
     : d->pixel_ramp ? d->light.ramp->reader->normal_run
                     : sheen_normal_run)(t, d, x, x1, y, run);
}

#endif
