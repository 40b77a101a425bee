/*
 * out_file.c - an output file that is there whole or not at all.
 */
#include "out_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* All of it, going on after short and interrupted writes. 0, or -1 and errno. */
static int write_all(int file, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t written = write(file, bytes, count);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return -1;
        bytes += written;
        count -= (size_t)written;
    }
    return 0;
}

static int write_in_place(const char *path, const void *bytes, size_t count)
{
    int file = open(path, O_WRONLY | O_CLOEXEC);

    if (file < 0)
        return -1;
    int result = write_all(file, bytes, count), why = errno;
    if (close(file) != 0 && result == 0)
        return -1;
    errno = why;
    return result;
}

/* beside: a template for mkstemp, in the folder of path. The new file has the mode that creating it plainly would. */
static int write_and_move(const char *path, char *beside, const void *bytes, size_t count)
{
    mode_t mask = umask(0);
    umask(mask);

    int file = mkstemp(beside);
    if (file < 0)
        return -1;
    int result = write_all(file, bytes, count);
    if (result == 0)
        result = fchmod(file, 0666 & ~mask);
    int why = errno;
    if (close(file) != 0 && result == 0) {
        result = -1;
        why = errno;
    }
    if (result == 0 && rename(beside, path) != 0) {
        result = -1;
        why = errno;
    }
    if (result != 0)
        unlink(beside);
    errno = why;
    return result;
}

/* A file that may not be written is not replaced either; a link stays one, its end is replaced. */
static int write_regular(const char *path, int exists, const void *bytes, size_t count)
{
    static const char suffix[] = ".XXXXXX";

    if (exists && access(path, W_OK) != 0)
        return -1;
    char *end = exists ? realpath(path, NULL) : strdup(path);
    char *beside = end ? malloc(strlen(end) + sizeof suffix) : NULL;
    int result = -1;
    if (beside) {
        strcpy(beside, end);
        strcat(beside, suffix);
        result = write_and_move(end, beside, bytes, count);
    }
    int why = errno;
    free(beside);
    free(end);
    errno = why;
    return result;
}

int sheen_out_file(const char *path, const void *bytes, size_t count, struct sheen_problem *problem)
{
    struct stat status;
    int exists = stat(path, &status) == 0, result;

    if (exists && S_ISDIR(status.st_mode))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(EISDIR));
    if (exists && !S_ISREG(status.st_mode)) {
        result = write_in_place(path, bytes, count);
    } else {
        /* A signal that ends us waits until the file is in its place. */
        sigset_t all, before;
        sigfillset(&all);
        sigprocmask(SIG_BLOCK, &all, &before);
        result = write_regular(path, exists, bytes, count);
        int why = errno;
        sigprocmask(SIG_SETMASK, &before, NULL);
        errno = why;
    }
    return result == 0 ? SHEEN_OK : sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, strerror(errno));
}
