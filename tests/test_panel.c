/*
 * test_panel.c - the shipped panel drivers on simulated panels, with every record in every orientation, against an
 * ideal memory that was pushed the same pixels.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "test_panel_canvas.h"

/* A whole picture and then 60 windows of noise must equal the ideal memory, without a complaint. */
static void equals_ideal(struct canvas *canvas, const char *name, unsigned orientation)
{
    assert_int_equal(canvas_push_all(canvas, 16), 0);
    if (canvas_differences(canvas))
        fail_msg("%s, orientation %u: %u pixels differ", name, orientation, canvas_differences(canvas));
    for (unsigned n = 0; n < 60; n++)
        assert_int_equal(canvas_push(canvas, canvas_rect(canvas)), 0);
    if (canvas_differences(canvas))
        fail_msg("%s, orientation %u, windows: %u pixels differ", name, orientation, canvas_differences(canvas));
    canvas_quiet(canvas);
}

static void every_record_and_orientation(void **state)
{
    const struct sheen_panel_record *record;
    struct canvas canvas;
    size_t i;

    (void)state;
    for (i = 0; (record = sheen_panel_at(i)); i++) {
        for (unsigned k = 0; k < 8; k++) {
            canvas_open(&canvas, record->name, (int)k, 0, 0);
            equals_ideal(&canvas, record->name, k);
            canvas_close(&canvas);
        }
    }
    assert_int_equal(i, 33);
}

static void ideal_of_any_size(void **state)
{
    static const uint16_t sizes[][2] = {{8, 8}, {33, 17}, {640, 480}};
    struct canvas canvas;

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        canvas_open(&canvas, "ideal", (int)i, sizes[i][0], sizes[i][1]);
        assert_int_equal(canvas.target->width, sizes[i][0]);
        equals_ideal(&canvas, "ideal", (unsigned)i);
        canvas_close(&canvas);
    }
}

/* The same pushes send the same to `ideal` and to a panel; window commands are sent only if the window changes. */
static void windows_only_when_they_change(void **state)
{
    static const struct {
        struct sheen_rect rect;
        unsigned bytes, commands, transactions;
    } pushes[] = {
        {{0, 0, 320, 16}, 5 + 5 + 1 + 10240, 3, 3},  /* both */
        {{0, 16, 320, 32}, 5 + 1 + 10240, 2, 2},     /* rows */
        {{0, 16, 320, 32}, 1 + 10240, 1, 1},         /* neither */
        {{10, 16, 11, 32}, 5 + 1 + 32, 2, 2},        /* columns */
        {{10, 17, 11, 32}, 5 + 1 + 30, 2, 2},        /* rows: only the start */
        {{319, 239, 320, 240}, 5 + 5 + 1 + 2, 3, 3}, /* both */
    };
    static const char *const names[] = {"ili9341", "ideal"};

    (void)state;
    for (size_t p = 0; p < 2; p++) {
        struct canvas canvas;

        canvas_open(&canvas, names[p], -1, 320, 240);
        assert_int_equal(sheen_sim_panel_init(canvas.panel), 0);
        for (size_t i = 0; i < sizeof pushes / sizeof pushes[0]; i++) {
            struct sheen_sim_bus *bus = sheen_sim_panel_bus(canvas.panel);
            struct sheen_sim_counters is;

            sheen_sim_bus_counters_reset(bus);
            assert_int_equal(canvas_push(&canvas, pushes[i].rect), 0);
            is = sheen_sim_bus_counters(bus);
            assert_int_equal(is.bytes, pushes[i].bytes);
            assert_int_equal(is.commands, pushes[i].commands);
            assert_int_equal(is.transactions, pushes[i].transactions);
            assert_int_equal(is.rectangles, 1);
        }
        canvas_quiet(&canvas);
        canvas_close(&canvas);
    }
}

/* The pixels of a push may be under way when it returns, nothing else; the next push waits for them. */
static void pixels_fly_until_the_wait(void **state)
{
    struct canvas canvas;
    struct sheen_sim_bus *bus;
    static uint8_t pixel[2][2] = {{0xF8, 0x00}, {0x07, 0xE0}};

    (void)state;
    canvas_open(&canvas, "ili9341", -1, 0, 0);
    bus = sheen_sim_panel_bus(canvas.panel);
    assert_int_equal(sheen_sim_panel_init(canvas.panel), 0);
    assert_null(bus->flight);
    assert_int_equal(canvas.target->push(canvas.target->ctx, (struct sheen_rect){0, 0, 1, 1}, pixel[0]), 0);
    assert_ptr_equal(bus->flight, pixel[0]);
    assert_int_equal(sheen_sim_panel_picture(canvas.panel, canvas.seen), SHEEN_ERR_STATE);
    assert_int_equal(canvas.target->push(canvas.target->ctx, (struct sheen_rect){1, 0, 2, 1}, pixel[1]), 0);
    assert_ptr_equal(bus->flight, pixel[1]);
    assert_int_equal(canvas.target->wait(canvas.target->ctx), 0);
    assert_int_equal(canvas.target->wait(canvas.target->ctx), 0);
    assert_int_equal(sheen_sim_panel_picture(canvas.panel, canvas.seen), 0);
    assert_int_equal(canvas.seen[0], 0xF800);
    assert_int_equal(canvas.seen[1], 0x07E0);
    canvas_quiet(&canvas);

    canvas.target->push(canvas.target->ctx, (struct sheen_rect){0, 0, 1, 1}, pixel[0]);
    pixel[0][0] = 0;
    canvas.target->wait(canvas.target->ctx);
    assert_int_equal(sheen_sim_panel_complaints(canvas.panel), 1);
    assert_non_null(strstr(sheen_sim_panel_complaint(canvas.panel), "touched before wait"));
    canvas_close(&canvas);
}

