/*
 * tinted.h - private: pixels from their normals and colours, lit by lights that may have colours.
 */
#ifndef SHEEN_TINTED_H
#define SHEEN_TINTED_H

#include "glow.h"
#include "shares.h"

/* A draw's lights, with their colours. */
struct tinted_lights {
    uint32_t ambient[3]; /* of channels, with the draw's fraction: what is there without diffuse light */
    uint16_t color[SHEEN_MAX_LIGHTS][3]; /* UQ1.15 */
};

/*
 * Pixels along which normals, times any factor, and colours times weight are linear: at the first, and what the next
 * one has more, modulo 2^32.
 */
struct tinted_run {
    struct tinted_lights lights;
    const struct shares *planes;
    int16_t color[3][3]; /* by corner */
    uint32_t z, dz;
    uint32_t n[3], dn[3];     /* Q1.30 */
    uint32_t c[3], dc[3];     /* Q1.30 */
    uint32_t weight, dweight; /* UQ2.30 */
};

/* What does not change over a triangle: lights, corners' colours, steps of depth, weight and colours. */
void sheen_tinted_begin(struct tinted_run *run, const struct setup *s, union shared_triangle of,
                        const struct shares *planes);
/* From a pixel of the triangle on, but for normals; share: out, of its corners. */
void sheen_tinted_row(struct tinted_run *run, const struct setup *s, int32_t x, int32_t y, int32_t share[3]);
/* Columns x to before x1. */
void sheen_tinted_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      const struct tinted_run *run);

/* Of a struct shares_setup, and how one becomes so: normals are linear in space. */
void sheen_tinted_rows(const struct tile *t, const struct setup *s);
void sheen_setup_tinted(struct setup *s, struct surface_corners *c, const struct gradients *g);

#endif
