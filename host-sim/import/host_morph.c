/*
 * host_morph.c - another frame of a mesh: the same polygons one for one, with points elsewhere.
 */
#include <stdlib.h>
#include <string.h>

#include "host_build.h"

int sheen_host_frames_fit(const struct sheen_polygons *first, const struct sheen_polygons *second, const char *name,
                          const char *second_name, struct sheen_problem *problem)
{
    int error = sheen_polygons_check(second, second_name, problem);

    if (error)
        return error;
    if (first->polygon_count != second->polygon_count)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: has %zu faces, %s has %zu: it is no other frame of it",
                             second_name, second->polygon_count, name, first->polygon_count);
    for (size_t p = 0; p < first->polygon_count; p++) {
        uint32_t corners = first->first[p + 1] - first->first[p], others = second->first[p + 1] - second->first[p];
        if (corners != others)
            return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                                 "%s: face %zu has %u corners, in %s %u: it is no other frame of it", second_name,
                                 p + 1, others, name, corners);
    }
    return SHEEN_OK;
}

int sheen_host_second(const struct sheen_host_build *build)
{
    const struct sheen_host_build *second = build->second;
    struct sheen_host_mesh *mesh = build->mesh;
    struct sheen_host_frame *to = &mesh->second;

    to->positions = malloc(mesh->vertex_count * sizeof *to->positions);
    to->normals = malloc(mesh->vertex_count * sizeof *to->normals);
    to->polygon_normals = malloc(mesh->polygon_count * sizeof *to->polygon_normals);
    if (!to->positions || !to->normals || !to->polygon_normals)
        return SHEEN_ERR_MEMORY;
    for (size_t c = 0; c < mesh->corner_count; c++) {
        const double *point = second->from->points[second->from->corners[second->source[c]]];
        uint32_t vertex = mesh->corners[c];
        for (int k = 0; k < 3; k++)
            to->positions[vertex][k] = (point[k] - mesh->center[k]) / mesh->radius;
        memcpy(to->normals[vertex], second->normals[c], sizeof to->normals[vertex]);
    }
    for (size_t p = 0; p < mesh->polygon_count; p++)
        memcpy(to->polygon_normals[p], second->mesh->polygons[p].normal, sizeof to->polygon_normals[p]);
    return SHEEN_OK;
}
