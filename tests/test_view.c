/*
 * test_view.c - how a glass looks, and pictures as text: every value against what it must be.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "terminal.h"
#include "view_glass.h"

/* Two pixels, red and grey 128. */
static const uint8_t pair[2][3] = {{255, 0, 0}, {128, 128, 128}};

static int all(const void *panel, unsigned x, unsigned y)
{
    (void)panel, (void)x, (void)y;
    return 1;
}

static int right_only(const void *panel, unsigned x, unsigned y)
{
    (void)panel, (void)y;
    return x == 1;
}

static void test_plain(void **state)
{
    struct sheen_glass_picture picture = {&pair[0][0], 2, 1, all, NULL};
    struct sheen_glass_look look = {SHEEN_THEME_PLAIN, 1, 0};
    uint32_t out[2];

    (void)state;
    sheen_glass_draw(&picture, &look, out, 2);
    assert_int_equal(out[0], 0xff0000);
    assert_int_equal(out[1], 0x808080);
}

/* Scale 3, gap 1: lit squares of 2 px, the gap to the right and below; nothing is written past the stride. */
static void test_gap(void **state)
{
    struct sheen_glass_picture picture = {&pair[0][0], 2, 1, all, NULL};
    struct sheen_glass_look look = {SHEEN_THEME_PLAIN, 3, 1};
    const uint32_t r = 0xff0000, g = 0x808080, past = 0x12345678;
    const uint32_t expected[3][7] = {{r, r, 0, g, g, 0, past}, {r, r, 0, g, g, 0, past}, {0, 0, 0, 0, 0, 0, past}};
    uint32_t out[3][7];

    (void)state;
    for (unsigned i = 0; i < 21; i++)
        out[i / 7][i % 7] = past;
    sheen_glass_draw(&picture, &look, &out[0][0], 7);
    assert_memory_equal(out, expected, sizeof out);
}

/* Where a round glass has no pixel there is bezel, also in the gap. */
static void test_mask(void **state)
{
    struct sheen_glass_picture picture = {&pair[0][0], 2, 1, right_only, NULL};
    struct sheen_glass_look look = {SHEEN_THEME_PLAIN, 2, 1};
    const uint32_t expected[2][4] = {{SHEEN_BEZEL, SHEEN_BEZEL, 0x808080, 0}, {SHEEN_BEZEL, SHEEN_BEZEL, 0, 0}};
    uint32_t out[2][4];

    (void)state;
    sheen_glass_draw(&picture, &look, &out[0][0], 4);
    assert_memory_equal(out, expected, sizeof out);
}

/* Colours are linear between off and on: a dark LCD pixel glows, a yellow OLED has one colour. */
static void test_themes(void **state)
{
    static const uint8_t black[3] = {0, 0, 0}, white[3] = {255, 255, 255}, half[3] = {51, 51, 51};

    (void)state;
    assert_int_equal(sheen_theme_colour(SHEEN_THEME_OLED, black), 0);
    assert_int_not_equal(sheen_theme_colour(SHEEN_THEME_LCD, black), 0);
    assert_int_equal(sheen_theme_colour(SHEEN_THEME_YELLOW, white), 0xffd53a);
    assert_int_equal(sheen_theme_colour(SHEEN_THEME_YELLOW, half), 0x332b0c); /* a fifth, rounded */
    for (int theme = SHEEN_THEME_PLAIN; theme < SHEEN_THEMES; theme++) {
        for (int other = SHEEN_THEME_PLAIN; other < theme; other++) {
            assert_string_not_equal(sheen_theme_name((enum sheen_theme)theme),
                                    sheen_theme_name((enum sheen_theme)other));
            assert_int_not_equal(sheen_theme_colour((enum sheen_theme)theme, white),
                                 sheen_theme_colour((enum sheen_theme)other, white));
        }
    }
}

/* ---- text ---- */

static void expect_size(unsigned width, unsigned height, unsigned max_columns, unsigned max_rows, unsigned columns,
                        unsigned rows)
{
    unsigned c, r;

    sheen_terminal_size(width, height, max_columns, max_rows, &c, &r);
    assert_int_equal(c, columns);
    assert_int_equal(r, rows);
}

static void test_terminal_size(void **state)
{
    (void)state;
    expect_size(320, 240, 80, 100, 80, 30); /* a character is two squares high */
    expect_size(320, 240, 80, 21, 56, 21);  /* limited by the height */
    expect_size(240, 320, 80, 24, 36, 24);
    expect_size(40, 20, 200, 100, 40, 10); /* not larger than the picture */
    expect_size(8, 9, 200, 100, 8, 5);
    expect_size(640, 8, 10, 1, 10, 1);
    expect_size(320, 240, 0, 0, 1, 1); /* a terminal that reports no size */
    expect_size(8, 480, 80, 24, 1, 24);
}

static void expect_text(const uint8_t *rgb, unsigned width, unsigned height, unsigned columns, unsigned rows,
                        const char *expected)
{
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);

    assert_non_null(stream);
    sheen_terminal_picture(stream, rgb, width, height, columns, rows, "\n");
    fclose(stream);
    assert_string_equal(text, expected);
    free(text);
}

/* A cell's upper pixel is its foreground, the lower one its background; unchanged colours are not repeated. */
static void test_terminal_picture(void **state)
{
    static const uint8_t picture[2][3][3] = {{{1, 2, 3}, {1, 2, 3}, {9, 9, 9}}, {{4, 5, 6}, {7, 8, 9}, {7, 8, 9}}};

    (void)state;
    expect_text(&picture[0][0][0], 3, 2, 3, 1,
                "\x1b[38;2;1;2;3m\x1b[48;2;4;5;6m\u2580"
                "\x1b[48;2;7;8;9m\u2580"
                "\x1b[38;2;9;9;9m\u2580\x1b[0m\n");
}

/* Half a cell has the mean of its pixels, rounded to nearest, halves up. */
static void test_terminal_mean(void **state)
{
    static const uint8_t picture[4][2][3] = {
        {{0, 10, 255}, {1, 10, 255}}, {{0, 20, 255}, {1, 21, 255}}, {{0, 0, 0}, {0, 0, 0}}, {{3, 3, 3}, {0, 0, 3}}};

    (void)state;
    expect_text(&picture[0][0][0], 2, 4, 1, 1, "\x1b[38;2;1;15;255m\x1b[48;2;1;1;2m\u2580\x1b[0m\n");
}

/* An odd height and fewer cells than pixels: every pixel counts, and none is read outside the picture. */
static void test_terminal_odd(void **state)
{
    uint8_t *picture = malloc(3 * 3 * 3); /* allocated, so that the sanitizer watches its end */
    const char *expected = "\x1b[38;2;10;10;10m\x1b[48;2;10;10;10m\u2580\u2580\x1b[0m\n"
                           "\x1b[38;2;40;40;40m\x1b[48;2;70;70;70m\u2580\u2580\x1b[0m\n";

    (void)state;
    assert_non_null(picture);
    for (int i = 0; i < 27; i++)
        picture[i] = (uint8_t)(10 + 30 * (i / 9));
    expect_text(picture, 3, 3, 2, 2, expected);
    free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_plain),         cmocka_unit_test(test_gap),
        cmocka_unit_test(test_mask),          cmocka_unit_test(test_themes),
        cmocka_unit_test(test_terminal_size), cmocka_unit_test(test_terminal_picture),
        cmocka_unit_test(test_terminal_mean), cmocka_unit_test(test_terminal_odd),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
