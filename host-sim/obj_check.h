/*
 * obj_check.h - an OBJ file's indices and numbers, line by line.
 */
#ifndef SHEEN_OBJ_CHECK_H
#define SHEEN_OBJ_CHECK_H

#include "problem.h"

/*
 * assimp overlooks some indices out of range and names no line. This names the line
 * of an index to a vertex or normal that is not there and of a coordinate that is no
 * finite number; whatever else may be wrong is left to assimp. A file that is not
 * called .obj passes. 0, or SHEEN_ERR_ARGUMENT and *problem.
 */
int sheen_obj_check(const char *path, struct sheen_problem *problem);

#endif
