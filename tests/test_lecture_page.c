/*
 * test_lecture_page.c - a page of the lecture reports which of its texts cannot be read.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <fontconfig/fontconfig.h>

#include "lecture_plot.h"
#include "sheen.h"

static struct sheen_page page, sheet;
static struct sheen_problem problem;

static void open_page(void)
{
    assert_int_equal(sheen_page_open(&page, "page", SHEEN_RECORD, SHEEN_PAGE_WIDTH, SHEEN_PAGE_HEIGHT), SHEEN_OK);
    sheen_page_title(&page, "Title", "Its claim, in a line.");
    sheen_page_caption(&page, "What is seen.");
    page.heart = (struct sheen_box){100, 100, 400, 300};
}

static void refused(const char *why)
{
    assert_int_equal(sheen_page_check(&page, &problem), SHEEN_ERR_ARGUMENT);
    if (!strstr(problem.text, why))
        fail_msg("'%s' does not say '%s'", problem.text, why);
    sheen_page_close(&page);
}

static void test_whole(void **state)
{
    (void)state;
    open_page();
    sheen_page_text(&page, 110, 200, SHEEN_LEFT, SHEEN_INK_TEXT, "inside the heart");
    sheen_page_text(&page, 990, 200, SHEEN_RIGHT, SHEEN_INK_TEXT, "beside it");
    assert_int_equal(sheen_page_check(&page, &problem), SHEEN_OK);
    assert_int_equal(page.texts, 5);
    sheen_page_close(&page);
}

static void test_leaves(void **state)
{
    static const double at[4][2] = {{-3, 200}, {960, 200}, {500, 8}, {500, 653}};

    (void)state;
    for (int i = 0; i < 4; i++) {
        open_page();
        sheen_page_text(&page, at[i][0], at[i][1], SHEEN_LEFT, SHEEN_INK_TEXT, "typography");
        refused("'typography' leaves the page");
    }
}

static void test_touches(void **state)
{
    (void)state;
    open_page();
    sheen_page_text(&page, 500, 200, SHEEN_LEFT, SHEEN_INK_TEXT, "first");
    sheen_page_text(&page, 510, 208, SHEEN_LEFT, SHEEN_INK_TEXT, "second");
    refused("'second' touches");
}

static void test_heart(void **state)
{
    (void)state;
    open_page();
    sheen_page_text(&page, 395, 200, SHEEN_LEFT, SHEEN_INK_TEXT, "across its edge");
    refused("'across its edge' is cut");
    open_page();
    page.heart = (struct sheen_box){0, 100, 1000, 580};
    sheen_page_text(&page, 395, 200, SHEEN_LEFT, SHEEN_INK_TEXT, "shown smaller");
    refused("'shown smaller' is too small on the contact sheet");
}

static void test_small(void **state)
{
    (void)state;
    open_page();
    sheen_page_lines(&page, 500, 200, 300, SHEEN_SMALLEST_TYPE - 1, 0, SHEEN_INK_TEXT, "fine print");
    refused("'fine print' is too small");
}

static void test_many(void **state)
{
    (void)state;
    open_page();
    for (int i = 0; i < SHEEN_PAGE_TEXTS; i++)
        sheen_page_text(&page, 20.0 + 30 * (i % 30), 120.0 + 30.0 * (i / 30), SHEEN_LEFT, SHEEN_INK_TEXT, "i");
    assert_int_equal(sheen_page_check(&page, &problem), SHEEN_ERR_CAPACITY);
    sheen_page_close(&page);
}

/* A claim that takes more lines than a cell has room for. */
static void test_sheet(void **state)
{
    static const char *const claims[2] = {"Short.", "A claim so long that it takes more than the two lines that there "
                                                    "are above the figure of a cell on the contact sheet."};

    (void)state;
    for (int i = 0; i < 2; i++) {
        open_page();
        page.claim = claims[i];
        assert_int_equal(sheen_page_sheet(&sheet, &page, 1), SHEEN_OK);
        int error = sheen_page_check(&sheet, &problem);
        assert_int_equal(error, i ? SHEEN_ERR_ARGUMENT : SHEEN_OK);
        if (i)
            assert_non_null(strstr(problem.text, "runs into a figure"));
        sheen_page_close(&sheet);
        sheen_page_close(&page);
    }
}

/* Lines break at spaces, and no text is lost. */
static void test_lines(void **state)
{
    (void)state;
    open_page();
    int before = page.texts;
    double last = sheen_page_lines(&page, 500, 200, 120, 16, 0, SHEEN_INK_TEXT, "one two three four five six seven");
    assert_true(page.texts - before >= 2);
    assert_true(last > 200 + 1.2 * 16 * (page.texts - before - 1));
    for (int i = before; i < page.texts; i++)
        assert_true(page.text[i].box.x1 <= 500 + 121);
    assert_string_equal(page.text[page.texts - 1].start + strlen(page.text[page.texts - 1].start) - 5, "seven");
    assert_int_equal(sheen_page_check(&page, &problem), SHEEN_OK);
    sheen_page_close(&page);
}

static int leave(void **state)
{
    (void)state;
    cairo_debug_reset_static_data();
    FcFini();
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole), cmocka_unit_test(test_leaves), cmocka_unit_test(test_touches),
        cmocka_unit_test(test_heart), cmocka_unit_test(test_small),  cmocka_unit_test(test_many),
        cmocka_unit_test(test_sheet), cmocka_unit_test(test_lines),
    };

    return cmocka_run_group_tests(tests, NULL, leave);
}
