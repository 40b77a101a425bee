/*
 * host_normals.c - Newell's normal of a polygon, and the normal of each corner.
 */
#include <stdlib.h>
#include <string.h>

#include "host_build.h"
#include "host_vector.h"
#include "sheen.h"

/*
 * An area below this part of the squared extent is rounding: the points are
 * 32-bit floats, whose products leave 1e-16 where three of them are in line.
 */
#define NO_AREA 1e-12

/* Unit normals that cancel leave at most this, times the polygons around a vertex. */
#define CANCELLED 1e-9

/* Rounding of a cosine (of the core, the same on every machine: 3e-9), so that "within 60 degrees" keeps 60. */
#define CREASE_SLACK 1e-8

/*
 * Newell's sum over the edges is that of the cross products of neighbouring
 * corners; taken from the first corner, a small polygon far out keeps its digits.
 */
int sheen_host_newell(const double (*points)[3], const uint32_t *corners, uint32_t count, double normal[3])
{
    const double *origin = points[corners[0]];
    double before[3] = {0, 0, 0}, sum[3] = {0, 0, 0}, extent = 0;

    for (uint32_t i = 1; i < count; i++) {
        double here[3], cross[3];
        for (int k = 0; k < 3; k++)
            here[k] = points[corners[i]][k] - origin[k];
        cross3(before, here, cross);
        for (int k = 0; k < 3; k++)
            sum[k] += cross[k];
        extent = fmax(extent, dot3(here, here));
        memcpy(before, here, sizeof before);
    }
    normal[0] = normal[1] = normal[2] = 0;
    if (!(sqrt(dot3(sum, sum)) > NO_AREA * extent))
        return 0;
    memcpy(normal, sum, sizeof sum);
    return unit3(normal);
}

/* The corners around each vertex: those of vertex w are list[begin[w]] .. list[begin[w + 1] - 1], in order. */
struct around {
    uint32_t *begin, *list, *polygon;
};

static int gather(const struct sheen_host_build *build, struct around *around)
{
    const struct sheen_host_mesh *mesh = build->mesh;

    around->begin = calloc(build->weld_count + 2, sizeof *around->begin);
    around->list = malloc(mesh->corner_count * sizeof *around->list);
    around->polygon = malloc(mesh->corner_count * sizeof *around->polygon);
    if (!around->begin || !around->list || !around->polygon)
        return SHEEN_ERR_MEMORY;
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        for (uint32_t c = 0; c < mesh->polygons[p].count; c++)
            around->polygon[mesh->polygons[p].first + c] = (uint32_t)p;
    }
    /* Counted two places up, summed, then moved down one place while the list fills. */
    for (size_t c = 0; c < mesh->corner_count; c++)
        around->begin[sheen_corner_weld(build, c) + 2]++;
    for (size_t w = 2; w < build->weld_count + 2; w++)
        around->begin[w] += around->begin[w - 1];
    for (size_t c = 0; c < mesh->corner_count; c++)
        around->list[around->begin[sheen_corner_weld(build, c) + 1]++] = (uint32_t)c;
    return SHEEN_OK;
}

/* The sum over the polygons around vertex w; own not NULL: only those with a cosine of `least` or more to it. */
static void sum_around(const struct sheen_host_build *build, const struct around *around, uint32_t w,
                       const double own[3], double least, double sum[3])
{
    sum[0] = sum[1] = sum[2] = 0;
    for (uint32_t i = around->begin[w]; i < around->begin[w + 1]; i++) {
        const double *normal = build->mesh->polygons[around->polygon[around->list[i]]].normal;
        if (own && dot3(own, normal) < least)
            continue;
        for (int k = 0; k < 3; k++)
            sum[k] += normal[k];
    }
}

static void average(struct sheen_host_build *build, const struct around *around)
{
    const double *file = build->from->normals && !build->options->average ? build->from->normals[0] : NULL;
    double turns = build->options->crease / 360; /* 0..1/2 */
    double least = sheen_cos((sheen_angle_t)(turns * 4294967296.0)) / 1073741824.0 - CREASE_SLACK;

    for (uint32_t w = 0; w < build->weld_count; w++) {
        double shared[3]; /* without a crease the sum is the same for every corner here */
        uint32_t begin = around->begin[w], end = around->begin[w + 1];

        sum_around(build, around, w, NULL, 0, shared);
        for (uint32_t i = begin; i < end; i++) {
            uint32_t c = around->list[i];
            double *normal = build->normals[c];
            const double *own = build->mesh->polygons[around->polygon[c]].normal;

            if (file) {
                memcpy(normal, file + 3 * (size_t)build->source[c], 3 * sizeof *normal);
                if (unit3(normal))
                    continue;
            }
            memcpy(normal, shared, sizeof shared);
            if (build->options->use_crease)
                sum_around(build, around, w, own, least, normal);
            if (sqrt(dot3(normal, normal)) < CANCELLED * (end - begin))
                memcpy(normal, own, 3 * sizeof *normal);
            unit3(normal);
        }
    }
}

int sheen_host_normals(struct sheen_host_build *build)
{
    struct around around = {0};
    int error = gather(build, &around);

    if (!error) {
        build->normals = calloc(build->mesh->corner_count, sizeof *build->normals);
        error = build->normals ? SHEEN_OK : SHEEN_ERR_MEMORY;
    }
    if (!error)
        average(build, &around);
    free(around.begin);
    free(around.list);
    free(around.polygon);
    return error;
}
