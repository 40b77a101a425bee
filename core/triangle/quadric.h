/*
 * quadric.h - private: functions that are quadratic on the screen, and the rows that step them.
 */
#ifndef SHEEN_QUADRIC_H
#define SHEEN_QUADRIC_H

#include "triangle.h"

#define LOWEST_SCALE 12 /* least exponent of gradients: steps up to 8 per pixel */
/*
 * The most stretch: products of barycentric coordinates are off by about 2^-20 (extent * step)^2, extent * step <
 * 2^(stretch + 1).
 */
#define QUADRIC_STRETCH 6

/* 1 if a triangle's gradients are good enough for quadrics; otherwise it is too small or a needle. */
static inline int quadric_fits(int exponent, int stretch)
{
    return exponent >= LOWEST_SCALE && stretch <= QUADRIC_STRETCH;
}

/*
 * The same from twice the area and the bits of differences: exponent = 40 - z - bits, stretch = z + 2 bits - 32, z =
 * clz32(area).
 */
static inline int quadric_fits_area(unsigned bits, uint32_t area)
{
    const unsigned small = bits + LOWEST_SCALE - 9, thin = 2 * bits - QUADRIC_STRETCH - 1;

    return area >> (bits > LOWEST_SCALE + QUADRIC_STRETCH - 8 ? thin : small) != 0;
}

/* Products of b's steps, xx, xy + yx, yy, that serve any function on a triangle: raw / 2^(2 exponent - 10). */
struct quadric_steps {
    const struct gradients *g;
    int32_t b1b1[3], b1b2[3], b2b2[3];
};

/* Returns 0 if the triangle is a needle or too small. */
int sheen_quadric_steps(struct quadric_steps *p, const struct gradients *g);

/*
 * A quadric about the origin pixel, modulo 2^32. f0: f at corner 0, Q.30. d1, d2: its differences from there to corners
 * 1 and 2, k: its excess on edges 01, 02, 12, all Q.16, below 2^19.
 */
void sheen_corner_quadric(struct quadric *q, const struct quadric_steps *p, uint32_t f0, int32_t d1, int32_t d2,
                          const int32_t k[3]);

#define LEAST_MEAN 8 /* least mean weight, in steps of z16: below it rounding is more than what is looked for */

/*
 * What perspective does to an edge's middle: lean = 2 (wi - wj) / (wi + wj) of edges 01, 02, 12, Q0.18; an f that is
 * linear in space has the excess lean (fi - fj). Returns 0 if a lean exceeds `most`, which is below 2^17, or the
 * weights' mean is below LEAST_MEAN.
 */
int sheen_leans(int32_t lean[3], const struct surface_corners *c, int32_t most);

/*
 * The quadric of what is linear in space, f at the corners, UQ1.15: Q1.30 plus half a step of UQ1.15. Range: |lean| <=
 * 2^16, so half of it times 2^15 fits 32 bits.
 */
void sheen_space_quadric(struct quadric *q, const struct quadric_steps *steps, const int32_t lean[3],
                         const int32_t f[3]);

/* As sheen_corner_quadric, but with all bits of k and in about twice the time: for an f that is nearly all excess. */
void sheen_fine_quadric(struct quadric *q, const struct quadric_steps *p, uint32_t f0, int32_t d1, int32_t d2,
                        const int32_t k[3]);

/* Moves the pixel that a quadric counts from by so many columns and rows; `to` may be q. */
void sheen_quadric_from(struct quadric *to, const struct quadric *q, int32_t column, int32_t row);

/* Moves the pixel that a quadric counts from to the next row. */
SPECIALISED void quadric_down(struct quadric *q)
{
    q->base += q->dy;
    q->dy += q->dyy;
    q->dx += q->dxy;
}

/* Value, first and second difference where a run begins, n columns from the pixel that q counts from. */
SPECIALISED void quadric_run(const struct quadric *q, int32_t n, uint32_t *value, uint32_t *step, uint32_t *bend)
{
    *value = q->base + (uint32_t)n * q->dx + pairs(n) * q->dxx;
    *step = q->dx + (uint32_t)n * q->dxx;
    *bend = q->dxx;
}

/* What the second quadric is. */
enum second {
    SECOND_NONE,     /* no highlight on this triangle */
    SECOND_SPECULAR, /* the specular intensity, Q1.30 */
    SECOND_POWER     /* 1 - R.V as the power table's argument */
};

struct quadric_setup {
    struct setup s;                 /* detail: enum second */
    int16_t x, y;                   /* the pixel that quadrics count from */
    struct quadric diffuse, second; /* diffuse: L.N or an intensity, Q1.30 plus half a step of UQ1.15 */
};

/* A run of pixels as it is stepped: values at a pixel, and their first and second differences. */
struct shaded_run {
    uint32_t z, dz;
    uint32_t f, df, ddf; /* as quadric_setup's diffuse */
    uint32_t u, du, ddu; /* as quadric_setup's second */
};

void sheen_quadric_rows(const struct tile *t, const struct setup *s);

/* quadric_rows.c: all of a struct quadric_setup except its quadrics; rows: sheen_quadric_rows or specialised ones. */
void sheen_take_quadric_rows(struct setup *s, const struct gradients *g, enum second second);
void sheen_shaded_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      struct shaded_run *run, enum second second);
/* A struct sheen_ramp_reader's shaded_run. */
void sheen_shaded_run_by_ramp(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                              struct shaded_run *run, unsigned second);

#endif
