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

/*
 * D outside the root table's [1/4, 1 + 1/512): normals far apart, or a triangle
 * scaled down. D is brought back by a power of four and L.N, V.N by its root.
 * Returns 0 where there is no direction left.
 */
int sheen_rescale(uint32_t *d, int32_t *ln, int32_t *nv)
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
SPECIALISED void light_pixel(struct power power, int32_t lv1, int32_t ln, int32_t nv, uint32_t d, struct lit *lit)
{
    lit->diffuse = 0;
    lit->specular = 0;
    if (ln <= 0)
        return;
    if (d - ROOT_LOWEST >= ROOT_RANGE && !sheen_rescale(&d, &ln, &nv))
        return;
    /* Range: L.N <= sqrt(D), so the product is below 2^31 and its quotient at most 1.0 but for rounding. */
    uint32_t root = root_seed(d);                                           /* UQ1.15 */
    uint32_t diffuse = ((((uint32_t)ln + HALF) >> 15) * root + HALF) >> 15; /* Q0.15 */
    if (diffuse > 32768)
        diffuse = 32768;
    lit->diffuse = diffuse;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is half of itself there */
    int32_t u = (int32_t)((uint32_t)lv1 - diffuse * (uint32_t)normalised(nv, root));
    lit->specular = highlight_at(power, u, diffuse);
}

/* Pixels x..x1 with a root each; fast is a constant argument, rounding then is in the terms. */
SPECIALISED void root_run(const struct tile *t, const struct phong_setup *p, const struct colour_terms *terms,
                          int32_t x, int32_t x1, int32_t y, struct normal_run run, int fast)
{
    const struct power power = p->s.draw->power;
    const int32_t lv1 = p->s.draw->light.lv1[0];
    const uint32_t dz = p->s.depth.dx, dln = p->light.dx, dnv = p->view.dx;
    const uint32_t ddd = p->square.dxx;
    const unsigned fraction = terms->fraction, swap = t->format->swap;
    struct rounding rounding = rounding_of(t, terms, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&p->s.depth, x, y);

    for (; x < x1; x++, at++, z += dz) {
        if (nearer(t, t->depth + at, z)) {
            struct lit lit;
            light_pixel(power, lv1, (int32_t)run.ln, (int32_t)run.nv, run.d, &lit);
            uint32_t r = colour_channel(terms, 0, &lit), g = colour_channel(terms, 1, &lit);
            uint32_t b = colour_channel(terms, 2, &lit);
            if (fast)
                ((uint16_t *)t->pixels)[at] = fast_pixel(r, g, b, fraction, swap);
            else
                put_general(t, terms, rounding, at, x, r, g, b);
        }
        run.ln += dln;
        run.nv += dnv;
        run.d += run.d_step;
        run.d_step += ddd;
    }
}

void sheen_phong_root_run(const struct tile *t, const struct phong_setup *p, int32_t x, int32_t x1, int32_t y,
                          struct normal_run run)
{
    struct colour_terms terms = p->s.draw->colour;

    if (!FAST_LOOPS || !p->s.fast) {
        root_run(t, p, &terms, x, x1, y, run, 0);
        return;
    }
    for (int k = 0; k < 3; k++) /* + 1/2 once for all pixels */
        terms.a[k] += 1u << (terms.fraction - 1);
    root_run(t, p, &terms, x, x1, y, run, 1);
}

/* A block from pixel x on: both parabolas stepped. */
void sheen_phong_block(const struct tile *t, const struct phong_setup *p, int32_t x, int32_t y, struct parabola diffuse,
                       struct parabola reflected)
{
    const struct colour_terms *terms = &p->s.draw->colour;
    const struct power power = p->s.draw->power;
    struct rounding rounding = rounding_of(t, terms, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&p->s.depth, x, y);

    for (int32_t end = x + (1 << p->s.detail); x < end; x++, at++, z += p->s.depth.dx) {
        if (nearer(t, t->depth + at, z)) {
            struct lit lit = {0, 0};
            if (diffuse.value > 0) {
                lit.diffuse = (uint32_t)diffuse.value >> 15;
                lit.specular = highlight_at(power, reflected.value, lit.diffuse);
            }
            put_general(t, terms, rounding, at, x, colour_channel(terms, 0, &lit), colour_channel(terms, 1, &lit),
                        colour_channel(terms, 2, &lit));
        }
        diffuse.value += diffuse.step;
        diffuse.step += diffuse.bend;
        reflected.value += reflected.step;
        reflected.step += reflected.bend;
    }
}

/* ---- several lights ---- */

/*
 * The normal at a pixel, Q0.15 of a length in [1/2, 1]; *root becomes 1/|N|,
 * UQ1.15. Returns 0 where there is no direction left.
 */
static int pixel_normal(const uint32_t plane[3], int32_t n[3], uint32_t *root)
{
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
    *root = root_seed(square << 1);
    return 1;
}

/* Sum over the lights, each with its weight. */
static void light_normal(const struct setup *s, const int32_t n[3], uint32_t root, struct lit *lit)
{
    const struct lighting *l = &s->draw->light;
    int32_t facing = normalised(2 * dot32_q29(n, l->view), root);
    const struct power power = s->draw->power;
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0 */

    facing = min32(max32(facing, -32768), 32768);
    for (unsigned i = 0; i < l->count; i++) {
        int32_t ln = min32(normalised(2 * dot32_q29(n, l->to[i]), root), 32768);
        if (ln <= 0)
            continue;
        diffuse += l->diffuse_weight[i] * (uint32_t)ln;
        int32_t u = (int32_t)((uint32_t)l->lv1[i] - (uint32_t)(ln * facing));
        specular += l->specular_weight[i] * highlight_at(power, u, (uint32_t)ln);
    }
    lit->diffuse = (diffuse + HALF) >> 15;
    lit->specular = (specular + HALF) >> 15;
}

void sheen_phong_lights_rows(const struct tile *t, const struct setup *s)
{
    const struct colour_terms *terms = &s->draw->colour;
    const struct plane *p = ((const struct phong_lights_setup *)s)->normal;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        struct rounding rounding = rounding_of(t, terms, y);
        uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
        uint32_t plane[3] = {plane_at(&p[0], x, y), plane_at(&p[1], x, y), plane_at(&p[2], x, y)};
        for (; x < x1; x++, at++, z += s->depth.dx) {
            if (nearer(t, t->depth + at, z)) {
                struct lit lit = {0, 0};
                uint32_t root;
                int32_t n[3];
                if (pixel_normal(plane, n, &root))
                    light_normal(s, n, root, &lit);
                put_general(t, terms, rounding, at, x, colour_channel(terms, 0, &lit), colour_channel(terms, 1, &lit),
                            colour_channel(terms, 2, &lit));
            }
            for (int i = 0; i < 3; i++)
                plane[i] += p[i].dx;
        }
    }
}
