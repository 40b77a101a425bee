/*
 * slerp.h - private to the room of slerp: its set-up, and what a row crosses.
 */
#ifndef SHEEN_SLERP_H
#define SHEEN_SLERP_H

#include "../math/arc.h"
#include "shading.h"

/* Corners from the top down; edges 02, 01 and 12 of them. */
struct slerp_corners {
    int16_t x[3], y[3];   /* as in struct vertex */
    int16_t normal[3][3]; /* as seen, 1.0 = 32767 */
    uint16_t weight[3];   /* UQ0.16, proportional to 1/m, not 0 */
    uint32_t inverse[3];  /* 1 / an edge's height, UQ.31, 1/64 px; 0: no row crosses it */
    uint8_t even;         /* no perspective: all weights are equal */
    uint8_t long_right;   /* edge 02 bounds the right */
};

struct slerp_setup {
    struct setup s;
    struct slerp_corners at;
};

extern const uint8_t sheen_slerp_end[3][2]; /* an edge's corners */

/* Of a weighed corner. */
static inline uint16_t slerp_weight(const struct surface_corners *c, unsigned k)
{
    return (uint16_t)(c->flat_weight ? 0xffff : max32((int32_t)(c->weight[k] >> 16), 1));
}

void sheen_slerp_corners(struct slerp_corners *s, const struct surface_corners *c);

/* Where a row crosses an edge. */
struct crossing {
    int32_t x;       /* px from the viewport's centre, Q15.16 */
    int32_t t;       /* of the edge in space, from the upper corner: UQ0.15 */
    uint32_t weight; /* UQ0.16 */
};

/* centre: of the row, 1/64 px from the viewport's centre. */
void sheen_slerp_cross(const struct slerp_corners *s, unsigned edge, int32_t centre, struct crossing *at);

/* t of the way from 1/m = a to b on the screen, UQ0.15, is so much in space; *weight: what is there. */
static inline int32_t in_space(int32_t t, uint32_t a, uint32_t b, uint32_t *weight)
{
    uint32_t part = (uint32_t)t * b, all = part + (uint32_t)(32768 - t) * a; /* below 2^31 */

    *weight = all >> 15;
    return ratio15(part, all);
}

void sheen_slerp_rows(const struct tile *t, const struct setup *s);

#endif
