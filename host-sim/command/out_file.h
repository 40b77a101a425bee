/*
 * out_file.h - an output file that is there whole or not at all.
 */
#ifndef SHEEN_OUT_FILE_H
#define SHEEN_OUT_FILE_H

#include <stddef.h>

#include "problem.h"

/*
 * Write count bytes to path. A regular file (or a new one) is written in its
 * folder under another name and moved there when complete; a device or pipe is
 * written in place. 0, or SHEEN_ERR_ARGUMENT and *problem: then the file is as it was.
 */
int sheen_out_file(const char *path, const void *bytes, size_t count, struct sheen_problem *problem);

#endif
