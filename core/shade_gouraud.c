/*
 * shade_gouraud.c - linear interpolation of intensities (lecture, "Gouraud
 * Shading"), perspective-correct by Blinn's I/m over 1/m.
 *
 * Colour is linear in the intensities, so the three channels are interpolated,
 * in levels, and rounded once a pixel.
 */
#include "newton.h"
#include "shade.h"

/* Intensities at a corner: lit when the mesh was drawn, or now for back faces. */
static void corner_lit(const struct setup *s, const struct surface_corners *c, int k, struct lit *lit)
{
    const struct vertex *v = c->at.v[k];

    if (!c->back || (v->flags & LIT_AS_SEEN) != 0) {
        lit->diffuse = v->diffuse;
        lit->specular = v->specular;
        return;
    }
    const int16_t *n = c->at.normal[k];
    const int16_t negated[3] = {(int16_t)-max32(n[0], -32767), (int16_t)-max32(n[1], -32767),
                                (int16_t)-max32(n[2], -32767)};
    sheen_light_normal(&s->draw->light, s->draw->material, negated, lit);
}

/*
 * Largest error of linear interpolation on the screen in place of in space:
 * dI (sqrt q - 1) / (sqrt q + 1) <= dI (q - 1) / 4, q the ratio of the weights.
 * 1 where it stays under 1/32 level: channels have `fraction` bits a level.
 */
static int nearly_linear(const struct surface_corners *c, int32_t channel[3][3], unsigned fraction)
{
    uint32_t low = c->weight[0], high = low;
    int32_t difference = 0;

    if (c->flat_weight)
        return 1;
    for (int k = 1; k < 3; k++) {
        low = c->weight[k] < low ? c->weight[k] : low;
        high = c->weight[k] > high ? c->weight[k] : high;
    }
    for (int k = 0; k < 3; k++) {
        int32_t least = min32(channel[k][0], min32(channel[k][1], channel[k][2]));
        int32_t most = max32(channel[k][0], max32(channel[k][1], channel[k][2]));
        difference = max32(difference, most - least);
    }
    /* difference / 2^fraction * (high - low) / low / 4 <= 1/32; the product is below 2^63 */
    return (uint64_t)(uint32_t)difference * (high - low) <= (uint64_t)low << (fraction - 3);
}

void sheen_setup_gouraud(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                         const struct gradients *g)
{
    const struct colour_terms *terms = &s->draw->colour;
    int32_t channel[3][3]; /* by channel and corner, < 2^31 */
    struct lit lit[3];

    for (int k = 0; k < 3; k++)
        corner_lit(s, c, k, &lit[k]);
    if (g == NULL) {
        struct lit mean = {(lit[0].diffuse + lit[1].diffuse + lit[2].diffuse) / 3,
                           (lit[0].specular + lit[1].specular + lit[2].specular) / 3};
        sheen_setup_constant(f, s, &mean);
        return;
    }
    s->clamp = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            channel[i][k] = (int32_t)colour_channel(terms, i, &lit[k]);
            s->clamp |= terms->clamp && (uint32_t)channel[i][k] > top_level(i) << terms->fraction;
        }
    s->way = nearly_linear(c, channel, terms->fraction) ? SHEEN_WAY_GOURAUD_LINEAR : SHEEN_WAY_GOURAUD_QUOTIENT;
    if (s->way == SHEEN_WAY_GOURAUD_QUOTIENT) {
        const int32_t half_weight[3] = {(int32_t)(c->weight[0] >> 1), (int32_t)(c->weight[1] >> 1),
                                        (int32_t)(c->weight[2] >> 1)};
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                channel[i][k] = (int32_t)mul_high((uint32_t)channel[i][k], c->weight[k]);
        s->shade.gouraud.weight = sheen_gradient_plane(g, half_weight, 1);
    }
    for (int i = 0; i < 3; i++) {
        s->shade.gouraud.channel[i] = sheen_gradient_plane(g, channel[i], 0);
        if (s->way == SHEEN_WAY_GOURAUD_LINEAR) /* rounding: + 1/2 once for all pixels */
            s->shade.gouraud.channel[i].base += 1u << (terms->fraction - 1);
    }
}

SPECIALISED void linear_rows(const struct tile *t, const struct setup *s, int clamp, unsigned swap)
{
    const struct plane *c = s->shade.gouraud.channel;
    const uint32_t dr = c[0].dx, dg = c[1].dx, db = c[2].dx, dz = s->depth.dx;
    const unsigned fraction = s->draw->colour.fraction;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y);
        uint32_t r = plane_at(&c[0], x0, y), g = plane_at(&c[1], x0, y), b = plane_at(&c[2], x0, y);
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                *pixels = pixel_of(r, g, b, fraction, clamp, swap);
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += dz;
            r += dr;
            g += dg;
            b += db;
        } while (--count > 0);
    }
}

void sheen_shade_gouraud_linear(const struct tile *t, const struct setup *s)
{
    if (s->clamp)
        linear_rows(t, s, 1, t->swap);
    else if (t->swap)
        linear_rows(t, s, 0, 1);
    else
        linear_rows(t, s, 0, 0);
}

/*
 * A channel times weight, over the weight. x: 16 top bits, r: UQ1.15 of 1/weight.
 * Range: the quotient is below 2^31 at the corners; rounding adds less than 2^17.
 */
SPECIALISED uint32_t quotient(uint32_t x, uint32_t r, uint32_t half)
{
    return ((not_negative(x) + (1u << 14)) >> 15) * r + half;
}

SPECIALISED void quotient_rows(const struct tile *t, const struct setup *s, unsigned swap)
{
    const struct plane *c = s->shade.gouraud.channel, *weight = &s->shade.gouraud.weight;
    const uint32_t dr = c[0].dx, dg = c[1].dx, db = c[2].dx, dw = weight->dx, dz = s->depth.dx;
    const unsigned fraction = s->draw->colour.fraction;
    const uint32_t half = 1u << (fraction - 1);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y), w = plane_at(weight, x0, y);
        uint32_t r = plane_at(&c[0], x0, y), g = plane_at(&c[1], x0, y), b = plane_at(&c[2], x0, y);
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                uint32_t up = 0, v = w | 1u; /* the weight brought up to [1/2, 1): once at the most where q <= 2 */
                while ((v & 0x80000000u) == 0) {
                    v <<= 1;
                    up++;
                }
                uint32_t one_over = reciprocal_seed(v);
                *pixels = pixel_of(quotient(r << up, one_over, half), quotient(g << up, one_over, half),
                                   quotient(b << up, one_over, half), fraction, 1, swap);
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += dz;
            w += dw;
            r += dr;
            g += dg;
            b += db;
        } while (--count > 0);
    }
}

void sheen_shade_gouraud_quotient(const struct tile *t, const struct setup *s)
{
    if (t->swap)
        quotient_rows(t, s, 1);
    else
        quotient_rows(t, s, 0);
}
