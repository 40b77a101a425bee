/*
 * exact_cover.c - coverage by 64-bit edge functions.
 */
#include "exact_cover.h"

static int64_t edge(int64_t ax, int64_t ay, int64_t bx, int64_t by, int64_t x, int64_t y)
{
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
}

int64_t cover_area(const struct cover_triangle *t)
{
    return edge(t->x[0], t->y[0], t->x[1], t->y[1], t->x[2], t->y[2]);
}

bool cover_inside(const struct cover_triangle *t, int32_t px, int32_t py)
{
    int64_t area = cover_area(t);
    int32_t x = 64 * px + 32, y = 64 * py + 32;

    if (area == 0)
        return false;
    for (int k = 0; k < 3; k++) {
        /* Walk clockwise as seen: then e > 0 is inside, left edges lead up, top edges lead right. */
        int a = area > 0 ? k : (k + 1) % 3, b = area > 0 ? (k + 1) % 3 : k;
        int64_t e = edge(t->x[a], t->y[a], t->x[b], t->y[b], x, y);
        bool left = t->y[b] < t->y[a], top = t->y[b] == t->y[a] && t->x[b] > t->x[a];
        if (e < 0 || (e == 0 && !left && !top))
            return false;
    }
    return true;
}
