/*
 * edges.c - the edges of a mesh: which triangles meet at each edge, and which edges are sharp.
 */
#include "../math/fixed.h"
#include "../math/vector.h"

#define NOWHERE UINT32_MAX

static APART uint32_t edge_corner(const struct sheen_mesh *mesh, uint32_t i)
{
    return mesh->index_bytes == 1 ? ((const uint8_t *)mesh->indices)[i] : ((const uint16_t *)mesh->indices)[i];
}

static int one_place(const int16_t *a, const int16_t *b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static uint32_t bucket_of(const int16_t *at, uint32_t buckets)
{
    uint32_t hash = (uint16_t)at[0] * 0x9e3779b1u + (uint16_t)at[1] * 0x85ebca77u + (uint16_t)at[2] * 0xc2b2ae3du;

    return (hash ^ hash >> 15) % buckets;
}

/*
 * weld[v]: the first vertex at v's place. A hash table finds these first vertices: head[] starts each bucket's list,
 * chain[v] is the vertex after v in the list.
 */
static void weld_vertices(const struct sheen_mesh *mesh, uint32_t *weld, uint32_t *head, uint32_t *chain)
{
    const uint32_t count = mesh->vertices;

    for (uint32_t i = 0; i < count; i++)
        head[i] = NOWHERE;
    for (uint32_t v = 0; v < count; v++) {
        const int16_t *at = mesh->positions + 3 * v;
        uint32_t *first = &head[bucket_of(at, count)], other = *first;
        while (other != NOWHERE && !one_place(mesh->positions + 3 * other, at))
            other = chain[other];
        weld[v] = other == NOWHERE ? v : other;
        chain[v] = *first;
        if (other == NOWHERE)
            *first = v;
    }
}

static uint32_t polygon_of(const struct sheen_mesh *mesh, uint32_t triangle)
{
    return mesh->polygons != NULL ? mesh->polygons[triangle] : triangle;
}

/*
 * 1 if polygons a and b face farther apart than the crease, a cosine in Q1.30. Rounding leaves normals a step or two
 * too short or too long, so |m| |n| counts, or rather (|m|^2 + |n|^2) / 2, which is as good. It turns each by at most
 * sqrt(3) / 2 of a step, and that takes up to 56,757 from the dot product: with this slack, edges at exactly the crease
 * angle are not sharp. Range: |dot| <= 3 * 2^30, squares <= 6 * 2^30.
 */
#define ROUNDING_SLACK 65536

static int is_sharp(const struct sheen_mesh *mesh, uint32_t a, uint32_t b, sheen_q30_t crease)
{
    const int16_t *m = mesh->polygon_normals + 3 * a, *n = mesh->polygon_normals + 3 * b;
    int64_t dot = 0, squares = 0;

    for (int k = 0; k < 3; k++) {
        dot += m[k] * n[k];
        squares += (int64_t)(m[k] * m[k]) + n[k] * n[k];
    }
    return dot < asr64(squares * crease, 31) - ROUNDING_SLACK;
}

/* The ends of half edge h, as welded vertices; a triangle has 3 half edges. */
static void ends_of(const struct sheen_mesh *mesh, const uint32_t *weld, uint32_t h, uint32_t *from, uint32_t *to)
{
    *from = weld[edge_corner(mesh, h)];
    *to = weld[edge_corner(mesh, h % 3 == 2 ? h - 2 : h + 1)];
}

static void join(const struct sheen_mesh *mesh, struct sheen_triangle_edges *edges, uint32_t h, uint32_t other,
                 sheen_q30_t crease)
{
    uint32_t t = h / 3, u = other / 3, p = polygon_of(mesh, t), q = polygon_of(mesh, u);
    unsigned mine = 1u << h % 3, theirs = 1u << other % 3;

    edges[t].across[h % 3] = (uint16_t)u;
    edges[u].across[other % 3] = (uint16_t)t;
    if (p == q) {
        edges[t].inner = (uint8_t)(edges[t].inner | mine);
        edges[u].inner = (uint8_t)(edges[u].inner | theirs);
    }
    if (p == q || !is_sharp(mesh, p, q, crease)) {
        edges[t].sharp = (uint8_t)(edges[t].sharp & ~mine);
        edges[u].sharp = (uint8_t)(edges[u].sharp & ~theirs);
    }
}

/* Joins each half edge to its opposite one. Those whose opposite has not come yet wait in a list per start vertex. */
static void join_edges(const struct sheen_mesh *mesh, sheen_q30_t crease, const uint32_t *weld, uint32_t *head,
                       uint32_t *next, struct sheen_triangle_edges *edges)
{
    for (uint32_t v = 0; v < mesh->vertices; v++)
        head[v] = NOWHERE;
    for (uint32_t t = 0; t < mesh->triangles; t++) {
        const uint32_t a = weld[edge_corner(mesh, 3 * t)], b = weld[edge_corner(mesh, 3 * t + 1)],
                       c = weld[edge_corner(mesh, 3 * t + 2)];
        edges[t] = (struct sheen_triangle_edges){{SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE}, 7, 0};
        for (uint32_t h = 3 * t; h < 3 * t + 3 && a != b && b != c && c != a; h++) {
            uint32_t from, to, start, end;
            ends_of(mesh, weld, h, &from, &to);
            uint32_t *link = &head[to];
            while (*link != NOWHERE && (ends_of(mesh, weld, *link, &start, &end), end != from))
                link = &next[*link];
            if (*link != NOWHERE) {
                join(mesh, edges, h, *link, crease);
                *link = next[*link];
            } else { /* append, so that of several opposite half edges the earliest is joined */
                next[h] = NOWHERE;
                for (link = &head[from]; *link != NOWHERE;)
                    link = &next[*link];
                *link = h;
            }
        }
    }
}

void sheen_mesh_edges(const struct sheen_mesh *mesh, sheen_q30_t crease, uint32_t *scratch,
                      struct sheen_triangle_edges *edges)
{
    uint32_t *weld = scratch, *head = weld + mesh->vertices, *chain = head + mesh->vertices;

    weld_vertices(mesh, weld, head, chain);
    join_edges(mesh, crease, weld, head, chain + mesh->vertices, edges);
}
