/*
 * ref_mesh.c - polygons as a file lists them -> the mesh that is drawn: fitted positions, Newell normals, corner
 * normals, triangles.
 */
#include <stdlib.h>
#include <string.h>

#include "ref_split.h"
#include "ref_vector.h"
#include "reference.h"

/*
 * Two positions are the same point if they are equal as 32-bit floats (-0 equals 0). On an axis on which the bounding
 * box's centre is more than 16 times the box's longest side from 0, distances from the centre are compared instead.
 */
struct weld_key {
    float at[3];
    uint32_t corner;
};

static int weld_order(const void *a, const void *b)
{
    const struct weld_key *p = a, *q = b;

    for (int k = 0; k < 3; k++) {
        if (p->at[k] != q->at[k])
            return p->at[k] < q->at[k] ? -1 : 1;
    }
    return 0;
}

static void weld_origin(const struct ref_mesh *mesh, double origin[3])
{
    double longest = 0;

    for (int k = 0; k < 3; k++) {
        double low = mesh->position[0][k], high = low;
        for (size_t c = 1; c < mesh->corner_count; c++) {
            low = fmin(low, mesh->position[c][k]);
            high = fmax(high, mesh->position[c][k]);
        }
        longest = fmax(longest, high - low);
        origin[k] = (low + high) / 2;
    }
    for (int k = 0; k < 3; k++) {
        if (fabs(origin[k]) <= 16 * longest)
            origin[k] = 0;
    }
}

static int weld(struct ref_mesh *mesh)
{
    double origin[3];

    weld_origin(mesh, origin);
    struct weld_key *keys = malloc(mesh->corner_count * sizeof *keys);
    if (!keys)
        return -1;
    for (size_t c = 0; c < mesh->corner_count; c++) {
        for (int k = 0; k < 3; k++)
            keys[c].at[k] = (float)(mesh->position[c][k] - origin[k]);
        keys[c].corner = (uint32_t)c;
    }
    qsort(keys, mesh->corner_count, sizeof *keys, weld_order);

    uint32_t id = 0;
    for (size_t i = 0; i < mesh->corner_count; i++) {
        if (i > 0 && weld_order(&keys[i - 1], &keys[i]) != 0)
            id++;
        mesh->weld[keys[i].corner] = id;
    }
    free(keys);
    return 0;
}

/* Move the bounding box's centre to 0, then scale the farthest position to distance 1. -1 if there is no extent. */
static int fit(struct ref_mesh *mesh)
{
    double low[3], high[3], far = 0;

    memcpy(low, mesh->position[0], sizeof low);
    memcpy(high, mesh->position[0], sizeof high);
    for (size_t c = 0; c < mesh->corner_count; c++) {
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], mesh->position[c][k]);
            high[k] = fmax(high[k], mesh->position[c][k]);
        }
    }
    for (size_t c = 0; c < mesh->corner_count; c++) {
        for (int k = 0; k < 3; k++)
            mesh->position[c][k] -= (low[k] + high[k]) / 2;
        far = fmax(far, ref_length(mesh->position[c]));
    }
    if (far <= 0)
        return -1;
    for (size_t c = 0; c < mesh->corner_count; c++) {
        for (int k = 0; k < 3; k++)
            mesh->position[c][k] /= far;
    }
    return 0;
}

/*
 * Newell's sum over all edges, with coordinates relative to the first corner, so that a small polygon far from the
 * origin keeps its digits. Zero if |N| is below the rounding of its own terms.
 */
void ref_newell(const double (*position)[3], size_t count, double normal[3])
{
    double largest = 0;

    normal[0] = normal[1] = normal[2] = 0;
    for (size_t i = 0; i < count; i++) {
        const double *a = position[i], *b = position[(i + 1) % count], *o = position[0];

        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            normal[k] += (a[u] - b[u]) * (a[v] + b[v] - 2 * o[v]);
        }
        double edge[3] = {b[0] - o[0], b[1] - o[1], b[2] - o[2]};
        largest = fmax(largest, ref_dot(edge, edge));
    }
    if (ref_length(normal) <= 1e-12 * largest)
        normal[0] = normal[1] = normal[2] = 0;
    ref_normalize(normal);
}

