/*
 * test_import.h - meshes for the tests of the importer.
 */
#ifndef TEST_IMPORT_H
#define TEST_IMPORT_H

#include <stddef.h>

#include "host_mesh.h"

/* Writes a file NAME into a folder of this program's own. Returns its path, valid until the next call. */
const char *import_file(const char *name, const void *bytes, size_t count);
const char *import_text(const char *name, const char *text);

/* Removes that folder; a group teardown for cmocka. */
int import_clean(void **state);

extern const struct sheen_host_options import_plain;

/* Imports a text as file NAME, whose ending gives the format. The test fails if the import fails. */
void import_mesh(struct sheen_host_mesh *mesh, const char *name, const char *text,
                 const struct sheen_host_options *options);

/* The same, but it must fail with `error` and with a message of one line that contains `part`. */
void import_refused(int error, const char *part, const char *name, const char *text);

#endif
