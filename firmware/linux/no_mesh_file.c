/*
 * no_mesh_file.c - replaces the sources that host-sim/import/mesh.cmake lists, if their libraries are missing.
 */
#include "../../host-sim/import/mesh_file.h"
#include "../../host-sim/import/simplify.h"

int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    (void)textures;
    *polygons = (struct sheen_polygons){0};
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                         "%s: this sheen-panel was built without the libraries that read files; builtin:teapot, "
                         "teapot-fine, sphere, torus and cube it has",
                         path);
}

int sheen_picture_file_read(struct sheen_picture *picture, const char *path, unsigned most,
                            struct sheen_problem *problem)
{
    (void)most;
    *picture = (struct sheen_picture){.name = NULL};
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                         "%s: this sheen-panel was built without the libraries that read files; glaze, chrome, clay "
                         "and jade it has",
                         path);
}

int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem)
{
    (void)corners, (void)count, (void)points, (void)point_count, (void)most, (void)keeps_joins, (void)error;
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "--reduce: this sheen-panel was built without meshoptimizer");
}
