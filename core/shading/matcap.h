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

/* Of texels, Q16.16: steps along a run, packed or not, are off by less, and must not show the other side. */
#define MATCAP_EDGE 1280

void sheen_matcap_quadric_rows(const struct tile *t, const struct setup *s);
void sheen_matcap_normal_rows(const struct tile *t, const struct setup *s);

#endif
