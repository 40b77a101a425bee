/*
 * host_border.c - whether an eye sees the inside of a mesh that is not closed.
 */
#include "host_border.h"

#include <stdlib.h>

#include "host_vector.h"
#include "unique.h"

#define LOOKS 64   /* triangles that are looked at: 4 million tests against triangles at most, 0.1 s */
#define SEEN 1e-3  /* the least area that counts, some ten pixels of a picture of 320x240 that shows the whole mesh */
#define TOUCH 1e-6 /* what is no farther behind a plane lies in it; the mesh's radius is 1 */

struct edge {
    uint32_t low, high; /* its places */
};

/* edge[t], zero before: 1 + the number of an edge that triangle t has to itself. 0, or SHEEN_ERR_MEMORY. */
static int find_border(const struct sheen_host_mesh *mesh, uint8_t *edge)
{
    const size_t count = 3 * mesh->triangle_count;
    struct edge *edges = calloc(count, sizeof *edges);
    uint32_t *ids = calloc(count, sizeof *ids), *uses = calloc(count, sizeof *uses);
    size_t distinct;
    int error = SHEEN_ERR_MEMORY;

    if (edges && ids && uses) {
        for (size_t e = 0; e < count; e++) {
            const uint32_t *corners = mesh->triangles[e / 3].vertex;
            const uint32_t from = mesh->vertices[corners[e % 3]].weld, to = mesh->vertices[corners[(e + 1) % 3]].weld;
            edges[e] = from < to ? (struct edge){from, to} : (struct edge){to, from};
        }
        error = sheen_unique(edges, sizeof *edges, count, ids, &distinct);
    }
    for (size_t e = 0; !error && e < count; e++)
        uses[ids[e]]++;
    for (size_t e = 0; !error && e < count; e++) {
        if (uses[ids[e]] == 1 && edges[e].low != edges[e].high)
            edge[e / 3] = (uint8_t)(1 + e % 3);
    }
    free(edges);
    free(ids);
    free(uses);
    return error;
}

/* The corners of triangle t as seen from `eye`: above 0, six times a volume, from the front; below, from behind. */
static double look_at(const struct sheen_host_mesh *mesh, size_t t, const double eye[3], double corners[3][3])
{
    double normal[3];

    for (int i = 0; i < 3; i++) {
        const double *at = mesh->vertices[mesh->triangles[t].vertex[i]].position;
        for (int k = 0; k < 3; k++)
            corners[i][k] = at[k] - eye[k];
    }
    cross3(corners[0], corners[1], normal);
    return -dot3(normal, corners[2]);
}

/* 1 if the ray from the eye through `to`, as seen from there, meets this triangle, seen from the front, before. */
static int hides(double corners[3][3], const double to[3])
{
    double side[3], a[3], b[3];

    for (int i = 0; i < 3; i++) {
        cross3(corners[i], corners[(i + 1) % 3], side);
        if (dot3(side, to) > 0)
            return 0;
    }
    for (int k = 0; k < 3; k++) {
        a[k] = corners[1][k] - corners[0][k];
        b[k] = corners[2][k] - corners[0][k];
    }
    cross3(a, b, side);
    unit3(side);
    return dot3(side, to) - dot3(side, corners[0]) < -TOUCH;
}

static int is_hidden(const struct sheen_host_mesh *mesh, const double eye[3], const double to[3])
{
    double corners[3][3];
    int found = 0;

    for (size_t t = 0; !found && t < mesh->triangle_count; t++)
        found = look_at(mesh, t, eye, corners) > 0 && hides(corners, to);
    return found;
}

int sheen_host_border_is_seen(const struct sheen_host_mesh *mesh, const double eye[3])
{
    uint8_t *edge = calloc(mesh->triangle_count, 1);
    double corners[3][3], at[3], seen = 0;
    size_t count = 0, number = 0;
    int error = edge ? find_border(mesh, edge) : SHEEN_ERR_MEMORY;

    for (size_t t = 0; !error && t < mesh->triangle_count; t++) {
        if (edge[t] && look_at(mesh, t, eye, corners) >= 0)
            edge[t] = 0;
        count += edge[t] > 0;
    }
    const size_t step = (count + LOOKS - 1) / LOOKS;
    for (size_t t = 0; !error && seen < SEEN && t < mesh->triangle_count; t++) {
        if (!edge[t] || number++ % step != 0)
            continue;
        const double volume = -look_at(mesh, t, eye, corners);
        for (int k = 0; k < 3; k++)
            at[k] = 0.45 * (corners[edge[t] - 1][k] + corners[edge[t] % 3][k]) + 0.1 * corners[(edge[t] + 1) % 3][k];
        if (!is_hidden(mesh, eye, at)) /* this one stands for as many as are passed over */
            seen += (double)step * volume / 2 / sqrt(dot3(at, at));
    }
    free(edge);
    return error ? error : seen >= SEEN;
}
