/*
 * ply_check.h - the header of a PLY file.
 */
#ifndef SHEEN_PLY_CHECK_H
#define SHEEN_PLY_CHECK_H

#include "problem.h"

/*
 * assimp looks for the end of a header that has none for ever. This wants one in a
 * file that begins as a PLY file does; any other passes. 0, or SHEEN_ERR_ARGUMENT
 * and *problem.
 */
int sheen_ply_check(const char *path, struct sheen_problem *problem);

#endif
