/*
 * phong.h - private to the room of Phong shading: its set-ups, and what its files hand each other.
 */
#ifndef SHEEN_PHONG_H
#define SHEEN_PHONG_H

#include "shading.h"

/* One light: L.N, V.N and N.N over the triangle; detail: blocks, the logarithm of their length, px. */
struct phong_setup {
    struct setup s;
    struct plane light, view; /* L.N and V.N, Q1.30 */
    struct quadric square;    /* N.N, UQ1.31 */
};

/* Several lights. */
struct phong_lights_setup {
    struct setup s;
    struct plane normal[3]; /* N, Q1.30 */
};

/* phong_nodes.c: normals nearly agree. Returns 0 where they do not, or another way is forced. */
int sheen_phong_nodes(struct setup *s, const struct surface_corners *c, const struct gradients *g);

/* L.N, V.N and N.N at a pixel of a row, and the last one's step. */
struct normal_run {
    uint32_t ln, nv, d, d_step;
};

/* A quadratic along a row, a step a pixel. */
struct parabola {
    int32_t value, step, bend;
};

int sheen_rescale(uint32_t *d, int32_t *ln, int32_t *nv);
void sheen_phong_root_run(const struct tile *t, const struct phong_setup *s, int32_t x, int32_t x1, int32_t y,
                          struct normal_run run);
void sheen_phong_block(const struct tile *t, const struct phong_setup *s, int32_t x, int32_t y, struct parabola diffuse,
                       struct parabola reflected);
void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

/* D inside the root table: UQ1.31 from 1/4 to 1 + 1/512. */
#define ROOT_LOWEST (1u << 29)
#define ROOT_RANGE ((3u << 29) + (1u << 22))

#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* A dot product with N over |N|: Q1.30 times UQ1.15 to Q0.15; modulo 2^32, should a sliver's rounding part the two. */
SPECIALISED int32_t normalised(int32_t dot, uint32_t root)
{
    return asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)dot + HALF), 15) * root + HALF), 15);
}

#endif
