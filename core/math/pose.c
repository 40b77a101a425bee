/*
 * pose.c - poses: rotations from angles, composition, repair, and where an eye looks.
 */
#include "pose.h"
#include "fixed.h"

#define ONE (1 << 30)
#define LARGEST_COMPONENT (ONE + (1 << 20)) /* no component of a rotation is larger */

/* Replaces what is 0 in a pose by its default. */
static void complete(struct sheen_pose *pose)
{
    if (sheen_rotation_is_zero(pose->rotation))
        pose->rotation[0] = pose->rotation[4] = pose->rotation[8] = ONE;
    if (pose->scale == 0)
        pose->scale = 1 << 16;
}

COLD void sheen_pose_identity(struct sheen_pose *pose)
{
    *pose = (struct sheen_pose){.scale = 0};
    complete(pose);
}

/* Range: |component| < 1.001, so a dot product, which wraps modulo 4.0, is near 0 only if it is so without wrapping. */
COLD int sheen_is_rotation(const sheen_q30_t r[9], int32_t within)
{
    for (int k = 0; k < 9; k++)
        if (magnitude32(r[k]) > LARGEST_COMPONENT)
            return 0;
    for (int i = 0; i < 9; i += 3)
        for (int j = i; j < 9; j += 3) {
            uint32_t dot = i == j ? 0u - ONE : 0;
            for (int k = 0; k < 3; k++)
                dot += (uint32_t)sheen_mul_round(r[i + k], r[j + k], 30);
            if (magnitude32((int32_t)dot) > (uint32_t)within)
                return 0;
        }
    return 1;
}

COLD int sheen_rotation_is_zero(const sheen_q30_t r[9])
{
    int32_t any = 0;

    for (int k = 0; k < 9; k++)
        any |= r[k];
    return any == 0;
}

COLD int sheen_pose_is_zero(const struct sheen_pose *p)
{
    return sheen_rotation_is_zero(p->rotation) && p->scale == 0 &&
           (p->translation[0] | p->translation[1] | p->translation[2]) == 0;
}

COLD int sheen_pose_valid(const struct sheen_pose *p)
{
    return p->scale >= 0 && (sheen_rotation_is_zero(p->rotation) || sheen_is_rotation(p->rotation, 1 << 20));
}

/*
 * A row of a rotation times a vector of any format, with 30 more fraction bits. Range: |row| <= 1.003, of a product of
 * two, so |result| < 2^61.8.
 */
static APART int64_t row_times(const sheen_q30_t *row, const int32_t *v, int stride)
{
    return (int64_t)row[0] * v[0] + (int64_t)row[1] * v[stride] + (int64_t)row[2] * v[2 * stride];
}

/* a x b of Q1.30 vectors no longer than 1.001. Range: the difference of two products is below 2^61. */
static void cross(const sheen_q30_t a[3], const sheen_q30_t b[3], sheen_q30_t out[3])
{
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        out[i] = (sheen_q30_t)round_shift64((int64_t)a[j] * b[k] - (int64_t)a[k] * b[j], 30);
    }
}

/* The rotation whose third row points along `back` and whose second row lies on the side of `up`. */
static int rotation_from(const int32_t back[3], const int32_t up[3], sheen_q30_t rotation[9])
{
    sheen_q30_t *right = rotation, *above = rotation + 3, *third = rotation + 6, upward[3];

    if (sheen_normalize(up, upward) < 0 || sheen_normalize(back, third) < 0)
        return SHEEN_ERR_DEGENERATE;
    cross(upward, third, right);
    if (magnitude32(right[0]) < 1024 && magnitude32(right[1]) < 1024 && magnitude32(right[2]) < 1024)
        return SHEEN_ERR_DEGENERATE; /* within 1e-6 of parallel: nothing is left but rounding */
    (void)sheen_normalize(right, right);
    cross(third, right, above);
    (void)sheen_normalize(above,
                          above); /* above is exactly at right angles to third, but right may lean by its rounding */
    cross(above, third, right);
    return SHEEN_OK;
}

COLD int sheen_pose_orthonormalize(struct sheen_pose *pose)
{
    sheen_q30_t r[9];
    const sheen_q30_t *first = pose->rotation;
    int64_t along = 0; /* negative if the pose mirrors, which its first row shows; halved so that the sum fits */

    if (rotation_from(first + 6, first + 3, r) < 0)
        return SHEEN_ERR_DEGENERATE;
    for (int k = 0; k < 3; k++)
        along += (int64_t)r[k] * (first[k] / 2);
    for (int k = 0; k < 9; k++)
        pose->rotation[k] = along < 0 && k < 3 ? -r[k] : r[k];
    return SHEEN_OK;
}

