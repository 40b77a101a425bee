/*
 * host_reduce.c - reduces a host mesh to fewer triangles: simplifies its places, then builds it anew from the rest.
 */
#include "host_reduce.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host_vector.h"
#include "simplify.h"
#include "unique.h"

#define NONE UINT32_MAX

/*
 * Vertices of the mesh that differ only in their normals share a place. Vertices at one point that differ in
 * group, uv or colour are at different places; the simplifier keeps them joined there.
 */
struct reducing {
    const struct sheen_host_mesh *from;
    uint32_t *place; /* of each vertex */
    size_t place_count;
    float (*points)[3];     /* of each place */
    uint32_t *first, *next; /* lists of the vertices at a place: first[place], then next[vertex] until NONE */
    unsigned *corners;      /* places, 3 per triangle */
    size_t corner_count;
    double error; /* as a fraction of the longest side */
};

/* Vertices with equal keys share a place. Every byte is compared, so the struct has no padding. */
struct place_key {
    double uv[2];
    uint32_t weld, group, has_uv;
    uint8_t color[4];
};

int sheen_host_places(const struct sheen_host_mesh *mesh, uint32_t *place, size_t *count)
{
    struct place_key *keys = malloc(mesh->vertex_count * sizeof *keys);
    int error = SHEEN_ERR_MEMORY;

    for (size_t v = 0; keys && v < mesh->vertex_count; v++) {
        const struct sheen_host_vertex *vertex = &mesh->vertices[v];
        keys[v] = (struct place_key){.weld = vertex->weld, .group = vertex->group, .has_uv = vertex->has_uv};
        memcpy(keys[v].uv, vertex->uv, sizeof keys[v].uv);
        memcpy(keys[v].color, vertex->color, sizeof keys[v].color);
    }
    if (keys)
        error = sheen_unique(keys, sizeof *keys, mesh->vertex_count, place, count);
    free(keys);
    return error;
}

static int list_places(struct reducing *to)
{
    const struct sheen_host_mesh *from = to->from;

    to->place = malloc(from->vertex_count * sizeof *to->place);
    if (!to->place || sheen_host_places(from, to->place, &to->place_count) != SHEEN_OK)
        return SHEEN_ERR_MEMORY;
    to->points = malloc(to->place_count * sizeof *to->points);
    to->first = malloc(to->place_count * sizeof *to->first);
    to->next = malloc(from->vertex_count * sizeof *to->next);
    if (!to->points || !to->first || !to->next)
        return SHEEN_ERR_MEMORY;
    memset(to->first, 0xff, to->place_count * sizeof *to->first);
    for (size_t v = 0; v < from->vertex_count; v++) {
        uint32_t place = to->place[v];
        for (int k = 0; k < 3; k++)
            to->points[place][k] = (float)from->vertices[v].position[k];
        to->next[v] = to->first[place];
        to->first[place] = (uint32_t)v;
    }
    return SHEEN_OK;
}

static int simplify(struct reducing *to, size_t most, struct sheen_problem *problem)
{
    const struct sheen_host_mesh *from = to->from;

    to->corners = malloc(3 * from->triangle_count * sizeof *to->corners);
    if (!to->corners)
        return SHEEN_ERR_MEMORY;
    for (size_t t = 0; t < from->triangle_count; t++) {
        for (int k = 0; k < 3; k++)
            to->corners[to->corner_count++] = to->place[from->triangles[t].vertex[k]];
    }
    return sheen_simplify(to->corners, &to->corner_count, (const float(*)[3])to->points, to->place_count, 3 * most,
                          from->picture_count > 0, &to->error, problem);
}

/* Chooses the normal nearest to `facing` among those at a place. */
static void choose_normal(const struct reducing *to, uint32_t place, const double facing[3], double normal[3])
{
    double best = -HUGE_VAL;

    for (uint32_t v = to->first[place]; v != NONE; v = to->next[v]) {
        const double *candidate = to->from->vertices[v].normal;
        if (dot3(candidate, facing) > best) {
            best = dot3(candidate, facing);
            memcpy(normal, candidate, 3 * sizeof *normal);
        }
    }
}

