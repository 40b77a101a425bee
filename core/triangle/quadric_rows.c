/*
 * quadric_rows.c - intensities that are quadratic over a triangle (Bishop and
 * Weimer, "Fast Phong Shading", 1986; here through the corners and the middles of
 * the edges): two adds a pixel each, no root, no quotient.
 *
 * Where a highlight may fall, 1 - R.V is the second quadric and the power table
 * follows a pixel. Gouraud's intensities in perspective come the same way.
 */
#include "triangle.h"

/* What the second quadric is; a constant argument of the fast loops. */
enum second {
    SECOND_NONE,     /* no highlight on this triangle */
    SECOND_SPECULAR, /* Gouraud: the specular intensity, Q1.30 */
    SECOND_POWER,    /* Phong: 1 - R.V, Q2.29 */
    SECOND_FADED     /* likewise, where L.N may lie below 1/8 */
};

/* Intensities at a pixel; rounding to UQ1.15 is in the quadrics. */
SPECIALISED struct lit lit_of(struct power power, uint32_t diffuse, uint32_t second, enum second kind)
{
    struct lit lit = {not_negative(diffuse) >> 15, 0};

    if (kind == SECOND_SPECULAR)
        lit.specular = not_negative(second) >> 15;
    else if (kind == SECOND_POWER && (int32_t)diffuse > 0)
        lit.specular = power_at(power, (int32_t)second);
    else if (kind == SECOND_FADED && (int32_t)diffuse > 0)
        lit.specular = highlight_at(power, (int32_t)second, lit.diffuse);
    return lit;
}

SPECIALISED uint32_t channel_lit(const struct colour_terms *t, int k, struct lit lit, enum second kind)
{
    return t->a[k] + t->b[k] * lit.diffuse + (kind == SECOND_NONE ? 0 : t->c[k] * lit.specular);
}

/* A run of pixels: the state of both quadrics at its first one. */
struct run {
    uint32_t z, diffuse, diffuse_step, second, second_step;
};

/* The loop's numbers are locals: no store of a pixel can be thought to change them. */
SPECIALISED void fast_run(const struct tile *t, const struct quadric_setup *q, const struct colour_terms *terms,
                          uint32_t at, uint32_t count, struct run run, enum second kind)
{
    uint16_t *pixels = (uint16_t *)t->pixels + at, *end = pixels + count, *depth = t->depth + at;
    const struct power power = q->s.draw->power;
    const uint32_t dz = q->s.depth.dx, ddd = q->diffuse.dxx, dds = q->second.dxx;
    const uint32_t ar = terms->a[0], ag = terms->a[1], ab = terms->a[2];
    const uint32_t br = terms->b[0], bg = terms->b[1], bb = terms->b[2];
    const uint32_t cr = terms->c[0], cg = terms->c[1], cb = terms->c[2];
    const unsigned fraction = terms->fraction, swap = t->format->swap;

    do {
        if (nearer(t, depth, run.z)) {
            struct lit lit = lit_of(power, run.diffuse, run.second, kind);
            uint32_t r = ar + br * lit.diffuse, g = ag + bg * lit.diffuse, b = ab + bb * lit.diffuse;
            if (kind != SECOND_NONE && lit.specular != 0) {
                r += cr * lit.specular;
                g += cg * lit.specular;
                b += cb * lit.specular;
            }
            *pixels = fast_pixel(r, g, b, fraction, swap);
        }
        depth++;
        run.z += dz;
        run.diffuse += run.diffuse_step;
        run.diffuse_step += ddd;
        if (kind != SECOND_NONE) {
            run.second += run.second_step;
            run.second_step += dds;
        }
    } while (++pixels != end);
}

SPECIALISED void general_run(const struct tile *t, const struct quadric_setup *q, const struct colour_terms *terms,
                             uint32_t at, int32_t x, int32_t x1, int32_t y, struct run run, enum second kind)
{
    struct rounding rounding = rounding_of(t, terms, y);

    for (; x < x1; x++, at++) {
        if (nearer(t, t->depth + at, run.z)) {
            struct lit lit = lit_of(q->s.draw->power, run.diffuse, run.second, kind);
            put_general(t, terms, rounding, at, x, channel_lit(terms, 0, lit, kind), channel_lit(terms, 1, lit, kind),
                        channel_lit(terms, 2, lit, kind));
        }
        run.z += q->s.depth.dx;
        run.diffuse += run.diffuse_step;
        run.diffuse_step += q->diffuse.dxx;
        run.second += run.second_step;
        run.second_step += q->second.dxx;
    }
}

SPECIALISED void quadratic_rows(const struct tile *t, const struct quadric_setup *q, enum second kind, int fast)
{
    struct colour_terms terms = q->s.draw->colour;
    struct quadric_row diffuse = quadric_row_at(&q->diffuse, t->first_row);
    struct quadric_row second = quadric_row_at(&q->second, t->first_row);

    if (fast) /* + 1/2 once for all pixels */
        for (int k = 0; k < 3; k++)
            terms.a[k] += 1u << (terms.fraction - 1);
    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x < x1) {
            struct run run = {plane_at(&q->s.depth, x, y), 0, 0, 0, 0};
            uint32_t at = tile_offset(t, x, y);
            quadric_run(&diffuse, x, &run.diffuse, &run.diffuse_step);
            if (kind != SECOND_NONE)
                quadric_run(&second, x, &run.second, &run.second_step);
            if (fast)
                fast_run(t, q, &terms, at, (uint32_t)(x1 - x), run, kind);
            else
                general_run(t, q, &terms, at, x, x1, y, run, kind);
        }
        quadric_row_next(&diffuse);
        if (kind != SECOND_NONE)
            quadric_row_next(&second);
    }
}

/* One loop for every format, clamp and dither. */
static APART void general_rows(const struct tile *t, const struct quadric_setup *q, enum second kind)
{
    quadratic_rows(t, q, kind, 0);
}

void sheen_quadric_rows_diffuse(const struct tile *t, const struct setup *s)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;

    if (FAST_LOOPS && s->fast)
        quadratic_rows(t, q, SECOND_NONE, 1);
    else
        general_rows(t, q, SECOND_NONE);
}

void sheen_quadric_rows_specular(const struct tile *t, const struct setup *s)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;

    if (FAST_LOOPS && s->fast)
        quadratic_rows(t, q, SECOND_SPECULAR, 1);
    else
        general_rows(t, q, SECOND_SPECULAR);
}

void sheen_quadric_rows_power(const struct tile *t, const struct setup *s)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;

    if (FAST_LOOPS && s->fast)
        quadratic_rows(t, q, SECOND_POWER, 1);
    else
        general_rows(t, q, s->detail ? SECOND_FADED : SECOND_POWER);
}
