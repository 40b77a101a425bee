/*
 * transform.c - a mesh's vertex to the eye, then to the screen, with 1/m.
 *
 * m = -z is the lecture's mass ("Fixing Distortion"): x_s = focal * x / m. One
 * reciprocal a vertex serves x, y and depth.
 */
#include "../math/inverse.h"
#include "vertex.h"

/* value / 2^fraction as mantissa and exponent. value > 0. */
static APART struct scaled scaled_of(uint64_t value, int fraction)
{
    unsigned zeros = clz64(value);
    struct scaled s = {(uint32_t)((value << zeros) >> 32), 63 - fraction - (int)zeros};

    return s;
}

/* 1/m for m > 0 in Q7.24, relative error 2^-28. */
static struct scaled reciprocal_of(sheen_q24_t m)
{
    unsigned zeros = clz32((uint32_t)m);
    struct scaled s = {sheen_reciprocal((uint32_t)m << zeros), (int)zeros - 8};

    return s;
}

/* The product of two. */
static APART struct scaled scaled_times(struct scaled a, struct scaled b)
{
    uint64_t product = (uint64_t)a.mantissa * b.mantissa; /* in [2^62, 2^64) */
    unsigned zeros = clz64(product);
    struct scaled s = {(uint32_t)((product << zeros) >> 32), a.exponent + b.exponent + 1 - (int)zeros};

    return s;
}

/* ---- what is divided by m ---- */

/* v / u * 2^31, v < u * 2 (1 - 2^-27). */
static inline uint32_t depth_over(struct inverse i, uint32_t v)
{
    uint32_t share = PRODUCT_FORM(share)(i.seed, v);

    return share + (uint32_t)asr32((int32_t)(share >> 17) * i.lacks, 12);
}

/* depth / m with its fraction bits; orthographic: what lies above far's. m in near..far. */
static inline uint32_t depth_at(const struct projection *p, struct inverse i, int32_t m)
{
    if (p->orthographic != 0)
        return (uint32_t)(((uint64_t)(uint32_t)(p->far - m) * p->depth) >> p->depth_shift);
    return depth_over(i, p->depth) >> (p->depth_shift - i.up); /* 0..31, see depth_begin */
}

/*
 * Depth's mantissa goes down a little, for what 1/m may be too large by. depth / m is mantissa / u * 2^(exponent + up -
 * 7). With fewer fraction bits than 15 nothing is shifted out at near, and 30 at most at far; with 15 it is 31 at most,
 * for depth is no less than 65020 raw steps.
 */
static void depth_begin(struct projection *p, struct scaled depth)
{
    int room = 38 - depth.exponent - (int)clz32((uint32_t)p->near); /* >= 0, for depth / near < 65020 * 2^15 */
    unsigned fraction = (unsigned)min32(room, 15);

    p->depth = depth.mantissa - (depth.mantissa >> 27);
    p->depth_shift = 38 - (int)fraction - depth.exponent;
    p->depth_fraction = fraction;
    p->depth_base =
        ((uint32_t)DEPTH_FAR << fraction) + (1u << fraction >> 1) - depth_at(p, inverse_of((uint32_t)p->far), p->far);
}

/*
 * 1/m = (z16 - DEPTH_FAR + depth / far) / depth, so a sum gives a number that is
 * proportional to it. The sum is scaled to just below 2^32.
 */
static void weight_begin(struct projection *p, struct scaled depth)
{
    struct scaled far = scaled_times(depth, reciprocal_of(p->far));
    int64_t offset = (int64_t)(((uint64_t)far.mantissa << 8) >> (31 - far.exponent)) - (DEPTH_FAR << 8); /* Q.8 */
    unsigned zeros = clz64((uint64_t)(offset + (65536 << 8)));                                           /* 24..40 */

    p->weight_shift = zeros - 32 + 8;
    p->weight_offset = (uint32_t)(zeros >= 32 ? offset * (int64_t)(1u << (zeros - 32)) : asr64(offset, 32 - zeros));
}

sheen_angle_t sheen_fov(const struct sheen_view *view)
{
    if (view->fov == 0)
        return SHEEN_DEGREES(40);
    return view->fov < SHEEN_DEGREES(0.99) || view->fov > SHEEN_DEGREES(150.01) ? 0 : view->fov;
}

