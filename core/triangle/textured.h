/*
 * textured.h - private: triangles that show texels, from their coordinates and light at the corners.
 */
#ifndef SHEEN_TEXTURED_H
#define SHEEN_TEXTURED_H

#include "texels.h"

/* What a pixel takes: all give what the first, which takes everything, would. */
enum textured_pixels {
    TEXTURED_ANY,
    TEXTURED_UNLIT, /* the others: texels that repeat, on 565, light and highlight of 1.0 at the most and no hue; */
    TEXTURED_LIT,   /* here no highlight; to OTHER nearest, to GLOSSY 565 without key */
    TEXTURED_GLOSSY,
    TEXTURED_OTHER,
    TEXTURED_BILINEAR, /* 565 without key, unlit */
    TEXTURED_BILINEAR_OTHER,
    TEXTURED_FOGGED /* as the others, under fog: see sheen_fogged_texel_run */
};

/*
 * Linear on the screen: U and V in texels, Q15.16 modulo 2^32, light, specular intensity. Else these times weight over
 * `weight`, U and V times 2^up / 2^31, the others over 2.
 * Light: alike in all channels: as such; else the diffuse intensity. specular: the highlight, where it is white; else
 * the specular intensity. All with LIGHT_BITS of fraction.
 */
struct textured_setup {
    struct setup s; /* fast: enum textured_pixels; detail: up, 0..30 */
    struct plane u, v, light, specular, weight;
};

/* What is stepped along a run. */
struct texel_at {
    uint32_t z, u, v, light, specular;
};

/* Pixels of a row, from (x, y) on, which stands at `depth` in the tile: these are given. */
struct texel_run {
    uint16_t *depth;
    int32_t x, y, count;
    const struct tile *t; /* of sheen_textured_begin */
    const struct draw *d;
    unsigned pixels;        /* enum textured_pixels */
    uint32_t columns, rows; /* what coordinates are masked with, see textured_rows.c */
    struct texel_at step;   /* of sheen_textured_step */
    uint32_t packed, mend;
};

/*
 * As near to a picture's edges, texels in Q16.16, a coordinate may come so that neither steps along a run, which are
 * off by less than TEXEL_EDGE, packed or not, nor a bilinear neighbour show the other side (its share is rounded, by
 * more than steps that are not packed are off).
 */
#define TEXEL_EDGE 1280

static inline int32_t texel_edge(const struct sheen_texture *t)
{
    return t->bilinear ? 1 << 15 : TEXEL_EDGE;
}

/* Light at a diffuse intensity, UQ1.15, as it is stepped. */
static inline int32_t texel_light(const struct texel_terms *t, uint32_t diffuse)
{
    if (!t->alike)
        return (int32_t)(diffuse << (LIGHT_BITS - 15));
    return (int32_t)((t->a[0] + t->b[0] * diffuse) >> (t->fraction - LIGHT_BITS));
}

/* The cheapest pixels that give what any would. at: as of sheen_setup_textured. */
enum textured_pixels sheen_textured_pixels(const struct draw *d, const struct at_corners at[4]);

/*
 * at: U and V in texels, Q15.16, and light and specular intensity as struct textured_setup has them. straight: light
 * may be linear on the screen. U and V are used up.
 */
void sheen_setup_textured(struct setup *s, struct surface_corners *c, const struct gradients *g,
                          struct at_corners at[4], int straight);

/* Pixels of a run, TEXEL_PART at the most, from its numbers on. */
struct texel_part {
    uint16_t *depth;
    int32_t count;
    const struct texel_at *from, *step;
    uint32_t fog, fog_step; /* in fog its share, UQ0.24; of sheen_faded_part what it leaves, and 2^-12 */
};

#define TEXEL_PART 32 /* px */

/* Once a triangle in a tile; where the step is another; then a run from its first pixel's numbers on. */
void sheen_textured_begin(struct texel_run *r, const struct tile *t, const struct setup *s);
void sheen_textured_step(struct texel_run *r, const struct texel_at *step);
void sheen_textured_run(const struct texel_run *r, const struct texel_at *at);

/*
 * Texels under fog. TEXTURED_FOGGED: of a part, light and specular are what the fog leaves of them, together at most
 * 1.0 with its share; or nearest ones, unlit. Else any.
 */
void sheen_faded_part(const struct texel_run *r, const struct texel_part *part);
void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part);
void sheen_fogged_any_texels(const struct texel_run *r, const struct texel_at *from);

void sheen_textured_blocks(const struct tile *t, const struct setup *s);

#endif