/*
 * round(sum * scale / 2^46) brings a row's product to a length in Q7.24. It is computed in two words: |high * scale| <
 * 2^31.8 * 2^31. The bits that are cut off before the rounding cannot change it: a floor of a floor is the floor.
 */
int64_t sheen_pose_part(const struct sheen_pose *pose, int i, const sheen_q24_t v[3])
{
    const int64_t sum = row_times(pose->rotation + 3 * i, v, 1), scale = pose->scale;
    int64_t high = asr64(sum, 30), low = sum & ((1 << 30) - 1);

    return round_shift64(high * scale + ((low * scale) >> 30), 16) + pose->translation[i];
}

COLD int sheen_pose_place(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out)
{
    struct sheen_pose a = *outer, b = *inner;

    if (!sheen_pose_valid(outer) || !sheen_pose_valid(inner))
        return SHEEN_ERR_ARGUMENT;
    complete(&a);
    complete(&b);
    int64_t scale = round_shift64((int64_t)a.scale * b.scale, 16);
    if (scale <= 0 || scale > INT32_MAX)
        return SHEEN_ERR_ARGUMENT;
    out->scale = (sheen_q16_t)scale;
    for (int i = 0; i < 3; i++) {
        const sheen_q30_t *row = a.rotation + 3 * i;
        for (int j = 0; j < 3; j++)
            out->rotation[3 * i + j] = (sheen_q30_t)round_shift64(row_times(row, b.rotation + j, 3), 30);
        int64_t moved = sheen_pose_part(&a, i, b.translation);
        if (moved > INT32_MAX || moved < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        out->translation[i] = (sheen_q24_t)moved;
    }
    return SHEEN_OK;
}

COLD int sheen_pose_compose(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out)
{
    struct sheen_pose p;

    if (sheen_pose_place(outer, inner, &p) < 0)
        return SHEEN_ERR_ARGUMENT;
    (void)sheen_pose_orthonormalize(
        &p); /* cannot fail on a product of rotations; keeps errors from adding up over many compositions */
    *out = p;
    return SHEEN_OK;
}

COLD int sheen_pose_rotate(struct sheen_pose *pose, unsigned axis, sheen_angle_t angle)
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

COLD int sheen_pose_scale(struct sheen_pose *pose, sheen_q16_t factor)
{
    const struct sheen_pose larger = {.scale = factor};

    return factor <= 0 ? SHEEN_ERR_ARGUMENT : sheen_pose_compose(&larger, pose, pose);
}

COLD int sheen_pose_translate(struct sheen_pose *pose, sheen_q24_t x, sheen_q24_t y, sheen_q24_t z)
{
    const struct sheen_pose moved = {.translation = {x, y, z}};

    return sheen_pose_compose(&moved, pose, pose);
}

COLD int sheen_pose_look_at(struct sheen_pose *pose, const sheen_q24_t eye[3], const sheen_q24_t target[3],
                            const int32_t up[3])
{
    struct sheen_pose p;
    int32_t back[3];
    unsigned halved = 0;

    for (int k = 0; k < 3; k++) {
        int64_t away = (int64_t)eye[k] - target[k];
        halved |= away > INT32_MAX || away < -INT32_MAX;
    }
    for (int k = 0; k < 3; k++) /* one bit less precision only if a difference needs 33 bits */
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

/* Turns rows a and b in their plane by the angle of that cosine and sine. */
static APART void turn_rows(sheen_q30_t *a, sheen_q30_t *b, int32_t cosine, int32_t sine)
{
    for (int k = 0; k < 3; k++) {
        const int32_t x = a[k], y = b[k];
        a[k] = sheen_mul_round(cosine, x, 30) - sheen_mul_round(sine, y, 30);
        b[k] = sheen_mul_round(sine, x, 30) + sheen_mul_round(cosine, y, 30);
    }
}

/*
 * The command line's order, R = Rz(roll) * Rx(pitch) * Ry(yaw). Each entry is within 6 raw steps of exact, so rows are
 * unit vectors to 1e-8.
 */
COLD void sheen_pose_orbit(struct sheen_pose *pose, sheen_angle_t yaw, sheen_angle_t pitch, sheen_angle_t roll,
                           sheen_q24_t distance)
{
    int32_t *r = pose->rotation;

    sheen_pose_identity(pose);
    turn_rows(r, r + 6, sheen_cos(yaw), -sheen_sin(yaw));
    turn_rows(r + 3, r + 6, sheen_cos(pitch), sheen_sin(pitch));
    turn_rows(r, r + 3, sheen_cos(roll), sheen_sin(roll));
    pose->translation[2] = -max32(distance, -INT32_MAX);
}