static void fill_triangle(const struct reducing *to, struct sheen_polygons *out, size_t t)
{
    const unsigned *corners = to->corners + 3 * t;
    double at[3][3], a[3], b[3], facing[3];

    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            at[i][k] = (double)to->points[corners[i]][k];
    }
    for (int k = 0; k < 3; k++) {
        a[k] = at[1][k] - at[0][k];
        b[k] = at[2][k] - at[0][k];
    }
    cross3(a, b, facing);
    for (size_t i = 0; i < 3; i++) {
        const struct sheen_host_vertex *vertex = &to->from->vertices[to->first[corners[i]]];
        if (out->uvs && vertex->has_uv)
            memcpy(out->uvs[3 * t + i], vertex->uv, sizeof vertex->uv);
        if (out->colors)
            memcpy(out->colors[3 * t + i], vertex->color, 3);
        out->corners[3 * t + i] = corners[i];
        choose_normal(to, corners[i], facing, out->normals[3 * t + i]);
    }
    out->groups[t] = (uint16_t)to->from->vertices[to->first[corners[0]]].group;
    out->first[t + 1] = (uint32_t)(3 * t + 3);
}

/* Makes polygons of the remaining triangles, as a reader of files would. */
static int make_polygons(const struct reducing *to, struct sheen_polygons *out)
{
    const struct sheen_host_mesh *from = to->from;
    int with =
        SHEEN_WITH_NORMALS | (from->picture_count ? SHEEN_WITH_UVS : 0) | (from->has_colors ? SHEEN_WITH_COLORS : 0);
    int error =
        sheen_polygons_alloc(out, to->place_count, to->corner_count / 3, to->corner_count, from->group_count, with);

    if (error)
        return error;
    for (size_t v = 0; v < from->vertex_count; v++) {
        double *point = out->points[to->place[v]];
        for (int k = 0; k < 3; k++)
            point[k] = from->vertices[v].position[k] * from->radius + from->center[k];
    }
    for (size_t t = 0; t < to->corner_count / 3; t++)
        fill_triangle(to, out, t);
    memcpy(out->group, from->group, from->group_count * sizeof *out->group);
    out->picture = from->picture; /* lent: rebuild() takes them back */
    out->picture_count = from->picture_count;
    out->z_up = from->z_up;
    out->notes = from->notes;
    return SHEEN_OK;
}

/* Builds *out from the reduced triangles in `to`. */
static int rebuild(const struct reducing *to, const struct sheen_host_options *options, struct sheen_host_mesh *out,
                   const char *name, struct sheen_problem *problem)
{
    const struct sheen_host_options how = {.by_group = options->by_group, .colors = options->colors};
    const size_t most = options->reduce;
    struct sheen_polygons polygons = {0};
    int error = make_polygons(to, &polygons);

    if (!error && to->corner_count == 0)
        error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: --reduce %zu leaves no triangle of it", name, most);
    if (!error)
        error = sheen_host_mesh_build(out, &polygons, &how, name, problem);
    if (!error) {
        out->crease = to->from->crease; /* only to tell sharp edges, because the normals are already chosen */
        sheen_note(&out->notes, out->triangle_count > most ? SHEEN_NOTE_WARNING : SHEEN_NOTE_DONE,
                   "%s: reduced from %zu triangles to %zu%s, off by at most %.2g %% of its size", name,
                   to->from->triangle_count, out->triangle_count, out->triangle_count > most ? ", not fewer" : "",
                   100 * to->error);
    }
    polygons.picture = NULL;
    polygons.picture_count = 0;
    sheen_polygons_free(&polygons);
    return error;
}

int sheen_host_mesh_reduce(struct sheen_host_mesh *mesh, const struct sheen_host_options *options, const char *name,
                           struct sheen_problem *problem)
{
    struct reducing to = {.from = mesh};
    struct sheen_host_mesh out = {0};
    int error = list_places(&to);

    if (!error)
        error = simplify(&to, options->reduce, problem);
    if (!error)
        error = rebuild(&to, options, &out, name, problem);
    if (error == SHEEN_ERR_MEMORY)
        sheen_problem(problem, error, "%s: not enough memory", name);
    free(to.place);
    free(to.points);
    free(to.first);
    free(to.next);
    free(to.corners);
    sheen_host_mesh_free(mesh);
    *mesh = out;
    return error;
}
