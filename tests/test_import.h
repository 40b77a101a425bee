/*
 * test_import.h - meshes for the tests of the importer.
 */
#ifndef TEST_IMPORT_H
#define TEST_IMPORT_H

#include <stddef.h>

#include "host_mesh.h"

/* Writes a file NAME into a folder that this program owns; the path, valid until the next call. */
const char *import_file(const char *name, const void *bytes, size_t count);
const char *import_text(const char *name, const char *text);

/* Removes the folder: a group teardown of cmocka. */
int import_clean(void **state);

extern const struct sheen_host_options import_plain;

/* Text as file NAME (its ending tells the format) to a host mesh; the test fails where that fails. */
void import_mesh(struct sheen_host_mesh *mesh, const char *name, const char *text,
                 const struct sheen_host_options *options);

/* The same, which must fail: with that code, a line that holds `part` and is one line. */
void import_refused(int error, const char *part, const char *name, const char *text);

#endif
