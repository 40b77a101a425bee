/*
 * mesh_dae_check.h - the structure of a COLLADA file.
 */
#ifndef SHEEN_MESH_DAE_CHECK_H
#define SHEEN_MESH_DAE_CHECK_H

#include "problem.h"

/*
 * assimp takes the nearest vertex where an index is out of range, as many faces as there are numbers, and leaves
 * out what it cannot do. This holds what the file's geometries promise against what they have, and names what
 * would be left out: indices of vertices and normals, counts of faces and of numbers, holes, fans, skewed nodes,
 * shapes of other files, XML that is cut short. 0, or SHEEN_ERR_ARGUMENT or _MEMORY and *problem.
 */
int sheen_dae_check(const char *path, struct sheen_problem *problem);

#endif
