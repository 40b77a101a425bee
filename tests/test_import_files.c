/*
 * test_import_files.c - makes mesh files for tests and checks what an import returns.
 */
#include "test_import.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

const struct sheen_host_options import_plain = {0};

static char folder[] = "/tmp/sheen_import_XXXXXX";
static char path[256];
static int made;

const char *import_file(const char *name, const void *bytes, size_t count)
{
    if (!made)
        assert_non_null(mkdtemp(folder));
    made = 1;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
    return path;
}

const char *import_text(const char *name, const char *text)
{
    return import_file(name, text, strlen(text));
}

int import_clean(void **state)
{
    char command[300];

    (void)state;
    snprintf(command, sizeof command, "rm -r %s", folder);
    return made ? system(command) : 0;
}

void import_mesh(struct sheen_host_mesh *mesh, const char *name, const char *text,
                 const struct sheen_host_options *options)
{
    struct sheen_problem problem;

    if (sheen_host_mesh_load(mesh, import_text(name, text), options, &problem) != 0)
        fail_msg("%s", problem.text);
}

void import_refused(int error, const char *part, const char *name, const char *text)
{
    struct sheen_problem problem = {""};
    struct sheen_host_mesh mesh;
    const char *file = import_text(name, text);

    assert_int_equal(sheen_host_mesh_load(&mesh, file, &import_plain, &problem), error);
    if (!strstr(problem.text, part) || !strstr(problem.text, file) || strchr(problem.text, '\n'))
        fail_msg("'%s' should name %s and say '%s'", problem.text, file, part);
}
