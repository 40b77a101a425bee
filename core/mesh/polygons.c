/*
 * polygons.c - cuts polygons into triangles, seen along their Newell normal (run at load, not while drawing).
 *
 * Every test is the sign of an exact number, so a fan is a fan on every machine and an
 * ear never depends on rounding. Only the direction of view, the unit normal, is rounded
 * (4 raw steps per part): a plane polygon's straight corners stay straight.
 */
#include "../math/fixed.h"
#include "../sheen.h"
#include "normals.h"

/* A polygon while its ears are clipped: a ring in the corners' order. */
struct ring {
    const int32_t *points;
    const uint32_t *corners;
    const sheen_q30_t *normal;
    uint32_t *next, *before; /* next[i] == i: corner i is cut off */
    uint32_t *blocker;       /* per corner: see find_blocker */
    uint32_t head, count;
};

#define NO_BLOCKER UINT32_MAX /* there is none, or none is searched for yet */

static APART const int32_t *point(const struct ring *ring, uint32_t i)
{
    return ring->points + 3 * (size_t)ring->corners[i];
}

/* An edge projected along the normal onto the plane of two axes: exact, times the normal's largest part. */
struct seen {
    int64_t x, y; /* at most 2^60 */
};

static struct seen see(const int32_t edge[3], const sheen_q30_t normal[3])
{
    int m = magnitude32(normal[0]) >= magnitude32(normal[1]) ? 0 : 1;
    m = magnitude32(normal[2]) > magnitude32(normal[m]) ? 2 : m;
    int x = m == 2 ? 0 : m + 1, y = m == 0 ? 2 : m - 1;

    return (struct seen){(int64_t)edge[x] * normal[m] - (int64_t)edge[m] * normal[x],
                         (int64_t)edge[y] * normal[m] - (int64_t)edge[m] * normal[y]};
}

/* 1 for half of all directions: those with y > 0, and +x. */
static APART int is_up(struct seen e)
{
    return e.y > 0 || (e.y == 0 && e.x > 0);
}

/*
 * Convex: no corner turns right, and the edges' direction goes around once (a five-pointed star turns left
 * everywhere, but goes around twice). A corner that turns straight back counts as half a round: the other half round
 * can close the polygon only by turning right, or without area. An edge between two points that are seen at one
 * place has no direction and is skipped.
 */
static int is_convex(const struct ring *ring)
{
    int32_t last[3] = {0, 0, 0}; /* the previous edge */
    int was_up = 0, rounds = 0;

    for (uint32_t i = 0; i < 2 * ring->count; i++) { /* the first round only finds the last edge */
        uint32_t a = i < ring->count ? i : i - ring->count, b = a + 1 < ring->count ? a + 1 : 0;
        int32_t edge[3];
        sheen_subtract(point(ring, b), point(ring, a), edge);
        struct seen seen = see(edge, ring->normal);
        if (seen.x == 0 && seen.y == 0)
            continue;
        if (i >= ring->count) {
            if (sheen_turn(last, edge, ring->normal) < 0)
                return 0;
            rounds += is_up(seen) && !was_up;
        }
        was_up = is_up(seen);
        for (int k = 0; k < 3; k++)
            last[k] = edge[k];
    }
    return rounds <= 1;
}

/* 1 if point q lies in or on the triangle, but not at one of its corners. */
static int is_inside(const int32_t *const triangle[3], const int32_t *q, const sheen_q30_t normal[3])
{
    for (int k = 0; k < 3; k++) {
        int32_t edge[3], to[3];
        sheen_subtract(q, triangle[k], to);
        if (to[0] == 0 && to[1] == 0 && to[2] == 0)
            return 0;
        sheen_subtract(triangle[k == 2 ? 0 : k + 1], triangle[k], edge);
        if (sheen_turn(edge, to, normal) < 0)
            return 0;
    }
    return 1;
}

/*
 * What keeps corner i from being an ear: the corner itself if it does not turn left, else the first corner of the ring
 * in or on its triangle; NO_BLOCKER if it is an ear.
 */
static uint32_t find_blocker(const struct ring *ring, uint32_t i)
{
    /* The side of the cut is tested first, because most corners lie beyond it and are ruled out at once. */
    const int32_t *const triangle[3] = {point(ring, ring->next[i]), point(ring, ring->before[i]), point(ring, i)};
    int32_t in[3], out[3];

    sheen_subtract(triangle[2], triangle[1], in);
    sheen_subtract(triangle[0], triangle[2], out);
    if (sheen_turn(in, out, ring->normal) <= 0)
        return i;
    uint32_t j = ring->head;
    do {
        if (is_inside(triangle, point(ring, j), ring->normal))
            return j;
        j = ring->next[j];
    } while (j != ring->head);
    return NO_BLOCKER;
}

/* The first ear, or the head. A corner is tested again only after a neighbour or its blocker was cut off. */
static uint32_t find_ear(struct ring *ring)
{
    uint32_t i = ring->head;

    do {
        uint32_t blocker = ring->blocker[i];
        if (blocker == NO_BLOCKER || ring->next[blocker] == blocker)
            ring->blocker[i] = blocker = find_blocker(ring, i);
        if (blocker == NO_BLOCKER)
            return i;
        i = ring->next[i];
    } while (i != ring->head);
    return ring->head;
}

/* Ear clipping: every iteration cuts one corner off, so the loop ends. */
static void cut_ears(struct ring *ring, uint32_t *triangles)
{
    for (uint32_t i = 0; i < ring->count; i++) {
        ring->next[i] = i + 1 < ring->count ? i + 1 : 0;
        ring->before[i] = i > 0 ? i - 1 : ring->count - 1;
        ring->blocker[i] = NO_BLOCKER;
    }
    for (; ring->count >= 3; ring->count--) {
        uint32_t ear = ring->count > 3 ? find_ear(ring) : ring->next[ring->head];
        uint32_t before = ring->before[ear], next = ring->next[ear];

        *triangles++ = before;
        *triangles++ = ear;
        *triangles++ = next;
        ring->next[before] = next;
        ring->before[next] = before;
        ring->blocker[before] = ring->blocker[next] = NO_BLOCKER;
        ring->next[ear] = ear;
        if (ear == ring->head)
            ring->head = next;
    }
}

int sheen_triangulate(const int32_t *points, const uint32_t *corners, unsigned count, const sheen_q30_t normal[3],
                      uint32_t *scratch, uint32_t *triangles)
{
    struct ring ring = {points, corners, normal, scratch, scratch + count, scratch + 2 * (size_t)count, 0, count};

    if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
        return SHEEN_ERR_DEGENERATE;
    if (count > 3 && !is_convex(&ring)) {
        cut_ears(&ring, triangles);
        return SHEEN_OK;
    }
    for (uint32_t k = 1; k + 1 < count; k++) {
        *triangles++ = 0;
        *triangles++ = k;
        *triangles++ = k + 1;
    }
    return SHEEN_OK;
}
