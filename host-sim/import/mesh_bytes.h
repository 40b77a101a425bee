/*
 * mesh_bytes.h - a whole file in memory, for the readers of mesh files.
 */
#ifndef SHEEN_MESH_BYTES_H
#define SHEEN_MESH_BYTES_H

#include <stddef.h>

#include "problem.h"

#ifdef __cplusplus
extern "C" {
#endif

struct sheen_bytes {
    unsigned char *bytes; /* `count` bytes and a zero */
    size_t count;
};

/* Reads a file. 0, or a negative code and *problem, which names the path. Release with sheen_bytes_free in any case. */
int sheen_bytes_load(struct sheen_bytes *bytes, const char *path, struct sheen_problem *problem);
void sheen_bytes_free(struct sheen_bytes *bytes);

/* Converts UTF-16 with a byte order mark to UTF-8 and removes UTF-8's mark. 0, or SHEEN_ERR_MEMORY. */
int sheen_bytes_to_utf8(struct sheen_bytes *bytes);

/* The path of a file that is named by another one and lies beside it: "folder of path/name". -1: too long for `out`. */
int sheen_beside(char *out, size_t room, const char *path, const char *name, size_t length);

/*
 * The path of a picture that the file names: where it says or, if that does not exist (paths of another machine), under
 * its bare name beside the file. NULL: no memory; to be freed.
 */
char *sheen_picture_beside(const char *path, const char *name, size_t length);

#ifdef __cplusplus
}
#endif

#endif
