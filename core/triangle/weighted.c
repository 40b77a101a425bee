/*
 * weighted.c - planes of attributes times weight: what is linear in space is linear on the screen when multiplied by
 * 1/m.
 */
#include "normal.h"

/*
 * The least weight of a corner. A unit normal is then 16 steps long where pixels read it (pixel_normal), from which
 * rounding, up to 0.87, and the planes' error take something; less than 8 counts as no normal.
 */
#define LEAST_WEIGHT 16

void sheen_corner_weights(struct surface_corners *c, int32_t w[3])
{
    sheen_weigh(c);
    for (int k = 0; k < 3; k++)
        w[k] = max32((int32_t)((c->weight[k] >> 17) + (c->weight[k] >> 16 & 1u)), LEAST_WEIGHT);
}

struct plane sheen_weighted_plane(const struct gradients *g, const int32_t w[3], const int32_t x[3])
{
    const int32_t f0 = w[0] * x[0];
    struct plane p;

    sheen_plane(&p, g, (uint32_t)f0, cut_cosine(w[1] * x[1], f0), cut_cosine(w[2] * x[2], f0), 16);
    return p;
}
