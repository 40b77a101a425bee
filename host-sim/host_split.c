/*
 * host_split.c - polygons to triangles, in the plane of their Newell normal.
 *
 * A convex polygon (a straight corner counts as convex) becomes the fan
 * (0, k, k + 1). Any other is cut by ears, the first valid one in the polygon's
 * order each time; where there is none, as in a polygon that crosses itself, the
 * first corner is cut.
 */
#include <stdlib.h>

#include "host_build.h"
#include "host_vector.h"

struct flat {
    double x, y;
};

/* A polygon that loses its ears: a ring in the polygon's order. */
struct ring {
    const struct flat *at;
    uint32_t *next, *before;
    uint32_t *blocker; /* of a corner that is no ear: a corner inside it, or itself if it does not turn left */
    unsigned char *gone;
    uint32_t head, count;
    double straight; /* twice an area: what is not more is straight, or rounding */
};

#define UNKNOWN UINT32_MAX /* a blocker: the corner is to be looked at */

/* Rounding, as a part of the squared extent: see NO_AREA. */
#define STRAIGHT 1e-12

/* Twice the signed area of a, b, c: > 0 where they turn left. */
static double turn(struct flat a, struct flat b, struct flat c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Coordinates along u and v with u x v = normal, so that the polygon runs counter-clockwise; its extent squared. */
static double flatten(const double (*points)[3], const uint32_t *corners, uint32_t count, const double normal[3],
                      struct flat *out)
{
    int least = 0;
    double axis[3] = {0, 0, 0}, u[3], v[3], extent = 0;

    for (int k = 1; k < 3; k++) {
        if (fabs(normal[k]) < fabs(normal[least]))
            least = k;
    }
    axis[least] = 1;
    cross3(axis, normal, u);
    unit3(u);
    cross3(normal, u, v);
    for (uint32_t i = 0; i < count; i++) {
        const double *p = points[corners[i]], *o = points[corners[0]];
        double d[3] = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
        out[i] = (struct flat){dot3(d, u), dot3(d, v)};
        extent = fmax(extent, out[i].x * out[i].x + out[i].y * out[i].y);
    }
    return extent;
}

/*
 * Convex: no corner turns right or back, and the edges' direction goes around
 * once (a five-pointed star turns left everywhere, but goes around twice). An
 * edge between two points at one place has no direction and is passed over.
 */
static int is_convex(const struct flat *at, uint32_t count, double straight)
{
    struct flat last = {0, 0}; /* the edge before */
    int rounds = 0;

    for (uint32_t i = 0; i < 2 * count; i++) { /* the first time around finds the last edge */
        struct flat a = at[i % count], b = at[(i + 1) % count], edge = {b.x - a.x, b.y - a.y};
        if (edge.x == 0 && edge.y == 0)
            continue;
        if (i >= count) {
            double across = last.x * edge.y - last.y * edge.x, along = last.x * edge.x + last.y * edge.y;
            if (across < -straight || (across <= straight && along < 0))
                return 0;
            int was_up = last.y > 0 || (last.y == 0 && last.x > 0), is_up = edge.y > 0 || (edge.y == 0 && edge.x > 0);
            rounds += is_up && !was_up;
        }
        last = edge;
    }
    return rounds <= 1;
}

static int same(struct flat a, struct flat b)
{
    return a.x == b.x && a.y == b.y;
}

/* The first corner of the ring in or on the triangle at corner i, itself where that does not turn left, or UNKNOWN. */
static uint32_t find_blocker(const struct ring *ring, uint32_t i)
{
    struct flat a = ring->at[ring->before[i]], b = ring->at[i], c = ring->at[ring->next[i]];

    if (turn(a, b, c) <= ring->straight)
        return i;
    uint32_t j = ring->head;
    do {
        struct flat q = ring->at[j];
        if (turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0 && !same(q, a) && !same(q, b) && !same(q, c))
            return j;
        j = ring->next[j];
    } while (j != ring->head);
    return UNKNOWN;
}

/* The first ear, or the head. A corner is looked at again only when a neighbour or what blocked it is gone. */
static uint32_t find_ear(struct ring *ring)
{
    uint32_t i = ring->head;

    do {
        if (ring->blocker[i] == UNKNOWN || ring->gone[ring->blocker[i]])
            ring->blocker[i] = find_blocker(ring, i);
        if (ring->blocker[i] == UNKNOWN)
            return i;
        i = ring->next[i];
    } while (i != ring->head);
    return ring->head;
}

static void cut_ears(struct ring *ring, uint32_t (*out)[3])
{
    for (; ring->count >= 3; ring->count--, out++) {
        uint32_t ear = ring->count > 3 ? find_ear(ring) : ring->next[ring->head];
        uint32_t before = ring->before[ear], next = ring->next[ear];

        (*out)[0] = before;
        (*out)[1] = ear;
        (*out)[2] = next;
        ring->next[before] = next;
        ring->before[next] = before;
        ring->blocker[before] = ring->blocker[next] = UNKNOWN;
        ring->gone[ear] = 1;
        if (ear == ring->head)
            ring->head = next;
    }
}

static int split_by_ears(const struct flat *at, uint32_t count, double straight, uint32_t (*out)[3])
{
    struct ring ring = {.at = at, .count = count, .straight = straight};
    int error = SHEEN_ERR_MEMORY;

    ring.next = malloc(count * sizeof *ring.next);
    ring.before = malloc(count * sizeof *ring.before);
    ring.blocker = malloc(count * sizeof *ring.blocker);
    ring.gone = calloc(count, 1);
    if (ring.next && ring.before && ring.blocker && ring.gone) {
        for (uint32_t i = 0; i < count; i++) {
            ring.next[i] = i + 1 < count ? i + 1 : 0;
            ring.before[i] = i > 0 ? i - 1 : count - 1;
            ring.blocker[i] = UNKNOWN;
        }
        cut_ears(&ring, out);
        error = SHEEN_OK;
    }
    free(ring.next);
    free(ring.before);
    free(ring.blocker);
    free(ring.gone);
    return error;
}

int sheen_host_split(const double (*points)[3], const uint32_t *corners, uint32_t count, const double normal[3],
                     uint32_t (*out)[3])
{
    struct flat *at = malloc(count * sizeof *at);
    int error = SHEEN_OK;

    if (!at)
        return SHEEN_ERR_MEMORY;
    double straight = STRAIGHT * flatten(points, corners, count, normal, at);
    if (count > 3 && !is_convex(at, count, straight)) {
        error = split_by_ears(at, count, straight, out);
    } else {
        for (uint32_t k = 1; k + 1 < count; k++) {
            out[k - 1][0] = 0;
            out[k - 1][1] = k;
            out[k - 1][2] = k + 1;
        }
    }
    free(at);
    return error;
}
