/*
 * pose.c - from angles to a rotation matrix.
 */
#include "fixed.h"
#include "sheen.h"

/*
 * PICTURE.md's order, R = Rz(roll) * Rx(pitch) * Ry(yaw), multiplied out. Each
 * entry is within 4 raw steps of exact, so rows are unit vectors to 1e-8.
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
    pose->translation[2] = -distance;
}
