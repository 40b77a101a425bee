/*
 * out_file.c - an output file that appears whole or not at all.
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

#define MOST_LINKS 40 /* symbolic links in a row, the same limit as Linux's */

/* Writes all bytes, continuing after short and interrupted writes. 0, or -1 and errno. */
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

/* beside: a template for mkstemp, in the folder of path. The new file gets the mode of a plainly created one. */
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

/* Joins the folder of path and the name; free() it. NULL: not enough memory. */
static char *in_folder_of(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
    char *joined = malloc(folder + strlen(name) + 1);

    if (joined) {
        memcpy(joined, path, folder);
        strcpy(joined + folder, name);
    }
    return joined;
}

/* The path that a link names; free() it. On failure NULL and errno. */
static char *named_by(const char *link)
{
    char name[4096];
    ssize_t length = readlink(link, name, sizeof name);

    if (length == (ssize_t)sizeof name)
        errno = ENAMETOOLONG;
    if (length < 0 || length == (ssize_t)sizeof name)
        return NULL;
    name[length] = '\0';
    return *name == '/' ? strdup(name) : in_folder_of(link, name);
}

/* Where links end, even if no file is there yet, which realpath() cannot tell; free() it. On failure NULL and errno. */
static char *end_of_links(const char *path)
{
    char *end = strdup(path);
    struct stat status;

    for (int count = 0; end && lstat(end, &status) == 0 && S_ISLNK(status.st_mode); count++) {
        char *next = count < MOST_LINKS ? named_by(end) : NULL;
        int why = count < MOST_LINKS ? errno : ELOOP;
        free(end);
        errno = why;
        end = next;
    }
    return end;
}

/*
 * A file without write permission is not replaced. A link stays a link; the file at its end is replaced or made. The
 * new file's temporary name is short, so that it is valid however long the final name is.
 */
static int write_regular(const char *path, int exists, const void *bytes, size_t count)
{
    if (exists && access(path, W_OK) != 0)
        return -1;
    char *end = exists ? realpath(path, NULL) : end_of_links(path);
    char *beside = end ? in_folder_of(end, ".sheen-XXXXXX") : NULL;
    int result = beside ? write_and_move(end, beside, bytes, count) : -1;
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
        /* A signal that would end the program waits until the file is in its place. */
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
