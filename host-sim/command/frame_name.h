/*
 * frame_name.h - the file name of a frame: %d or %0Nd stands for its number.
 */
#ifndef SHEEN_FRAME_NAME_H
#define SHEEN_FRAME_NAME_H

#include <stddef.h>

/* 1 if the pattern's file name holds exactly one %d or %0Nd (N: 1..9); folders and other conversions do not count. */
int sheen_frame_name_varies(const char *pattern);

/*
 * The name of frame `number` of `count`; the pattern itself if there is only one frame or the pattern does not vary.
 * 0, or -1 if the name does not fit.
 */
int sheen_frame_name(char *name, size_t size, const char *pattern, int number, size_t count);

/* A path's file name, without its folders. */
const char *sheen_file_of(const char *path);

/* The ending of a file's name, with its dot; "" if it has none. */
const char *sheen_ending(const char *path);

#endif
