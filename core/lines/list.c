/*
 * list.c - which edges of a mesh are drawn, and where on the screen they run.
 */
#include "../triangle/morph.h"
#include "lines.h"

static inline int in_front(const struct line_list *l, uint32_t triangle)
{
    return (l->front[triangle >> 5] >> (triangle & 31u) & 1u) != 0;
}

/* A corner of the draw's mesh in eye space. */
static APART struct point corner_point(const struct line_list *l, uint32_t index)
{
    int16_t store[3];

    return sheen_transform_point(l->transform, position_of(l->draw, l->mesh->positions + 3 * index, store));
}

/* An end of an edge: the corner in eye space, and its vertex. */
static void end_of_edge(const struct line_list *l, uint32_t index, struct clip_corner *end)
{
    end->point = corner_point(l, index);
    end->v = l->vertex[l->place[index]];
    for (int k = 0; k < 3; k++)
        end->share[k] = 0;
}

/* Clip an edge to the view volume; new ends are stored as vertices. 0 if nothing is left, or no room for the ends. */
static int cut_line(struct line_list *l, const uint32_t index[2], uint16_t place[2])
{
    struct clip_corner end[2];
    const struct clip_job job = {l->projection, l->transform, 0, NULL, NULL, 2};

    for (int k = 0; k < 2; k++)
        end_of_edge(l, index[k], &end[k]);
    if (!sheen_clip_line(&job, end))
        return 0;
    for (int k = 0; k < 2; k++) {
        place[k] = l->place[index[k]];
        if ((l->vertex[place[k]].flags & OUTSIDE) == 0)
            continue;
        place[k] = (uint16_t)l->used++;
        if (l->used <= l->max_used)
            l->vertex[place[k]] = end[k].v;
    }
    return l->used <= l->max_used;
}

static inline int32_t pixel_of(int32_t coordinate)
{
    return asr32(coordinate, SUBPIXEL_BITS);
}

/* Store a line if it reaches into the viewport; lines that find no room are counted too. */
static void add_line(struct line_list *l, const uint16_t place[2], unsigned contour)
{
    const struct vertex *a = &l->vertex[place[0]], *b = &l->vertex[place[1]];
    const struct screen *screen = l->screen;
    int32_t x0 = pixel_of(min32(a->x, b->x) + screen->centre_x), x1 = pixel_of(max32(a->x, b->x) + screen->centre_x);
    int32_t y0 = pixel_of(min32(a->y, b->y) + screen->centre_y), y1 = pixel_of(max32(a->y, b->y) + screen->centre_y);

    if (x0 >= screen->viewport.x1 || x1 < screen->viewport.x0 || y0 >= screen->viewport.y1 || y1 < screen->viewport.y0)
        return;
    if (l->lines++ >= l->max_lines)
        return;
    SHEEN_TAP(EDGE, 1);
    l->line[l->lines - 1] = (struct line){place[0], place[1], (int16_t)max32(y0, screen->viewport.y0),
                                          (uint16_t)((uint32_t)min32(y1 + 1, screen->viewport.y1) | contour)};
}

/* List edge k of a triangle; if that is seen from behind, the edge runs the other way. */
static void list_edge(struct line_list *l, uint32_t triangle, uint32_t k, int back, unsigned contour)
{
    uint32_t next = k == 2 ? 0 : k + 1;
    const uint32_t index[2] = {mesh_index(l->mesh, 3 * triangle + (back ? next : k)),
                               mesh_index(l->mesh, 3 * triangle + (back ? k : next))};
    uint16_t place[2] = {l->place[index[0]], l->place[index[1]]};
    unsigned flags = l->vertex[place[0]].flags | l->vertex[place[1]].flags;

    if ((flags & OUTSIDE) == 0 || cut_line(l, index, place))
        add_line(l, place, contour);
}

