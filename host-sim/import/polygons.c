/*
 * polygons.c - a mesh as its file lists it.
 */
#include "polygons.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int sheen_polygons_alloc(struct sheen_polygons *polygons, size_t points, size_t count, size_t corners, size_t groups,
                         int with)
{
    memset(polygons, 0, sizeof *polygons);
    polygons->point_count = points;
    polygons->polygon_count = count;
    polygons->corner_count = corners;
    polygons->group_count = groups;
    polygons->points = calloc(points + 1, sizeof *polygons->points);
    polygons->first = calloc(count + 1, sizeof *polygons->first);
    polygons->corners = calloc(corners + 1, sizeof *polygons->corners);
    polygons->groups = calloc(count + 1, sizeof *polygons->groups);
    polygons->group = calloc(groups + 1, sizeof *polygons->group);
    if (with & SHEEN_WITH_NORMALS)
        polygons->normals = calloc(corners + 1, sizeof *polygons->normals);
    if (with & SHEEN_WITH_COLORS)
        polygons->colors = calloc(corners + 1, sizeof *polygons->colors);
    if (!polygons->points || !polygons->first || !polygons->corners || !polygons->groups || !polygons->group ||
        (with & SHEEN_WITH_NORMALS && !polygons->normals) || (with & SHEEN_WITH_COLORS && !polygons->colors))
        return SHEEN_ERR_MEMORY;
    return SHEEN_OK;
}

void sheen_polygons_free(struct sheen_polygons *polygons)
{
    free(polygons->points);
    free(polygons->first);
    free(polygons->corners);
    free(polygons->normals);
    free(polygons->colors);
    free(polygons->groups);
    free(polygons->group);
    memset(polygons, 0, sizeof *polygons);
}

static int is_finite3(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

/* The mean over the group's corners; 0 where it has none. */
static int mean_color(const struct sheen_polygons *polygons, size_t group, uint8_t mean[3])
{
    uint64_t sum[3] = {0, 0, 0}, count = 0;

    for (size_t p = 0; p < polygons->polygon_count; p++) {
        if (polygons->groups[p] != group)
            continue;
        for (uint32_t c = polygons->first[p]; c < polygons->first[p + 1]; c++) {
            for (int k = 0; k < 3; k++)
                sum[k] += polygons->colors[c][k];
        }
        count += polygons->first[p + 1] - polygons->first[p];
    }
    for (int k = 0; k < 3 && count; k++)
        mean[k] = (uint8_t)((sum[k] + count / 2) / count);
    return count > 0;
}

void sheen_polygons_finish(struct sheen_polygons *polygons, const char *name)
{
    for (size_t c = 0; polygons->normals && c < polygons->corner_count; c++) {
        if (!is_finite3(polygons->normals[c]))
            memset(polygons->normals[c], 0, sizeof polygons->normals[c]);
    }
    for (size_t g = 0; polygons->colors && g < polygons->group_count; g++) {
        struct sheen_group *group = &polygons->group[g];
        if (group->has_color || !mean_color(polygons, g, group->color))
            continue;
        group->has_color = 1;
        sheen_note(&polygons->notes, SHEEN_NOTE_ON_COLORS, "%s: has vertex colours; their mean is used", name);
    }
}

static int is_float3(const double v[3])
{
    return fabs(v[0]) <= FLT_MAX && fabs(v[1]) <= FLT_MAX && fabs(v[2]) <= FLT_MAX; /* false for NaN */
}

static int check_polygon(const struct sheen_polygons *polygons, size_t p, const char *name,
                         struct sheen_problem *problem)
{
    uint32_t begin = polygons->first[p], end = polygons->first[p + 1];

    if (end > polygons->corner_count || end < begin || end - begin < 3)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: face %zu is broken", name, p + 1);
    if (polygons->groups[p] >= polygons->group_count)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: face %zu: no such material", name, p + 1);
    for (uint32_t c = begin; c < end; c++) {
        uint32_t point = polygons->corners[c];
        if (point >= polygons->point_count)
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: face %zu: vertex %lu of %zu", name, p + 1,
                                 (unsigned long)point + 1, polygons->point_count);
        if (!is_float3(polygons->points[point]))
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: face %zu has a vertex that is not a finite number",
                                 name, p + 1);
        if (polygons->normals && !is_finite3(polygons->normals[c]))
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: face %zu has a normal that is not a finite number",
                                 name, p + 1);
    }
    return SHEEN_OK;
}

int sheen_polygons_check(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem)
{
    if (polygons->polygon_count == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no faces", name);
    if (polygons->first[0] != 0 || polygons->first[polygons->polygon_count] != polygons->corner_count)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: faces are broken", name);
    for (size_t p = 0; p < polygons->polygon_count; p++) {
        int error = check_polygon(polygons, p, name, problem);
        if (error)
            return error;
    }
    return SHEEN_OK;
}

static void turn(double (*vectors)[3], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        double y = vectors[i][1];
        vectors[i][1] = vectors[i][2];
        vectors[i][2] = -y;
    }
}

void sheen_polygons_turn(struct sheen_polygons *polygons)
{
    turn(polygons->points, polygons->point_count);
    if (polygons->normals)
        turn(polygons->normals, polygons->corner_count);
}
