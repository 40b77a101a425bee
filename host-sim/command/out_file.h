/*
 * out_file.h - an output file that appears whole or not at all.
 */
#ifndef SHEEN_OUT_FILE_H
#define SHEEN_OUT_FILE_H

#include <stddef.h>

#include "problem.h"

/*
 * Writes count bytes to path. A regular or new file is written in the same folder under another name and renamed when
 * it is complete; a device or pipe is written in place. 0, or SHEEN_ERR_ARGUMENT and *problem: then a regular file is
 * as it was.
 */
int sheen_out_file(const char *path, const void *bytes, size_t count, struct sheen_problem *problem);

#endif