/* A corner of the mesh; sorted by weld, so that all corners at one point are neighbours. */
struct around {
    uint32_t weld, corner, polygon;
    double angle;
};

static int around_order(const void *a, const void *b)
{
    const struct around *p = a, *q = b;

    return p->weld != q->weld ? (p->weld < q->weld ? -1 : 1) : p->corner < q->corner ? -1 : p->corner > q->corner;
}

/* The interior angle at corner c of the polygon with the corners first..end-1; 0 if an edge at c has no length. */
static double interior_angle(const struct ref_mesh *mesh, const double normal[3], uint32_t first, uint32_t c,
                             uint32_t end)
{
    const double *here = mesh->position[c];
    const double *before = mesh->position[c > first ? c - 1 : end - 1];
    const double *after = mesh->position[c + 1 < end ? c + 1 : first];
    double u[3], v[3], cross[3];

    for (int k = 0; k < 3; k++) {
        u[k] = after[k] - here[k];
        v[k] = before[k] - here[k];
    }
    ref_cross(u, v, cross); /* along the normal if the corner turns left */
    double angle = atan2(ref_length(cross), ref_dot(u, v));
    return ref_dot(cross, normal) < -1e-12 * ref_length(u) * ref_length(v) ? 2 * acos(-1) - angle : angle;
}

static void average(struct ref_mesh *mesh, const struct around *group, size_t count,
                    const struct ref_mesh_options *options)
{
    double crease = options->crease;

    for (size_t i = 0; i < count; i++) {
        const double *own = mesh->polygon_normal[group[i].polygon];
        double *sum = mesh->normal[group[i].corner];

        if (ref_length(sum) > 0)
            continue; /* the file's own normal */
        for (size_t j = 0; j < count; j++) {
            const double *other = mesh->polygon_normal[group[j].polygon];
            if (crease >= 0 && ref_dot(own, other) < cos(crease * acos(-1) / 180) - 1e-12)
                continue;
            for (int k = 0; k < 3; k++)
                sum[k] += other[k] * (options->equal_weights ? 1 : group[j].angle);
        }
        if (ref_length(sum) < 1e-9) /* opposite unit normals cancel except for rounding */
            memcpy(sum, own, 3 * sizeof *sum);
        ref_normalize(sum);
    }
}

static int corner_normals(struct ref_mesh *mesh, const struct ref_polygons *from,
                          const struct ref_mesh_options *options)
{
    struct around *all = malloc(mesh->corner_count * sizeof *all);
    if (!all)
        return -1;
    for (size_t p = 0; p < from->polygon_count; p++) {
        for (uint32_t c = from->first[p]; c < from->first[p + 1]; c++) {
            double angle = interior_angle(mesh, mesh->polygon_normal[p], from->first[p], c, from->first[p + 1]);
            all[c] = (struct around){mesh->weld[c], c, (uint32_t)p, angle};
            if (from->normals && !options->average_normals)
                memcpy(mesh->normal[c], from->normals[c], sizeof mesh->normal[c]);
            ref_normalize(mesh->normal[c]);
        }
    }
    qsort(all, mesh->corner_count, sizeof *all, around_order);
    for (size_t i = 0, j; i < mesh->corner_count; i = j) {
        for (j = i + 1; j < mesh->corner_count && all[j].weld == all[i].weld; j++)
            ;
        average(mesh, all + i, j - i, options);
    }
    free(all);
    return 0;
}

