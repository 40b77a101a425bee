/*
 * simple_polygon.c - random polygons whose edges do not cross, all in exact integers.
 */
#include "simple_polygon.h"

#include "frame_stage.h"

int64_t polygon_side(const int32_t a[2], const int32_t b[2], const int32_t c[2])
{
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) - (int64_t)(b[1] - a[1]) * (c[0] - a[0]);
}

static int is_between(const int32_t a[2], const int32_t b[2], const int32_t q[2])
{
    return polygon_side(a, b, q) == 0 &&
           (q[0] - a[0]) * (int64_t)(q[0] - b[0]) + (q[1] - a[1]) * (int64_t)(q[1] - b[1]) <= 0;
}

static int sign(int64_t x)
{
    return (x > 0) - (x < 0);
}

/* Whether two edges have a point in common. */
static int meet(const int32_t a[2], const int32_t b[2], const int32_t c[2], const int32_t d[2])
{
    return (sign(polygon_side(a, b, c)) * sign(polygon_side(a, b, d)) < 0 &&
            sign(polygon_side(c, d, a)) * sign(polygon_side(c, d, b)) < 0) ||
           is_between(a, b, c) || is_between(a, b, d) || is_between(c, d, a) || is_between(c, d, b);
}

void polygon_reverse(int32_t (*at)[2], unsigned from, unsigned to)
{
    for (; from < to; from++, to--)
        for (int k = 0; k < 2; k++) {
            int32_t other = at[from][k];
            at[from][k] = at[to][k];
            at[to][k] = other;
        }
}

/* Uncrosses edges that meet until none do; each time the outline gets shorter. */
int polygon_make_simple(int32_t (*at)[2], unsigned count, uint32_t extent, uint32_t *state)
{
    for (unsigned i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            at[i][k] = (int32_t)(stage_random(state) % extent) - (int32_t)(extent / 2);
    for (int tries = 0; tries < 300; tries++) {
        int met = 0;
        for (unsigned i = 0; i < count && !met; i++)
            for (unsigned j = i + 1; j < count && !met; j++) {
                unsigned next = (j + 1) % count;
                if (j == i + 1  ? is_between(at[i], at[j], at[next]) || is_between(at[j], at[next], at[i])
                    : next == i ? is_between(at[i], at[i + 1], at[j]) || is_between(at[j], at[i], at[i + 1])
                                : meet(at[i], at[i + 1], at[j], at[next])) {
                    polygon_reverse(at, i + 1, j);
                    met = 1;
                }
            }
        if (!met)
            return 1;
    }
    return 0;
}
