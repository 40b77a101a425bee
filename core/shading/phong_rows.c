/*
 * phong_rows.c - linear interpolation of normals (lecture, "Phong Shading",
 * "Clever Implementation"): no vector is ever normalised.
 *
 * With N(x, y) linear on the screen (times 1/m: Blinn's way, the factor drops
 * out), L.N and V.N are linear and D = N.N is quadratic: adds only. One
 * r = 1/sqrt(D) a pixel gives both terms,
 *   diffuse  = (L.N) r,   R.V = 2 (L.N)(V.N) r^2 - L.V.
 * Over a triangle the result does not depend on its orientation.
 */
#include "phong.h"

/* D inside the root table: UQ1.31 from 1/4 to 1 + 1/512. */
#define ROOT_LOWEST (1u << 29)
#define ROOT_RANGE ((3u << 29) + (1u << 22))
#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* A dot product with N over |N|: Q1.30 times UQ1.15 to Q0.15; modulo 2^32, should a sliver's rounding part the two. */
SPECIALISED int32_t normalised(int32_t dot, uint32_t root)
{
    return asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)dot + HALF), 15) * root + HALF), 15);
}

/*
 * D outside the root table's [1/4, 1 + 1/512): it is brought back by a power of four and L.N, V.N by its root.
 * Returns 0 where there is no direction left.
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
    /* Range: L.N <= sqrt(D), so the product is below 2^31 and its quotient at most 1.0 but for rounding. */
    uint32_t root = root_seed(d);                                           /* UQ1.15 */
    uint32_t diffuse = ((((uint32_t)ln + HALF) >> 15) * root + HALF) >> 15; /* Q0.15 */
    lit.diffuse = diffuse < 32768 ? diffuse : 32768;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is half of itself there */
    int32_t u = (int32_t)((uint32_t)draw->light.lv1[0] - lit.diffuse * (uint32_t)normalised(nv, root));
    lit.specular = highlight_at(draw->power, u, lit.diffuse);
    return lit;
}

/* Any format, clamp and dither. */
SPECIALISED void put_lit(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                         struct lit lit)
{
    if (FAST_LOOPS && d->loop.usable) {
        uint32_t threshold = t->dither ? (uint32_t)rounding.threshold[x & 7] << rounding.shift : 0;
        ((uint16_t *)t->pixels)[at] =
            pixel_order(loop_pixel(t, t->depth + at, &d->loop, lit.diffuse, lit.specular, threshold), t->format->swap);
    } else {
        put_general(t, &d->colour, rounding, at, x, colour_channel(&d->colour, 0, &lit),
                    colour_channel(&d->colour, 1, &lit), colour_channel(&d->colour, 2, &lit));
    }
}

void sheen_phong_rows(const struct tile *t, const struct setup *s)
{
    const struct phong_setup *p = (const struct phong_setup *)s;
    const struct draw *draw = s->draw;
    struct quadric square = sheen_quadric_from(&p->square, t->first_row - p->y);

    for (unsigned row = 0; row < t->rows; row++, quadric_down(&square)) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row, n = x - p->x;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &draw->colour, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t ln = plane_at(&p->light, x, y), nv = plane_at(&p->view, x, y);
        uint32_t d = square.base + (uint32_t)n * square.dx + pairs(n) * square.dxx;
        uint32_t step = square.dx + (uint32_t)n * square.dxx;
        for (; x < x1; x++, at++) {
            if (nearer(t, t->depth + at, z))
                put_lit(t, draw, rounding, at, x, lit_by_root(draw, (int32_t)ln, (int32_t)nv, d));
            z += s->depth.dx;
            ln += p->light.dx;
            nv += p->view.dx;
            d += step;
            step += square.dxx;
        }
    }
}

/* ---- several lights ---- */

/*
 * A pixel's normal, Q0.15 of a length in [1/2, 1], and 1/|N|: a root seed, UQ1.15, and the share, Q.28, that it lacks
 * of it. Where a triangle is magnified, what the seed is off by is that of thousands of pixels, and of it a highlight
 * makes n times as much; what rounding turns N by does not show.
 */
