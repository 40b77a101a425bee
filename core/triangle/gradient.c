/*
 * gradient.c - planes over a triangle: from three values to a value and two steps.
 *
 * One reciprocal of the area serves all attributes of a triangle.
 */
#include "triangle.h"

/*
 * b1x = 64 (y2 - y0) / area and so on, coordinates in 1/64 px, area in 1/4096
 * px^2 and > 0 for corners that run clockwise on the screen (y down).
 * Range: differences <= 65,408 (2 * 511 px), so `bits`, their length, is at most
 * 16; a difference times the reciprocal is at most (2^bits - 1) 2^32, and a b
 * (1 - 2^-16) 2^31.
 * Returns 0 where the triangle is too flat, see MIN_EXPONENT.
 */
int sheen_gradients(struct gradients *g, const int32_t x[3], const int32_t y[3], uint32_t area)
{
    int32_t x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
    uint32_t all = magnitude32(x1) | magnitude32(y1) | magnitude32(x2) | magnitude32(y2);
    unsigned bits = 32 - clz32(all), zeros = clz32(area);
    int64_t scale = sheen_reciprocal(area << zeros); /* 1/area = scale * 2^(zeros - 63) */

    if (56 - MIN_EXPONENT < zeros + bits)
        return 0;
    g->exponent = 56 - zeros - bits;
    g->stretch = (int)(2 * bits + zeros) - 32;
    g->b1[0] = (int32_t)round_shift64(y2 * scale, bits + 1);
    g->b1[1] = (int32_t)round_shift64(-x2 * scale, bits + 1);
    g->b2[0] = (int32_t)round_shift64(-y1 * scale, bits + 1);
    g->b2[1] = (int32_t)round_shift64(x1 * scale, bits + 1);
    g->origin[0] = asr32(x[0], SUBPIXEL_BITS);
    g->origin[1] = asr32(y[0], SUBPIXEL_BITS);
    g->centre[0] = g->origin[0] * SUBPIXEL_ONE + SUBPIXEL_HALF - x[0];
    g->centre[1] = g->origin[1] * SUBPIXEL_ONE + SUBPIXEL_HALF - y[0];
    return 1;
}

/*
 * The steps carry `up` more fraction bits than the values.
 * Range: |value differences| < 2^31, so two products stay 2^47 below 2^63; and
 * times 2^up at most 2^32 (z16: 2^16 with up 16), so steps, of gradients below
 * 2^11 a px, are below 2^44, and half a pixel of both below 2^50.
 */
void sheen_slope(const struct gradients *g, const int32_t value[3], unsigned up, struct slope *s)
{
    int64_t d1 = (int64_t)value[1] - value[0], d2 = (int64_t)value[2] - value[0];
    unsigned shift = g->exponent - up;

    s->dx = round_shift64(d1 * g->b1[0] + d2 * g->b2[0], shift);
    s->dy = round_shift64(d1 * g->b1[1] + d2 * g->b2[1], shift);
    s->value =
        value[0] * ((int64_t)1 << up) + round_shift64(s->dx * g->centre[0] + s->dy * g->centre[1], SUBPIXEL_BITS);
}

/* Modulo 2^32, moved from the origin pixel to pixel (0, 0) of the target. */
struct plane sheen_slope_plane(const struct gradients *g, const struct slope *s)
{
    struct plane p = {(uint32_t)s->value, (uint32_t)s->dx, (uint32_t)s->dy};

    p.base -= (uint32_t)g->origin[0] * p.dx + (uint32_t)g->origin[1] * p.dy;
    return p;
}

/*
 * A polynomial given at a pixel (value, first and second differences) about pixel
 * (0, 0) of the target; exact modulo 2^32.
 */
struct quadric sheen_quadric(const int32_t pixel[2], uint32_t base, uint32_t dx, uint32_t dy, uint32_t dxx,
                             uint32_t dxy, uint32_t dyy)
{
    int32_t ox = -pixel[0], oy = -pixel[1];
    uint32_t x = (uint32_t)ox, y = (uint32_t)oy;
    struct quadric q = {0, dx + x * dxx + y * dxy, dy + y * dyy + x * dxy, dxx, dxy, dyy};

    q.base = base + x * dx + y * dy + pairs(ox) * dxx + x * y * dxy + pairs(oy) * dyy;
    return q;
}

struct plane sheen_gradient_plane(const struct gradients *g, const int32_t value[3], unsigned up)
{
    struct slope s;

    sheen_slope(g, value, up, &s);
    return sheen_slope_plane(g, &s);
}
