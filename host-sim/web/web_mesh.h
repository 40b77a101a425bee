/*
 * web_mesh.h - mesh files in the page. Private to web_mesh.c and web_without.cpp.
 */
#ifndef SHEEN_WEB_MESH_H
#define SHEEN_WEB_MESH_H

#include "problem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The file that is being read. */
extern const char *sheen_web_path;

/* Answers that it cannot be read, for this reason, and ends this instance of the module. */
_Noreturn void sheen_web_refuse(int error, const char *why);

#ifdef __cplusplus
}
#endif

#endif
