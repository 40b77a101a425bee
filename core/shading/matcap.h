/*
 * matcap.h - private to the room of matcaps: their set-up and how its rows are drawn.
 */
#ifndef SHEEN_MATCAP_H
#define SHEEN_MATCAP_H

#include "../triangle/quadric.h"
#include "../triangle/textured.h"
#include "shading.h"

/* Along a row texel coordinates are linear over blocks of `detail` px, whose ends are those of the triangle's way. */
struct matcap_setup {
    struct setup s; /* fast: enum textured_pixels; detail: 1..LARGEST_BLOCK */
    union {
        struct quadric quadric[2]; /* (1 + x of the normal) / 2 and (1 - y) / 2, UQ1.31: within the picture */
        struct plane normal[3];    /* the normal before the eye times 1/m, Q1.30 */
    };
    int16_t x, y; /* the pixel that quadrics count from */
};

#define LARGEST_BLOCK 32 /* px */

/* (1 + x) / 2 of the picture's 2^size texels, Q16.16, within its edges; x: Q0.15. */
static inline int32_t texel_at_cosine(int32_t x, unsigned size, int32_t edge)
{
    return max32(edge, min32((x + 32768) * (1 << size) + BORDER_BIAS, (1 << (16 + size)) - edge));
}

void sheen_matcap_quadric_rows(const struct tile *t, const struct setup *s);
void sheen_matcap_normal_rows(const struct tile *t, const struct setup *s);

#endif
