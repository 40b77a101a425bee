/*
 * mesh_format.h - chooses the reader for a mesh file. For mesh_file.c, which confines it first, and for tests.
 */
#ifndef SHEEN_MESH_FORMAT_H
#define SHEEN_MESH_FORMAT_H

#include "polygons.h"

/*
 * As sheen_mesh_file_read, but in this process, where a hostile file may do what it likes; polygons->target says what
 * is asked for. The reader is chosen by the ending of the file's name, in upper or lower case; if that is unknown, by
 * the first bytes of the file.
 */
int sheen_mesh_format_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

#endif
