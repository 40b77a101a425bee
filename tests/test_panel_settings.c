/*
 * test_panel_settings.c - settings of an open panel: orientation, brightness and TE output; and a bus that others use
 * too.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../firmware/examples/own_module/record.h"
#include "test_panel_canvas.h"

#define BAND 16 /* rows per push */

static struct sheen_sim_bus *bus_of(const struct canvas *canvas)
{
    return sheen_sim_panel_bus(canvas->panel);
}

/* Every panel, lit in one orientation and then turned to another, must show what a panel opened in that one shows. */
static void turned_while_open(void **state)
{
    const struct sheen_panel_record *record;

    (void)state;
    for (size_t i = 0; (record = sheen_panel_at(i)); i++) {
        for (unsigned k = 0; k < 8; k++) {
            struct canvas canvas;
            struct sheen_target target;
            uint64_t operations;

            canvas_open(&canvas, record->name, (int)k, 0, 0); /* the viewer looks at it as in orientation k */
            assert_int_equal(sheen_panel_turn(sheen_sim_panel_driver(canvas.panel), (k + 5) % 8), 0);
            assert_int_equal(bus_of(&canvas)->operations, 0); /* not lit yet, so nothing is sent */
            assert_int_equal(sheen_sim_panel_init(canvas.panel), 0);
            operations = bus_of(&canvas)->operations;
            assert_int_equal(sheen_panel_turn(sheen_sim_panel_driver(canvas.panel), k), 0);
            assert_true(bus_of(&canvas)->operations - operations <= 4); /* the panel is not initialised again */
            assert_int_equal(sheen_panel_target(sheen_sim_panel_driver(canvas.panel), &target), 0);
            canvas.target = &target;
            assert_int_equal(canvas_push_all(&canvas, BAND), 0);
            if (canvas_differences(&canvas))
                fail_msg("%s, turned to %u: %u pixels differ", record->name, k, canvas_differences(&canvas));
            canvas_quiet(&canvas);
            canvas_close(&canvas);
        }
    }
}

static void turning_fails_and_heals(void **state)
{
    struct canvas canvas;

    (void)state;
    canvas_open(&canvas, "ili9341", 2, 0, 0);
    assert_int_equal(sheen_panel_turn(sheen_sim_panel_driver(canvas.panel), 8), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_sim_panel_init(canvas.panel), 0);
    assert_int_equal(sheen_panel_turn(sheen_sim_panel_driver(canvas.panel), 6), 0);
    sheen_sim_bus_fault(bus_of(&canvas), SHEEN_FAULT_ERROR, 0);
    assert_int_equal(sheen_panel_turn(sheen_sim_panel_driver(canvas.panel), 2), SHEEN_ERR_BUS);
    assert_int_equal(canvas_push_all(&canvas, BAND), 0); /* initialised again, in orientation 2 */
    assert_int_equal(canvas_differences(&canvas), 0);
    canvas_close(&canvas);
}

/* The register's value for each level; DCS panels obey it once 53 was sent. */
static void brightness_reaches_the_register(void **state)
{
    static const struct {
        const char *panel;
        unsigned level, value;
    } cases[] = {
        {"ili9341", 200, 200},       {"st7789-240x240", 0, 0}, {"gc9a01", 255, 255}, {"st7796", 7, 7},
        {"ssd1351-128x96", 255, 15}, {"ssd1325", 255, 127},    {"ssd0323", 3, 1},    {"ssd1327-96x96", 255, 255},
        {"ssd1306-72x40", 1, 1},     {"sh1106", 128, 128},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct canvas canvas;

        canvas_open(&canvas, cases[i].panel, -1, 0, 0);
        struct sheen_panel *panel = sheen_sim_panel_driver(canvas.panel);
        const struct sheen_sim_controller *chip = bus_of(&canvas)->controller;

        /* before the panel is lit, the level is kept for the initialisation */
        assert_int_equal(sheen_panel_brightness(panel, 100), 0);
        assert_int_equal(bus_of(&canvas)->operations, 0);
        assert_int_equal(canvas_push_all(&canvas, BAND), 0);
        assert_int_equal(chip->brightness, 100 >> panel->record->brightness_shift);
        assert_int_equal(sheen_panel_brightness(panel, cases[i].level), 0);
        if (chip->brightness != cases[i].value)
            fail_msg("%s: level %u is %u in the register", cases[i].panel, cases[i].level, chip->brightness);
        assert_int_equal(chip->lit_by_it, panel->record->driver == &sheen_driver_dcs);
        sheen_sim_power_cycle(bus_of(&canvas)->controller);
        assert_int_equal(sheen_panel_init(panel), 0);
        assert_int_equal(chip->brightness, cases[i].value);
        assert_int_equal(sheen_panel_brightness(panel, 256), SHEEN_ERR_ARGUMENT);
        canvas_quiet(&canvas);
        canvas_close(&canvas);
    }
}

