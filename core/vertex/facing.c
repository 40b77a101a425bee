/*
 * facing.c - polygons that face away are passed over before any of their vertices is transformed.
 *
 * With the eye e and a polygon's normal n in the mesh's raw units, a polygon through p faces away where n.(p - e) > 0.
 * The margin holds what that is off by: the stored normal stands for all of the polygon's triangles (its warp),
 * e is cut to 14 bits, a rotation need not be one exactly. So only what faces away is skipped; the rest is left to the
 * area on the screen. Orthographic, e is the direction to the eye and p does not count.
 */
#include "../math/newton.h"
#include "../math/pose.h"
#include "vertex.h"

#define EYE_BITS 14
#define MOST_SHIFT 13
#define WARP_BITS 10
#define CORNER 56756         /* sqrt(3) * 2^15: how far a raw position may lie from the origin */
#define ROUNDED (3 << 16)    /* n times what e is off by: 2 * 56,760 for its cut, 45,000 for the rotation */
#define STRAIGHT (1 << 14)   /* Q1.30: rows that are off by more are no rotation to rely on */
#define LEAST_UNIT (1 << 24) /* pose.scale * mesh.scale: below that e is too coarse */

/* 1 where the rows turn what they are given, and do not mirror it. */
static int turns(const sheen_q30_t r[9])
{
    int64_t volume = 0;

    for (int k = 0; k < 3; k++) {
        int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        volume += asr64((int64_t)r[i] * r[3 + j] - (int64_t)r[j] * r[3 + i], 30) * r[6 + k];
    }
    return volume > 0 && sheen_is_rotation(r, STRAIGHT);
}

/*
 * The eye in raw units, 0 where it lies 2^27 of them away or more: -(R^T t) / (pose.scale mesh.scale) - offset /
 * mesh.scale, by reciprocals. Within 1 raw unit and 2^-27 of it.
 */
static int find_eye(const struct sheen_mesh *mesh, const struct sheen_pose *pose, int64_t unit, int64_t eye[3])
{
    unsigned zeros = clz64((uint64_t)unit), shift = 59 - zeros, up = clz32((uint32_t)mesh->scale);
    uint32_t over_unit = sheen_reciprocal((uint32_t)((uint64_t)unit << zeros >> 32));
    uint32_t over_scale = sheen_reciprocal((uint32_t)mesh->scale << up);

    for (int k = 0; k < 3; k++) {
        const sheen_q30_t *column = pose->rotation + k;
        int64_t sum = asr64((int64_t)column[0] * pose->translation[0] + (int64_t)column[3] * pose->translation[1] +
                                (int64_t)column[6] * pose->translation[2],
                            shift);
        if (sum > INT32_MAX || sum < -INT32_MAX)
            return 0;
        eye[k] = -asr64(sum * over_unit, 35) - asr64(mesh->offset[k] * (int64_t)over_scale, 48 - up);
        if (eye[k] >= 1 << (EYE_BITS + MOST_SHIFT) || eye[k] <= -(1 << (EYE_BITS + MOST_SHIFT)))
            return 0;
    }
    return 1;
}

void sheen_viewpoint_begin(struct viewpoint *viewpoint, const struct projection *p, const struct sheen_mesh *mesh,
                           const struct sheen_pose *pose)
{
    int64_t eye[3], unit = (int64_t)pose->scale * mesh->scale;
    uint32_t all = 0, distance = CORNER; /* < 2^29 */

    viewpoint->a_warp = 0;
    if (mesh->warp == NULL || mesh->polygon_normals == NULL || unit < LEAST_UNIT || !turns(pose->rotation))
        return;
    if (p->orthographic != 0) {
        viewpoint->shift = 31;
        viewpoint->a_warp = 1 << (15 + EYE_BITS - WARP_BITS);
        for (int k = 0; k < 3; k++)
            viewpoint->eye[k] = asr32(pose->rotation[6 + k], 30 - EYE_BITS);
        return;
    }
    if (!find_eye(mesh, pose, unit, eye))
        return;
    for (int k = 0; k < 3; k++) {
        uint32_t away = magnitude32((int32_t)eye[k]);
        distance += away;
        all |= away;
    }
    viewpoint->shift = 1;
    while (all >> viewpoint->shift >= 1u << EYE_BITS)
        viewpoint->shift++;
    for (int k = 0; k < 3; k++)
        viewpoint->eye[k] = asr32((int32_t)eye[k], viewpoint->shift);
    viewpoint->a_warp = (int32_t)((distance >> viewpoint->shift << (15 - WARP_BITS)) + (2u << (15 - WARP_BITS)));
}

/* n.v modulo 2^32; a unit n and |v| < 2^16 fit. */
static inline int32_t facing_dot(const int16_t n[3], int32_t x, int32_t y, int32_t z)
{
    return (int32_t)((uint32_t)n[0] * (uint32_t)x + (uint32_t)n[1] * (uint32_t)y + (uint32_t)n[2] * (uint32_t)z);
}

uint32_t sheen_next_facing(const struct viewpoint *viewpoint, const struct sheen_mesh *mesh, uint32_t i,
                           uint32_t *faces)
{
    const uint16_t *polygons = mesh->polygons;
    const uint32_t end = mesh->triangles;
    const int32_t x = viewpoint->eye[0], y = viewpoint->eye[1], z = viewpoint->eye[2], a_warp = viewpoint->a_warp;
    const unsigned shift = viewpoint->shift;
    uint32_t polygon = polygons != NULL ? polygons[i] : i;

    while (polygon != *faces) {
        const int16_t *n = mesh->polygon_normals + 3 * polygon, *p = mesh->positions + 3 * mesh_index(mesh, 3 * i);
        uint32_t away = polygon, warp = mesh->warp[polygon];
        SHEEN_TAP(FACING, 1);
        uint32_t above = (uint32_t)asr32(facing_dot(n, p[0], p[1], p[2]), shift) - (uint32_t)facing_dot(n, x, y, z);
        if ((int32_t)above <= (int32_t)warp * a_warp + ROUNDED || warp == SHEEN_WARP_UNKNOWN) {
            *faces = polygon;
            break;
        }
        do {
            if (++i == end)
                return end;
            polygon = polygons != NULL ? polygons[i] : i;
        } while (polygon == away);
    }
    return i;
}
