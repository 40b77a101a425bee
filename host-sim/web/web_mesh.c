/*
 * web_mesh.c - mesh files in the page.
 *
 * The command reads a file in a confined child process (mesh_file.h). The page reads it in a worker, in a separate
 * instance of this module that is discarded afterwards: web_read() writes an answer in the format of mesh_wire.h to its
 * output, and the instance that draws finds this answer where the command finds the file. The answer for another frame
 * of a mesh, whose file may be the mesh's own, is found under FRAME_OF and the file's name.
 */
#include "web_mesh.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "confine.h"
#include "mesh_file.h"
#include "mesh_format.h"
#include "mesh_wire.h"
#include "scene.h"
#include "simplify.h"

#define FRAME_OF "frame of "

const char *sheen_web_path;

/* ---- the instance that reads ---- */

static _Noreturn void answer(int error, struct sheen_polygons *polygons, const struct sheen_problem *problem)
{
    if (!error)
        sheen_polygons_finish(polygons);
    exit(sheen_mesh_send(STDOUT_FILENO, error, polygons, problem) == 0 ? 0 : 1);
}

void sheen_web_refuse(int error, const char *why)
{
    struct sheen_problem problem;

    sheen_problem(&problem, error, "%s: %s", sheen_web_path, why);
    answer(error, NULL, &problem);
}

/* Room for the file's name, for the page to fill in. NULL: not enough memory. */
__attribute__((export_name("web_path"))) char *web_path(size_t size)
{
    char *path = calloc(size + 1, 1);

    sheen_web_path = path;
    return path;
}

/*
 * Reads the file named by web_path() as the words of web_words() ask, with --morph as another frame of a mesh. Writes
 * the answer and ends this instance: never returns.
 */
__attribute__((export_name("web_read"))) void web_read(int count)
{
    static struct sheen_options options;
    struct sheen_polygons polygons = {0};
    struct sheen_problem problem = {""};
    struct stat status;

    if (stat(sheen_web_path, &status) != 0)
        sheen_web_refuse(SHEEN_ERR_ARGUMENT, strerror(errno));
    if (status.st_size == 0)
        sheen_web_refuse(SHEEN_ERR_ARGUMENT, "the file is empty");
    int go = sheen_web_options(&options, count, &problem);
    if (go > 0 && options.morph)
        polygons.target = (unsigned)options.morph_target + 1;
    int error = go < 0 ? go : sheen_mesh_format_read(&polygons, sheen_web_path, &problem);
    if (!error && !options.morph) {
        const struct sheen_texture_options textures = sheen_scene_texture_options(&options);
        error = sheen_textures_read(&polygons, &textures, sheen_web_path, &problem);
    }
    answer(error, &polygons, &problem);
}

/* Nothing to do: a page is confined anyway. */
void sheen_confine_file(int file)
{
    (void)file;
}

/* ---- the instance that draws ---- */

int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    const int is_frame = textures && textures->target;
    char *name = malloc(sizeof FRAME_OF + strlen(path));
    int file = -1, error = SHEEN_OK;

    memset(polygons, 0, sizeof *polygons);
    if (!name)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    sprintf(name, "%s%s", is_frame ? FRAME_OF : "", path);
    file = open(name, O_RDONLY);
    free(name);
    if (file < 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
    int answered = sheen_mesh_receive(file, &error, polygons, problem);
    close(file);
    return answered
               ? error
               : sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its importer gave no answer, or one too large", path);
}

int sheen_picture_file_read(struct sheen_picture *picture, const char *path, unsigned most,
                            struct sheen_problem *problem)
{
    (void)most;
    *picture = (struct sheen_picture){.name = NULL};
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED,
                         "%s: matcaps of files are for the command sheen, a page has glaze, chrome, clay and jade",
                         path);
}

int sheen_simplify(unsigned *corners, size_t *count, const float (*points)[3], size_t point_count, size_t most,
                   int keeps_joins, double *error, struct sheen_problem *problem)
{
    (void)corners, (void)count, (void)points, (void)point_count, (void)most, (void)keeps_joins, (void)error;
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "--reduce is for the command sheen, a page is without it");
}
