/*
 * utf8.h - text from outside, a file's name or a material's, made fit to be printed.
 */
#ifndef SHEEN_UTF8_H
#define SHEEN_UTF8_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Length in bytes of the character that text begins with, 1..4; 0 at its end and at bytes
 * that are not valid UTF-8.
 */
size_t sheen_utf8_bytes(const char *text);

/* Replaces in place by '?' what is not valid UTF-8, or controls a terminal or the direction of text. */
void sheen_utf8_clean(char *text);

/* A clean copy of what fits into size bytes (1 or more) with its '\0'; cut between characters. */
void sheen_utf8_copy(char *to, size_t size, const char *from);

/* Shortens clean text in place to at most `most` characters, with "..." in the middle of its longest words. */
void sheen_utf8_shorten(char *text, size_t most);

#ifdef __cplusplus
}
#endif

#endif