static int split_all(struct ref_mesh *mesh, const struct ref_polygons *from)
{
    mesh->triangles = malloc(mesh->corner_count * sizeof *mesh->triangles); /* a polygon has at most its corners - 2 */
    if (!mesh->triangles)
        return -1;
    for (size_t p = 0; p < from->polygon_count; p++) {
        uint32_t first = from->first[p], count = from->first[p + 1] - first;
        uint32_t(*cut)[3] = malloc(count * sizeof *cut);
        if (!cut)
            return -1;
        size_t made = 0;
        if (count >= 3 && ref_length(mesh->polygon_normal[p]) > 0)
            made = ref_split((const double(*)[3])mesh->position + first, count, mesh->polygon_normal[p], cut);
        for (size_t t = 0; t < made; t++) {
            struct ref_triangle *out = &mesh->triangles[mesh->triangle_count++];
            for (int k = 0; k < 3; k++)
                out->corner[k] = first + cut[t][k];
            out->polygon = (uint32_t)p;
        }
        free(cut);
    }
    return 0;
}

static int build(struct ref_mesh *mesh, const struct ref_polygons *from, const struct ref_mesh_options *options)
{
    for (size_t c = 0; c < mesh->corner_count; c++)
        memcpy(mesh->position[c], from->points[from->corners[c]], sizeof mesh->position[c]);
    if (weld(mesh) != 0 || (options->fit && fit(mesh) != 0))
        return -1;
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        uint32_t first = from->first[p];
        uint32_t count = from->first[p + 1] - first;
        ref_newell((const double(*)[3])mesh->position + first, count, mesh->polygon_normal[p]);
        for (uint32_t i = 0; i < 3 * count; i++)
            mesh->center[p][i % 3] += mesh->position[first + i / 3][i % 3] / count;
    }
    if (corner_normals(mesh, from, options) != 0 || split_all(mesh, from) != 0)
        return -1;
    if (from->uv)
        memcpy(mesh->uv, from->uv, mesh->corner_count * sizeof *mesh->uv);
    if (from->color)
        memcpy(mesh->color, from->color, mesh->corner_count * sizeof *mesh->color);
    if (from->base)
        memcpy(mesh->base, from->base, mesh->polygon_count * sizeof *mesh->base);
    return mesh->triangle_count > 0 ? 0 : -1;
}

int ref_mesh_build(struct ref_mesh *mesh, const struct ref_polygons *from, const struct ref_mesh_options *options)
{
    memset(mesh, 0, sizeof *mesh);
    mesh->polygon_count = from->polygon_count;
    mesh->corner_count = from->polygon_count ? from->first[from->polygon_count] : 0;
    if (mesh->corner_count == 0)
        return -1;
    mesh->position = calloc(mesh->corner_count, sizeof *mesh->position);
    mesh->normal = calloc(mesh->corner_count, sizeof *mesh->normal);
    mesh->weld = calloc(mesh->corner_count, sizeof *mesh->weld);
    mesh->polygon_normal = calloc(mesh->polygon_count, sizeof *mesh->polygon_normal);
    mesh->uv = from->uv ? calloc(mesh->corner_count, sizeof *mesh->uv) : NULL;
    mesh->base = from->base ? calloc(mesh->polygon_count, sizeof *mesh->base) : NULL;
    mesh->color = from->color ? calloc(mesh->corner_count, sizeof *mesh->color) : NULL;
    mesh->center = calloc(mesh->polygon_count, sizeof *mesh->center);
    bool allocated = mesh->position && mesh->normal && mesh->weld && mesh->polygon_normal && mesh->center;
    if (!allocated || (from->base && !mesh->base) || (from->uv && !mesh->uv) || (from->color && !mesh->color) ||
        build(mesh, from, options) != 0) {
        ref_mesh_free(mesh);
        return -1;
    }
    return 0;
}

void ref_mesh_free(struct ref_mesh *mesh)
{
    free(mesh->position);
    free(mesh->normal);
    free(mesh->weld);
    free(mesh->triangles);
    free(mesh->polygon_normal);
    free(mesh->base);
    free(mesh->uv);
    free(mesh->color);
    free(mesh->center);
    memset(mesh, 0, sizeof *mesh);
}