struct pixel_normal {
    int32_t n[3];
    uint32_t root;
    int32_t lacks;
};

/* Half of 1 - D root^2, D UQ1.31, Q.28: below 2^15. */
static int32_t root_lacks(uint32_t d, uint32_t root)
{
    const uint32_t square = root * root, high = d >> 16, low = d & 0xffffu; /* UQ2.30 */
    uint32_t product =
        high * (square >> 16) + (high * (square & 0xffffu) >> 16) + (low * (square >> 16) >> 16); /* UQ.29 */

    return asr32((int32_t)((1u << 29) - product), 2);
}

/* Returns 0 where there is no direction left. */
static int pixel_normal(const uint32_t plane[3], struct pixel_normal *p)
{
    int32_t *n = p->n;
    uint32_t square = 0; /* UQ2.30 */

    for (int i = 0; i < 3; i++) {
        n[i] = asr32((int32_t)(plane[i] + HALF), 15); /* |n| <= 2^16 whatever the planes */
        n[i] = min32(max32(n[i], -32768), 32768);
        square += (uint32_t)(n[i] * n[i]); /* three terms <= 2^30 */
    }
    if (square < 1u << 8)
        return 0;
    if (square >= 1u << 30) /* a unit normal, rounded outwards */
        square = 1u << 30;
    while (square < ROOT_LOWEST >> 1) {
        square <<= 2;
        for (int i = 0; i < 3; i++)
            n[i] *= 2;
    }
    p->root = root_seed(square << 1);
    p->lacks = root_lacks(square << 1, p->root);
    return 1;
}

/* v.N over |N|, held at +-1.0: Q2.29. Range: |dot| < 2^31, so root times its high half stays below 2^31. */
SPECIALISED int32_t unit_dot_at(const struct pixel_normal *p, const int32_t v[3])
{
    int32_t dot = 2 * dot32_q29(p->n, v);
    int32_t x = (int32_t)p->root * asr32(dot, 16) + (int32_t)(p->root * ((uint32_t)dot & 0xffffu) >> 16);

    x += asr32(asr32(x, 15) * p->lacks, 13);
    return min32(max32(x, -(1 << 29)), 1 << 29);
}

/* Sum over the lights, each with its weight. */
static void light_normal(const struct draw *d, const struct pixel_normal *p, struct lit *lit)
{
    const struct lighting *l = &d->light;
    const int32_t facing = unit_dot_at(p, l->view);
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0 */

    for (unsigned i = 0; i < l->count; i++) {
        int32_t ln = unit_dot_at(p, l->to[i]), high = asr32(ln, 14);
        uint32_t rounded = (uint32_t)asr32(ln + (1 << 13), 14); /* UQ1.15 */
        if (ln <= 0)
            continue;
        int32_t product = mul_16_32(high, facing) + asr32((ln & 0x3fff) * asr32(facing, 15), 15); /* Q.28 */
        int32_t u = (int32_t)((uint32_t)l->lv1[i] - 4u * (uint32_t)product);
        diffuse += l->diffuse_weight[i] * rounded;
        specular += l->specular_weight[i] * highlight_at(d->power, u, rounded);
    }
    lit->diffuse = (diffuse + HALF) >> 15;
    lit->specular = (specular + HALF) >> 15;
}

void sheen_phong_lights_rows(const struct tile *t, const struct setup *s)
{
    const struct plane *p = ((const struct phong_normals_setup *)s)->normal;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &s->draw->colour, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t plane[3] = {plane_at(&p[0], x, y), plane_at(&p[1], x, y), plane_at(&p[2], x, y)};
        for (; x < x1; x++, at++, z += s->depth.dx) {
            if (nearer(t, t->depth + at, z)) {
                struct lit lit = {0, 0};
                struct pixel_normal normal;
                if (pixel_normal(plane, &normal))
                    light_normal(s->draw, &normal, &lit);
                put_lit(t, s->draw, rounding, at, x, lit);
            }
            for (int i = 0; i < 3; i++)
                plane[i] += p[i].dx;
        }
    }
}
