/*
 * test_problem.c - messages are valid UTF-8 of bounded length, whatever they were made from.
 */
#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <wctype.h>

#include <cmocka.h>

#include "problem.h"
#include "utf8.h"

/* Counts characters as the C library does in a UTF-8 locale; fails if the text is not valid. */
static size_t judge(const char *text)
{
    wchar_t wide[2048];
    size_t count = mbstowcs(wide, text, 2048);

    assert_true(count < 2048);
    for (size_t i = 0; i < count; i++)
        assert_false(iswcntrl((wint_t)wide[i]));
    return count;
}

static uint32_t next(uint32_t *state)
{
    return *state = *state * 1664525u + 1013904223u;
}

/* Fills the text with many whole, truncated, overlong and forbidden sequences. */
static void fill(char *text, size_t length, uint32_t *state)
{
    static const char pieces[][5] = {"a",
                                     " ",
                                     "/",
                                     "\n",
                                     "\xc3\xa4",
                                     "\xe2\x82\xac",
                                     "\xf0\x9f\x90\x87",
                                     "\xc0\x80",
                                     "\xed\xa0\x80",
                                     "\xf4\x90\x80\x80",
                                     "\x80",
                                     "\xff",
                                     "\xe2\x80\xae",
                                     "\xc2\x85",
                                     "\x7f",
                                     "\xf0\x9f",
                                     "bc",
                                     "d"};
    size_t at = 0;

    while (at < length) {
        const char *piece = pieces[(next(state) >> 8) % (sizeof pieces / sizeof pieces[0])];
        for (; *piece && at < length; piece++)
            text[at++] = *piece;
    }
    text[length] = '\0';
}

static void any_bytes_become_a_line(void **ctx)
{
    struct sheen_problem problem;
    uint32_t state = 1;
    char text[1200];

    (void)ctx;
    for (int turn = 0; turn < 100000; turn++) {
        fill(text, (next(&state) >> 8) % (sizeof text - 1), &state);
        assert_int_equal(sheen_problem(&problem, -3, "%s", text), -3);
        assert_true(judge(problem.text) <= SHEEN_PROBLEM_MAX);
    }
}

/* A copy holds as many whole characters as fit, and no more. */
static void copies_are_cut_between_characters(void **ctx)
{
    static const char text[] = "a\xc3\xa4\xe2\x82\xac\xf0\x9f\x90\x87z";
    static const size_t fits[] = {0, 0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 11, 11};

    (void)ctx;
    for (size_t size = 1; size < sizeof fits / sizeof fits[0]; size++) {
        char copy[16];
        sheen_utf8_copy(copy, size, text);
        assert_int_equal(strlen(copy), fits[size]);
        assert_memory_equal(copy, text, fits[size]);
    }
}

/* All first and second bytes, with the others at the ends of their ranges, must be read as the C library reads them. */
static void characters_are_those_of_the_library(void **ctx)
{
    static const unsigned char inner[] = {0, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xff};
    enum {
        INNERS = sizeof inner
    };

    (void)ctx;
    for (unsigned first = 0; first < 256; first++) {
        for (unsigned second = 0; second < 256; second++) {
            for (unsigned rest = 0; rest < INNERS * INNERS; rest++) {
                char text[5] = {(char)first, (char)second, (char)inner[rest / INNERS], (char)inner[rest % INNERS], 0};
                mbstate_t start = {0};
                wchar_t wide;
                size_t bytes = mbrtowc(&wide, text, strlen(text) + 1, &start);
                int valid =
                    bytes <= 4 && wide <= 0x10ffff && (wide < 0xd800 || wide > 0xdfff); /* the library accepts more */
                assert_int_equal(sheen_utf8_bytes(text), valid ? bytes : 0);
            }
        }
    }
}

static void what_is_clean_and_short_stays(void **ctx)
{
    struct sheen_problem problem;

    (void)ctx;
    sheen_problem(&problem, 0, "%s:%d: '%s' is no number",
                  "stra\xc3\x9f"
                  "e.obj",
                  7, "\xe2\x82\xac");
    assert_string_equal(problem.text, "stra\xc3\x9f"
                                      "e.obj:7: '\xe2\x82\xac' is no number");
}

/* A long path is shortened in the middle, so that both its ends and all that is said about it stay. */
static void a_path_gives_way_before_words(void **ctx)
{
    static const char what[] = ":41: a face names vertex 9 of 8, and there is a long explanation of the way out of it";
    char path[2000] = "/begin";
    struct sheen_problem problem;

    (void)ctx;
    for (int i = 0; i < 150; i++)
        strcat(path, "/folder");
    sheen_problem(&problem, 0, "%s/last.obj%s", path, what);
    assert_int_equal(judge(problem.text), SHEEN_PROBLEM_MAX);
    assert_memory_equal(problem.text, "/begin", 6);
    assert_non_null(strstr(problem.text, "..."));
    assert_non_null(strstr(problem.text, "/last.obj"));
    assert_string_equal(problem.text + strlen(problem.text) - strlen(what), what);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bytes_become_a_line),
        cmocka_unit_test(copies_are_cut_between_characters),
        cmocka_unit_test(characters_are_those_of_the_library),
        cmocka_unit_test(what_is_clean_and_short_stays),
        cmocka_unit_test(a_path_gives_way_before_words),
    };

    if (!setlocale(LC_ALL, "C.UTF-8"))
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
