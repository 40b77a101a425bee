/*
 * frame_name.h - the file name of a frame: %d or %0Nd stands for its number.
 */
#ifndef SHEEN_FRAME_NAME_H
#define SHEEN_FRAME_NAME_H

#include <stddef.h>

/* 1 where the pattern holds, behind its folders, exactly one %d or %0Nd (N: 1..9), which is all that counts as one. */
int sheen_frame_name_varies(const char *pattern);

/*
 * The name of frame `number` of `count`; that of the only one, and a pattern that does not vary, is copied. 0, or -1
 * where it does not fit.
 */
int sheen_frame_name(char *name, size_t size, const char *pattern, int number, size_t count);

/* A file's name behind its folders. */
const char *sheen_file_of(const char *path);

/* The ending of a file's name, with its dot; "" where it has none. */
const char *sheen_ending(const char *path);

#endif