/* A panel is initialised by its first push, and not again unless something fails. */
static void initialises_once(void **state)
{
    struct canvas canvas;

    (void)state;
    canvas_open(&canvas, "ili9341", -1, 0, 0);
    assert_int_equal(sheen_sim_panel_bus(canvas.panel)->operations, 0);
    assert_int_equal(canvas_push(&canvas, (struct sheen_rect){0, 0, 320, 1}), 0);
    uint64_t first = sheen_sim_panel_bus(canvas.panel)->operations;
    assert_int_equal(canvas_push(&canvas, (struct sheen_rect){0, 0, 320, 1}), 0);
    assert_true(first > 15);
    /* RAMWR with pixels, and the wait for it */
    assert_int_equal(sheen_sim_panel_bus(canvas.panel)->operations - first, 2);
    canvas_close(&canvas);
}

/* Two panels with different drivers, pushed to in turns, do not affect each other. */
static void two_at_once(void **state)
{
    struct canvas canvas[2];

    (void)state;
    canvas_open(&canvas[0], "st7789-135x240", 3, 0, 0);
    canvas_open(&canvas[1], "ssd1306", 5, 0, 0);
    assert_int_equal(canvas_push_all(&canvas[0], 16), 0);
    assert_int_equal(canvas_push_all(&canvas[1], 16), 0);
    for (unsigned n = 0; n < 100; n++)
        assert_int_equal(canvas_push(&canvas[n & 1], canvas_rect(&canvas[n & 1])), 0);
    for (unsigned i = 0; i < 2; i++) {
        assert_int_equal(canvas_differences(&canvas[i]), 0);
        canvas_quiet(&canvas[i]);
        canvas_close(&canvas[i]);
    }
}

static void bad_rectangles(void **state)
{
    static const struct sheen_rect bad[] = {{-1, 0, 8, 8},  {0, -1, 8, 8}, {0, 0, 321, 8},
                                            {0, 0, 8, 241}, {8, 0, 8, 8},  {0, 9, 8, 8}};
    struct canvas canvas;
    const struct sheen_target *target;

    (void)state;
    canvas_open(&canvas, "ili9341", -1, 0, 0);
    target = canvas.target;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_int_equal(target->push(target->ctx, bad[i], canvas.buffer), SHEEN_ERR_ARGUMENT);
    assert_int_equal(target->push(target->ctx, (struct sheen_rect){0, 0, 8, 8}, NULL), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_sim_panel_bus(canvas.panel)->operations, 0);
    canvas_close(&canvas);
}

static void bad_records(void **state)
{
    struct sheen_sim_panel *sim;
    struct sheen_sim_choice choice = {.width = 8, .height = 8};
    struct sheen_panel panel;
    struct sheen_panel_record record = *sheen_panel_find("ili9341");

    (void)state;
    assert_int_equal(sheen_sim_panel_open(&sim, &choice), 0);
    const struct sheen_bus *bus = &sheen_sim_panel_bus(sim)->bus;

    assert_int_equal(sheen_panel_open(&panel, &record, bus, 7), 0);
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 8), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_panel_open(&panel, NULL, bus, 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_panel_open(&panel, &record, NULL, 0), SHEEN_ERR_ARGUMENT);
    record.gap_x = 1;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT);
    record.glass_w = 239;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), 0);
    for (uint8_t pixel = SHEEN_RGB565_LE; pixel <= SHEEN_GREY256; pixel++) {
        record.pixel = pixel;
        assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT);
    }
    record.driver = &sheen_driver_grey;
    record.pixel = SHEEN_RGB565_BE; /* the same as if it were left out */
    record.glass_w = 238;
    record.gap_x = 2;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT);
    record.glass_w = 239;
    record.gap_x = 1;
    record.pixel = SHEEN_GREY16; /* half a byte per row */
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT);
    record.glass_w = 238;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT); /* the gap is odd */
    record.gap_x = 2;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), 0);
    record.driver = &sheen_driver_ssd1306;
    record.pixel = SHEEN_GREY2;
    record.glass_w = 232;
    record.glass_h = 312;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), 0);
    record.gap_y = 4;
    assert_int_equal(sheen_panel_open(&panel, &record, bus, 0), SHEEN_ERR_ARGUMENT); /* half a page */
    sheen_sim_panel_close(sim);
}

