/*
 * bake_name.h - which names a header made by `sheen bake`, and the data in it, may have.
 */
#ifndef SHEEN_BAKE_NAME_H
#define SHEEN_BAKE_NAME_H

#include <stddef.h>

/*
 * 1 if a mesh may have this name: an identifier of C and C++ of at most 39 characters that neither the languages nor
 * sheen.h use or reserve.
 */
int sheen_bake_is_name(const char *name);

/*
 * Makes an identifier from a file's name: the part before the first dot, with '_' for each character that is no letter
 * or digit, and "mesh_" in front if the result would otherwise be no identifier or is taken.
 */
void sheen_bake_name(char *name, size_t size, const char *path);

/* 1 if the file has the name of one of sheen's own headers and so might be included instead of that header. */
int sheen_bake_is_own_header(const char *path);

#endif
