/*
 * string.h - what the core and its test use of it.
 */
#ifndef LX106_STRING_H
#define LX106_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memset(void *to, int byte, size_t count);
int memcmp(const void *a, const void *b, size_t count);

#endif
