/*
 * mesh_file.h - mesh files of every format (mesh_format.c).
 *
 * Parsers of two dozen formats are the widest door for a hostile file. They run in a
 * child process that may read files and nothing else (confine.h), with limits on memory
 * and processor time; what it returns is checked here.
 */
#ifndef SHEEN_MESH_FILE_H
#define SHEEN_MESH_FILE_H

#include "textures.h"

#define SHEEN_IMPORT_SECONDS 10u       /* processor time of the child */
#define SHEEN_IMPORT_BYTES (48u << 20) /* its memory besides 16 times the files; the command itself needs 16 MB */

/* The function that runs in the child: sheen_mesh_format_read, or a test's own. */
typedef int sheen_mesh_reader(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/*
 * Reads polygons, with the file's node transforms applied, n-gons kept, points and lines left out, and the textures
 * that are asked for (NULL: none). 0, or a negative code and *problem. Release with sheen_polygons_free in any case.
 */
int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path,
                         const struct sheen_texture_options *textures, struct sheen_problem *problem);

/* The same with another reader. */
int sheen_mesh_file_read_by(sheen_mesh_reader *reader, struct sheen_polygons *polygons, const char *path,
                            const struct sheen_texture_options *textures, struct sheen_problem *problem);

/*
 * Reads a square picture alone, with its sides reduced to `most` (a power of two), in such a child. 0, or a negative
 * code and *problem. Release with sheen_picture_free in any case.
 */
int sheen_picture_file_read(struct sheen_picture *picture, const char *path, unsigned most,
                            struct sheen_problem *problem);

#endif