int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned width, unsigned height)
{
    sheen_angle_t fov = sheen_fov(view), half = fov / 2;
    sheen_q24_t z_far = view->z_far != 0 ? view->z_far : SHEEN_Q24(16);
    sheen_q24_t z_near = view->z_near != 0 ? view->z_near : z_far / 16;
    int64_t span = (int64_t)z_far - z_near;

    if (fov == 0)
        return SHEEN_ERR_ARGUMENT;
    if (z_near <= 0 || span <= 0 || span << 15 < z_far || view->orthographic < 0)
        return SHEEN_ERR_ARGUMENT;

    /* height / 2 / tan(half); sine and cosine are Q1.30, a reciprocal takes Q7.24: 2^-6 each way */
    p->focal =
        scaled_times(scaled_of((uint64_t)height * (uint32_t)sheen_cos(half), 31), reciprocal_of(sheen_sin(half)));
    p->focal.exponent += 6;

    p->view_x = (int16_t)min32((int32_t)width * SUBPIXEL_HALF, INNER_VIEW);
    p->view_y = (int16_t)min32((int32_t)height * SUBPIXEL_HALF, INNER_VIEW);
    p->near = z_near;
    p->far = z_far;
    p->orthographic = view->orthographic;
    struct scaled steps = scaled_times(scaled_of(DEPTH_RANGE, 0), reciprocal_of((sheen_q24_t)span)); /* a unit */
    if (p->orthographic != 0) { /* all weights are equal */
        p->depth = steps.mantissa;
        p->depth_fraction = 8;
        p->depth_shift = 47 - steps.exponent; /* 8..39 */
        p->depth_base = (DEPTH_FAR << 8) + 128;
        p->weight_shift = 0;
        p->weight_offset = 0;
        return SHEEN_OK;
    }
    steps = scaled_times(steps, scaled_of((uint64_t)z_near * (uint64_t)z_far, 48));
    weight_begin(p, steps);
    depth_begin(p, steps);
    return SHEEN_OK;
}

/* With 16 fraction bits. Range: below 2^46. */
static int64_t scaled_value(struct scaled s)
{
    const int up = s.exponent - 15;

    return up >= 0 ? (int64_t)s.mantissa << up : up > -32 ? (int64_t)(s.mantissa >> -up) : 0;
}

int64_t sheen_depth_beyond(const struct projection *p, sheen_q24_t m)
{
    const int64_t away = (int64_t)p->far - m;
    struct scaled steps = scaled_times(scaled_of(DEPTH_RANGE, 0), reciprocal_of(p->far - p->near));

    if (p->orthographic != 0) {
        const struct scaled far = scaled_times(steps, scaled_of((uint64_t)(away < 0 ? 1 - away : away + 1), 24));
        return ((int64_t)DEPTH_FAR << 16) + (away < 0 ? -scaled_value(far) : scaled_value(far));
    }
    steps = scaled_times(steps, scaled_of((uint64_t)p->near * (uint64_t)p->far, 48));
    return ((int64_t)DEPTH_FAR << 16) + scaled_value(scaled_times(steps, reciprocal_of(m))) -
           scaled_value(scaled_times(steps, reciprocal_of(p->far)));
}

/* Row i of the rotation times a vector of lengths, in Q7.24. */
static int64_t rotate_row(const sheen_q30_t *row, const sheen_q24_t v[3])
{
    int64_t sum = 0;

    for (int k = 0; k < 3; k++)
        sum += asr64((int64_t)row[k] * v[k], 15);
    return asr64(sum, 15);
}

