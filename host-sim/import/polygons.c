/*
 * polygons.c - a mesh as its file lists it.
 */
#include "polygons.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "picture.h"

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
    if (with & SHEEN_WITH_UVS)
        polygons->uvs = malloc((corners + 1) * sizeof *polygons->uvs);
    for (size_t c = 0; polygons->uvs && c < corners; c++)
        polygons->uvs[c][0] = polygons->uvs[c][1] = NAN;
    if (!polygons->points || !polygons->first || !polygons->corners || !polygons->groups || !polygons->group ||
        (with & SHEEN_WITH_NORMALS && !polygons->normals) || (with & SHEEN_WITH_COLORS && !polygons->colors) ||
        (with & SHEEN_WITH_UVS && !polygons->uvs))
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
    free(polygons->uvs);
    free(polygons->groups);
    sheen_polygons_drop_pictures(polygons);
    free(polygons->group);
    memset(polygons, 0, sizeof *polygons);
}

void sheen_picture_free(struct sheen_picture *picture)
{
    free(picture->name);
    free(picture->bytes);
    free(picture->rgba);
}

void sheen_polygons_drop_pictures(struct sheen_polygons *polygons)
{
    for (size_t i = 0; i < polygons->picture_count; i++)
        sheen_picture_free(&polygons->picture[i]);
    free(polygons->picture);
    polygons->picture = NULL;
    polygons->picture_count = 0;
    for (size_t g = 0; polygons->group && g < polygons->group_count; g++)
        polygons->group[g].picture = 0;
}

/* Names are enough to compare: pictures within a file have different ones. */
static int is_same_picture(const struct sheen_picture *a, const struct sheen_picture *b)
{
    return strcmp(a->name, b->name) == 0 && memcmp(a->wrap, b->wrap, sizeof a->wrap) == 0 && !(a->cutoff < b->cutoff) &&
           !(a->cutoff > b->cutoff);
}

uint32_t sheen_polygons_picture(struct sheen_polygons *polygons, struct sheen_picture *picture)
{
    struct sheen_picture *grown = NULL;

    for (size_t i = 0; picture->name && i < polygons->picture_count; i++) {
        if (is_same_picture(&polygons->picture[i], picture)) {
            sheen_picture_free(picture);
            return (uint32_t)i + 1;
        }
    }
    if (picture->name)
        grown = realloc(polygons->picture, (polygons->picture_count + 1) * sizeof *grown);
    if (!grown) {
        sheen_picture_free(picture);
        return 0;
    }
    polygons->picture = grown;
    grown[polygons->picture_count++] = *picture;
    return (uint32_t)polygons->picture_count;
}

int sheen_polygons_is_textured(const struct sheen_polygons *polygons, size_t polygon)
{
    if (!polygons->uvs || !polygons->group[polygons->groups[polygon]].picture)
        return 0;
    for (uint32_t c = polygons->first[polygon]; c < polygons->first[polygon + 1]; c++) {
        if (isnan(polygons->uvs[c][0]) || isnan(polygons->uvs[c][1]))
            return 0;
    }
    return 1;
}

static int is_finite3(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

void sheen_polygons_finish(struct sheen_polygons *polygons)
{
    for (size_t c = 0; polygons->normals && c < polygons->corner_count; c++) {
        if (!is_finite3(polygons->normals[c]))
            memset(polygons->normals[c], 0, sizeof polygons->normals[c]);
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
        if (polygons->uvs && (isinf(polygons->uvs[c][0]) || isinf(polygons->uvs[c][1])))
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                                 "%s: face %zu has a texture coordinate that is not a finite number", name, p + 1);
    }
    return SHEEN_OK;
}

static int is_side(unsigned texels)
{
    return texels > 0 && texels <= SHEEN_TEXTURE_MAX && (texels & (texels - 1)) == 0;
}

/* Checks pictures that have been read already. */
static int check_pictures(const struct sheen_polygons *polygons, const char *name, struct sheen_problem *problem)
{
    for (size_t i = 0; i < polygons->picture_count; i++) {
        const struct sheen_picture *picture = &polygons->picture[i];
        int is_right = is_side(picture->size[0]) && is_side(picture->size[1]) && picture->rgba &&
                       picture->wrap[0] <= SHEEN_WRAP_CLAMP && picture->wrap[1] <= SHEEN_WRAP_CLAMP &&
                       picture->cutoff >= 0 && picture->cutoff <= SHEEN_CUT_ALL;
        if (!is_right)
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: texture %zu is broken", name, i + 1);
    }
    for (size_t g = 0; g < polygons->group_count; g++) {
        if (polygons->group[g].picture > polygons->picture_count)
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: material %zu: no such texture", name, g + 1);
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
    return check_pictures(polygons, name, problem);
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
