/*
 * pose.c - rotations from angles, composition, and where an eye looks.
 */
#include "../sheen.h"
#include "fixed.h"

void sheen_pose_identity(struct sheen_pose *pose)
{
    for (int k = 0; k < 9; k++)
        pose->rotation[k] = k % 4 == 0 ? 1 << 30 : 0;
    pose->scale = 1 << 16;
    for (int k = 0; k < 3; k++)
        pose->translation[k] = 0;
}

/* Row of a rotation times a vector of any format, in that format. Range: |row| <= 1, so |result| <= 2^31.8. */
static int64_t row_times(const sheen_q30_t *row, const int32_t *v, int stride)
{
    int64_t sum = 0;

    for (int k = 0; k < 3; k++)
        sum += round_shift64((int64_t)row[k] * v[k * stride], 15);
    return round_shift64(sum, 15);
}

int sheen_pose_compose(const struct sheen_pose *outer, const struct sheen_pose *inner, struct sheen_pose *out)
{
    struct sheen_pose p;
    int64_t scale = round_shift64((int64_t)outer->scale * inner->scale, 16);

    if (scale <= 0 || scale > INT32_MAX)
        return SHEEN_ERR_ARGUMENT;
    p.scale = (sheen_q16_t)scale;
    for (int i = 0; i < 3; i++) {
        const sheen_q30_t *row = outer->rotation + 3 * i;
        for (int j = 0; j < 3; j++)
            p.rotation[3 * i + j] = (sheen_q30_t)row_times(row, inner->rotation + j, 3);
        int64_t moved = asr64(row_times(row, inner->translation, 1) * outer->scale, 16) + outer->translation[i];
        if (moved > INT32_MAX || moved < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        p.translation[i] = (sheen_q24_t)moved;
    }
    *out = p;
    return SHEEN_OK;
}

/* a x b of Q1.30 vectors; |result| <= 1. */
static void cross(const sheen_q30_t a[3], const sheen_q30_t b[3], sheen_q30_t out[3])
{
    for (int i = 0; i < 3; i++) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        out[i] = (sheen_q30_t)round_shift64((int64_t)a[j] * b[k] - (int64_t)a[k] * b[j], 30);
    }
}

int sheen_pose_look_at(struct sheen_pose *pose, const sheen_q24_t eye[3], const sheen_q24_t target[3],
                       const int32_t up[3])
{
    struct sheen_pose p;
    sheen_q30_t *right = p.rotation, *above = p.rotation + 3, *back = p.rotation + 6, upward[3];
    int32_t away[3];

    for (int k = 0; k < 3; k++) /* halved, so that the difference fits */
        away[k] = eye[k] / 2 - target[k] / 2;
    if (sheen_normalize(away, back) < 0 || sheen_normalize(up, upward) < 0)
        return SHEEN_ERR_DEGENERATE;
    cross(upward, back, right);
    if (magnitude32(right[0]) < 1024 && magnitude32(right[1]) < 1024 && magnitude32(right[2]) < 1024)
        return SHEEN_ERR_DEGENERATE; /* within 1e-6 of parallel: nothing left but rounding */
    (void)sheen_normalize(right, right);
    cross(back, right, above);
    (void)sheen_normalize(above, above); /* at right angles to back, exactly; right may lean by its rounding */
    cross(above, back, right);
    p.scale = 1 << 16;
    for (int k = 0; k < 3; k++) {
        int64_t moved = -row_times(p.rotation + 3 * k, eye, 1);
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
    int32_t sxsy = mul_round(sx, sy, 30), sxcy = mul_round(sx, cy, 30);
    int32_t *r = pose->rotation;

    r[0] = mul_round(cz, cy, 30) - mul_round(sz, sxsy, 30);
    r[1] = -mul_round(sz, cx, 30);
    r[2] = mul_round(cz, sy, 30) + mul_round(sz, sxcy, 30);
    r[3] = mul_round(sz, cy, 30) + mul_round(cz, sxsy, 30);
    r[4] = mul_round(cz, cx, 30);
    r[5] = mul_round(sz, sy, 30) - mul_round(cz, sxcy, 30);
    r[6] = -mul_round(cx, sy, 30);
    r[7] = sx;
    r[8] = mul_round(cx, cy, 30);

    pose->scale = 1 << 16;
    pose->translation[0] = 0;
    pose->translation[1] = 0;
    pose->translation[2] = -max32(distance, -INT32_MAX);
}
