/*
 * mesh_dae_check.h - checks the structure of a COLLADA file.
 */
#ifndef SHEEN_MESH_DAE_CHECK_H
#define SHEEN_MESH_DAE_CHECK_H

#include "problem.h"

/*
 * Assimp takes the nearest vertex if an index is out of range, reads as many faces as there are numbers, and leaves out
 * what it does not support, all in silence. This compares what the file's geometries promise with what they have, and
 * names what would be left out: indices of vertices and normals, counts of faces and of numbers, holes, fans, skewed
 * nodes, shapes in other files, truncated XML. 0, or SHEEN_ERR_ARGUMENT or _MEMORY and *problem.
 */
int sheen_dae_check(const char *path, struct sheen_problem *problem);

#endif
