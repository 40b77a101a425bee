/*
 * transform.c - a mesh's vertex to the eye, then to the screen, with 1/m.
 *
 * m = -z is the lecture's mass ("Fixing Distortion"): x_s = focal * x / m. One
 * reciprocal per vertex serves x, y and depth.
 */
#include "../math/inverse.h"
#include "../math/pose.h"
#include "vertex.h"

/* s * value / 2^fraction, value > 0. */
static APART COLD void scale_by(struct scaled *s, uint32_t value, int fraction)
{
    const unsigned zeros = clz32(value);
    const uint64_t product = (uint64_t)s->mantissa * (value << zeros); /* in [2^62, 2^64) */
    const unsigned up = product >> 63 == 0;

    s->mantissa = (uint32_t)(product << up >> 32);
    s->exponent += 32 - fraction - (int)(zeros + up);
}

/* s / m for m > 0 in Q7.24. */
static APART void divide_by(struct scaled *s, sheen_q24_t m)
{
    const unsigned zeros = clz32((uint32_t)m);

    scale_by(s, sheen_reciprocal((uint32_t)m << zeros), 39 - (int)zeros);
}

/* ---- what is divided by m ---- */

/* v / u * 2^31, v < u * 2 (1 - 2^-27). */
static inline uint32_t depth_over(struct inverse i, uint32_t v)
{
    uint32_t share = PRODUCT_FORM(share)(i.seed, v);

    return share + (uint32_t)asr32((int32_t)(share >> 17) * i.lacks, 12);
}

/* How much z16 exceeds that of the far plane, with depth_fraction bits, in an orthographic view. m in near..far. */
static uint32_t straight_depth(const struct projection *p, sheen_q24_t m)
{
    return (uint32_t)(((uint64_t)(uint32_t)(p->far - m) * p->depth) >> p->depth_shift);
}

/* In an orthographic view the steps of z16 per unit of depth; else the factor of 1/m in z16. */
static void depth_factor(const struct projection *p, struct scaled *s)
{
    struct scaled both = {1u << 31, 0};

    *s = (struct scaled){(uint32_t)DEPTH_RANGE << 16, 15};
    divide_by(s, p->far - p->near);
    if (p->orthographic != 0)
        return;
    scale_by(&both, (uint32_t)p->near, 24);
    scale_by(&both, (uint32_t)p->far, 24);
    scale_by(s, both.mantissa, 31 - both.exponent);
}

/* The value with 16 fraction bits. Range: 2^-17 to 2^47; 65020 steps, over at most 128 units and at least a raw one. */
static APART int64_t scaled_value(const struct scaled *s)
{
    return (int64_t)((uint64_t)s->mantissa << 31 >> (46 - s->exponent));
}

/*
 * Depth's mantissa is reduced a little because 1/m may be slightly too large. depth / m is mantissa / u * 2^(exponent +
 * up - 7). With fewer fraction bits than 15 no bit is shifted out at near and at most 30 are at far; with 15 bits at
 * most 31 are, because depth is at least 65020 raw steps.
 */
static void depth_begin(struct projection *p, const struct scaled *depth)
{
    int room = 38 - depth->exponent - (int)clz32((uint32_t)p->near); /* >= 0, for depth / near < 65020 * 2^15 */
    unsigned fraction = (unsigned)min32(room, 15);
    const struct inverse far = inverse_of((uint32_t)p->far);

    p->depth = depth->mantissa - (depth->mantissa >> 27);
    p->depth_shift = 38 - (int)fraction - depth->exponent;
    p->depth_fraction = fraction;
    p->depth_base =
        (((uint32_t)DEPTH_FAR * 2 + 1) << fraction >> 1) - (depth_over(far, p->depth) >> (p->depth_shift - far.up));
}

/*
 * 1/m = (z16 - DEPTH_FAR + depth / far) / depth, so z16 plus an offset is proportional to it. The sum is scaled to just
 * below 2^31, so that its sign shows: the offset is negative if far is 254 times as far as near, or farther.
 */
static void weight_begin(struct projection *p, struct scaled far)
{
    divide_by(&far, p->far);
    const int64_t offset = asr64(scaled_value(&far), 8) - (DEPTH_FAR << 8); /* Q.8 */
    const unsigned zeros = clz64((uint64_t)(offset + (65536 << 8))) - 1;    /* 24..39 */

    p->weight_shift = zeros - 32 + 8;
    p->weight_offset = (int32_t)asr64(offset * ((int64_t)1 << (zeros - 24)), 8);
}

