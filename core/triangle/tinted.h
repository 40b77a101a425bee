/*
 * tinted.h - private: pixels with normals and colours of their own, lit by lights that may have colours.
 */
#ifndef SHEEN_TINTED_H
#define SHEEN_TINTED_H

#include "glow.h"
#include "normal.h"
#include "shares.h"

/* What a step of UQ1.15 of one of a draw's lights adds to the channels, with the draw's fraction bits. */
struct tinted_beam {
    uint16_t base[3], gloss[3];
};

void sheen_tinted_beam(struct tinted_beam *beam, const struct draw *d, unsigned light);

/* Channels with the draw's fraction bits. */
struct channels {
    uint32_t r, g, b;
};

/* Channels in ambient light alone, to which sheen_tinted_quadrics_begin has added what a ramp's low gives. */
SPECIALISED struct channels ambient_channels(const struct draw *d)
{
    return (struct channels){d->colour.a[0], d->colour.a[1], d->colour.a[2]};
}

SPECIALISED void add_light(struct channels *c, const uint16_t beam[3], uint32_t light)
{
    c->r += beam[0] * light;
    c->g += beam[1] * light;
    c->b += beam[2] * light;
}

/* A channel times a vertex's colour, UQ1.15. Range: 2^16 * 2^15. */
SPECIALISED uint32_t times_colour(uint32_t channel, uint32_t colour)
{
    return ((channel + HALF) >> 15) * colour;
}

/* Stores a pixel on any target, in fog too; in builds for size it is not inlined. */
#if FAST_LOOPS
SPECIALISED void put_tinted(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at,
                            int32_t x, uint32_t z, struct channels c)
#else
#define put_tinted sheen_put_tinted
void sheen_put_tinted(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                      uint32_t z, struct channels c);
static inline void put_tinted_here(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at,
                                   int32_t x, uint32_t z, struct channels c)
#endif
{
    const uint32_t threshold = rounding.threshold[(uint32_t)x & 7u], by = threshold << rounding.shift;

    if (d->fog != NULL) {
        put_fogged_terms(t, d, at, z, c.r, c.g, c.b, threshold, t->format->grey);
    } else if (FAST_LOOPS && d->is_565 && d->colour.fraction == LOOP_FRACTION) {
        SHEEN_TEST_TAP(t, at, c.r, c.g, c.b, LOOP_FRACTION);
        ((uint16_t *)t->pixels)[at] = pixel_order(clamped_565(c.r + by, c.g + by, c.b + by, 0), d->swap);
    } else {
        put_clamped(t, &d->colour, by, at, c.r, c.g, c.b, t->format->grey, d->colour.fraction, t->format->swap);
    }
}

/*
 * Pixels along which normals, times any factor, and colours, times weight, are linear: values at the first one and
 * steps per pixel, modulo 2^32.
 */
struct tinted_run {
    struct tinted_beam beam[SHEEN_MAX_LIGHTS];
    const struct shares *planes;
    int16_t color[3][3]; /* by corner */
    uint32_t z, dz;
    uint32_t n[3], dn[3];     /* Q1.30 */
    uint32_t c[3], dc[3];     /* Q1.30 */
    uint32_t weight, dweight; /* UQ2.30 */
};

/* Fills in what does not change over a triangle: beams, corners' colours, steps of depth, weight and colours. */
void sheen_tinted_begin(struct tinted_run *run, const struct setup *s, union shared_triangle of,
                        const struct shares *planes);
/* Fills in the values at a pixel of the triangle, except normals; share: set to the corners' shares there. */
void sheen_tinted_row(struct tinted_run *run, const struct setup *s, int32_t x, int32_t y, int32_t share[3]);
/* Draws columns x to x1 - 1. */
void sheen_tinted_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      const struct tinted_run *run);

/* The rows of a struct shares_setup, and the set-up that takes them: normals are linear in space. */
void sheen_tinted_rows(const struct tile *t, const struct setup *s);
void sheen_setup_tinted(struct setup *s, struct surface_corners *c, const struct gradients *g);

/*
 * tinted_quadrics.c: the same by quadrics for normals no farther apart than `widest` (UQ2.30, |Ni - Nj|^2), and a
 * shader's `begin` for both. The set-up returns 0 and leaves *s as it was if quadrics are not accurate enough. It is
 * not for pieces: vertices MUST keep cosines (sheen_keep_cosines), and c->at.normal MUST be the mesh's.
 */
void sheen_tinted_quadrics_begin(struct draw *d, const struct sheen_material *material,
                                 const struct pixel_format *format, const struct sheen_object *object,
                                 const struct sheen_pose *view);
int sheen_setup_tinted_quadrics(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                                uint32_t widest);
void sheen_tinted_quadric_rows(const struct tile *t, const struct setup *s);

#endif
