/*
 * pose.c - rotations from angles, composition, repair, and where an eye looks.
 */
#include "pose.h"
#include "fixed.h"

void sheen_pose_identity(struct sheen_pose *pose)
{
    for (int k = 0; k < 9; k++)
        pose->rotation[k] = k % 4 == 0 ? 1 << 30 : 0;
    pose->scale = 1 << 16;
    for (int k = 0; k < 3; k++)
        pose->translation[k] = 0;
}

int sheen_is_rotation(const sheen_q30_t r[9], int32_t within)
{
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++) {
            int64_t dot = 0; /* Q.30; the terms are cut first, since any rotation may come */
            for (int k = 0; k < 3; k++)
                dot += asr64((int64_t)r[3 * i + k] * r[3 * j + k], 30);
            dot -= i == j ? 1 << 30 : 0;
            if (dot > within || dot < -within)
                return 0;
        }
    return 1;
}

int sheen_rotation_is_zero(const sheen_q30_t r[9])
{
    int32_t any = 0;

    for (int k = 0; k < 9; k++)
        any |= r[k];
    return any == 0;
}

int sheen_pose_is_zero(const struct sheen_pose *p)
{
    return sheen_rotation_is_zero(p->rotation) && p->scale == 0 &&
           (p->translation[0] | p->translation[1] | p->translation[2]) == 0;
}

int sheen_pose_valid(const struct sheen_pose *p)
{
    return p->scale >= 0 && (sheen_rotation_is_zero(p->rotation) || sheen_is_rotation(p->rotation, 1 << 20));
}

/* A pose with its defaults filled in. */
static void complete(const struct sheen_pose *from, struct sheen_pose *to)
{
    sheen_pose_identity(to);
    for (int k = 0; k < 9 && !sheen_rotation_is_zero(from->rotation); k++)
        to->rotation[k] = from->rotation[k];
    for (int k = 0; k < 3; k++)
        to->translation[k] = from->translation[k];
    to->scale = from->scale != 0 ? from->scale : to->scale;
}

/* Row of a rotation times a vector of any format, Q.30 more. Range: |row| <= 1.001, so |result| < 2^61.8. */
static APART int64_t row_times(const sheen_q30_t *row, const int32_t *v, int stride)
{
    return (int64_t)row[0] * v[0] + (int64_t)row[1] * v[stride] + (int64_t)row[2] * v[2 * stride];
}

/* a x b of Q1.30 vectors no longer than 1.001: their products' difference is below 2^61. */
static void cross(const sheen_q30_t a[3], const sheen_q30_t b[3], sheen_q30_t out[3])
{
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        out[i] = (sheen_q30_t)round_shift64((int64_t)a[j] * b[k] - (int64_t)a[k] * b[j], 30);
    }
}

/* The rotation whose third row points along `back` and whose second one lies on the side of `up`. */
static int rotation_from(const int32_t back[3], const int32_t up[3], sheen_q30_t rotation[9])
{
    sheen_q30_t *right = rotation, *above = rotation + 3, *third = rotation + 6, upward[3];

    if (sheen_normalize(up, upward) < 0 || sheen_normalize(back, third) < 0)
        return SHEEN_ERR_DEGENERATE;
    cross(upward, third, right);
    if (magnitude32(right[0]) < 1024 && magnitude32(right[1]) < 1024 && magnitude32(right[2]) < 1024)
        return SHEEN_ERR_DEGENERATE; /* within 1e-6 of parallel: nothing left but rounding */
    (void)sheen_normalize(right, right);
    cross(third, right, above);
    (void)sheen_normalize(above, above); /* at right angles to third, exactly; right may lean by its rounding */
    cross(above, third, right);
    return SHEEN_OK;
}

int sheen_pose_orthonormalize(struct sheen_pose *pose)
{
    sheen_q30_t r[9];
    const sheen_q30_t *first = pose->rotation;
    int64_t along = 0; /* the first row says whether the pose mirrors; halved, the sum fits */

    if (rotation_from(first + 6, first + 3, r) < 0)
        return SHEEN_ERR_DEGENERATE;
    for (int k = 0; k < 3; k++)
        along += (int64_t)r[k] * (first[k] / 2);
    for (int k = 0; k < 9; k++)
        pose->rotation[k] = along < 0 && k < 3 ? -r[k] : r[k];
    return SHEEN_OK;
}

/*
 * round(sum * scale / 2^46), a row's product to a length of Q7.24, in two words: |high * scale| < 2^31.8 * 2^31. What
 * is cut off before the rounding could not change it: a floor of a floor is the floor.
 */
static int64_t scaled_length(int64_t sum, sheen_q16_t scale)
{
    int64_t high = asr64(sum, 30), low = sum & ((1 << 30) - 1);

    return round_shift64(high * scale + ((low * scale) >> 30), 16);
}

