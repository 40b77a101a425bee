/*
 * ref_split.c - splits a polygon in the plane of its Newell normal: into a fan if it is convex, otherwise by cutting
 * ears, each time the first valid one in vertex order.
 */
#include <stdbool.h>
#include <stdlib.h>

#include "ref_split.h"
#include "ref_vector.h"

struct point2 {
    double x, y;
};

/* Twice the signed area of a, b, c: > 0 if they turn left. */
static double turn(struct point2 a, struct point2 b, struct point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Coordinates in the plane: u, v with u x v = normal, so that the polygon runs counter-clockwise. */
static void flatten(const double (*position)[3], size_t count, const double normal[3], struct point2 *plane)
{
    int least = 0;

    for (int k = 1; k < 3; k++) {
        if (fabs(normal[k]) < fabs(normal[least]))
            least = k;
    }
    double axis[3] = {least == 0, least == 1, least == 2}, u[3], v[3];
    ref_cross(axis, normal, u);
    ref_normalize(u);
    ref_cross(normal, u, v);
    for (size_t i = 0; i < count; i++) {
        double d[3] = {position[i][0] - position[0][0], position[i][1] - position[0][1],
                       position[i][2] - position[0][2]};
        plane[i] = (struct point2){ref_dot(d, u), ref_dot(d, v)};
    }
}

/* No corner turns right, and all turns add up to one revolution: a five-pointed star turns left only, but twice. */
static bool is_convex(const struct point2 *p, size_t count, double straight)
{
    double angle = 0;

    for (size_t i = 0; i < count; i++) {
        struct point2 a = p[(i + count - 1) % count], b = p[i], c = p[(i + 1) % count];
        double across = turn(a, b, c), along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);

        if (across < -straight)
            return false;
        angle += fabs(across) <= straight && along >= 0 ? 0 : atan2(across, along);
    }
    return angle < 3 * acos(-1); /* 2 pi, not 4 pi */
}

/* An ear: its corner turns left, and no other corner lies in the triangle or on its boundary. */
static bool is_ear(const struct point2 *p, const uint32_t *left, size_t count, size_t i, double straight)
{
    struct point2 a = p[left[(i + count - 1) % count]], b = p[left[i]], c = p[left[(i + 1) % count]];

    if (turn(a, b, c) <= straight)
        return false;
    for (size_t j = 0; j < count; j++) {
        struct point2 q = p[left[j]];
        bool own = (q.x == a.x && q.y == a.y) || (q.x == b.x && q.y == b.y) || (q.x == c.x && q.y == c.y);

        if (!own && turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0)
            return false;
    }
    return true;
}

static size_t cut_ears(const struct point2 *p, size_t count, double straight, uint32_t *left, uint32_t (*out)[3])
{
    size_t made = 0;

    for (size_t i = 0; i < count; i++)
        left[i] = (uint32_t)i;
    while (count > 3) {
        size_t ear = 0;
        while (ear < count && !is_ear(p, left, count, ear, straight))
            ear++;
        if (ear == count)
            ear = 0; /* no ear, as in a polygon that crosses itself: cut the first corner */
        out[made][0] = left[(ear + count - 1) % count];
        out[made][1] = left[ear];
        out[made++][2] = left[(ear + 1) % count];
        for (size_t i = ear; i + 1 < count; i++)
            left[i] = left[i + 1];
        count--;
    }
    for (int k = 0; k < 3; k++)
        out[made][k] = left[k];
    return made + 1;
}

size_t ref_split(const double (*position)[3], size_t count, const double normal[3], uint32_t (*out)[3])
{
    struct point2 *plane = malloc(count * sizeof *plane);
    uint32_t *left = malloc(count * sizeof *left);
    size_t made = 0;

    if (plane && left) {
        double reach = 0;
        flatten(position, count, normal, plane);
        for (size_t i = 0; i < count; i++)
            reach = fmax(reach, hypot(plane[i].x, plane[i].y));
        double straight = 1e-12 * reach * reach; /* below this a turn is rounding */
        if (is_convex(plane, count, straight)) {
            for (uint32_t k = 1; k + 1 < count; k++) {
                out[made][0] = 0;
                out[made][1] = k;
                out[made++][2] = k + 1;
            }
        } else {
            made = cut_ears(plane, count, straight, left, out);
        }
    }
    free(plane);
    free(left);
    return made;
}
