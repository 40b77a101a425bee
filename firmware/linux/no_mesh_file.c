/*
 * no_mesh_file.c - in place of host-sim/mesh_file.c where there is no assimp.
 */
#include "../../host-sim/mesh_file.h"

int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    *polygons = (struct sheen_polygons){0};
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                         "%s: this sheen-panel was built without assimp and reads no files; builtin:teapot, "
                         "builtin:sphere and builtin:torus it has",
                         path);
}
