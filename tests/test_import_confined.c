/*
 * test_import_confined.c - the reader of mesh files runs confined. Readers that were taken over try forbidden things,
 * and broken readers give up, crash or hang: the test checks that nothing forbidden succeeds and what is reported.
 */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmocka.h>

#include "mesh_bytes.h"
#include "mesh_file.h"
#include "test_import.h"

/* Runs a reader. Returns its error line, or "" if it succeeded. */
static const char *said(sheen_mesh_reader *reader)
{
    static struct sheen_problem problem;
    struct sheen_polygons polygons;

    problem.text[0] = '\0';
    int error = sheen_mesh_file_read_by(reader, &polygons, import_text("any.obj", "v 0 0 0\n"), NULL, &problem);
    assert_int_equal(error == 0, problem.text[0] == '\0');
    sheen_polygons_free(&polygons);
    return problem.text;
}

static void says(sheen_mesh_reader *reader, const char *part)
{
    const char *text = said(reader);

    if (!strstr(text, part) || !strstr(text, "any.obj: "))
        fail_msg("'%s' should say '%s'", text, part);
}

/* An error line with the result of an attempt, so that the test sees what the reader could do. */
static int report(struct sheen_problem *problem, const char *path, const char *what, int result)
{
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s: %s", path, what,
                         result < 0 ? strerror(errno) : "it was possible");
}

static int writes_a_file(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "create", open("/tmp/sheen_intruder", O_WRONLY | O_CREAT, 0666));
}

static int writes_the_mesh(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "write", open(path, O_RDWR));
}

static int truncates(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "truncate", open(path, O_RDONLY | O_TRUNC));
}

static int removes(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "remove", unlink(path));
}

static int makes_code(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    void *code = mmap(NULL, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return report(problem, path, "code", code == MAP_FAILED ? -1 : 0);
}

static int writes_to_others(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "output", (int)write(STDOUT_FILENO, "intruder\n", 9));
}

static void it_cannot_write(void **state)
{
    (void)state;
    says(writes_a_file, "create: Operation not permitted");
    assert_int_equal(access("/tmp/sheen_intruder", F_OK), -1);
    says(writes_the_mesh, "write: Operation not permitted");
    says(truncates, "truncate: Operation not permitted");
    says(removes, "remove: Operation not permitted");
    says(makes_code, "code: Operation not permitted");
    says(writes_to_others, "output: Operation not permitted");
}

static int connects(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "socket", socket(AF_INET, SOCK_STREAM, 0));
}

static int runs_a_program(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "execve", execve("/bin/true", (char *[]){"true", NULL}, (char *[]){NULL}));
}

static int forks(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "fork", fork());
}

static int shoots(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "kill", kill(getppid(), SIGTERM));
}

static void an_intruder_is_stopped(void **state)
{
    (void)state;
    says(connects, "stopped");
    says(runs_a_program, "stopped");
    says(forks, "stopped");
    says(shoots, "stopped");
}

static int crashes(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons, (void)path, (void)problem;
    return raise(SIGSEGV);
}

static int gives_up(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons, (void)path, (void)problem;
    abort();
}

static int leaves(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons, (void)path, (void)problem;
    _exit(0);
}

static int sends_rubbish(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)path, (void)problem;
    memset(polygons, 0, sizeof *polygons);
    polygons->point_count = SIZE_MAX / 3;
    polygons->group_count = 1;
    return 0;
}

static void a_broken_one_is_one_line(void **state)
{
    (void)state;
    says(gives_up, "importer crashed");
    says(leaves, "no answer");
    says(sends_rubbish, "no answer");
    says(crashes, "importer crashed");
}

/* Allocates memory and writes to it, because address space alone does not count. */
static int take(struct sheen_problem *problem, const char *path, size_t megabytes)
{
    char *volatile memory = malloc(megabytes << 20); /* volatile, because clang would leave out unused memory */

    if (memory)
        memset(memory, 1, megabytes << 20);
    return report(problem, path, "malloc", memory ? 0 : -1);
}

static int takes_little(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return take(problem, path, (SHEEN_IMPORT_BYTES >> 20) - 4);
}

static int takes_much(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return take(problem, path, (SHEEN_IMPORT_BYTES >> 20) + 4);
}

/* A file of a megabyte: while it is read, 16 more may be allocated, but only once. */
static char large_file[300];

static int takes_for_a_file(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    struct sheen_bytes bytes;

    (void)polygons;
    for (int twice = 0; twice < 2; twice++) {
        int error = sheen_bytes_load(&bytes, large_file, problem);
        if (error)
            return error;
        sheen_bytes_free(&bytes);
    }
    return take(problem, path, (SHEEN_IMPORT_BYTES >> 20) + 12);
}

static int takes_too_much_for_it(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)takes_for_a_file(polygons, path, problem);
    return take(problem, path, (SHEEN_IMPORT_BYTES >> 20) + 20);
}

static int takes_forever(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons, (void)path, (void)problem;
    for (volatile int wait = 1; wait;)
        ;
    return 0;
}

static int waits(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons;
    return report(problem, path, "open to wait", open(path, O_RDONLY));
}

static int gives_up_for_want(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    (void)polygons, (void)path, (void)problem;
    return SHEEN_ERR_MEMORY;
}

static void limits(void **state)
{
    static char megabyte[1 << 20];

    (void)state;
    snprintf(large_file, sizeof large_file, "%s", import_file("large", megabyte, sizeof megabyte));
#if !defined(__SANITIZE_ADDRESS__)
    says(takes_little, "malloc: it was possible");
    says(takes_much, "malloc: Cannot allocate memory");
    says(takes_for_a_file, "malloc: it was possible");
    says(takes_too_much_for_it, "malloc: Cannot allocate memory");
    says(waits, "open to wait: Operation not permitted");
#else
    (void)takes_little, (void)takes_much, (void)takes_for_a_file, (void)takes_too_much_for_it, (void)waits;
#endif
    says(gives_up_for_want, "more memory than 16 times its size and 64 MB");
    says(takes_forever, "more than 10 s of processor time");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_cannot_write),
        cmocka_unit_test(an_intruder_is_stopped),
        cmocka_unit_test(a_broken_one_is_one_line),
        cmocka_unit_test(limits),
    };

    return cmocka_run_group_tests(tests, NULL, import_clean);
}
