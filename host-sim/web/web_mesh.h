/*
 * web_mesh.h - mesh files in the page. Private to web*.c and web_without.cpp.
 */
#ifndef SHEEN_WEB_MESH_H
#define SHEEN_WEB_MESH_H

#include "problem.h"

#ifdef __cplusplus
extern "C" {
#endif

struct sheen_options;

/* Parses the words of web_words() as a command line of `sheen view`. 1, or a negative code and *problem. In web.c. */
int sheen_web_options(struct sheen_options *options, int count, struct sheen_problem *problem);

/* The file that is being read. */
extern const char *sheen_web_path;

/* Answers that the file cannot be read and why, and ends this instance of the module. */
_Noreturn void sheen_web_refuse(int error, const char *why);

#ifdef __cplusplus
}
#endif

#endif
