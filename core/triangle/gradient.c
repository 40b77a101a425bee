/*
 * gradient.c - planes over a triangle: from an attribute's three values at the corners to one value and two steps.
 *
 * One reciprocal of the area serves all attributes of a triangle. Its seed's 15 bits and 32-bit products suffice except
 * for needles, whose steps are much larger than the differences that they add up to, and for triangles of 256 px and
 * more.
 */
#include "triangle.h"

/* x / 2^shift, rounded; shift < 0: modulo 2^32. */
static inline uint32_t scaled_step(int32_t x, int shift)
{
    return shift > 0 ? (uint32_t)asr32(asr32(x, (unsigned)(shift - 1)) + 1, 1) : (uint32_t)x << -shift;
}

/*
 * b1x = 64 (y2 - y0) / area and so on, coordinates in 1/64 px, area in 1/4096 px^2 and > 0 for corners that run
 * clockwise on the screen (y down).
 * Range: a difference is below 2^bits, and the seed, of 16 bits, is cut by as many as `bits` exceeds NARROW_BITS, so
 * their product is below 2^30.
 * Returns 0 if the triangle is too flat, see FLATTEST.
 */
HOT int sheen_gradients(struct gradients *g, int32_t x, int32_t y)
{
    g->origin[0] = asr32(x, SUBPIXEL_BITS);
    g->origin[1] = asr32(y, SUBPIXEL_BITS);
    g->centre[0] = (int16_t)(SUBPIXEL_HALF - (x & (SUBPIXEL_ONE - 1)));
    g->centre[1] = (int16_t)(SUBPIXEL_HALF - (y & (SUBPIXEL_ONE - 1)));

    const unsigned zeros = clz32(g->area), bits = g->bits, sum = zeros + bits;
    const unsigned narrow = bits < NARROW_BITS ? bits : NARROW_BITS, cut = bits - narrow;
    if (sum > FLATTEST)
        return 0;
    const int stretch = (int)(sum + bits) - 32;
    g->exponent = (uint16_t)(40 - sum);
    g->stretch = (int16_t)stretch;
    g->wide = (uint16_t)(cut | (stretch > WIDEST_STRETCH));

    const unsigned shift = narrow + 1;
    const int32_t seed = (int32_t)(reciprocal_seed(g->area << zeros) >> cut), half = 1 << narrow;
    g->b1[0] = asr32(g->to2[1] * seed + half, shift);
    g->b1[1] = asr32(half - g->to2[0] * seed, shift);
    g->b2[0] = asr32(half - g->to1[1] * seed, shift);
    g->b2[1] = asr32(g->to1[0] * seed + half, shift);
    return 1;
}

/* The steps of b1 and b2 with 31 bits: value = raw / 2^exponent. */
struct wide_steps {
    int32_t b1[2], b2[2];
    unsigned exponent; /* 20..40 */
};

/* (a x + b y) / 2^shift, rounded. A product with y = 0 is skipped because it costs a call on an M0+. */
HOT static APART int64_t wide_sum(int64_t a, int32_t x, int64_t b, int32_t y, unsigned shift)
{
    return round_shift64(y != 0 ? a * x + b * y : a * x, shift);
}

/* Range: differences <= 65,408 (2 * 511 px), bits <= 16; a difference times the reciprocal <= (2^bits - 1) 2^32. */
static void wide_steps_of(const struct gradients *g, struct wide_steps *w)
{
    unsigned zeros = clz32(g->area), shift = g->bits + 1;
    int64_t scale = sheen_reciprocal(g->area << zeros); /* 1/area = scale * 2^(zeros - 63) */

    w->exponent = 56 - zeros - g->bits;
    w->b1[0] = (int32_t)wide_sum(scale, g->to2[1], 0, 0, shift);
    w->b1[1] = (int32_t)wide_sum(scale, -g->to2[0], 0, 0, shift);
    w->b2[0] = (int32_t)wide_sum(scale, -g->to1[1], 0, 0, shift);
    w->b2[1] = (int32_t)wide_sum(scale, g->to1[0], 0, 0, shift);
}

/*
 * The steps carry `up` more fraction bits than the values.
 * Range: |value differences| < 2^31, so two products stay 2^47 below 2^63. Differences times 2^up are at most 2^32
 * (z16: 2^16 with up 16) and gradients are below 2^11 per pixel, so steps are below 2^44, and half a pixel of both
 * below 2^50.
 */
HOT void sheen_slope(const struct gradients *g, const int32_t value[3], unsigned up, struct slope *s)
{
    struct wide_steps w;
    int64_t d1 = (int64_t)value[1] - value[0], d2 = (int64_t)value[2] - value[0];

    wide_steps_of(g, &w);
    unsigned shift = w.exponent - up;
    s->dx = wide_sum(d1, w.b1[0], d2, w.b2[0], shift);
    s->dy = wide_sum(d1, w.b1[1], d2, w.b2[1], shift);
    s->value = value[0] * ((int64_t)1 << up) + wide_sum(s->dx, g->centre[0], s->dy, g->centre[1], SUBPIXEL_BITS);
}

/* A slope as a plane modulo 2^32, moved from the origin pixel to pixel (0, 0) of the target. */
struct plane sheen_slope_plane(const struct gradients *g, const struct slope *s)
{
    struct plane p = {(uint32_t)s->value, (uint32_t)s->dx, (uint32_t)s->dy};

    p.base -= (uint32_t)g->origin[0] * p.dx + (uint32_t)g->origin[1] * p.dy;
    return p;
}

struct plane sheen_gradient_plane(const struct gradients *g, const int32_t value[3], unsigned up)
{
    struct slope s;

    sheen_slope(g, value, up, &s);
    return sheen_slope_plane(g, &s);
}

HOT static struct plane wide_plane(const struct gradients *g, uint32_t base, int32_t d1, int32_t d2, unsigned up)
{
    const int32_t value[3] = {0, d1, d2};
    struct plane p = sheen_gradient_plane(g, value, up);

    p.base += base;
    return p;
}

/*
 * Range: in dx and dy each of the two products is at most 2^15 2^15; to_centre, half of such a step times half a pixel,
 * twice, is at most 2^30; |b| < 2^15, so the products' sum fits. A step may exceed 32 bits and wrap, on a triangle less
 * than a pixel across. As pixels are whole steps from the origin pixel, the plane is right modulo 2^32 all the same.
 */
HOT void sheen_plane(struct plane *p, const struct gradients *g, uint32_t base, int32_t d1, int32_t d2, unsigned up)
{
    if (g->wide) {
        *p = wide_plane(g, base, d1, d2, up);
        return;
    }
    int32_t dx = d1 * g->b1[0] + d2 * g->b2[0], dy = d1 * g->b1[1] + d2 * g->b2[1];
    int32_t to_centre = asr32(dx, SUBPIXEL_BITS + 1) * g->centre[0] + asr32(dy, SUBPIXEL_BITS + 1) * g->centre[1];
    int shift = g->exponent - (int)up;
    const uint32_t x = scaled_step(dx, shift), y = scaled_step(dy, shift);
    base += scaled_step(to_centre, shift - 1) - (uint32_t)g->origin[0] * x - (uint32_t)g->origin[1] * y;
    *p = (struct plane){base, x, y};
}