/* List the edges of a visible triangle; an edge between two visible ones is listed by the one of lower number. */
static void triangle_edges(struct line_list *l, const struct line_kind *which, uint32_t t, int back)
{
    const struct sheen_triangle_edges *e = &l->mesh->edges[t];
    unsigned lines = which->all ? ~(unsigned)e->inner : which->sharp ? e->sharp : 0;

    for (uint32_t k = 0; k < 3; k++) {
        uint32_t other = e->across[k];
        int faces = other != SHEEN_NO_TRIANGLE && in_front(l, other);
        if (other == SHEEN_NO_TRIANGLE || (!faces && !back))
            list_edge(l, t, k, back, LINE_CONTOUR);
        else if (faces != back && other > t && (lines >> k & 1u) != 0)
            list_edge(l, t, k, back, 0);
    }
}

/*
 * Whether a triangle with a corner outside the view volume faces the eye: whether the eye is on the front side of its
 * plane. Its normal is cut to 30 bits; a triangle that this takes to the wrong side is so nearly edge-on that no line
 * shows it.
 */
static APART int outside_in_front(const struct line_list *l, uint32_t first)
{
    struct point at[3];
    int64_t n[3], most;

    for (int k = 0; k < 3; k++)
        at[k] = corner_point(l, mesh_index(l->mesh, first + (uint32_t)k));
    const int64_t a[3] = {asr32(at[1].x, 1) - asr32(at[0].x, 1), asr32(at[1].y, 1) - asr32(at[0].y, 1),
                          asr32(at[1].m, 1) - asr32(at[0].m, 1)};
    const int64_t b[3] = {asr32(at[2].x, 1) - asr32(at[0].x, 1), asr32(at[2].y, 1) - asr32(at[0].y, 1),
                          asr32(at[2].m, 1) - asr32(at[0].m, 1)};
    for (int k = 0; k < 3; k++)
        n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    if (l->projection->orthographic != 0)
        return n[2] >= 0;
    do {
        most = 0;
        for (int k = 0; k < 3; k++)
            most |= n[k] < 0 ? -n[k] : n[k];
        for (int k = 0; k < 3 && most >> 30 != 0; k++)
            n[k] = asr64(n[k], 1);
    } while (most >> 30 != 0);
    return n[0] * at[0].x + n[1] * at[0].y + n[2] * at[0].m >= 0;
}

/* Whether a triangle is seen from the front or edge-on; corners of polygons that were passed over may lack vertices. */
static int faces_eye(const struct line_list *l, uint32_t triangle)
{
    const uint32_t first = 3 * triangle;
    const uint32_t place[3] = {l->place[mesh_index(l->mesh, first)], l->place[mesh_index(l->mesh, first + 1)],
                               l->place[mesh_index(l->mesh, first + 2)]};

    if (place[0] >= l->max_used || place[1] >= l->max_used || place[2] >= l->max_used)
        return 0;
    const struct vertex *a = &l->vertex[place[0]], *b = &l->vertex[place[1]], *c = &l->vertex[place[2]];
    unsigned any = a->flags | b->flags | c->flags;
    if ((any & OUTSIDE) != 0)
        return outside_in_front(l, first);
    return (any & OFF_VIEW) == 0 ? small_twice_area(a, b, c) <= 0 : sheen_twice_area(a, b, c) <= 0;
}

void sheen_list_edges(struct line_list *l, const struct line_kind *which)
{
    const uint32_t end = l->mesh->triangles;

    SHEEN_TAP(EDGE_TRIANGLE, end);
    for (uint32_t t = 0; t < end; t++)
        if (faces_eye(l, t))
            l->front[t >> 5] |= 1u << (t & 31u);
    for (uint32_t word = 0; 32 * word < end; word++) {
        uint32_t bits = l->front[word];
        for (uint32_t t = 32 * word; bits != 0; bits >>= 1, t++)
            if ((bits & 1u) != 0)
                triangle_edges(l, which, t, 0);
    }
    for (uint32_t t = 0; l->two_sided && t < end; t++)
        if (!in_front(l, t))
            triangle_edges(l, which, t, 1);
}
