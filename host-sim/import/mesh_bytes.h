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
    unsigned char *bytes; /* count of them and a zero */
    size_t count;
};

/* 0, or a negative code and *problem, which names the path. Release with sheen_bytes_free in either case. */
int sheen_bytes_load(struct sheen_bytes *bytes, const char *path, struct sheen_problem *problem);
void sheen_bytes_free(struct sheen_bytes *bytes);

/* UTF-16 with its mark, of either byte order, becomes UTF-8, and UTF-8's own mark goes. 0, or SHEEN_ERR_MEMORY. */
int sheen_bytes_to_utf8(struct sheen_bytes *bytes);

/* A file that another names, beside it: "folder of path/name". -1 where that is too long for `out`. */
int sheen_beside(char *out, size_t room, const char *path, const char *name, size_t length);

/*
 * The path of a picture that the file names: there, or under its bare name beside the file, as when it came from
 * another machine. NULL without memory; to be freed.
 */
char *sheen_picture_beside(const char *path, const char *name, size_t length);

#ifdef __cplusplus
}
#endif

#endif
