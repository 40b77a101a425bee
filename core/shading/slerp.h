/*
 * slerp.h - private to the room of slerp: its set-up, a row's arc, and its blocks.
 */
#ifndef SHEEN_SLERP_H
#define SHEEN_SLERP_H

#include "shading.h"

struct slerp_setup {
    struct setup s;
    int16_t normal[3][3]; /* of the corners, as seen, Q0.15 */
    uint16_t weight[3];   /* UQ0.16, proportional to 1/m */
    int16_t x[3], y[3];   /* as in struct vertex */
    uint32_t angle[3];    /* between the normals of corners k and k + 1, turns */
};

/* A unit vector at each end of a row of the triangle, and the arc between. */
struct slerp_row {
    int32_t x0, width;      /* the left crossing and the distance to the right one, px, Q15.16 */
    uint32_t weight[2];     /* at both, UQ0.32 */
    uint32_t angle;         /* between the normals, turns, at most 1/2 */
    uint8_t even;           /* t* is t: no perspective, or none that would be seen */
    uint8_t block;          /* px over which the angle may grow evenly */
    uint8_t opposite;       /* the ends are opposite: the left one holds while t < 1/2 */
    struct arc_light {      /* a light along the arc, w the angle from the left end: */
        int32_t a, b;       /* L.N = a cos w + b sin w, Q1.30 */
        int32_t mean, p, q; /* R.V = mean + p cos 2w + q sin 2w, Q2.29 */
    } light[SHEEN_MAX_LIGHTS];
};

/* x + x's law x'' = -e x, one light's two sinusoids at a pixel and their next steps. */
struct arc_state {
    int32_t light, light_step;         /* L.N, Q1.30 */
    int32_t reflected, reflected_step; /* R.V less its mean, Q2.29 */
};

/* A run of pixels over which the angle grows evenly. */
struct arc_block {
    struct arc_state state[SHEEN_MAX_LIGHTS];
    uint32_t light_law, reflected_law;             /* e = 4 sin^2(step / 2) and 4 sin^2(step): 15 bits, */
    unsigned light_law_shift, reflected_law_shift; /* over 2^(15 + shift) */
};

void sheen_slerp_block(const struct tile *t, const struct slerp_setup *s, const struct slerp_row *row,
                       struct arc_block *block, int32_t x, int32_t y, unsigned length);

#endif
