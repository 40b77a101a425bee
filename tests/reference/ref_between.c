/*
 * ref_between.c - two frames of a mesh to a mesh between them.
 */
#include <stdlib.h>
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

static void *copy(const void *from, size_t count, size_t size)
{
    void *to = from ? malloc(count * size) : NULL;

    return to ? memcpy(to, from, count * size) : NULL;
}

static void mix(double out[3], const double a[3], const double b[3], double k)
{
    for (int i = 0; i < 3; i++)
        out[i] = (1 - k) * a[i] + k * b[i];
}

static void mix_normals(double out[3], const double a[3], const double b[3], double k)
{
    mix(out, a, b, k);
    if (ref_length(out) < 1e-12)
        memcpy(out, a, 3 * sizeof *out);
    ref_normalize(out);
}

int ref_mesh_between(struct ref_mesh *mesh, const struct ref_mesh *first, const struct ref_mesh *second, double k)
{
    const size_t corners = first->corner_count, polygons = first->polygon_count;

    *mesh = (struct ref_mesh){.corner_count = corners,
                              .triangle_count = first->triangle_count,
                              .polygon_count = polygons,
                              .position = copy(first->position, corners, sizeof *mesh->position),
                              .normal = copy(first->normal, corners, sizeof *mesh->normal),
                              .weld = copy(first->weld, corners, sizeof *mesh->weld),
                              .triangles = copy(first->triangles, first->triangle_count, sizeof *mesh->triangles),
                              .polygon_normal = copy(first->polygon_normal, polygons, sizeof *mesh->polygon_normal),
                              .base = copy(first->base, polygons, sizeof *mesh->base),
                              .uv = copy(first->uv, corners, sizeof *mesh->uv),
                              .color = copy(first->color, corners, sizeof *mesh->color),
                              .center = copy(first->center, polygons, sizeof *mesh->center)};
    if (!mesh->position || !mesh->normal || !mesh->weld || !mesh->triangles || !mesh->polygon_normal || !mesh->center ||
        (first->base && !mesh->base) || (first->uv && !mesh->uv) || (first->color && !mesh->color)) {
        ref_mesh_free(mesh);
        return -1;
    }
    for (size_t c = 0; c < corners; c++) {
        mix(mesh->position[c], first->position[c], second->position[c], k);
        mix_normals(mesh->normal[c], first->normal[c], second->normal[c], k);
    }
    for (size_t p = 0; p < polygons; p++) {
        mix_normals(mesh->polygon_normal[p], first->polygon_normal[p], second->polygon_normal[p], k);
        mix(mesh->center[p], first->center[p], second->center[p], k);
    }
    return 0;
}