static void no_brightness(void **state)
{
    struct canvas canvas;

    (void)state;
    canvas_open(&canvas, "st7735-128x160", -1, 0, 0);
    assert_int_equal(sheen_panel_brightness(sheen_sim_panel_driver(canvas.panel), 1), SHEEN_ERR_UNSUPPORTED);
    canvas_close(&canvas);
}

/* The simulated panel pulses TE at multiples of 16,667 us, and only delays advance time: pixels leave at a pulse. */
static void a_frame_begins_with_the_pulse(void **state)
{
    struct canvas canvas;
    const struct sheen_sim_controller *chip;

    (void)state;
    canvas_open(&canvas, "st7789-240x240", -1, 0, 0);
    struct sheen_panel *panel = sheen_sim_panel_driver(canvas.panel);
    chip = bus_of(&canvas)->controller;
    assert_int_equal(canvas_push_all(&canvas, BAND), 0);
    assert_int_equal(chip->tearing, 0);
    for (unsigned frame = 0; frame < 3; frame++) {
        uint64_t before;

        assert_int_equal(sheen_panel_sync(panel), 0);
        bus_of(&canvas)->bus.delay(bus_of(&canvas), 1234);
        before = chip->now_us;
        assert_int_equal(canvas_push(&canvas, (struct sheen_rect){0, 0, 240, 16}), 0);
        assert_int_equal(chip->now_us % 16667, 0);
        assert_true(chip->now_us > before);
        before = chip->now_us;
        assert_int_equal(canvas_push(&canvas, (struct sheen_rect){0, 16, 240, 32}), 0); /* only the first push waits */
        assert_true(chip->now_us == before);
    }
    sheen_sim_bus_fault(bus_of(&canvas), SHEEN_FAULT_TIMEOUT, 0);
    assert_int_equal(sheen_panel_sync(panel), 0);
    assert_int_equal(canvas_push_all(&canvas, BAND), SHEEN_ERR_TIMEOUT);
    assert_int_equal(canvas_push_all(&canvas, BAND), 0);
    assert_int_equal(canvas_differences(&canvas), 0);
    canvas_quiet(&canvas);
    bus_of(&canvas)->bus.tearing = NULL;
    assert_int_equal(sheen_panel_sync(panel), SHEEN_ERR_UNSUPPORTED);
    canvas_close(&canvas);

    canvas_open(&canvas, "ssd1306", -1, 0, 0);
    assert_int_equal(sheen_panel_sync(sheen_sim_panel_driver(canvas.panel)), SHEEN_ERR_UNSUPPORTED);
    canvas_close(&canvas);
}

static const char *const a_driver_each[] = {"st7735-80x160", "ssd1351-128x96", "ssd1325", "ssd1306-72x40", "sh1106"};

