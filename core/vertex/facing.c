/*
 * facing.c - back-face culling of polygons before any of their vertices is transformed.
 *
 * With the eye e and a polygon's normal n in the mesh's raw units, a polygon through p faces away if n.(p - e) > 0. A
 * margin covers the error of that: the stored normal stands for all of the polygon's triangles (its warp), e is cut to
 * 14 bits, and the rotation may be slightly off. So only polygons that do face away are skipped; the others are decided
 * by their area on the screen. In an orthographic view e is the direction to the eye and p does not count.
 */
#include "../math/newton.h"
#include "../math/pose.h"
#include "vertex.h"

#define EYE_BITS 14
#define MOST_SHIFT 13
#define WARP_BITS 10
#define CORNER 56756          /* sqrt(3) * 2^15: how far a raw position may lie from the origin */
#define ROUNDED (3 << 16)     /* n times the error of e: 56,760 from its cut, as much from the origin, 45,000 from R */
#define EYE_ROUNDED 6         /* |e| beyond the sum of its parts: cuts 1.8, origin 1.8, R 1.4; and 1 for CORNER */
#define STRAIGHT (1 << 14)    /* Q1.30: a rotation whose rows are off by more is not relied on */
#define LEAST_SCALE (1 << 16) /* Q7.24: the origin is off by at most 4 of its steps, here at most 2 raw steps */

/* 1 if the matrix rotates and does not mirror. Range: volume, its determinant, is about 2^28 or -2^28. */
static int is_proper_rotation(const sheen_q30_t r[9])
{
    int32_t volume = 0;

    for (int k = 0; k < 3; k++) {
        int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        int32_t area = asr32(r[i], 16) * asr32(r[3 + j], 16) - asr32(r[j], 16) * asr32(r[3 + i], 16);
        volume += asr32(area, 14) * asr32(r[6 + k], 16);
    }
    return volume > 0;
}

/*
 * The eye, -R^T origin / scale, with as many bits as fit; there is no test if it is 2^27 raw units away or more. The
 * origin is used as v = origin * 2^up in 31 bits; R^T v * 2^(31 - zeros) / scale is the eye in raw units times
 * 2^(16 + up - zeros), a factor of at least 1 and less than 2^15.
 */
static void find_eye(struct viewpoint *viewpoint, const sheen_q30_t rotation[9], const sheen_q24_t origin[3],
                     uint32_t scale)
{
    const unsigned zeros = clz32(scale),
                   room = clz32(scale | magnitude32(origin[0]) | magnitude32(origin[1]) | magnitude32(origin[2])) - 1;
    const int32_t inverse = (int32_t)(sheen_reciprocal(scale << zeros) >> 1);
    unsigned shift = 1, drop = 16 + room - zeros; /* room = up + 1 */
    uint32_t all = 0, distance = EYE_ROUNDED;
    int32_t v[3], eye[3];

    for (int k = 0; k < 3; k++)
        v[k] = asr32(origin[k] * (1 << room), 1);
    sheen_to_model(rotation, v, eye);
    for (int k = 0; k < 3; k++) {
        eye[k] = sheen_mul_round(eye[k], inverse, 31);
        all |= magnitude32(eye[k]);
    }
    for (; all >> drop >= 1u << EYE_BITS; drop++)
        shift++;
    if (shift > MOST_SHIFT)
        return;
    for (int k = 0; k < 3; k++) {
        viewpoint->eye[k] = -asr32(eye[k], drop);
        distance += magnitude32(viewpoint->eye[k]);
    }
    viewpoint->shift = shift;
    viewpoint->margin_per_warp = (int32_t)((distance + (CORNER >> shift)) << (15 - WARP_BITS));
}

COLD void sheen_viewpoint_begin(struct viewpoint *viewpoint, const struct projection *p, const struct sheen_mesh *mesh,
                                const struct sheen_pose *pose)
{
    sheen_q24_t origin[3];

    viewpoint->margin_per_warp = 0;
    if (mesh->warp == NULL || mesh->polygon_normals == NULL || !sheen_is_rotation(pose->rotation, STRAIGHT) ||
        !is_proper_rotation(pose->rotation))
        return;
    if (p->orthographic != 0) {
        viewpoint->shift = 31;
        viewpoint->margin_per_warp = 1 << (15 + EYE_BITS - WARP_BITS);
        for (int k = 0; k < 3; k++)
            viewpoint->eye[k] = asr32(pose->rotation[6 + k], 30 - EYE_BITS);
        return;
    }
    const sheen_q24_t scale = sheen_origin(mesh, pose, origin);
    if (scale >= LEAST_SCALE)
        find_eye(viewpoint, pose->rotation, origin, (uint32_t)scale);
}

/* n.v modulo 2^32; exact for a unit n and |v| < 2^16. */
static inline int32_t facing_dot(const int16_t n[3], int32_t x, int32_t y, int32_t z)
{
    return (int32_t)((uint32_t)n[0] * (uint32_t)x + (uint32_t)n[1] * (uint32_t)y + (uint32_t)n[2] * (uint32_t)z);
}

uint32_t sheen_next_facing(const struct viewpoint *viewpoint, const struct sheen_mesh *mesh, uint32_t i,
                           uint32_t *faces)
{
    const uint16_t *polygons = mesh->polygons;
    const uint32_t end = mesh->triangles;
    const int32_t x = viewpoint->eye[0], y = viewpoint->eye[1], z = viewpoint->eye[2],
                  margin_per_warp = viewpoint->margin_per_warp;
    const unsigned shift = viewpoint->shift;
    uint32_t polygon = polygons != NULL ? polygons[i] : i;

    while (polygon != *faces) {
        const int16_t *n = mesh->polygon_normals + 3 * polygon, *p = mesh->positions + 3 * mesh_index(mesh, 3 * i);
        uint32_t away = polygon, warp = mesh->warp[polygon];
        SHEEN_TAP(FACING, 1);
        uint32_t above = (uint32_t)asr32(facing_dot(n, p[0], p[1], p[2]), shift) - (uint32_t)facing_dot(n, x, y, z);
        if ((int32_t)above <= (int32_t)warp * margin_per_warp + ROUNDED || warp == SHEEN_WARP_UNKNOWN) {
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
