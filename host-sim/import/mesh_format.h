/*
 * mesh_format.h - which reader a mesh file gets. For mesh_file.c, which confines it first, and for tests.
 */
#ifndef SHEEN_MESH_FORMAT_H
#define SHEEN_MESH_FORMAT_H

#include "polygons.h"

/*
 * As sheen_mesh_file_read, in this process, with `target` of *polygons what is asked for: a hostile file may do to it
 * what it likes. A file's name chooses by its ending, in any case; where that is none that is known, its first bytes
 * choose.
 */
int sheen_mesh_format_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

#endif
