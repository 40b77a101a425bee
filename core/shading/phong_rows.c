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
#include "../triangle/normal.h"
#include "phong.h"

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

void sheen_phong_rows(const struct tile *t, const struct setup *s)
{
    const struct phong_setup *p = (const struct phong_setup *)s;
    const struct draw *draw = s->draw;
    struct quadric square;

    sheen_quadric_from(&square, &p->square, -p->x, t->first_row - p->y);
    for (unsigned row = 0; row < t->rows; row++, quadric_down(&square)) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, &draw->colour, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t ln = plane_at(&p->light, x, y), nv = plane_at(&p->view, x, y);
        uint32_t d, step, bend;
        quadric_run(&square, x, &d, &step, &bend);
        for (; x < x1; x++, at++) {
            if (nearer(t, t->depth + at, z))
                put_lit(t, draw, rounding, at, x, lit_by_root(draw, (int32_t)ln, (int32_t)nv, d));
            z += s->depth.dx;
            ln += p->light.dx;
            nv += p->view.dx;
            d += step;
            step += bend;
        }
    }
}
