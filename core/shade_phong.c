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

/* D inside the root table: UQ1.31 from 1/4 to 1 + 1/512. */
#define ROOT_LOWEST (1u << 29)
#define ROOT_RANGE ((3u << 29) + (1u << 22))

/*
 * D outside the root table's [1/4, 1 + 1/512): normals far apart, or a triangle
 * scaled down. D is brought back by a power of four and L.N, V.N by its root.
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

#define HALF (1u << 14) /* rounding: floors would darken highlights of n = 128 by a tenth of a level */

/* A dot product with N over |N|: Q1.30 times UQ1.15 to Q0.15; modulo 2^32, should a sliver's rounding part the two. */
SPECIALISED int32_t normalised(int32_t dot, uint32_t root)
{
    return asr32((int32_t)((uint32_t)asr32((int32_t)((uint32_t)dot + HALF), 15) * root + HALF), 15);
}

/* Intensities at a pixel from L.N, V.N (Q1.30) and D = N.N (UQ1.31). */
SPECIALISED void light_pixel(struct power power, int32_t lv1, int32_t ln, int32_t nv, uint32_t d, struct lit *lit)
{
    lit->diffuse = 0;
    lit->specular = 0;
    if (ln <= 0)
        return;
    if (d - ROOT_LOWEST >= ROOT_RANGE && !rescale(&d, &ln, &nv))
        return;
    /* Range: L.N <= sqrt(D), so the product is below 2^31 and its quotient at most 1.0 but for rounding. */
    uint32_t root = root_seed(d);                                           /* UQ1.15 */
    uint32_t diffuse = ((((uint32_t)ln + HALF) >> 15) * root + HALF) >> 15; /* Q0.15 */
    if (diffuse > 32768)
        diffuse = 32768;
    lit->diffuse = diffuse;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is half of itself there */
    lit->specular = power_at(power, (int32_t)((uint32_t)lv1 - diffuse * (uint32_t)normalised(nv, root)));
}

/* L.N, V.N and N.N along a row. */
struct normal_run {
    uint32_t ln, nv, d, d_step;
};

SPECIALISED struct normal_run normal_run_at(const struct setup *s, const struct quadric_row *square, int32_t x,
                                            int32_t y)
{
    struct normal_run r = {plane_at(&s->shade.phong.light, x, y), plane_at(&s->shade.phong.view, x, y), 0, 0};

    quadric_run(square, x, &r.d, &r.d_step);
    return r;
}

/* To the pixel n further on. */
SPECIALISED void normal_run_next(const struct setup *s, struct normal_run *r, int32_t n)
{
    r->ln += (uint32_t)n * s->shade.phong.light.dx;
    r->nv += (uint32_t)n * s->shade.phong.view.dx;
    r->d += (uint32_t)n * r->d_step + pairs(n) * s->shade.phong.square.dxx;
    r->d_step += (uint32_t)n * s->shade.phong.square.dxx;
}

/* Colour from intensities; fast where rounding is in the terms. */
SPECIALISED void put_lit(const struct tile *t, const struct colour_terms *terms, struct rounding rounding, uint32_t at,
                         int32_t x, const struct lit *lit, enum put put)
{
    uint32_t r = colour_channel(terms, 0, lit), g = colour_channel(terms, 1, lit), b = colour_channel(terms, 2, lit);

    if (put == PUT_GENERAL)
        put_general(t, terms, rounding, at, x, r, g, b);
    else
        ((uint16_t *)t->pixels)[at] = fast_pixel(r, g, b, terms->fraction, put);
}

/* Pixels x..x1 with a root each. */
SPECIALISED void root_run(const struct tile *t, const struct setup *s, const struct colour_terms *terms, int32_t x,
                          int32_t x1, int32_t y, struct normal_run run, enum put put)
{
    const struct power power = power_of(s->draw->material);
    const int32_t lv1 = s->draw->light.lv1[0];
    const uint32_t dz = s->depth.dx, dln = s->shade.phong.light.dx, dnv = s->shade.phong.view.dx;
    const uint32_t ddd = s->shade.phong.square.dxx;
    struct rounding rounding = rounding_of(t, terms, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);

    for (; x < x1; x++, at++, z += dz) {
        if (nearer(t, t->depth + at, z)) {
            struct lit lit;
            light_pixel(power, lv1, (int32_t)run.ln, (int32_t)run.nv, run.d, &lit);
            put_lit(t, terms, rounding, at, x, &lit, put);
        }
        run.ln += dln;
        run.nv += dnv;
        run.d += run.d_step;
        run.d_step += ddd;
    }
}

SPECIALISED void root_rows(const struct tile *t, const struct setup *s, enum put put)
{
    struct quadric_row square = quadric_row_at(&s->shade.phong.square, t->first_row);
    struct colour_terms terms = s->draw->colour;

    if (put != PUT_GENERAL) /* + 1/2 once for all pixels */
        for (int k = 0; k < 3; k++)
            terms.a[k] += 1u << (terms.fraction - 1);
    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x < x1)
            root_run(t, s, &terms, x, x1, y, normal_run_at(s, &square, x, y), put);
        quadric_row_next(&square);
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

