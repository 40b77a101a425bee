/*
 * quantise.c - a host mesh in the core's integers.
 */
#include "quantise.h"

#include <stdlib.h>
#include <string.h>

#include "host_vector.h"

#define ONE 32767.0

/* q / |q| against unit: the squared sine of the angle between them times |q|^2, over |q|^2. */
static double off_direction(const double q[3], const double unit[3])
{
    double cross[3];

    cross3(q, unit, cross);
    return dot3(cross, cross) / dot3(q, q);
}

/* Rounding each part would leave 1.2e-5 rad in the mean, the best of the eight around leaves 0.8e-5. */
void sheen_quantise_unit(const double unit[3], int16_t out[3])
{
    double best = HUGE_VAL;

    for (int corner = 0; corner < 8; corner++) {
        double q[3];
        for (int k = 0; k < 3; k++)
            q[k] = fmin(floor(unit[k] * ONE) + (corner >> k & 1), ONE);
        double off = off_direction(q, unit);
        if (off < best) {
            best = off;
            for (int k = 0; k < 3; k++)
                out[k] = (int16_t)q[k];
        }
    }
}

/* What of the host mesh goes into this one: the new number of each vertex and polygon, or NONE. */
#define NONE UINT32_MAX
struct chosen {
    uint32_t *vertex, *polygon;
    uint32_t vertices, polygons, triangles;
};

static int choose(struct chosen *chosen, const struct sheen_host_mesh *host, uint32_t group)
{
    chosen->vertex = malloc(host->vertex_count * sizeof *chosen->vertex);
    chosen->polygon = malloc(host->polygon_count * sizeof *chosen->polygon);
    if (!chosen->vertex || !chosen->polygon)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 0; i < host->vertex_count; i++)
        chosen->vertex[i] = NONE;
    for (size_t p = 0; p < host->polygon_count; p++) {
        const struct sheen_host_polygon *polygon = &host->polygons[p];
        chosen->polygon[p] = NONE;
        if (group != SHEEN_ALL_GROUPS && polygon->group != group)
            continue;
        chosen->polygon[p] = chosen->polygons++;
        chosen->triangles += polygon->count - 2;
        for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++) {
            if (chosen->vertex[host->corners[c]] == NONE)
                chosen->vertex[host->corners[c]] = chosen->vertices++;
        }
    }
    return chosen->polygons ? SHEEN_OK : SHEEN_ERR_ARGUMENT;
}

static int allocate(struct sheen_quantised *out, const struct chosen *chosen)
{
    out->polygon_count = chosen->polygons;
    out->mesh.vertices = (uint16_t)chosen->vertices;
    out->mesh.triangles = (uint16_t)chosen->triangles;
    out->mesh.index_bytes = chosen->vertices <= 256 ? 1 : 2;
    out->positions = calloc(chosen->vertices, 3 * sizeof *out->positions);
    out->normals = calloc(chosen->vertices, 3 * sizeof *out->normals);
    out->polygon_normals = calloc(chosen->polygons, 3 * sizeof *out->polygon_normals);
    out->warp = calloc(chosen->polygons, sizeof *out->warp);
    out->indices = calloc(chosen->triangles, 3 * (size_t)out->mesh.index_bytes);
    if (chosen->polygons < chosen->triangles)
        out->polygons = calloc(chosen->triangles, sizeof *out->polygons);
    if (!out->positions || !out->normals || !out->polygon_normals || !out->warp || !out->indices ||
        (chosen->polygons < chosen->triangles && !out->polygons))
        return SHEEN_ERR_MEMORY;
    return SHEEN_OK;
}

static void fill_vertices(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen)
{
    for (size_t i = 0; i < host->vertex_count; i++) {
        if (chosen->vertex[i] == NONE)
            continue;
        size_t at = 3 * (size_t)chosen->vertex[i];
        for (int k = 0; k < 3; k++)
            out->positions[at + k] = (int16_t)floor(host->vertices[i].position[k] * ONE + 0.5);
        sheen_quantise_unit(host->vertices[i].normal, out->normals + at);
    }
    for (size_t p = 0; p < host->polygon_count; p++) {
        if (chosen->polygon[p] != NONE)
            sheen_quantise_unit(host->polygons[p].normal, out->polygon_normals + 3 * (size_t)chosen->polygon[p]);
    }
}

static void fill_triangles(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen)
{
    size_t made = 0;

    for (size_t t = 0; t < host->triangle_count; t++) {
        const struct sheen_host_triangle *triangle = &host->triangles[t];
        uint32_t polygon = chosen->polygon[triangle->polygon];
        if (polygon == NONE)
            continue;
        for (int k = 0; k < 3; k++) {
            uint32_t vertex = chosen->vertex[triangle->vertex[k]];
            if (out->mesh.index_bytes == 1)
                ((uint8_t *)out->indices)[3 * made + k] = (uint8_t)vertex;
            else
                ((uint16_t *)out->indices)[3 * made + k] = (uint16_t)vertex;
        }
        if (out->polygons)
            out->polygons[made] = (uint16_t)polygon;
        made++;
    }
}

int sheen_quantise(struct sheen_quantised *out, const struct sheen_host_mesh *host, uint32_t group)
{
    struct chosen chosen = {0};

    memset(out, 0, sizeof *out);
    int error = choose(&chosen, host, group);
    if (!error)
        error = allocate(out, &chosen);
    if (!error) {
        fill_vertices(out, host, &chosen);
        fill_triangles(out, host, &chosen);
        out->mesh.positions = out->positions;
        out->mesh.normals = out->normals;
        out->mesh.polygon_normals = out->polygon_normals;
        out->mesh.polygons = out->polygons;
        out->mesh.indices = out->indices;
        out->mesh.scale = SHEEN_Q24(32768 / ONE);
        sheen_mesh_warp(&out->mesh, out->polygon_count, out->warp);
        out->mesh.warp = out->warp;
    }
    free(chosen.vertex);
    free(chosen.polygon);
    if (error)
        sheen_quantised_free(out);
    return error;
}

void sheen_quantised_free(struct sheen_quantised *quantised)
{
    free(quantised->positions);
    free(quantised->normals);
    free(quantised->polygon_normals);
    free(quantised->polygons);
    free(quantised->warp);
    free(quantised->indices);
    memset(quantised, 0, sizeof *quantised);
}
