/*
 * quantise.c - a host mesh in the core's integers.
 */
#include "quantise.h"

#include <stdlib.h>
#include <string.h>

#include "host_vector.h"

#define ONE 32767.0

/* The squared sine of the angle between q and unit: |q x unit|^2 / |q|^2. */
static double off_direction(const double q[3], const double unit[3])
{
    double cross[3];

    cross3(q, unit, cross);
    return dot3(cross, cross) / dot3(q, q);
}

/* Takes the best of the eight vectors around: mean error 0.8e-5 rad, where rounding each part has 1.2e-5. */
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

/* The part of the host mesh that goes into the quantised mesh: the new index of each vertex and polygon, or NONE. */
#define NONE UINT32_MAX
struct chosen {
    uint32_t *vertex, *polygon;
    uint32_t vertices, polygons, triangles;
};

static int choose(struct chosen *chosen, const struct sheen_host_mesh *host, uint32_t part)
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
        if (part != SHEEN_ALL_PARTS && polygon->part != part)
            continue;
        chosen->polygon[p] = chosen->polygons++;
        chosen->triangles += polygon->count - 2;
        for (uint32_t c = polygon->first; c < polygon->first + polygon->count; c++) {
            if (chosen->vertex[host->corners[c]] == NONE)
                chosen->vertex[host->corners[c]] = chosen->vertices++;
        }
    }
    return SHEEN_OK;
}

static int allocate(struct sheen_quantised *out, const struct chosen *chosen, int with_uvs, int with_colors)
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
    if (with_uvs)
        out->uvs = calloc(chosen->vertices, 2 * sizeof *out->uvs);
    if (with_colors)
        out->colors = calloc(chosen->vertices, 3);
    if ((with_uvs && !out->uvs) || (with_colors && !out->colors))
        return SHEEN_ERR_MEMORY;
    if (!out->positions || !out->normals || !out->polygon_normals || !out->warp || !out->indices ||
        (chosen->polygons < chosen->triangles && !out->polygons))
        return SHEEN_ERR_MEMORY;
    return SHEEN_OK;
}

static void quantise_point(const double position[3], int16_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (int16_t)floor(position[k] * ONE + 0.5);
}

static void fill_vertices(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen)
{
    for (size_t i = 0; i < host->vertex_count; i++) {
        if (chosen->vertex[i] == NONE)
            continue;
        size_t at = 3 * (size_t)chosen->vertex[i];
        quantise_point(host->vertices[i].position, out->positions + at);
        sheen_quantise_unit(host->vertices[i].normal, out->normals + at);
    }
    for (size_t p = 0; p < host->polygon_count; p++) {
        if (chosen->polygon[p] != NONE)
            sheen_quantise_unit(host->polygons[p].normal, out->polygon_normals + 3 * (size_t)chosen->polygon[p]);
    }
}

/* The normal of a polygon without area is zero and stays so. */
static void quantise_normal(const double normal[3], int16_t out[3])
{
    if (dot3(normal, normal) > 0)
        sheen_quantise_unit(normal, out);
}

/* Quantises the second frame like the first. */
static int make_second(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen)
{
    const struct sheen_host_frame *second = &host->second;

    out->second_positions = calloc(chosen->vertices, 3 * sizeof *out->second_positions);
    out->second_normals = calloc(chosen->vertices, 3 * sizeof *out->second_normals);
    out->second_polygon_normals = calloc(chosen->polygons, 3 * sizeof *out->second_polygon_normals);
    if (!out->second_positions || !out->second_normals || !out->second_polygon_normals)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 0; i < host->vertex_count; i++) {
        if (chosen->vertex[i] == NONE)
            continue;
        size_t at = 3 * (size_t)chosen->vertex[i];
        quantise_point(second->positions[i], out->second_positions + at);
        quantise_normal(second->normals[i], out->second_normals + at);
    }
    for (size_t p = 0; p < host->polygon_count; p++) {
        if (chosen->polygon[p] != NONE)
            quantise_normal(second->polygon_normals[p], out->second_polygon_normals + 3 * (size_t)chosen->polygon[p]);
    }
    return SHEEN_OK;
}

/* ---- texture coordinates ---- */

/* The whole number to subtract from all values of u or v, so that they are near 0; the texture looks the same. */
static double whole_part(double low, double high, int wrap)
{
    if (wrap != SHEEN_WRAP_CLAMP)
        return floor((low + high) / 2);
    /* Beyond its edge a clamped texture is constant, so one texture's width beyond is as good as any place. */
    return low > 2 ? floor(low) - 2 : high < -1 ? ceil(high) + 1 : 0;
}

