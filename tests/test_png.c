/*
 * test_png.c - pictures written to files and read back. An output file appears whole or not at all.
 */
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "frame_name.h"
#include "out_file.h"
#include "png_file.h"

enum {
    WIDTH = 37,
    HEIGHT = 5
};

static char folder[64];
static uint8_t picture[WIDTH * HEIGHT * 3];

static int enter(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/sheen_png_XXXXXX");
    for (size_t i = 0; i < sizeof picture; i++)
        picture[i] = (uint8_t)(i * 7919 >> 3);
    return mkdtemp(folder) ? chdir(folder) : -1;
}

static int leave(void **state)
{
    char command[100];

    (void)state;
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

/* Counts the files in the folder, so that temporary ones that were left are noticed. */
static int files(void)
{
    DIR *open = opendir(".");
    int count = -2; /* . and .. */

    while (readdir(open))
        count++;
    closedir(open);
    return count;
}

static void is_picture(const char *path)
{
    struct sheen_problem problem;
    unsigned width, height;
    uint8_t *rgb;

    assert_int_equal(sheen_png_read(path, &rgb, &width, &height, &problem), 0);
    assert_int_equal(width, WIDTH);
    assert_int_equal(height, HEIGHT);
    assert_memory_equal(rgb, picture, sizeof picture);
    free(rgb);
}

static void there_and_back(void **state)
{
    struct sheen_problem problem;
    struct stat status;

    (void)state;
    umask(027);
    assert_int_equal(sheen_png_write("a.png", picture, WIDTH, HEIGHT, &problem), 0);
    is_picture("a.png");
    assert_int_equal(stat("a.png", &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    assert_int_equal(files(), 1);
}

static void a_link_stays_a_link(void **state)
{
    struct sheen_problem problem;
    struct stat status;

    (void)state;
    assert_int_equal(mkdir("far", 0777), 0);
    assert_int_equal(symlink("far/real.png", "link.png"), 0);
    fclose(fopen("far/real.png", "w"));
    assert_int_equal(sheen_png_write("link.png", picture, WIDTH, HEIGHT, &problem), 0);
    assert_int_equal(lstat("link.png", &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    is_picture("far/real.png");
}

static void a_link_to_nothing_yet(void **state)
{
    static const char *const links[] = {"b.png", "new/c.png", "d.png"};
    struct sheen_problem problem;
    struct stat status;

    (void)state;
    assert_int_equal(mkdir("new", 0777), 0);
    assert_int_equal(symlink("new/e.png", "b.png"), 0);
    assert_int_equal(symlink("../b.png", "new/c.png"), 0);
    assert_int_equal(symlink("new/c.png", "d.png"), 0);
    for (size_t i = 0; i < 2; i++) { /* the second time the files exist */
        assert_int_equal(sheen_png_write("d.png", picture, WIDTH, HEIGHT, &problem), 0);
        for (size_t k = 0; k < 3; k++) {
            assert_int_equal(lstat(links[k], &status), 0);
            assert_true(S_ISLNK(status.st_mode));
        }
        assert_int_equal(lstat("new/e.png", &status), 0);
        assert_true(S_ISREG(status.st_mode));
        is_picture("new/e.png");
    }
}

static void a_name_as_long_as_names_are(void **state)
{
    struct sheen_problem problem;
    char name[256];

    (void)state;
    memset(name, 'n', 255);
    strcpy(name + 251, ".png");
    int before = files();
    assert_int_equal(sheen_png_write(name, picture, WIDTH, HEIGHT, &problem), 0);
    is_picture(name);
    assert_int_equal(files(), before + 1);
}

static void refused(const char *path, const char *why)
{
    struct sheen_problem problem = {""};
    int before = files();

    assert_true(sheen_png_write(path, picture, WIDTH, HEIGHT, &problem) < 0);
    if (!strstr(problem.text, path) || !strstr(problem.text, why))
        fail_msg("'%s' should name %s and say '%s'", problem.text, path, why);
    assert_int_equal(files(), before);
}

static void what_cannot_be_written(void **state)
{
    (void)state;
    assert_int_equal(mkdir("folder", 0777), 0);
    refused("folder", "Is a directory");
    refused("nowhere/a.png", "No such file or directory");
    refused("/proc/a.png", "No such file or directory");
    assert_int_equal(symlink("round.png", "round.png"), 0);
    refused("round.png", "Too many levels of symbolic links");
    assert_int_equal(symlink("nowhere/a.png", "astray.png"), 0);
    refused("astray.png", "No such file or directory");
    refused("/dev/full", "No space left on device");
}

static void a_read_only_file_stays(void **state)
{
    struct sheen_problem problem;

    (void)state;
    if (geteuid() == 0) /* root may write anything, so as another user */
        assert_int_equal(seteuid(65534), 0);
    assert_true(sheen_out_file("/etc/passwd", "x", 1, &problem) < 0);
    assert_non_null(strstr(problem.text, "/etc/passwd: Permission denied"));
    if (getuid() == 0)
        assert_int_equal(seteuid(0), 0);
}

static void bytes_that_are_no_png(void **state)
{
    struct sheen_problem problem;
    unsigned width, height;
    uint8_t *rgb = picture;

    (void)state;
    assert_int_equal(sheen_out_file("no.png", "\x89PNG\r\n\x1a\nrubbish", 15, &problem), 0);
    assert_true(sheen_png_read("no.png", &rgb, &width, &height, &problem) < 0);
    assert_null(rgb);
    assert_true(sheen_png_read("absent.png", &rgb, &width, &height, &problem) < 0);
}

static void names_of_frames(void **state)
{
    static const struct {
        const char *pattern, *name;
        int varies;
    } cases[] = {{"a%d.png", "a42.png", 1},
                 {"%04d", "0042", 1},
                 {"a.png", "a.png", 0},
                 {"%d%d.png", "%d%d.png", 0},
                 {"100%.png", "100%.png", 0},
                 {"%s%n.png", "%s%n.png", 0},
                 {"%%d.png", "%42.png", 1},
                 {"%05x.png", "%05x.png", 0},
                 {"%012d", "%012d", 0},
                 {"50%d/a.png", "50%d/a.png", 0},
                 {"%d/%d/a%02d.png", "%d/%d/a42.png", 1}};
    char name[32];

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(sheen_frame_name_varies(cases[i].pattern), cases[i].varies);
        assert_int_equal(sheen_frame_name(name, sizeof name, cases[i].pattern, 42, 43), 0);
        assert_string_equal(name, cases[i].name);
        assert_int_equal(sheen_frame_name(name, sizeof name, cases[i].pattern, 0, 1), 0); /* a single frame */
        assert_string_equal(name, cases[i].pattern);
    }
    assert_int_equal(sheen_frame_name(name, 5, "%d.png", 12, 13), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back),         cmocka_unit_test(a_link_stays_a_link),
        cmocka_unit_test(a_link_to_nothing_yet),  cmocka_unit_test(a_name_as_long_as_names_are),
        cmocka_unit_test(what_cannot_be_written), cmocka_unit_test(a_read_only_file_stays),
        cmocka_unit_test(bytes_that_are_no_png),  cmocka_unit_test(names_of_frames),
    };

    return cmocka_run_group_tests(tests, enter, leave);
}
