/*
 * transform.c - a mesh's vertex to the eye, then to the screen, with 1/m.
 *
 * m = -z is the lecture's mass ("Fixing Distortion"): x_s = focal * x / m. One
 * reciprocal a vertex serves x, y and depth.
 */
#include "../math/newton.h"
#include "vertex.h"

/* x / 2^shift, any shift >= 0. */
static uint64_t shift_right(uint64_t x, int shift)
{
    return shift > 63 ? 0 : x >> shift;
}

/* value / 2^fraction as mantissa and exponent. value > 0. */
static struct scaled scaled_of(uint64_t value, int fraction)
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
static struct scaled scaled_times(struct scaled a, struct scaled b)
{
    uint64_t product = (uint64_t)a.mantissa * b.mantissa; /* in [2^62, 2^64) */
    unsigned zeros = clz64(product);
    struct scaled s = {(uint32_t)((product << zeros) >> 32), a.exponent + b.exponent + 1 - (int)zeros};

    return s;
}

/* a * b, Q.8. Below 2^41 for depth / m with m >= near. */
static int64_t product_q8(struct scaled a, struct scaled b)
{
    return (int64_t)shift_right((uint64_t)a.mantissa * b.mantissa, 62 - 8 - a.exponent - b.exponent);
}

/*
 * Steps of z16 above far's, Q.8: (1/m - 1/far) depth, or in an orthographic view (far - m) depth. Not negative. At
 * near depth / m is at most 65020 * 2^15, and the relative error 2^-27 of that 16 steps above DEPTH_RANGE.
 */
static int64_t depth_above_far(const struct projection *p, sheen_q24_t m, struct scaled one_over_m)
{
    if (p->orthographic == 0) {
        int64_t above = product_q8(p->depth, one_over_m) - p->depth_far;
        return above > 0 ? above : 0;
    }
    return m < p->far ? product_q8(p->depth, scaled_of((uint64_t)(p->far - m), 24)) : 0;
}

/*
 * 1/m = (z16 - DEPTH_FAR + depth / far) / depth, so a sum gives a number that is
 * proportional to it. The sum is scaled to just below 2^32.
 */
static void weight_begin(struct projection *p)
{
    int64_t offset = p->depth_far - (DEPTH_FAR << 8);          /* Q.8 */
    unsigned zeros = clz64((uint64_t)(offset + (65536 << 8))); /* 24..40 */

    p->weight_shift = zeros - 32 + 8;
    p->weight_offset = (uint32_t)(zeros >= 32 ? offset * (int64_t)(1u << (zeros - 32)) : asr64(offset, 32 - zeros));
}

int sheen_project_begin(struct projection *p, const struct sheen_view *view, unsigned width, unsigned height)
{
    sheen_angle_t fov = view->fov != 0 ? view->fov : SHEEN_DEGREES(40), half = fov / 2;
    sheen_q24_t z_far = view->z_far != 0 ? view->z_far : SHEEN_Q24(16);
    sheen_q24_t z_near = view->z_near != 0 ? view->z_near : z_far / 16;
    int64_t span = (int64_t)z_far - z_near;

    if (fov < SHEEN_DEGREES(0.99) || fov > SHEEN_DEGREES(150.01))
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
    if (p->orthographic != 0) { /* all weights are equal */
        p->fixed = reciprocal_of(p->orthographic);
        p->depth = scaled_times(scaled_of(DEPTH_RANGE, 0), reciprocal_of((sheen_q24_t)span));
        p->depth_far = 0;
        p->weight_shift = 0;
        p->weight_offset = 0;
        return SHEEN_OK;
    }
    /* DEPTH_RANGE * near * far / (far - near), the second factor at most near * 2^15 */
    p->depth = scaled_times(scaled_of((uint64_t)z_near * (uint64_t)z_far, 48), reciprocal_of((sheen_q24_t)span));
    p->depth = scaled_times(p->depth, scaled_of(DEPTH_RANGE, 0));
    p->depth_far = product_q8(p->depth, reciprocal_of(z_far));
    weight_begin(p);
    return SHEEN_OK;
}

/* Row i of the rotation times a vector of lengths, in Q7.24. */
static int64_t rotate_row(const sheen_q30_t *row, const sheen_q24_t v[3])
{
    int64_t sum = 0;

    for (int k = 0; k < 3; k++)
        sum += asr64((int64_t)row[k] * v[k], 15);
    return asr64(sum, 15);
}