static void fill_uvs(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen,
                     const struct sheen_picture *picture)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, moved[2], center[2], most = 0;
    int bits = 15;

    for (size_t i = 0; i < host->vertex_count; i++) {
        for (int k = 0; chosen->vertex[i] != NONE && k < 2; k++) {
            low[k] = fmin(low[k], host->vertices[i].uv[k]);
            high[k] = fmax(high[k], host->vertices[i].uv[k]);
        }
    }
    for (int k = 0; k < 2; k++) {
        moved[k] = whole_part(low[k], high[k], picture->wrap[k]);
        most = fmax(most, high[k] - low[k]);
    }
    while (bits > 0 && ldexp(most, bits) > 65533) /* 65535 less what the two roundings below may add */
        bits--;
    out->mesh.uv_bits = (uint8_t)bits;
    for (int k = 0; k < 2; k++) {
        center[k] = ldexp(floor(ldexp((low[k] + high[k]) / 2 - moved[k], bits) + 0.5), -bits);
        out->mesh.uv_offset[k] = (sheen_q16_t)floor(center[k] * 65536 + 0.5);
    }
    for (size_t i = 0; i < host->vertex_count; i++) {
        for (int k = 0; chosen->vertex[i] != NONE && k < 2; k++)
            out->uvs[2 * (size_t)chosen->vertex[i] + (size_t)k] =
                (int16_t)floor(ldexp(host->vertices[i].uv[k] - moved[k] - center[k], bits) + 0.5);
    }
}

static void fill_colors(struct sheen_quantised *out, const struct sheen_host_mesh *host, const struct chosen *chosen)
{
    for (size_t i = 0; i < host->vertex_count; i++) {
        if (chosen->vertex[i] != NONE)
            memcpy(out->colors + 3 * (size_t)chosen->vertex[i], host->vertices[i].color, 3);
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

/* Where corners do not meet as 16 bits, they do not as floats either, or less than 1/65534 of the radius is between. */
static int find_edges(struct sheen_quantised *out, double crease)
{
    const struct sheen_mesh *mesh = &out->mesh;
    uint32_t *scratch = calloc(SHEEN_EDGES_WORDS((size_t)mesh->vertices, (size_t)mesh->triangles), sizeof *scratch);

    out->edges = calloc(mesh->triangles, sizeof *out->edges);
    if (scratch && out->edges) {
        sheen_mesh_edges(mesh, sheen_cos((sheen_angle_t)(crease / 360 * 4294967296.0)), scratch, out->edges);
        out->mesh.edges = out->edges;
    }
    free(scratch);
    return out->mesh.edges ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

/* Points the core's meshes at the arrays, which are filled already. */
static void set_meshes(struct sheen_quantised *out)
{
    struct sheen_mesh *mesh = &out->mesh;

    mesh->positions = out->positions;
    mesh->normals = out->normals;
    mesh->polygon_normals = out->polygon_normals;
    mesh->polygons = out->polygons;
    mesh->indices = out->indices;
    mesh->uvs = out->uvs;
    mesh->colors = out->colors;
    mesh->scale = SHEEN_Q24(32768 / ONE);
    sheen_mesh_warp(mesh, out->polygon_count, out->warp);
    mesh->warp = out->warp;
    out->second = (struct sheen_mesh){.positions = out->second_positions,
                                      .normals = out->second_normals,
                                      .polygon_normals = out->second_polygon_normals,
                                      .vertices = mesh->vertices,
                                      .triangles = mesh->triangles,
                                      .scale = mesh->scale};
}

int sheen_quantise(struct sheen_quantised *out, const struct sheen_host_mesh *host, uint32_t part)
{
    struct chosen chosen = {0};
    uint32_t picture = part == SHEEN_ALL_PARTS ? 0 : host->part[part].picture;

    memset(out, 0, sizeof *out);
    int error = choose(&chosen, host, part);
    if (!error)
        error = allocate(out, &chosen, picture > 0, host->has_colors);
    if (!error && out->uvs)
        fill_uvs(out, host, &chosen, &host->picture[picture - 1]);
    if (!error && out->colors)
        fill_colors(out, host, &chosen);
    if (!error && host->second.positions)
        error = make_second(out, host, &chosen);
    if (!error) {
        fill_vertices(out, host, &chosen);
        fill_triangles(out, host, &chosen);
        set_meshes(out);
        error = find_edges(out, host->crease);
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
    free(quantised->second_positions);
    free(quantised->second_normals);
    free(quantised->second_polygon_normals);
    free(quantised->uvs);
    free(quantised->colors);
    free(quantised->polygons);
    free(quantised->warp);
    free(quantised->edges);
    free(quantised->indices);
    memset(quantised, 0, sizeof *quantised);
}
