/*
 * corner_angles.c - interior angles of polygons: weights for vertex normals (run at load or when a mesh moves).
 */
#include "../math/angle.h"
#include "../math/fixed.h"
#include "../math/newton.h"
#include "../sheen.h"
#include "normals.h"

#define HALF_TURN 0x80000000u
#define QUARTER_TURN 0x40000000u

static uint64_t magnitude64(int64_t x)
{
    return x < 0 ? 0u - (uint64_t)x : (uint64_t)x;
}

/*
 * sqrt(x), computed as x / sqrt(x); the error is at most 2^-28 relative plus 1.
 * With `up` even and f = x * 2^up / 2^64 in [1/4, 1), sqrt(x) is f / sqrt(f) * 2^(32 - up/2); the product in the
 * return statement is sqrt(f) * 2^63.
 */
static uint32_t square_root(uint64_t x)
{
    if (x == 0)
        return 0;
    unsigned up = clz64(x) & ~1u;
    uint32_t f = (uint32_t)((x << up) >> 32);

    return (uint32_t)(((uint64_t)f * sheen_reciprocal_root(f)) >> (31 + up / 2));
}

/*
 * The angle between u and v, 0 .. half a turn, from |u x v| = |u||v| sin and u.v = |u||v| cos. 0 if u or v has no
 * length. The error in raw steps is at most 16 + 2 from the arc sine, whose result is at most an eighth of a turn,
 * plus 4 from the arc sine's argument, which is good to 6e-9.
 * Range: parts of u and v are at most 2^29, so parts of the cross product and the dot product are at most 3 * 2^58.
 * All four are scaled together until the largest lies in [2^29, 2^30); then the sum of their squares, |u|^2 |v|^2, is
 * below 2^62 and the cross product's length below 2^31.
 */
static APART sheen_angle_t angle_between(const int32_t u[3], const int32_t v[3])
{
    uint64_t part[4], all = 0, square;
    int64_t dot = 0;

    for (int k = 0; k < 3; k++) {
        int m = k == 2 ? 0 : k + 1, n = k == 0 ? 2 : k - 1;
        part[k] = magnitude64((int64_t)u[m] * v[n] - (int64_t)u[n] * v[m]);
        dot += (int64_t)u[k] * v[k];
    }
    part[3] = magnitude64(dot);
    for (int k = 0; k < 4; k++)
        all |= part[k];
    if (all == 0)
        return 0;
    unsigned zeros = clz64(all); /* 4 or more */
    for (int k = 0; k < 4; k++)
        part[k] = zeros > 34 ? part[k] << (zeros - 34) : part[k] >> (34 - zeros);
    square = part[0] * part[0] + part[1] * part[1] + part[2] * part[2];
    uint32_t across = square_root(square);
    square += part[3] * part[3]; /* in [2^58, 2^62) */

    /* root: of x = square * 2^up / 2^64, up 2 or 4; part / sqrt(square) = part * root / 2^(63 - up/2), here Q1.30. */
    unsigned up = clz64(square) & ~1u;
    uint64_t root = sheen_reciprocal_root((uint32_t)((square << up) >> 32)); /* UQ1.31 */
    uint32_t sine = (uint32_t)((across * root) >> (33 - up / 2));
    uint32_t cosine = (uint32_t)((part[3] * root) >> (33 - up / 2));
    sheen_angle_t angle =
        sine < cosine ? sheen_arc_sine((int32_t)sine) : QUARTER_TURN - sheen_arc_sine((int32_t)cosine);

    return dot < 0 ? HALF_TURN - angle : angle;
}

void sheen_corner_angles(const struct sheen_polygon_list *list, const sheen_q30_t *polygon_normals,
                         sheen_angle_t *angles)
{
    const uint32_t *corners = list->corners;

    for (uint32_t p = 0; p < list->polygon_count; p++, polygon_normals += 3) {
        uint32_t count = list->sizes[p];
        for (uint32_t i = 0; i < count; i++) {
            const int32_t *here = list->points + 3 * (size_t)corners[i];
            int32_t in[3], out[3], back[3];
            sheen_subtract(here, list->points + 3 * (size_t)corners[i > 0 ? i - 1 : count - 1], in);
            sheen_subtract(list->points + 3 * (size_t)corners[i + 1 < count ? i + 1 : 0], here, out);
            for (int k = 0; k < 3; k++)
                back[k] = -in[k];
            sheen_angle_t angle = angle_between(back, out);
            *angles++ = sheen_turn(in, out, polygon_normals) < 0 ? 0u - angle : angle; /* right turn: > half */
        }
        corners += count;
    }
}