int sheen_transform_begin(struct transform *t, const struct sheen_mesh *mesh, const struct sheen_pose *pose)
{
    if (pose->scale <= 0 || mesh->scale <= 0)
        return SHEEN_ERR_ARGUMENT;
    int64_t scale = ((int64_t)pose->scale * mesh->scale) >> 16; /* Q7.24 */
    if (scale <= 0 || scale > INT32_MAX)
        return SHEEN_ERR_ARGUMENT;

    unsigned zeros = clz32((uint32_t)scale) - 1; /* scale * 2^zeros in [2^30, 2^31) */
    for (int k = 0; k < 9; k++)
        t->m[k] = mul_round(pose->rotation[k], (int32_t)(scale << zeros), 31);
    t->shift = (int)zeros - 2; /* raw / 2^15, rotation / 2^30, m = rotation * scale * 2^(zeros - 31) */

    for (int k = 0; k < 3; k++) {
        int64_t moved =
            asr64(rotate_row(pose->rotation + 3 * k, mesh->offset) * pose->scale, 16) + pose->translation[k];
        /* raw positions reach sqrt(3) * scale from the mesh's origin: nothing may wrap later */
        if (moved + 2 * scale > INT32_MAX || moved - 2 * scale < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        t->t[k] = (sheen_q24_t)moved;
    }
    return SHEEN_OK;
}

/* Range: three terms of at most 2^15 * 2^30 / 2^16 = 2^29. */
void sheen_transform_point(const struct transform *t, const int16_t position[3], sheen_q24_t eye[3])
{
    for (int k = 0; k < 3; k++) {
        const int32_t *m = t->m + 3 * k;
        int32_t sum = mul_16_32(position[0], m[0]) + mul_16_32(position[1], m[1]) + mul_16_32(position[2], m[2]);

        eye[k] = t->t[k] + (t->shift >= 0 ? asr32(sum, (unsigned)t->shift) : sum * (1 << -t->shift));
    }
}

/* x * scale in 1/64 px, rounded; beyond the guard band *flags gets low or high and the band's limit is returned. */
static int16_t screen(sheen_q24_t x, struct scaled scale, unsigned low, unsigned high, unsigned *flags)
{
    int shift = 24 - SUBPIXEL_BITS + 30 - scale.exponent; /* 8 at the least: focal / m < 2^39 */
    int64_t product = (int64_t)x * (scale.mantissa >> 1); /* < 2^62 */
    int64_t value = shift > 62 ? 0 : round_shift64(product, (unsigned)shift);

    if (value < -GUARD_BAND) {
        *flags |= low;
        return -GUARD_BAND;
    }
    if (value > GUARD_BAND) {
        *flags |= high;
        return GUARD_BAND;
    }
    return (int16_t)value;
}

/*
 * |eye| <= INT32_MAX a part. Beyond near or far only the flag is set; beyond the
 * guard band depth is right and x, y are held at its limits, OFF_VIEW.
 */
void sheen_project(const struct projection *p, const sheen_q24_t eye[3], struct vertex *v)
{
    sheen_q24_t m = -eye[2];
    unsigned flags = 0;

    v->x = 0;
    v->y = 0;
    v->z = 0;
    if (m < p->near) {
        v->flags = OUTSIDE_NEAR;
        return;
    }
    if (m > p->far) {
        v->flags = OUTSIDE_FAR;
        return;
    }
    struct scaled one_over_m = p->orthographic != 0 ? p->fixed : reciprocal_of(m);
    struct scaled scale = {mul_high(p->focal.mantissa, one_over_m.mantissa), /* in [2^30, 2^32) */
                           p->focal.exponent + one_over_m.exponent + 1};
    v->x = screen(eye[0], scale, OUTSIDE_LEFT, OUTSIDE_RIGHT, &flags);
    v->y = screen(-eye[1], scale, OUTSIDE_TOP, OUTSIDE_BOTTOM, &flags);
    v->z = (uint16_t)(DEPTH_FAR + ((depth_above_far(p, m, one_over_m) + 128) >> 8));
    if (v->x > p->view_x || v->x < -p->view_x || v->y > p->view_y || v->y < -p->view_y)
        flags |= OFF_VIEW;
    v->flags = (uint16_t)flags;
}
