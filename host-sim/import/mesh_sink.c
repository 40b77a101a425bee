/*
 * mesh_sink.c - collects polygons from a reader that goes over its file twice: once to count, once to keep.
 */
#include "mesh_sink.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void sheen_sink_point(struct sheen_sink *sink, const double point[3], const uint8_t color[3])
{
    if (sink->keeping) {
        memcpy(sink->out->points[sink->points], point, 3 * sizeof *point);
        if (color)
            memcpy(sink->color[sink->points], color, 3);
    }
    sink->has_point_color |= color != NULL;
    sink->points++;
}

void sheen_sink_normal(struct sheen_sink *sink, const double normal[3])
{
    if (sink->keeping)
        memcpy(sink->normal[sink->normals], normal, 3 * sizeof *normal);
    sink->normals++;
}

/* A NaN in the file becomes infinite, because NaN stands for a missing uv (polygons.h). */
void sheen_sink_uv(struct sheen_sink *sink, const double uv[2])
{
    if (sink->keeping) {
        double v = 1 - uv[1];
        sink->uv[sink->uvs][0] = isnan(uv[0]) ? (double)INFINITY : uv[0];
        sink->uv[sink->uvs][1] = isnan(v) ? (double)INFINITY : v;
    }
    sink->uvs++;
}

void sheen_sink_corner(struct sheen_sink *sink, size_t point, size_t normal, size_t uv)
{
    /* The corners of a polygon that will be dropped may exceed the count of those to be kept. */
    if (sink->keeping && sink->corners < sink->out->corner_count) {
        sink->out->corners[sink->corners] = (uint32_t)point;
        /* Until spread(), index + 1 of the normal and of the uv; 0 for none. */
        if (sink->out->normals)
            sink->out->normals[sink->corners][0] = normal == SHEEN_NONE ? 0 : (double)normal + 1;
        if (sink->out->uvs)
            sink->out->uvs[sink->corners][0] = uv == SHEEN_NONE ? 0 : (double)uv + 1;
    }
    sink->corners++;
}

void sheen_sink_corner_uvs(struct sheen_sink *sink, size_t first)
{
    if (!sink->keeping || !sink->out->uvs)
        return;
    for (size_t c = sink->begun; c < sink->corners && c < sink->out->corner_count; c++)
        sink->out->uvs[c][0] = (double)(first + (c - sink->begun)) + 1;
}

void sheen_sink_polygon(struct sheen_sink *sink, uint16_t group, const uint8_t color[3])
{
    sink->has_colors |= color != NULL;
    if (sink->keeping) {
        for (size_t c = sink->begun; sink->out->colors && color && c < sink->corners; c++)
            memcpy(sink->out->colors[c], color, 3);
        sink->out->groups[sink->polygons] = group;
        sink->out->first[sink->polygons + 1] = (uint32_t)sink->corners;
    }
    sink->begun = sink->corners;
    sink->polygons++;
}

size_t sheen_sink_drop(struct sheen_sink *sink)
{
    size_t dropped = sink->corners - sink->begun;

    sink->corners = sink->begun;
    return dropped;
}

/* Allocates the arrays for what the first pass counted. */
static int make_room(struct sheen_sink *sink)
{
    int with = (sink->normals ? SHEEN_WITH_NORMALS : 0) | (sink->has_colors ? SHEEN_WITH_COLORS : 0) |
               (sink->uvs ? SHEEN_WITH_UVS : 0);
    struct sheen_notes notes = sink->out->notes;
    int error = sheen_polygons_alloc(sink->out, sink->points, sink->polygons, sink->corners, sink->groups, with);

    sink->out->notes = notes;
    sink->normal = malloc((sink->normals + 1) * sizeof *sink->normal);
    sink->uv = malloc((sink->uvs + 1) * sizeof *sink->uv);
    sink->color = sink->has_point_color ? malloc((sink->points + 1) * sizeof *sink->color) : NULL;
    if (sink->color)
        memset(sink->color, 255, (sink->points + 1) * sizeof *sink->color);
    return error || !sink->normal || !sink->uv || (sink->has_point_color && !sink->color) ? SHEEN_ERR_MEMORY : SHEEN_OK;
}

/* Replaces indices of normals and uv by the normals and uv, and copies the colours of points to their corners. */
static void spread(struct sheen_sink *sink)
{
    const struct sheen_polygons *out = sink->out;

    for (size_t c = 0; c < out->corner_count; c++) {
        size_t number = out->normals ? (size_t)out->normals[c][0] : 0;
        if (number)
            memcpy(out->normals[c], sink->normal[number - 1], sizeof out->normals[c]);
        number = out->uvs ? (size_t)out->uvs[c][0] : 0;
        for (int k = 0; out->uvs && k < 2; k++)
            out->uvs[c][k] = number ? sink->uv[number - 1][k] : (double)NAN;
        if (sink->color)
            memcpy(out->colors[c], sink->color[out->corners[c]], sizeof out->colors[c]);
    }
}

static int run_passes(struct sheen_sink *sink, sheen_sink_pass *pass, void *context, const char *path,
                      struct sheen_problem *problem)
{
    int error = pass(context, sink);

    if (error)
        return error;
    if (sink->polygons == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no faces%s", path, sink->points ? ", only points" : "");
    if (sink->points > UINT32_MAX / 8 || sink->corners > UINT32_MAX / 8)
        return SHEEN_ERR_MEMORY;
    sink->has_colors |= sink->has_point_color;
    error = make_room(sink);
    if (error)
        return error;
    sink->keeping = 1;
    sink->points = sink->normals = sink->uvs = sink->polygons = sink->corners = sink->begun = 0;
    error = pass(context, sink);
    if (!error)
        spread(sink);
    return error;
}

int sheen_sink_run(struct sheen_polygons *out, sheen_sink_pass *pass, void *context, const char *path,
                   struct sheen_problem *problem)
{
    struct sheen_sink sink = {.out = out, .groups = 1};

    sheen_polygons_free(out);
    int error = run_passes(&sink, pass, context, path, problem);
    free(sink.normal);
    free(sink.uv);
    free(sink.color);
    return error == SHEEN_ERR_MEMORY ? sheen_problem(problem, error, "%s: not enough memory", path) : error;
}

uint8_t sheen_color_byte(double value, double most)
{
    return (uint8_t)(255 * fmin(fmax(value / most, 0), 1) + 0.5); /* fmax(NaN, 0) is 0 */
}

void sheen_color_range_add(struct sheen_color_range *range, const double parts[3])
{
    for (int k = 0; k < 3; k++) {
        range->has_others |= !(parts[k] >= 0 && parts[k] <= 255 && parts[k] == floor(parts[k]));
        range->largest = fmax(range->largest, parts[k]);
    }
}

double sheen_color_range_most(const struct sheen_color_range *range, double least)
{
    return !range->has_others && range->largest >= least ? 255 : 1;
}
