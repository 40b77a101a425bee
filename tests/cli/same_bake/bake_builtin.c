/*
 * bake_builtin.c - prints the headers of the built-in meshes, plain and with a crease.
 */
#include "bake_text.h"
#include "mesh_file.h"
#include "simplify.h"

/* There is no reader of files on these machines, and none is asked for. */
int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    (void)polygons, (void)textures;
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "%s: no files", path);
}

int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem)
{
    (void)corners, (void)count, (void)points, (void)point_count, (void)most, (void)keeps_joins, (void)error;
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "--reduce: there is no meshoptimizer");
}

static int bake(const char *name, const struct sheen_host_options *options)
{
    struct sheen_host_mesh host;
    struct sheen_quantised quantised;
    struct sheen_problem problem;

    if (sheen_host_mesh_load(&host, name, options, &problem) != 0) {
        fprintf(stderr, "%s\n", problem.text);
        return 1;
    }
    int error = sheen_quantise(&quantised, &host, SHEEN_ALL_PARTS);
    if (!error) {
        struct sheen_bake made = {.meshes = &quantised, .count = 1, .name = "mesh", .source = name, .flat = 1};
        error = sheen_bake_text(stdout, &made);
        sheen_quantised_free(&quantised);
    }
    sheen_host_mesh_free(&host);
    return error;
}

int main(void)
{
    static const char *const names[] = {"builtin:teapot", "builtin:sphere", "builtin:torus", "builtin:cube"};
    int failed = 0;

    for (size_t i = 0; i < 4; i++) {
        failed |= bake(names[i], &(struct sheen_host_options){0});
        failed |= bake(names[i], &(struct sheen_host_options){.use_crease = 1, .crease = 25});
    }
    return failed;
}
