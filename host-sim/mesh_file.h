/*
 * mesh_file.h - mesh files: OBJ, STL, PLY, glTF and what else assimp reads.
 */
#ifndef SHEEN_MESH_FILE_H
#define SHEEN_MESH_FILE_H

#include "polygons.h"

/*
 * Polygons with the file's node transforms applied, n-gons kept, points and lines
 * left out. 0, or a negative code and *problem. Release with sheen_polygons_free in
 * any case.
 */
int sheen_mesh_file_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

#endif