/* outer * inner with their defaults, each rotation entry within 1 raw step of the product. */
static int pose_product(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out)
{
    struct sheen_pose a, b;

    if (!sheen_pose_valid(outer) || !sheen_pose_valid(inner))
        return SHEEN_ERR_ARGUMENT;
    complete(outer, &a);
    complete(inner, &b);
    int64_t scale = round_shift64((int64_t)a.scale * b.scale, 16);
    if (scale <= 0 || scale > INT32_MAX)
        return SHEEN_ERR_ARGUMENT;
    out->scale = (sheen_q16_t)scale;
    for (int i = 0; i < 3; i++) {
        const sheen_q30_t *row = a.rotation + 3 * i;
        for (int j = 0; j < 3; j++)
            out->rotation[3 * i + j] = (sheen_q30_t)round_shift64(row_times(row, b.rotation + j, 3), 30);
        int64_t moved = scaled_length(row_times(row, b.translation, 1), a.scale) + a.translation[i];
        if (moved > INT32_MAX || moved < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        out->translation[i] = (sheen_q24_t)moved;
    }
    return SHEEN_OK;
}

int sheen_pose_compose(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out)
{
    struct sheen_pose p;

    if (pose_product(outer, inner, &p) < 0)
        return SHEEN_ERR_ARGUMENT;
    (void)sheen_pose_orthonormalize(&p); /* rotations multiply to one: errors do not add up over many compositions */
    *out = p;
    return SHEEN_OK;
}

int sheen_pose_place(const struct sheen_pose *view, const struct sheen_pose *pose, struct sheen_pose *out)
{
    if (!sheen_pose_is_zero(view))
        return pose_product(view, pose, out);
    if (!sheen_pose_valid(pose))
        return SHEEN_ERR_ARGUMENT;
    complete(pose, out);
    return SHEEN_OK;
}

int sheen_pose_rotate(struct sheen_pose *pose, unsigned axis, sheen_angle_t angle)
{
    unsigned first = axis == 2 ? 0 : axis + 1, second = axis == 0 ? 2 : axis - 1;
    struct sheen_pose turn;

    if (axis > 2)
        return SHEEN_ERR_ARGUMENT;
    sheen_pose_identity(&turn);
    turn.rotation[4 * first] = turn.rotation[4 * second] = sheen_cos(angle);
    turn.rotation[3 * second + first] = sheen_sin(angle);
    turn.rotation[3 * first + second] = -sheen_sin(angle);
    return sheen_pose_compose(&turn, pose, pose);
}

int sheen_pose_scale(struct sheen_pose *pose, sheen_q16_t factor)
{
    const struct sheen_pose larger = {.scale = factor};

    return factor <= 0 ? SHEEN_ERR_ARGUMENT : sheen_pose_compose(&larger, pose, pose);
}

int sheen_pose_translate(struct sheen_pose *pose, sheen_q24_t x, sheen_q24_t y, sheen_q24_t z)
{
    const struct sheen_pose moved = {.translation = {x, y, z}};

    return sheen_pose_compose(&moved, pose, pose);
}

int sheen_pose_look_at(struct sheen_pose *pose, const sheen_q24_t eye[3], const sheen_q24_t target[3],
                       const int32_t up[3])
{
    struct sheen_pose p;
    int32_t back[3];
    unsigned halved = 0;

    for (int k = 0; k < 3; k++) {
        int64_t away = (int64_t)eye[k] - target[k];
        halved |= away > INT32_MAX || away < -INT32_MAX;
    }
    for (int k = 0; k < 3; k++) /* one bit less only where the difference needs 33 */
        back[k] = (int32_t)asr64((int64_t)eye[k] - target[k], halved);
    if (rotation_from(back, up, p.rotation) < 0)
        return SHEEN_ERR_DEGENERATE;
    p.scale = 1 << 16;
    for (int k = 0; k < 3; k++) {
        int64_t moved = round_shift64(-row_times(p.rotation + 3 * k, eye, 1), 30);
        if (moved > INT32_MAX || moved < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        p.translation[k] = (sheen_q24_t)moved;
    }
    *pose = p;
    return SHEEN_OK;
}

/*
 * The command line's order, R = Rz(roll) * Rx(pitch) * Ry(yaw), multiplied out. Each
 * entry is within 6 raw steps of exact, so rows are unit vectors to 1e-8.
 */
void sheen_pose_orbit(struct sheen_pose *pose, sheen_angle_t yaw, sheen_angle_t pitch, sheen_angle_t roll,
                      sheen_q24_t distance)
{
    int32_t sy = sheen_sin(yaw), cy = sheen_cos(yaw);
    int32_t sx = sheen_sin(pitch), cx = sheen_cos(pitch);
    int32_t sz = sheen_sin(roll), cz = sheen_cos(roll);
    int32_t sxsy = sheen_mul_round(sx, sy, 30), sxcy = sheen_mul_round(sx, cy, 30);
    int32_t *r = pose->rotation;

    r[0] = sheen_mul_round(cz, cy, 30) - sheen_mul_round(sz, sxsy, 30);
    r[1] = -sheen_mul_round(sz, cx, 30);
    r[2] = sheen_mul_round(cz, sy, 30) + sheen_mul_round(sz, sxcy, 30);
    r[3] = sheen_mul_round(sz, cy, 30) + sheen_mul_round(cz, sxsy, 30);
    r[4] = sheen_mul_round(cz, cx, 30);
    r[5] = sheen_mul_round(sz, sy, 30) - sheen_mul_round(cz, sxcy, 30);
    r[6] = -sheen_mul_round(cx, sy, 30);
    r[7] = sx;
    r[8] = sheen_mul_round(cx, cy, 30);

    pose->scale = 1 << 16;
    pose->translation[0] = 0;
    pose->translation[1] = 0;
    pose->translation[2] = -max32(distance, -INT32_MAX);
}
