/*
 * test_linux_options.c - sheen-panel's options from a file, whose texts stay valid after reading, and the signals that
 * it handles.
 */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "../firmware/linux/options.h"
#include "../firmware/linux/stop.h"

static char path[] = "/tmp/sheen_options_XXXXXX";

/* Reads a file with these bytes as --config. */
static int read_file(struct options *options, const char *bytes, size_t count, struct sheen_failure *why)
{
    char name[] = "sheen-panel", config[] = "--config";
    char *words[] = {name, config, path, NULL};
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
    why->text[0] = '\0';
    return options_read(options, 3, words, why);
}

static void texts_stay(void **state)
{
    static const char text[] = "matcap = chrome\n  texture = /usr/share/a-wood.png # of the table\nmorph=second.obj\n\n"
                               "texture-out = t.png\nfps = 30\npanel = ili9341\nquiet = yes";
    struct options options;
    struct sheen_failure why;

    (void)state;
    assert_int_equal(read_file(&options, text, strlen(text), &why), 0);
    assert_string_equal(options.view.matcap, "chrome");
    assert_string_equal(options.view.texture, "/usr/share/a-wood.png");
    assert_string_equal(options.view.morph, "second.obj");
    assert_string_equal(options.view.texture_out, "t.png");
    assert_string_equal(options.panel, "ili9341");
    assert_int_equal(options.quiet, 1);
    free(options.file);
}

static void wrong_files(void **state)
{
    static const char zero[] = "fps = 30\n\0quiet = yes\n";
    static char longest[4096 + 16];
    struct options options;
    struct sheen_failure why;

    (void)state;
    assert_int_equal(read_file(&options, "", 0, &why), 0);
    free(options.file);
    assert_int_equal(read_file(&options, zero, sizeof zero - 1, &why), 1);
    assert_non_null(strstr(why.text, ": holds a zero byte"));
    assert_int_equal(read_file(&options, "fps = 30\nfps\n", 13, &why), 1);
    assert_non_null(strstr(why.text, ":2: 'fps' is not of the form name = value"));
    free(options.file);
    memset(longest, '#', sizeof longest - 1);
    longest[0] = '\n';
    assert_int_equal(read_file(&options, longest, 4095, &why), 0);
    free(options.file);
    assert_int_equal(read_file(&options, longest, 4096, &why), 1);
    assert_non_null(strstr(why.text, ":2: a line longer than 4094 characters"));
    free(options.file);
}

/*
 * Starts a process that handles signals, sends it one at each of the times (ms from now; 0 ends them). Returns the
 * signal that ended it; 0: it was asked to stop.
 */
static int stopped_by(int number, const unsigned *times)
{
    int status;
    pid_t child = fork();

    if (child == 0) {
        stop_watch();
        for (unsigned passed = 0; *times; passed = *times++) {
            usleep((*times - passed) * 1000);
            (void)raise(number);
        }
        _exit(stop_asked() ? 0 : 99);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/*
 * Two in a row are one request; a second later, one ends the program at once, however many came before. SIGPIPE does
 * not: whoever read the output may have been stopped by the same Ctrl-C, and be missed only at the next line.
 */
static void signals_twice(void **state)
{
    static const int all[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    static const unsigned once[] = {1, 0}, twice[] = {1, 20, 0}, late[] = {1, 20, 1200, 0};

    (void)state;
    (void)signal(SIGHUP, SIG_DFL);
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        assert_int_equal(stopped_by(all[i], once), 0);
        assert_int_equal(stopped_by(all[i], twice), 0);
    }
    assert_int_equal(stopped_by(SIGTERM, late), SIGTERM);
    assert_int_equal(stopped_by(SIGPIPE, late), 0);
}

/* SIGHUP and SIGPIPE stay ignored if they were ignored at the start, as under nohup; SIGINT stops the program. */
static void signals(void **state)
{
    (void)state;
    (void)signal(SIGHUP, SIG_IGN);
    (void)signal(SIGPIPE, SIG_IGN);
    (void)signal(SIGINT, SIG_IGN);
    stop_watch();
    assert_int_equal(raise(SIGHUP), 0);
    assert_int_equal(raise(SIGPIPE), 0);
    assert_int_equal(stop_asked(), 0);
    assert_int_equal(raise(SIGINT), 0);
    assert_int_equal(stop_asked(), 1);
}

static int make_file(void **state)
{
    const int fd = mkstemp(path);

    (void)state;
    return fd < 0 ? -1 : close(fd);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts_stay),
        cmocka_unit_test(wrong_files),
        cmocka_unit_test(signals_twice), /* before the next, which asks this process to stop */
        cmocka_unit_test(signals),
    };

    return cmocka_run_group_tests_name("linux options", tests, make_file, remove_file);
}
