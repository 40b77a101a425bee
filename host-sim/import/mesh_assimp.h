/*
 * mesh_assimp.h - mesh files by assimp. For mesh_file.c, which confines it first, and for tests.
 */
#ifndef SHEEN_MESH_ASSIMP_H
#define SHEEN_MESH_ASSIMP_H

#include "polygons.h"

/* As sheen_mesh_file_read, in this process: a hostile file may do to it what it likes. */
int sheen_mesh_assimp_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/* 1 where some reader of assimp takes files of this ending, its dot included. */
int sheen_mesh_assimp_knows(const char *ending);

#endif