/* ---- blocks: exact nodes 4 or 8 px apart, quadratic through three of them ---- */

/* An exact node: L.N / |N| (Q1.30, 15 bits of it true) and 1 - R.V (Q2.29). 0 where there is no direction. */
struct node {
    int32_t diffuse, reflected;
};

static int node_at(int32_t lv1, const struct normal_run *r, struct node *n)
{
    int32_t ln = (int32_t)r->ln, nv = (int32_t)r->nv;
    uint32_t d = r->d;

    if (d - ROOT_LOWEST >= ROOT_RANGE && !rescale(&d, &ln, &nv))
        return 0;
    uint32_t root = root_seed(d);
    int32_t diffuse = min32(max32(normalised(ln, root), -32768), 32768);
    int32_t facing = min32(max32(normalised(nv, root), -32768), 32768);
    n->diffuse = diffuse * 32767; /* just below Q1.30, so that sums of nodes hold */
    /* 2.0 at the most, where there is no highlight any more; halved on the way, so that nothing overflows */
    n->reflected = 2 * min32(asr32(lv1, 1) - asr32(diffuse * facing, 1), (1 << 29) - 1);
    return 1;
}

/* First and second difference a px of the parabola through f0, f1 (half a block on) and f2; block of 2^shift px. */
SPECIALISED void parabola(int32_t f0, int32_t f1, int32_t f2, unsigned shift, int32_t *first, int32_t *second)
{
    int32_t half = 1 << (shift - 1), bend = asr32(f0, 1) - f1 + asr32(f2, 1); /* half of f0 - 2 f1 + f2 */

    *second = asr32(bend, 2 * shift - 3); /* over (half)^2 / 2 */
    *first = asr32(f1 - f0, shift - 1) - *second * ((half - 1) / 2) - *second * ((half - 1) & 1) / 2;
}

SPECIALISED void block_run(const struct tile *t, const struct setup *s, int32_t x, int32_t y, const struct node node[3])
{
    const struct colour_terms *terms = &s->draw->colour;
    struct rounding rounding = rounding_of(t, terms, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&s->depth, x, y);
    const struct power power = power_of(s->draw->material);
    unsigned shift = s->block_shift;
    int32_t diffuse = node[0].diffuse + (int32_t)HALF, reflected = node[0].reflected, d1, d2, r1, r2;

    parabola(node[0].diffuse, node[1].diffuse, node[2].diffuse, shift, &d1, &d2);
    parabola(node[0].reflected, node[1].reflected, node[2].reflected, shift, &r1, &r2);
    for (int32_t end = x + (1 << shift); x < end; x++, at++, z += s->depth.dx) {
        if (nearer(t, t->depth + at, z)) {
            struct lit lit = {0, 0};
            if (diffuse > 0) {
                lit.diffuse = (uint32_t)diffuse >> 15;
                lit.specular = power_at(power, reflected);
            }
            put_lit(t, terms, rounding, at, x, &lit, PUT_GENERAL);
        }
        diffuse += d1;
        d1 += d2;
        reflected += r1;
        r1 += r2;
    }
}

void sheen_shade_phong_blocks(const struct tile *t, const struct setup *s)
{
    struct quadric_row square = quadric_row_at(&s->shade.phong.square, t->first_row);
    const int32_t lv1 = s->draw->light.lv1[0], length = 1 << s->block_shift;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        struct normal_run run = normal_run_at(s, &square, x, y);
        struct node node[3];
        int known = x + length <= x1 && node_at(lv1, &run, &node[0]);

        for (; known && x + length <= x1; x += length, node[0] = node[2]) {
            struct normal_run start = run;
            normal_run_next(s, &run, length / 2);
            known = node_at(lv1, &run, &node[1]);
            normal_run_next(s, &run, length / 2);
            known = known && node_at(lv1, &run, &node[2]);
            if (known)
                block_run(t, s, x, y, node);
            else
                root_run(t, s, &s->draw->colour, x, x + length, y, start, PUT_GENERAL);
        }
        if (x < x1)
            root_run(t, s, &s->draw->colour, x, x1, y, run, PUT_GENERAL);
        quadric_row_next(&square);
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
    const struct power power = power_of(s->draw->material);
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0 */

    facing = min32(max32(facing, -32768), 32768);
    for (unsigned i = 0; i < l->count; i++) {
        int32_t ln = min32(normalised(2 * dot32_q29(n, l->to[i]), root), 32768);
        if (ln <= 0)
            continue;
        diffuse += l->diffuse_weight[i] * (uint32_t)ln;
        specular += l->specular_weight[i] * power_at(power, (int32_t)((uint32_t)l->lv1[i] - (uint32_t)(ln * facing)));
    }
    lit->diffuse = (diffuse + HALF) >> 15;
    lit->specular = (specular + HALF) >> 15;
}

void sheen_shade_phong_lights(const struct tile *t, const struct setup *s)
{
    const struct colour_terms *terms = &s->draw->colour;
    const struct plane *p = s->shade.normal;

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
