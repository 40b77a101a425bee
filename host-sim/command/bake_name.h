/*
 * bake_name.h - which names a header that `sheen bake` makes, and what is in it, may have.
 */
#ifndef SHEEN_BAKE_NAME_H
#define SHEEN_BAKE_NAME_H

#include <stddef.h>

/*
 * 1 where a mesh may be called that: an identifier of C and C++ of at most 39 letters that neither they nor sheen.h
 * take or reserve.
 */
int sheen_bake_is_name(const char *name);

/*
 * The identifier that a file's name gives: its base without ending, others than letters and digits as _, "mesh_"
 * before what would be none or is taken.
 */
void sheen_bake_name(char *name, size_t size, const char *path);

/* 1 where a file is called as one of sheen's own headers, which it would be included in place of. */
int sheen_bake_is_own_header(const char *path);

#endif