static void names(void **state)
{
    (void)state;
    assert_ptr_equal(sheen_panel_find("ili9341"), sheen_panel_find("ili9341-240x320"));
    assert_non_null(sheen_panel_find("ili9341"));
    assert_ptr_equal(sheen_panel_find("ILI9341"), sheen_panel_find("ili9341"));
    assert_ptr_equal(sheen_panel_find("St7735-128X160-Red"), sheen_panel_find("st7735-128x160-red"));
    assert_null(sheen_panel_find("ili934"));
    assert_null(sheen_panel_find("ili9341-"));
    assert_null(sheen_panel_find("ili9341-240x3200"));
    assert_null(sheen_panel_find(""));
    assert_null(sheen_panel_find(NULL));
    for (size_t i = 0; sheen_panel_at(i); i++)
        assert_ptr_equal(sheen_panel_find(sheen_panel_at(i)->name), sheen_panel_at(i));
}

#define CHOICE(panel, k, w, h) sheen_sim_choose(&choice, panel, k, w, h, why, sizeof why)

static void assert_choice(const struct sheen_sim_choice *choice, unsigned orientation, unsigned width, unsigned height)
{
    assert_int_equal(choice->orientation, orientation);
    assert_int_equal(choice->width, width);
    assert_int_equal(choice->height, height);
}

static void choices(void **state)
{
    struct sheen_sim_choice choice;
    char why[160];

    (void)state;
    assert_int_equal(CHOICE("ili9341", -1, 0, 0), 0);
    assert_choice(&choice, 1, 320, 240);
    assert_int_equal(CHOICE("ili9341", 4, 0, 0), 0);
    assert_choice(&choice, 4, 240, 320);
    assert_int_equal(CHOICE("ili9341", -1, 240, 320), 0);
    assert_choice(&choice, 0, 240, 320);
    assert_int_equal(CHOICE("ili9341", -1, 320, 240), 0);
    assert_choice(&choice, 1, 320, 240);
    assert_int_equal(CHOICE("ili9341", 7, 320, 240), 0);
    assert_choice(&choice, 7, 320, 240);
    assert_int_equal(CHOICE("ili9341", 0, 320, 240), SHEEN_ERR_ARGUMENT);
    assert_string_equal(why, "ili9341-240x320 in orientation 0 is 240x320, not 320x240");
    assert_int_equal(CHOICE("ili9341", -1, 100, 100), SHEEN_ERR_ARGUMENT);
    assert_string_equal(why, "ili9341-240x320 is 240x320 or 320x240, not 100x100");
    assert_int_equal(CHOICE("ili9342", -1, 0, 0), SHEEN_ERR_ARGUMENT);
    assert_string_equal(why, "no panel is called 'ili9342'; the nearest is ili9341 (`sheen panels` lists them)");
    assert_int_equal(CHOICE("Ideal", -1, 0, 0), SHEEN_OK);
    assert_null(choice.record);
    assert_int_equal(CHOICE("SSD1306-128X32", -1, 0, 0), SHEEN_OK);
    assert_string_equal(choice.record->name, "ssd1306-128x32");
    assert_int_equal(CHOICE("ili9341", 8, 0, 0), SHEEN_ERR_ARGUMENT);

    assert_int_equal(CHOICE("ideal", -1, 0, 0), 0);
    assert_choice(&choice, 0, 320, 240);
    assert_int_equal(CHOICE("ideal", 5, 8, 480), 0);
    assert_choice(&choice, 5, 8, 480);
    assert_int_equal(CHOICE("ideal", -1, 7, 8), SHEEN_ERR_ARGUMENT);
    assert_int_equal(CHOICE("ideal", -1, 640, 481), SHEEN_ERR_ARGUMENT);
    assert_string_equal(why, "ideal takes sizes from 8x8 to 640x480, not 640x481");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_record_and_orientation),
        cmocka_unit_test(ideal_of_any_size),
        cmocka_unit_test(windows_only_when_they_change),
        cmocka_unit_test(pixels_fly_until_the_wait),
        cmocka_unit_test(initialises_once),
        cmocka_unit_test(two_at_once),
        cmocka_unit_test(bad_rectangles),
        cmocka_unit_test(bad_records),
        cmocka_unit_test(names),
        cmocka_unit_test(choices),
    };

    return cmocka_run_group_tests_name("panel", tests, NULL, NULL);
}
