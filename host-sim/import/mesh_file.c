/*
 * mesh_file.c - reads mesh files in a confined child process.
 */
#include "mesh_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confine.h"
#include "mesh_format.h"
#include "mesh_wire.h"

/* Reports what is wrong with the file itself, in the operating system's words, which are better than a parser's. */
static int check_file(const char *path, struct sheen_problem *problem)
{
    struct stat status;
    int failed = stat(path, &status);

    if (!failed && !S_ISREG(status.st_mode)) /* not opened, because a pipe would wait for its writer */
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path,
                             S_ISDIR(status.st_mode) ? strerror(EISDIR) : "not a regular file");
    if (failed || access(path, R_OK) != 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
    if (status.st_size == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: the file is empty", path);
    return SHEEN_OK;
}

/* The child process. Resets the program's signal handlers, so that a crash ends it. */
static _Noreturn void read_and_send(sheen_mesh_reader *reader, const char *path,
                                    const struct sheen_texture_options *textures, int pipe)
{
    struct sheen_polygons polygons = {.target = textures ? textures->target : 0};
    struct sheen_problem problem = {""};

    for (int number = 1; number < NSIG; number++)
        signal(number, SIG_DFL);
    int error = sheen_confine(pipe, SHEEN_IMPORT_SECONDS, SHEEN_IMPORT_BYTES, &problem);

    if (!error)
        error = reader(&polygons, path, &problem);
    if (!error)
        error = sheen_textures_read(&polygons, textures, path, &problem);
    if (!error)
        sheen_polygons_finish(&polygons);
    _exit(sheen_mesh_send(pipe, error, &polygons, &problem) == 0 ? 0 : 1);
}

/* Reports why there is no answer. status is waitpid's. */
static int explain(int status, const char *path, struct sheen_problem *problem)
{
    int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;

    if (number == SIGXCPU)
        return sheen_problem(problem, SHEEN_ERR_TIMEOUT, "%s: reading it takes more than %u s of processor time", path,
                             SHEEN_IMPORT_SECONDS);
    if (number == SIGSYS)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its importer was stopped: it tried to do more than read",
                             path);
    if (number)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its importer crashed (%s)", path, strsignal(number));
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its importer gave no answer, or one too large", path);
}

static int receive(struct sheen_polygons *polygons, const char *path, pid_t child, int pipe,
                   struct sheen_problem *problem)
{
    int error = SHEEN_OK, status = 0;
    int answered = sheen_mesh_receive(pipe, &error, polygons, problem);

    close(pipe); /* ends a child that still writes */
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    if (answered && error == SHEEN_ERR_MEMORY) /* replaces the reader's message, if any */
        return sheen_problem(problem, error, "%s: reading it takes more memory than %u times its size and 64 MB", path,
                             SHEEN_CONFINE_TIMES);
    return answered ? error : explain(status, path, problem);
}

int sheen_mesh_file_read_by(sheen_mesh_reader *reader, struct sheen_polygons *polygons, const char *path,
                            const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    int ends[2], error = check_file(path, problem);

    memset(polygons, 0, sizeof *polygons);
    if (error)
        return error;
    if (pipe(ends) != 0)
        return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "%s: no pipe: %s", path, strerror(errno));
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        read_and_send(reader, path, textures, ends[1]);
    }
    error = errno;
    close(ends[1]);
    if (child > 0)
        return receive(polygons, path, child, ends[0], problem);
    close(ends[0]);
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "%s: cannot start a process to read it: %s", path,
                         strerror(error));
}

int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem)
{
    return sheen_mesh_file_read_by(sheen_mesh_format_read, polygons, path, textures, problem);
}

/* Makes a triangle that shows the picture, so that the picture is read like a mesh's. */
static int read_carrier(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    if (sheen_polygons_alloc(polygons, 3, 1, 3, 1, SHEEN_WITH_UVS) != SHEEN_OK)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    for (uint32_t c = 0; c < 3; c++) {
        polygons->points[c][0] = polygons->uvs[c][0] = c == 1;
        polygons->points[c][1] = polygons->uvs[c][1] = c == 2;
        polygons->corners[c] = c;
    }
    polygons->first[1] = 3;
    return SHEEN_OK;
}

int sheen_picture_file_read(struct sheen_picture *picture, const char *path, unsigned most,
                            struct sheen_problem *problem)
{
    const struct sheen_texture_options options = {
        .file = path, .wrap = SHEEN_ALL_CLAMP, .most = most, .square = 1, .cutoff = 0};
    struct sheen_polygons polygons;
    int error = sheen_mesh_file_read_by(read_carrier, &polygons, path, &options, problem);

    memset(picture, 0, sizeof *picture);
    if (!error && polygons.picture_count != 1)
        error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its importer gave no picture", path);
    if (!error) {
        *picture = polygons.picture[0];
        polygons.picture_count = 0;
    }
    sheen_polygons_free(&polygons);
    return error;
}
