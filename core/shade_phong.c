/*
 * shade_phong.c - linear interpolation of normals (lecture, "Phong Shading",
 * "Clever Implementation"): no vector is ever normalised.
 *
 * With N(x, y) linear on the screen (times 1/m: Blinn's way, the factor drops
 * out), L.N and V.N are linear and D = N.N is quadratic: adds only. One
 * r = 1/sqrt(D) a pixel gives both terms,
 *   diffuse  = (L.N) r,   R.V = 2 (L.N)(V.N) r^2 - L.V.
 * Over a triangle the result does not depend on its orientation.
 */
#include "newton.h"
#include "shade.h"

/*
 * D outside the root table's [1/4, 1 + 1/512): normals far apart, or a triangle
 * scaled down. D is brought back by a power of four and L.N, V.N by its root.
 * Returns 0 where there is no direction left.
 */
static int rescale(uint32_t *d, int32_t *ln, int32_t *nv)
{
    if (*d < 1u << 8)
        return 0;
    while (*d < 1u << 29) {
        *d <<= 2;
        *ln = (int32_t)((uint32_t)*ln << 1);
        *nv = (int32_t)((uint32_t)*nv << 1);
    }
    while (*d >= (1u << 31) + (1u << 22)) {
        *d >>= 2;
        *ln = asr32(*ln, 1);
        *nv = asr32(*nv, 1);
    }
    return 1;
}

#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* Intensities at a pixel from L.N, V.N (Q1.30) and D = N.N (UQ1.31). */
SPECIALISED void light_pixel(const struct sheen_material *m, int32_t lv1, int32_t ln, int32_t nv, uint32_t d,
                             struct lit *lit)
{
    lit->diffuse = 0;
    lit->specular = 0;
    if (ln <= 0)
        return;
    if (d - (1u << 29) >= (3u << 29) + (1u << 22) && !rescale(&d, &ln, &nv))
        return;
    /*
     * Range: L.N <= sqrt(D), so the first product is below 2^31 and its quotient at most 1.0 but for rounding;
     * unsigned, so that nothing overflows where a sliver's rounding has parted the two.
     */
    uint32_t root = root_seed(d);                                           /* UQ1.15 */
    uint32_t diffuse = ((((uint32_t)ln + HALF) >> 15) * root + HALF) >> 15; /* Q0.15 */
    int32_t facing =
        asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)nv + HALF), 15) * root + HALF), 15); /* Q0.15 */
    if (diffuse > 32768)
        diffuse = 32768;
    lit->diffuse = diffuse;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is half of itself there */
    lit->specular = (power_at(m, (int32_t)((uint32_t)lv1 - diffuse * (uint32_t)facing)) + 1) >> 1;
}

SPECIALISED void root_rows(const struct tile *t, const struct setup *s, enum put put)
{
    const struct sheen_material *material = s->draw->material;
    const struct quadric *q = &s->shade.phong.square;
    const uint32_t dln = s->shade.phong.light.dx, dnv = s->shade.phong.view.dx, dz = s->depth.dx;
    const int32_t lv1 = s->draw->light.lv1[0];
    struct colour_terms terms = s->draw->colour;

    if (put != PUT_GENERAL) /* + 1/2 once for all pixels */
        for (int k = 0; k < 3; k++)
            terms.a[k] += 1u << (terms.fraction - 1);
    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &terms, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t ln = plane_at(&s->shade.phong.light, x, y), nv = plane_at(&s->shade.phong.view, x, y);
        uint32_t d = quadric_at(q, x, y), dd = q->dx + (uint32_t)x * q->dxx + (uint32_t)y * q->dxy;
        for (; x < x1; x++, at++, z += dz, ln += dln, nv += dnv, d += dd, dd += q->dxx) {
            if (!depth_test(t, at, z))
                continue;
            struct lit lit;
            light_pixel(material, lv1, (int32_t)ln, (int32_t)nv, d, &lit);
            uint32_t r = colour_channel(&terms, 0, &lit), g = colour_channel(&terms, 1, &lit);
            uint32_t b = colour_channel(&terms, 2, &lit);
            if (put == PUT_GENERAL)
                put_general(t, &terms, rounding, at, x, r, g, b);
            else
                put_fast(t, at, r, g, b, terms.fraction, put == PUT_FAST_SWAP);
        }
    }
}

void sheen_shade_phong_root(const struct tile *t, const struct setup *s)
{
    if (!s->fast)
        root_rows(t, s, PUT_GENERAL);
    else if (t->format->swap)
        root_rows(t, s, PUT_FAST_SWAP);
    else
        root_rows(t, s, PUT_FAST);
}