sheen_angle_t sheen_fov(const struct sheen_view *view)
{
    if (view->fov == 0)
        return SHEEN_DEGREES(40);
    return view->fov < SHEEN_DEGREES(0.99) || view->fov > SHEEN_DEGREES(150.01) ? 0 : view->fov;
}

COLD int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned width, unsigned height)
{
    sheen_angle_t fov = sheen_fov(view), half = fov / 2;
    struct scaled depth;

    p->far = view->z_far != 0 ? view->z_far : SHEEN_Q24(16);
    p->near = view->z_near != 0 ? view->z_near : p->far / 16;
    p->orthographic = view->orthographic;
    if (fov == 0 || p->near <= 0 || p->far <= p->near || p->far - p->near <= (p->far - 1) >> 15 || p->orthographic < 0)
        return SHEEN_ERR_ARGUMENT;

    /* height / 2 / tan(half): the sine, Q1.30, is taken as Q7.24; the cosine with 25 bits, one more, for the half */
    p->focal = (struct scaled){1u << 31, 0};
    scale_by(&p->focal, height, 0);
    scale_by(&p->focal, (uint32_t)sheen_cos(half), 25);
    divide_by(&p->focal, sheen_sin(half));
    p->view_x = (int16_t)min32((int32_t)width * SUBPIXEL_HALF, INNER_VIEW);
    p->view_y = (int16_t)min32((int32_t)height * SUBPIXEL_HALF, INNER_VIEW);

    depth_factor(p, &depth);
    if (p->orthographic == 0) {
        weight_begin(p, depth);
        depth_begin(p, &depth);
        return SHEEN_OK;
    }
    p->depth = depth.mantissa;
    p->depth_fraction = 8;
    p->depth_shift = 47 - depth.exponent; /* 8..39 */
    p->depth_base = (DEPTH_FAR << 8) + 128;
    p->weight_shift = 0; /* all weights are equal */
    p->weight_offset = 0;
    return SHEEN_OK;
}

COLD int64_t sheen_depth_beyond(const struct projection *p, sheen_q24_t m)
{
    const int32_t away = p->far - m;
    int64_t depth = (int64_t)DEPTH_FAR << 16;
    struct scaled steps, at_far;

    depth_factor(p, &steps);
    if (p->orthographic != 0) {
        scale_by(&steps, magnitude32(away) + 1, 24);
        return away < 0 ? depth - scaled_value(&steps) : depth + scaled_value(&steps);
    }
    at_far = steps;
    divide_by(&at_far, p->far);
    divide_by(&steps, m);
    return depth + scaled_value(&steps) - scaled_value(&at_far);
}

sheen_q24_t sheen_origin(const struct sheen_mesh *mesh, const struct sheen_pose *pose, sheen_q24_t origin[3])
{
    const int64_t scale = ((int64_t)pose->scale * mesh->scale) >> 16;

    if (pose->scale <= 0 || mesh->scale <= 0 || scale == 0)
        return SHEEN_ERR_ARGUMENT;
    for (int k = 0; k < 3; k++) {
        const int64_t at = sheen_pose_part(pose, k, mesh->offset), most = (at < 0 ? -at : at) + 2 * scale;
        if (most > INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        origin[k] = (sheen_q24_t)at;
    }
    return (sheen_q24_t)scale;
}

COLD int sheen_transform_begin(struct transform *t, const struct projection *p, const struct sheen_mesh *mesh,
                               const struct sheen_pose *pose)
{
    sheen_q24_t origin[3];
    const sheen_q24_t scale = sheen_origin(mesh, pose, origin);

    if (scale < 0)
        return SHEEN_ERR_ARGUMENT;
    /* raw positions lie up to sqrt(3) * scale from the mesh's origin: nothing may wrap later */
    const uint32_t reach =
        (magnitude32(origin[0]) + 2 * (uint32_t)scale) | (magnitude32(origin[1]) + 2 * (uint32_t)scale);
    unsigned zeros = clz32((uint32_t)scale) - 1; /* 1..30; scale * 2^zeros in [2^30, 2^31) */
    const uint32_t deepest = (uint32_t)(p->orthographic != 0 ? p->orthographic : p->far);
    int most = 8 + p->focal.exponent + (int)clz32(deepest); /* then screen_shift - up <= 30 */
    t->fine = (unsigned)min32((int32_t)clz32(reach) - 1, most);
    t->shift = zeros - 1;               /* raw / 2^15 * rotation / 2^30 * scale = raw * row / 2^(14 + shift) */
    t->shift_fine = t->shift - t->fine; /* >= 0, for reach holds twice the scale */
    t->screen_shift = 22 - p->focal.exponent + (int)t->fine;
    const int32_t most_part = (1 << 29) - 1; /* reached only by a rotation that is slightly off */
    int32_t factor = (int32_t)(p->focal.mantissa >> 1);
    unsigned fine = t->fine;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) {
            int32_t part = sheen_mul_round(pose->rotation[3 * k + i], scale * (1 << zeros), 31);
            part = sheen_mul_round(part, factor, 32);
            PRODUCT_FORM(row_set)(&t->row[k], i, max32(-most_part, min32(part, most_part)));
        }
        t->t[k] = sheen_mul_round(origin[k] * (1 << fine), factor, 31);
        factor = k == 0 ? -factor : -INT32_MAX;
        fine = k == 0 ? fine : 0;
    }
    return SHEEN_OK;
}

