/*
 * phong_rows.c - linear interpolation of normals (lecture, "Phong Shading",
 * "Clever Implementation"): no vector is ever normalised.
 *
 * With N(x, y) linear on the screen (times 1/m: Blinn's way, the factor drops
 * out), L.N and V.N are linear and D = N.N is quadratic: adds only. One
 * r = 1/sqrt(D) per pixel gives both terms,
 *   diffuse  = (L.N) r,   R.V = 2 (L.N)(V.N) r^2 - L.V.
 * Over a triangle the result does not depend on its orientation.
 */
#include "../triangle/normal.h"
#include "phong.h"

/* A dot product with N, Q1.30, times 1 / |N|, UQ1.15: Q0.15. Modulo 2^32, as rounding on a sliver may part the two. */
SPECIALISED int32_t normalised(int32_t dot, uint32_t root)
{
    return asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)dot + HALF), 15) * root + HALF), 15);
}

/*
 * Brings D from outside the root table's range [1/4, 1 + 1/512) into it by a power of four, and L.N and V.N along by
 * the root of that. Returns 0 if N is too short to have a direction.
 */
static int rescale(uint32_t *d, int32_t *ln, int32_t *nv)
{
    if (*d < 1u << 8)
        return 0;
    while (*d < ROOT_LOWEST) {
        *d <<= 2;
        *ln = (int32_t)((uint32_t)*ln << 1);
        *nv = (int32_t)((uint32_t)*nv << 1);
    }
    while (*d >= ROOT_LOWEST + ROOT_RANGE) {
        *d >>= 2;
        *ln = asr32(*ln, 1);
        *nv = asr32(*nv, 1);
    }
    return 1;
}

/* Intensities at a pixel from L.N, V.N (Q1.30) and D = N.N (UQ1.31). */
SPECIALISED struct lit lit_by_root(const struct draw *draw, int32_t ln, int32_t nv, uint32_t d)
{
    struct lit lit = {0, 0};

    if (ln <= 0 || (d - ROOT_LOWEST >= ROOT_RANGE && !rescale(&d, &ln, &nv)))
        return lit;
    /* Range: L.N <= sqrt(D), except between opposite normals, where N nearly vanishes: the product is below 2^31. */
    uint32_t root = root_seed(d);                                           /* UQ1.15 */
    uint32_t diffuse = ((((uint32_t)ln + HALF) >> 15) * root + HALF) >> 15; /* Q0.15 */
    lit.diffuse = diffuse < 32768 ? diffuse : 32768;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is Q0.30, so as Q2.29 it is doubled */
    int32_t u = (int32_t)((uint32_t)draw->light.lv1[0] - lit.diffuse * (uint32_t)normalised(nv, root));
    if (u < (int32_t)draw->power.limit)
        lit.specular = highlight_at(draw->power, u, lit.diffuse);
    return lit;
}

SPECIALISED void root_step(struct root_run *at)
{
    at->z += at->dz;
    at->ln += at->dln;
    at->nv += at->dnv;
    at->d += at->step;
    at->step += at->bend;
}

#if FAST_LOOPS
/* On M0+ a pixel is a function of its own, so that it has enough registers. */
#if defined(__ARM_ARCH_6M__)
#define PIXEL HOT static APART
#else
#define PIXEL SPECIALISED
#endif

/* What the pixels of a row share, and in `depth` the current pixel's. */
struct root_row {
    const struct draw *draw;
    const threshold_t *thresholds; /* NULL: nothing dithers */
    const struct tile *t;
    const uint16_t *depth;
};

PIXEL uint32_t root_pixel(const struct root_row *row, int32_t ln, int32_t nv, uint32_t d)
{
    const struct lit lit = lit_by_root(row->draw, ln, nv, d);
    const uint32_t pair = row->thresholds != NULL ? threshold_pair(row->thresholds, row->depth) : 0;

    return loop_pixel(row->t, row->depth, &row->draw->loop, lit.diffuse, lit.specular != 0, lit.specular,
                      pair << (LOOP_FRACTION - 11));
}

/* 565 with the loop's terms: the pixels whose depths follow `depth`, up to `last` inclusive. */
SPECIALISED void quick_root_run(const struct tile *t, const struct draw *draw, const threshold_t *thresholds,
                                uint16_t *depth, const uint16_t *last, const struct root_run *run)
{
    struct root_row row = {draw, thresholds, t, NULL};
    const intptr_t to_pixel = t->to_pixel;
    const unsigned swap = draw->swap;
    struct root_run at = *run;

    do {
        depth++;
        if (nearer(t, depth, at.z)) {
            row.depth = depth;
            *pixel_at(depth, to_pixel) = pixel_order(root_pixel(&row, (int32_t)at.ln, (int32_t)at.nv, at.d), swap);
        }
        root_step(&at);
    } while (depth != last);
}
#endif

/* Any format, clamp and dither. */
static COLD void general_root_run(const struct tile *t, const struct draw *draw, int32_t x, int32_t x1, int32_t y,
                                  struct root_run *run)
{
    struct rounding rounding = rounding_of(t, &draw->colour, y);

    for (uint32_t at = tile_offset(t, x, y); x < x1; x++, at++, root_step(run)) {
        if (nearer(t, t->depth + at, run->z)) {
            struct lit lit = lit_by_root(draw, (int32_t)run->ln, (int32_t)run->nv, run->d);
            put_any(t, draw, rounding, at, x, &lit);
        }
    }
}

HOT void sheen_root_run(const struct tile *t, const struct draw *draw, int32_t x, int32_t x1, int32_t y,
                        struct root_run *run)
{
#if FAST_LOOPS
    if (draw->is_565 && draw->loop.usable) {
        uint16_t *before = t->depth + tile_offset(t, x, y) - 1;
        quick_root_run(t, draw, t->dither ? t->dither_rows[y & 7] : NULL, before, before + (x1 - x), run);
        return;
    }
#endif
    general_root_run(t, draw, x, x1, y, run);
}
