/*
 * matcap.h - private to the room of matcaps: their set-up and the functions that draw its rows.
 */
#ifndef SHEEN_MATCAP_H
#define SHEEN_MATCAP_H

#include "../triangle/quadric.h"
#include "../triangle/textured.h"
#include "shading.h"

/*
 * Along a row texel coordinates are linear over blocks of `detail` px. At a block's ends they come from the quadrics or
 * from the normal, according to the triangle's way.
 */
struct matcap_setup {
    struct setup s; /* special_loop: enum textured_loop; detail: 1..LARGEST_BLOCK */
    union {
        struct quadric quadric[2]; /* (1 + x of the normal) / 2 and (1 - y) / 2, UQ1.31, within the picture */
        struct plane normal[3];    /* the normal in eye space times 1/m, Q1.30 */
    };
    int16_t x, y; /* the pixel that quadrics count from */
};

#define LARGEST_BLOCK 32 /* px */

/* Two lights along the eye's x and y axes: their L.N are x and y of the normal in eye space. */
static const struct sheen_light eye_axes[2] = {{.to = {1 << 30, 0, 0}, .with_eye = 1},
                                               {.to = {0, 1 << 30, 0}, .with_eye = 1}};

/* (1 + x) / 2 of the picture's 2^size texels, Q16.16, held at least `edge` inside the picture; x: Q0.15. */
static inline int32_t texel_at_cosine(int32_t x, unsigned size, int32_t edge)
{
    return max32(edge, min32((x + 32768) * (1 << size) + BORDER_BIAS, (1 << (16 + size)) - edge));
}

/*
 * x and y, Q0.15, of a normal of any length after it is normalised; 0 if it is too short to have a direction. Range:
 * parts are below 2^15, the largest is 2^14 or more, so a part times half of the root is at most 2^30.
 */
static inline void cosines_of(const uint32_t normal[3], int32_t *x, int32_t *y)
{
    uint32_t all = magnitude32((int32_t)normal[0]) | magnitude32((int32_t)normal[1]) | magnitude32((int32_t)normal[2]);
    unsigned up = 0;

    *x = *y = 0;
    if (all >= 1u << 10) {
        int32_t n[3];
        for (; all < 1u << 30; all <<= 1)
            up++;
        for (int i = 0; i < 3; i++)
            n[i] = asr32((int32_t)(normal[i] << up), 16);
        const uint32_t square = (uint32_t)(n[0] * n[0]) + (uint32_t)(n[1] * n[1]) + (uint32_t)(n[2] * n[2]);
        const unsigned quarter = square < 1u << 30 ? 2 : 0;
        const int32_t root = (int32_t)(root_seed(square << quarter >> 1) >> 1);
        *x = asr32(n[0] * root, 15 - quarter / 2);
        *y = asr32(n[1] * root, 15 - quarter / 2);
    }
}

void sheen_matcap_quadric_rows(const struct tile *t, const struct setup *s);
void sheen_matcap_normal_rows(const struct tile *t, const struct setup *s);

#endif
