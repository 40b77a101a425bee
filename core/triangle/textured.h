/*
 * textured.h - private: textured triangles, from texel coordinates and light at their corners.
 */
#ifndef SHEEN_TEXTURED_H
#define SHEEN_TEXTURED_H

#include "texels.h"

/*
 * Which loop draws the pixels. TEXTURED_ANY draws everything. The others give the same pixels, but need a 565 target, a
 * texture that repeats (or no coordinate near its edges), and light and highlight without hue and at most 1.0. From
 * UNLIT to OTHER texels are nearest, and from UNLIT to GLOSSY 565 without key.
 */
enum textured_loop {
    TEXTURED_ANY,
    TEXTURED_UNLIT,
    TEXTURED_LIT, /* no highlight */
    TEXTURED_GLOSSY,
    TEXTURED_OTHER,
    TEXTURED_BILINEAR, /* 565 without key, unlit */
    TEXTURED_BILINEAR_OTHER,
    TEXTURED_FOGGED /* as the others, under fog: see sheen_fogged_texel_run */
};

/*
 * Linear on the screen: u and v are in texels, Q15.16 modulo 2^32. Otherwise all four are times weight / 2^31, u and v
 * times 2^up besides; `weight` is UQ0.32.
 * light: if it is alike in all channels, the light itself; else the diffuse intensity. specular: if it is white, the
 * highlight itself; else the specular intensity. Both have LIGHT_BITS of fraction.
 */
struct textured_setup {
    struct setup s; /* special_loop: enum textured_loop; detail: up, 0..30 */
    struct plane u, v, light, specular, weight;
};

/* What is stepped along a run. */
struct texel_at {
    uint32_t z, u, v, light, specular;
};

/* A run of pixels in a row. */
struct texel_run {
    uint16_t *depth; /* of the first pixel, (x, y), in the tile; set by the caller, as are these: */
    int32_t x, y, count;
    const struct tile *t; /* set by sheen_textured_begin, as are these: */
    const struct draw *d;
    unsigned special_loop;      /* enum textured_loop */
    uint32_t columns, rows;     /* masks of coordinates, see textured_rows.c */
    struct texel_at step;       /* set by sheen_textured_step, as are these: */
    uint32_t packed_step, mend; /* U and V in one word, see texel_steps.h; mend: what TEXEL_PART steps lack */
};

/*
 * How near to a picture's edges, in texels, Q16.16, a coordinate may come without showing the other side: steps along a
 * run, packed or not, are off by less than TEXEL_EDGE; a bilinear neighbour is half a texel away (the rounding of its
 * share hides the error of steps that are not packed, which is smaller).
 */
#define TEXEL_EDGE 1280

static inline int32_t texel_edge(const struct sheen_texture *t)
{
    return t->bilinear ? 1 << 15 : TEXEL_EDGE;
}

/* The light at a diffuse intensity, UQ1.15, as struct textured_setup has it. */
static inline int32_t texel_light(const struct texel_terms *t, uint32_t diffuse)
{
    if (!t->alike)
        return (int32_t)(diffuse << (LIGHT_BITS - 15));
    return (int32_t)((t->a[0] + t->b[0] * diffuse) >> (t->fraction - LIGHT_BITS));
}

/* The cheapest loop that gives the same pixels as TEXTURED_ANY. at: as for sheen_setup_textured. */
enum textured_loop sheen_textured_loop(const struct draw *d, const struct at_corners at[4]);

/*
 * at: U and V in texels, Q15.16, and light and specular as struct textured_setup has them; U and V are overwritten.
 * straight: light may be linear on the screen.
 */
void sheen_setup_textured(struct setup *s, struct surface_corners *c, const struct gradients *g,
                          struct at_corners at[4], int straight);

/* A part of a run, at most TEXEL_PART pixels; `from`: the values at its first pixel. */
struct texel_part {
    uint16_t *depth;
    int32_t count;
    const struct texel_at *from, *step;
    uint32_t fog, fog_step; /* the fog's share, UQ0.24; for sheen_faded_part what the fog leaves, plus 2^-12 */
};

#define TEXEL_PART 32 /* px */

/*
 * How runs are drawn: _begin is called once per triangle in a tile, _step whenever the step changes, _run for each run
 * with the values at its first pixel.
 */
void sheen_textured_begin(struct texel_run *r, const struct tile *t, const struct setup *s);
void sheen_textured_step(struct texel_run *r, const struct texel_at *step);
void sheen_textured_run(const struct texel_run *r, const struct texel_at *at);

/* TEXTURED_ANY, without fog. */
void sheen_any_texels(const struct texel_run *r, const struct texel_at *from);

/*
 * Texels under fog. sheen_faded_part: of TEXTURED_FOGGED, nearest and unlit. sheen_fogged_part: of TEXTURED_FOGGED;
 * light and specular are what the fog leaves of them, at most 1.0 together with its share. Then any other texels.
 */
void sheen_faded_part(const struct texel_run *r, const struct texel_part *part);
void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part);
void sheen_fogged_any_texels(const struct texel_run *r, const struct texel_at *from);

void sheen_textured_blocks(const struct tile *t, const struct setup *s);

#endif
