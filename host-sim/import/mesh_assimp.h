/*
 * mesh_assimp.h - mesh files read by Assimp. For mesh_file.c, which confines it first, and for tests.
 */
#ifndef SHEEN_MESH_ASSIMP_H
#define SHEEN_MESH_ASSIMP_H

#include "polygons.h"

/* As sheen_mesh_file_read, but in this process, where a hostile file may do what it likes. */
int sheen_mesh_assimp_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/* 1 if a reader of Assimp accepts files with this ending (with its dot). */
int sheen_mesh_assimp_knows(const char *ending);

#endif