struct point sheen_transform_point(const struct transform *t, const int16_t position[3])
{
    int32_t x = position[0], y = position[1], z = position[2];
    struct point point = {t->t[0] + asr32(PRODUCT_FORM(row_times)(&t->row[0], x, y, z), t->shift_fine),
                          t->t[1] + asr32(PRODUCT_FORM(row_times)(&t->row[1], x, y, z), t->shift_fine),
                          t->t[2] + asr32(PRODUCT_FORM(row_times)(&t->row[2], x, y, z), t->shift)};

    return point;
}

/* value * 2^by, for an m so small that the value grows; held just beyond the guard band. by <= 22. */
static APART int32_t grown(int32_t value, int by)
{
    const int32_t most = GUARD_BAND + 1, fits = asr32(most, (unsigned)by);

    return value > fits ? most : value < -fits ? -most : value * (1 << by);
}

/* Holds a coordinate at the guard band's limits. Returns `low`, or the flag after it, if it was beyond them; else 0. */
static APART unsigned guard(int16_t *out, int32_t value, unsigned low)
{
    const int32_t held = max32(-GUARD_BAND, min32(value, GUARD_BAND));

    *out = (int16_t)held;
    return value < held ? low : value > held ? 2 * low : 0;
}

static APART void hold_off_view(struct vertex *v, int32_t x, int32_t y)
{
    v->flags = (uint16_t)(OFF_VIEW | guard(&v->x, x, OUTSIDE_LEFT) | guard(&v->y, y, OUTSIDE_TOP));
}

/*
 * A point beyond near or far gets only that flag. Beyond the guard band depth is right, x and y are held at its limits,
 * and OFF_VIEW is set besides the side's flag.
 */
void sheen_project(const struct projection *p, int screen_shift, const struct point *point, struct vertex *v)
{
    if ((uint32_t)point->m - (uint32_t)p->near > (uint32_t)(p->far - p->near)) {
        *v = (struct vertex){.flags = point->m < p->near ? OUTSIDE_NEAR : OUTSIDE_FAR};
        return;
    }
    struct inverse i = inverse_of((uint32_t)(p->orthographic != 0 ? p->orthographic : point->m));
    int32_t x = over(i, point->x), y = over(i, point->y);
    int shift = screen_shift - i.up; /* -23..30 */
    uint32_t depth = p->orthographic != 0 ? straight_depth(p, point->m)
                                          : depth_over(i, p->depth) >> (p->depth_shift - i.up); /* 0..31 */
    if (shift >= 0) {
        x = asr32(asr32(x, (unsigned)shift) + 1, 1);
        y = asr32(asr32(y, (unsigned)shift) + 1, 1);
    } else {
        x = grown(x, -shift - 1);
        y = grown(y, -shift - 1);
    }
    depth = (depth + p->depth_base) >> p->depth_fraction;
    v->x = (int16_t)x;
    v->y = (int16_t)y;
    v->z = (uint16_t)(depth > DEPTH_FAR ? depth : DEPTH_FAR);
    v->flags = 0;
    if ((uint32_t)(x + p->view_x) > 2u * (uint32_t)p->view_x || (uint32_t)(y + p->view_y) > 2u * (uint32_t)p->view_y)
        hold_off_view(v, x, y);
}
