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

/* A pixel's values; d: N.N, whose step changes by the quadric's dxx at each pixel. */
struct root_at {
    uint32_t z, ln, nv, d, step;
};

SPECIALISED struct root_at root_begin(const struct phong_setup *p, const struct quadric *square, int32_t x, int32_t y)
{
    uint32_t bend;
    struct root_at at = {
        .z = plane_at(&p->s.depth, x, y), .ln = plane_at(&p->light, x, y), .nv = plane_at(&p->view, x, y)};

    quadric_run(square, x, &at.d, &at.step, &bend);
    return at;
}

SPECIALISED void root_step(const struct phong_setup *p, struct root_at *at)
{
    at->z += p->s.depth.dx;
    at->ln += p->light.dx;
    at->nv += p->view.dx;
    at->d += at->step;
    at->step += p->square.dxx;
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

/* 565 with the loop's terms. */
SPECIALISED void quick_root_rows(const struct tile *t, const struct phong_setup *p, const struct quadric *first)
{
    struct root_row row = {p->s.draw, NULL, t, NULL};
    struct quadric square = *first; /* a copy whose address nobody has, so that it can be in registers */
    const intptr_t to_pixel = t->to_pixel;
    const unsigned swap = p->s.draw->swap;
    const struct span *span = t->spans;
    uint16_t *line = t->depth + (t->first_row - t->rect.y0) * (int32_t)t->pitch - t->rect.x0;

    for (int32_t y = t->first_row, last = y + t->rows; y != last;
         y++, span++, line += t->pitch, quadric_down(&square)) {
        uint16_t *depth = line + span->x0, *const end = line + span->x1;
        if (depth >= end)
            continue;
        struct root_at at = root_begin(p, &square, span->x0, y);
        if (t->dither)
            row.thresholds = t->dither_rows[y & 7];
        do {
            if (nearer(t, depth, at.z)) {
                row.depth = depth;
                *pixel_at(depth, to_pixel) = pixel_order(root_pixel(&row, (int32_t)at.ln, (int32_t)at.nv, at.d), swap);
            }
            root_step(p, &at);
        } while (++depth != end);
    }
}
#endif

/* Any format, clamp and dither. */
static COLD void general_root_rows(const struct tile *t, const struct phong_setup *p, struct quadric *square)
{
    const struct draw *draw = p->s.draw;

    for (unsigned row = 0; row < t->rows; row++, quadric_down(square)) {
        const int32_t y = t->first_row + (int32_t)row;
        const struct rounding rounding = rounding_of(t, &draw->colour, y);
        int32_t x = t->spans[row].x0;
        struct root_at at = root_begin(p, square, x, y);
        for (uint32_t offset = tile_offset(t, x, y); x < t->spans[row].x1; x++, offset++, root_step(p, &at)) {
            if (nearer(t, t->depth + offset, at.z)) {
                struct lit lit = lit_by_root(draw, (int32_t)at.ln, (int32_t)at.nv, at.d);
                put_any(t, draw, rounding, offset, x, &lit);
            }
        }
    }
}

HOT void sheen_phong_rows(const struct tile *t, const struct setup *s)
{
    const struct phong_setup *p = (const struct phong_setup *)s;
    struct quadric square;

    sheen_quadric_from(&square, &p->square, -p->x, t->first_row - p->y);
#if FAST_LOOPS
    if (s->draw->is_565 && s->draw->loop.usable) {
        quick_root_rows(t, p, &square);
        return;
    }
#endif
    general_root_rows(t, p, &square);
}
