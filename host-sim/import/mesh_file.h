/*
 * mesh_file.h - mesh files of every format (mesh_format.c).
 *
 * A parser of two dozen formats is the widest door that a hostile file finds. It
 * runs in a child process that may read files and nothing else (confine.h), within
 * limits of memory and processor time; what it hands back is checked here.
 */
#ifndef SHEEN_MESH_FILE_H
#define SHEEN_MESH_FILE_H

#include "textures.h"

#define SHEEN_IMPORT_SECONDS 10u       /* processor time of the child */
#define SHEEN_IMPORT_BYTES (48u << 20) /* its memory beside 16 times the files; the command itself takes 16 MB */

/* What runs in the child: sheen_mesh_format_read, or a test's own. */
typedef int sheen_mesh_reader(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/*
 * Polygons with the file's node transforms applied, n-gons kept, points and lines
 * left out, and the textures that are asked for; NULL: none. 0, or a negative code and *problem. Release with
 * sheen_polygons_free in any case.
 */
int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem);

/* The same by another reader. */
int sheen_mesh_file_read_by(sheen_mesh_reader *reader, struct sheen_polygons *polygons, const char *path,
                            const struct sheen_texture_options *textures, struct sheen_problem *problem);

/*
 * A picture alone, square, its sides reduced to `most` (a power of two), in the same child. 0, or a negative code and
 * *problem. Release with sheen_picture_free in any case.
 */
int sheen_picture_file_read(struct sheen_picture *picture, const char *path, unsigned most,
                            struct sheen_problem *problem);

#endif