int sheen_transform_begin(struct transform *t, const struct projection *p, const struct sheen_mesh *mesh,
                          const struct sheen_pose *pose)
{
    int32_t moved[3];
    uint32_t reach = 0;

    if (pose->scale <= 0 || mesh->scale <= 0)
        return SHEEN_ERR_ARGUMENT;
    int64_t scale = ((int64_t)pose->scale * mesh->scale) >> 16; /* Q7.24 */
    if (scale <= 0)
        return SHEEN_ERR_ARGUMENT;
    for (int k = 0; k < 3; k++) {
        int64_t sum = asr64(rotate_row(pose->rotation + 3 * k, mesh->offset) * pose->scale, 16) + pose->translation[k];
        /* raw positions reach sqrt(3) * scale from the mesh's origin: nothing may wrap later */
        int64_t most = (sum < 0 ? -sum : sum) + 2 * scale;
        if (most > INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        moved[k] = (int32_t)sum;
        reach |= k < 2 ? (uint32_t)most : 0;
    }
    unsigned zeros = clz32((uint32_t)scale) - 1; /* 1..30; scale * 2^zeros in [2^30, 2^31) */
    const uint32_t deepest = (uint32_t)(p->orthographic != 0 ? p->orthographic : p->far);
    int most = 8 + p->focal.exponent + (int)clz32(deepest); /* then screen_shift - up <= 30 */
    t->fine = (unsigned)min32((int32_t)clz32(reach) - 1, most);
    t->shift = zeros - 1;               /* raw / 2^15 * rotation / 2^30 * scale = raw * row / 2^(14 + shift) */
    t->shift_fine = t->shift - t->fine; /* >= 0, for reach holds twice the scale */
    t->screen_shift = 22 - p->focal.exponent + (int)t->fine;
    const int32_t focal = (int32_t)(p->focal.mantissa >> 1), factor[3] = {focal, -focal, -INT32_MAX};
    const int32_t most_part = (1 << 29) - 1; /* met by what rotations are off by alone */
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) {
            int32_t part = sheen_mul_round(pose->rotation[3 * k + i], (int32_t)(scale << zeros), 31);
            part = sheen_mul_round(part, factor[k], 32);
            PRODUCT_FORM(row_set)(&t->row[k], i, max32(-most_part, min32(part, most_part)));
        }
        t->t[k] = sheen_mul_round(moved[k] * (1 << (k < 2 ? t->fine : 0)), factor[k], 31);
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

/* value * 2^by where m is so small that it grows, held beyond the guard band. |value| < 2^31, by <= 22. */
static int32_t grown(int32_t value, int by)
{
    const int64_t most = GUARD_BAND + 1;
    int64_t product = (int64_t)value * (1 << by);

    return (int32_t)(product > most ? most : product < -most ? -most : product);
}

/* Flags of a coordinate beyond the guard band, which is held at its limits. */
static unsigned guard(int16_t *out, int32_t value, unsigned low, unsigned high)
{
    *out = (int16_t)max32(-GUARD_BAND, min32(value, GUARD_BAND));
    return value < -GUARD_BAND ? low : value > GUARD_BAND ? high : 0;
}

/*
 * Beyond near or far only the flag is set; beyond the guard band depth is right and x, y are held at its limits,
 * OFF_VIEW.
 */
void sheen_project(const struct projection *p, int screen_shift, struct point point, struct vertex *v)
{
    if ((uint32_t)point.m - (uint32_t)p->near > (uint32_t)(p->far - p->near)) {
        *v = (struct vertex){.flags = point.m < p->near ? OUTSIDE_NEAR : OUTSIDE_FAR};
        return;
    }
    struct inverse i = inverse_of((uint32_t)(p->orthographic != 0 ? p->orthographic : point.m));
    int32_t x = over(i, point.x), y = over(i, point.y);
    int shift = screen_shift - i.up; /* -23..30 */
    uint32_t depth = (depth_at(p, i, point.m) + p->depth_base) >> p->depth_fraction;
    if (shift >= 0) {
        x = asr32(asr32(x, (unsigned)shift) + 1, 1);
        y = asr32(asr32(y, (unsigned)shift) + 1, 1);
    } else {
        x = grown(x, -shift - 1);
        y = grown(y, -shift - 1);
    }
    v->x = (int16_t)x;
    v->y = (int16_t)y;
    v->z = (uint16_t)(depth > DEPTH_FAR ? depth : DEPTH_FAR);
    v->flags = 0;
    if ((uint32_t)(x + p->view_x) > 2u * (uint32_t)p->view_x || (uint32_t)(y + p->view_y) > 2u * (uint32_t)p->view_y)
        v->flags = (uint16_t)(OFF_VIEW | guard(&v->x, x, OUTSIDE_LEFT, OUTSIDE_RIGHT) |
                              guard(&v->y, y, OUTSIDE_TOP, OUTSIDE_BOTTOM));
}