/* Between pushes others may use the bus, whatever was done with the panel and whichever operation failed. */
static void a_shared_bus_is_given_back(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof a_driver_each / sizeof a_driver_each[0]; i++) {
        for (uint64_t n = 0, more = 1; more; n++) {
            struct canvas canvas;
            int error;

            canvas_open(&canvas, a_driver_each[i], -1, 0, 0);
            struct sheen_panel *panel = sheen_sim_panel_driver(canvas.panel);
            sheen_sim_bus_share(bus_of(&canvas));
            sheen_sim_bus_fault(bus_of(&canvas), SHEEN_FAULT_ERROR, n);
            error = canvas_push_all(&canvas, 96);
            assert_int_equal(bus_of(&canvas)->held, 0);
            error = error < 0 ? error : sheen_panel_turn(panel, panel->orientation);
            assert_int_equal(bus_of(&canvas)->held, 0);
            if (panel->record->brightness_command)
                error = error < 0 ? error : sheen_panel_brightness(panel, 9);
            assert_int_equal(bus_of(&canvas)->held, 0);
            error = error < 0 ? error : sheen_panel_off(panel);
            assert_int_equal(bus_of(&canvas)->held, 0);
            more = error < 0;
            sheen_sim_bus_fault(bus_of(&canvas), SHEEN_FAULT_NONE, 0);
            assert_int_equal(canvas_push_all(&canvas, 96), 0);
            assert_int_equal(canvas_differences(&canvas), 0);
            canvas_quiet(&canvas);
            canvas_close(&canvas);
        }
    }
}

/* While pixels are under way the bus is held, because another user would cut them off. */
static void held_while_pixels_fly(void **state)
{
    static const uint8_t pixel[2];
    struct canvas canvas;

    (void)state;
    canvas_open(&canvas, "ili9341", -1, 0, 0);
    sheen_sim_bus_share(bus_of(&canvas));
    assert_int_equal(canvas.target->push(canvas.target->ctx, (struct sheen_rect){0, 0, 1, 1}, pixel), 0);
    assert_int_equal(bus_of(&canvas)->held, 1);
    assert_int_equal(canvas.target->wait(canvas.target->ctx), 0);
    assert_int_equal(bus_of(&canvas)->held, 0);
    /* Switching the TE output meanwhile must not forget the pixels under way. */
    assert_int_equal(canvas.target->push(canvas.target->ctx, (struct sheen_rect){0, 0, 1, 1}, pixel), 0);
    assert_int_equal(sheen_panel_tearing(sheen_sim_panel_driver(canvas.panel)), 0);
    assert_int_equal(sheen_panel_off(sheen_sim_panel_driver(canvas.panel)), 0);
    assert_int_equal(bus_of(&canvas)->held, 0);
    assert_int_equal(bus_of(&canvas)->flying, 0);
    canvas_quiet(&canvas);
    canvas_close(&canvas);
}

/* The example of a record for one's own module, on the simulated hardware that it describes. */
static void the_example_is_right(void **state)
{
    struct sheen_panel_record record = own_module;

    (void)state;
    record.name = "st7789-240x280";
    for (unsigned k = 0; k < 8; k++) {
        struct sheen_sim_choice choice = {.record = &record, .orientation = k};
        struct canvas canvas;

        sheen_panel_size(&record, k, &choice.width, &choice.height);
        canvas_open_choice(&canvas, &choice);
        assert_int_equal(canvas_push_all(&canvas, BAND), 0);
        assert_int_equal(canvas_differences(&canvas), 0);
        canvas_quiet(&canvas);
        canvas_close(&canvas);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turned_while_open),
        cmocka_unit_test(turning_fails_and_heals),
        cmocka_unit_test(brightness_reaches_the_register),
        cmocka_unit_test(no_brightness),
        cmocka_unit_test(a_frame_begins_with_the_pulse),
        cmocka_unit_test(a_shared_bus_is_given_back),
        cmocka_unit_test(held_while_pixels_fly),
        cmocka_unit_test(the_example_is_right),
    };

    return cmocka_run_group_tests_name("panel settings", tests, NULL, NULL);
}
