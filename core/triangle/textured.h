/*
 * textured.h - private: triangles that show texels, from their coordinates and light at the corners.
 */
#ifndef SHEEN_TEXTURED_H
#define SHEEN_TEXTURED_H

#include "triangle.h"

/* What a pixel takes: all give what the first, which takes everything, would. */
enum textured_pixels {
    TEXTURED_ANY,
    TEXTURED_UNLIT, /* the others: nearest texels of 565 that repeat, without key; no light, */
    TEXTURED_LIT    /* or one that is alike in all channels and 1.0 at most, without a highlight */
};

/*
 * Linear on the screen: U and V in texels, Q15.16 modulo 2^32, light, specular intensity. Else these times weight over
 * `weight`, U and V times 2^up / 2^31, the others over 2.
 * Light: alike in all channels: UQ6.25; else the diffuse intensity, UQ2.30. specular: UQ2.30.
 */
struct textured_setup {
    struct setup s; /* fast: enum textured_pixels; detail: up, 0..30 */
    struct plane u, v, light, specular, weight;
};

/* What is stepped along a run. */
struct texel_at {
    uint32_t z, u, v, light, specular;
};

/* Pixels of a row, from (x, y) on, which stands at `depth` in the tile. */
struct texel_run {
    const struct tile *t;
    const struct draw *d;
    uint16_t *depth;
    int32_t x, y, count;
    unsigned pixels; /* enum textured_pixels */
};

/*
 * What rounding takes off a coordinate that lies on a border must not show the texel on its other side, and light is
 * cut at a pixel, so half of what is cut is there before.
 */
#define BORDER_BIAS 64 /* 1/1024 texel */
#define LIGHT_BIAS (1 << (LIGHT_PLANE_BITS - LIGHT_BITS - 1))

/* Of an attribute, in the order of the gradients. */
struct at_corners {
    int32_t f[3];
};

/* Light at a diffuse intensity, UQ1.15, as it is stepped. */
static inline int32_t texel_light(const struct texel_terms *t, uint32_t diffuse)
{
    if (!t->alike)
        return (int32_t)(diffuse << 15);
    return (int32_t)((t->a[0] + t->b[0] * diffuse) >> (t->fraction - LIGHT_PLANE_BITS)) + LIGHT_BIAS;
}

/*
 * at: U and V in texels, Q15.16, and light and specular intensity as struct textured_setup has them. straight: light
 * may be linear on the screen.
 */
void sheen_setup_textured(struct setup *s, struct surface_corners *c, const struct gradients *g,
                          const struct at_corners at[4], int straight);

void sheen_textured_run(const struct texel_run *r, struct texel_at at, const struct texel_at *step);
void sheen_textured_blocks(const struct tile *t, const struct setup *s);

#endif
