/*
 * loaded_mesh.c - a mesh by name, built in two ways that share only the reader of files.
 */
#include "loaded_mesh.h"

#include <stdio.h>
#include <string.h>

static int make_both(struct loaded_mesh *mesh, const struct sheen_polygons *from, struct sheen_problem *problem)
{
    static const struct ref_mesh_options fit = {.fit = true, .crease = -1};
    static const struct sheen_host_options as_given = {0};
    struct ref_polygons polygons = {.points = (const double(*)[3])from->points,
                                    .point_count = from->point_count,
                                    .first = from->first,
                                    .polygon_count = from->polygon_count,
                                    .corners = from->corners,
                                    .normals = (const double(*)[3])from->normals};
    struct sheen_host_mesh host;
    int status = sheen_host_mesh_build(&host, from, &as_given, mesh->name, problem);

    if (status != 0)
        return status;
    status = sheen_quantise(&mesh->quantised, &host, SHEEN_ALL_PARTS);
    sheen_host_mesh_free(&host);
    if (status == 0 && ref_mesh_build(&mesh->reference, &polygons, &fit) != 0)
        status = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: refused by the reference", mesh->name);
    return status;
}

int loaded_mesh_make(struct loaded_mesh *mesh, const char *name)
{
    struct sheen_polygons polygons;
    struct sheen_problem problem = {"out of memory"};

    memset(mesh, 0, sizeof *mesh);
    mesh->name = name;
    int status = sheen_polygons_load(&polygons, name, NULL, &problem);
    if (status == 0)
        status = make_both(mesh, &polygons, &problem);
    sheen_polygons_free(&polygons);
    if (status != 0) {
        fprintf(stderr, "%s\n", problem.text);
        loaded_mesh_free(mesh);
        return -1;
    }
    return 0;
}

void loaded_mesh_free(struct loaded_mesh *mesh)
{
    ref_mesh_free(&mesh->reference);
    sheen_quantised_free(&mesh->quantised);
}
