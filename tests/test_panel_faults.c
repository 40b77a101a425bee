/*
 * test_panel_faults.c - everything that can fail on a bus, made to fail, one operation at a time: the error is reported
 * and the next frame is right.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "test_panel_canvas.h"

/* One panel of each driver. */
static const char *const panels[] = {"st7735-80x160", "ssd1351-128x96", "ssd1325",
                                     "ssd1306-72x40", "sh1106",         "ssd1322"};
#define BAND 96 /* rows: few bands, because each operation of each is made to fail many times */
#define PANELS (sizeof panels / sizeof panels[0])

/* Two frames: the whole picture, then two windows. Stops at the first error, as the core does. */
static int two_frames(struct canvas *canvas)
{
    int error = canvas_push_all(canvas, BAND);

    for (unsigned i = 0; i < 2 && error == 0; i++)
        error = canvas_push(canvas, canvas_rect(canvas));
    return error;
}

/* The glass of a panel that was switched off shows nothing. */
static void assert_dark(struct canvas *canvas, const char *name, int after)
{
    size_t pixels = (size_t)canvas->target->width * canvas->target->height, lit = 0;

    assert_int_equal(sheen_sim_panel_picture(canvas->panel, canvas->seen), 0);
    for (size_t i = 0; i < pixels; i++)
        lit += canvas->seen[i] != 0;
    if (lit)
        fail_msg("%s, call %d: switched off after the error, and %zu pixels are lit", name, after, lit);
}

static uint64_t operations_of_two_frames(const char *name)
{
    struct canvas canvas;

    canvas_open(&canvas, name, -1, 0, 0);
    assert_int_equal(two_frames(&canvas), 0);
    uint64_t operations = sheen_sim_panel_bus(canvas.panel)->operations;
    canvas_close(&canvas);
    return operations;
}

/* off: the panel is switched off between the error and the next frame. */
static void fail_at(const char *name, enum sheen_sim_fault fault, uint64_t after, int off)
{
    int expected = fault == SHEEN_FAULT_TIMEOUT ? SHEEN_ERR_TIMEOUT : SHEEN_ERR_BUS;
    struct canvas canvas;
    struct sheen_sim_bus *bus;

    canvas_open(&canvas, name, -1, 0, 0);
    bus = sheen_sim_panel_bus(canvas.panel);
    sheen_sim_bus_fault(bus, fault, after);
    assert_int_equal(two_frames(&canvas), expected);
    if (fault == SHEEN_FAULT_STUCK_RESET) {
        assert_int_equal(canvas_push_all(&canvas, BAND), SHEEN_ERR_BUS); /* while it is stuck */
        sheen_sim_bus_fault(bus, SHEEN_FAULT_NONE, 0);
    }
    if (off) {
        assert_int_equal(sheen_panel_off(sheen_sim_panel_driver(canvas.panel)), 0);
        assert_dark(&canvas, name, (int)after);
    }
    assert_int_equal(canvas_push_all(&canvas, BAND), 0);
    if (canvas_differences(&canvas))
        fail_msg("%s, %s at operation %u: the next frame is wrong", name, sheen_sim_fault_name(fault),
                 (unsigned)after + 1);
    canvas_quiet(&canvas);
    canvas_close(&canvas);
}

static void every_operation_and_fault(void **state)
{
    (void)state;
    for (size_t p = 0; p < PANELS; p++) {
        uint64_t operations = operations_of_two_frames(panels[p]);

        assert_true(operations > 30);
        for (unsigned fault = SHEEN_FAULT_ERROR; fault < SHEEN_FAULT_COUNT; fault++)
            for (uint64_t n = 0; n < operations; n++) {
                fail_at(panels[p], (enum sheen_sim_fault)fault, n, 0);
                fail_at(panels[p], (enum sheen_sim_fault)fault, n, 1);
            }
    }
}

/* The machine stops after any operation, with or without the panel losing power, and starts again. */
static void cut_at(const char *name, uint64_t after, int power)
{
    struct canvas canvas;

    canvas_open(&canvas, name, -1, 0, 0);
    sheen_sim_bus_fault(sheen_sim_panel_bus(canvas.panel), SHEEN_FAULT_ERROR, after);
    assert_int_equal(two_frames(&canvas), SHEEN_ERR_BUS);
    if (power)
        sheen_sim_power_cycle(sheen_sim_panel_bus(canvas.panel)->controller);
    assert_int_equal(sheen_sim_panel_restart(canvas.panel), 0);
    assert_int_equal(canvas_push_all(&canvas, BAND), 0);
    if (canvas_differences(&canvas))
        fail_msg("%s, cut after operation %u: wrong after restart", name, (unsigned)after);
    canvas_quiet(&canvas);
    canvas_close(&canvas);
}

static void cut_after_every_operation(void **state)
{
    (void)state;
    for (size_t p = 0; p < PANELS; p++) {
        uint64_t operations = operations_of_two_frames(panels[p]);

        for (uint64_t n = 0; n < operations; n++) {
            cut_at(panels[p], n, 0);
            cut_at(panels[p], n, 1);
        }
    }
}

/*
 * A bus with an error code of the board's own, which must reach the caller unchanged, and without a reset line, so that
 * the panel is reset by command.
 */
struct own_bus {
    struct sheen_bus_layer layer; /* around the simulated bus */
    int countdown;                /* calls before the one that fails */
    int code;                     /* what that call returns */
};

static int own_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct own_bus *own = ctx;
    const struct sheen_bus *to = own->layer.to;

    if (own->countdown-- != 0)
        return to->send(to->ctx, command, commands, data, count);
    if (commands + count > 1) { /* half of it is sent */
        size_t half = (commands + count) / 2, first = half < commands ? half : commands;

        to->send(to->ctx, command, first, data, half - first);
        to->wait(to->ctx);
    }
    return own->code;
}

/*
 * Call n fails with the board's code, the panel loses power for a moment or not, is switched off or not, and the next
 * frame must be whole. 0 once there is no call n. A code above 0 counts as an error of the bus.
 */
static int fail_without_reset_line(const char *name, int n, int code, int power, int off)
{
    const int expected = code < 0 ? code : SHEEN_ERR_BUS;
    const struct sheen_panel_record *record = sheen_panel_find(name);
    struct canvas canvas;
    struct sheen_panel panel;
    struct sheen_target target;

    canvas_open(&canvas, name, -1, 0, 0);
    struct own_bus own = {.countdown = n, .code = code};
    sheen_bus_layer_open(&own.layer, &sheen_sim_panel_bus(canvas.panel)->bus);
    own.layer.bus.send = own_send;
    own.layer.bus.reset = NULL;

    assert_int_equal(sheen_panel_open(&panel, record, &own.layer.bus, sheen_panel_default_orientation(record)), 0);
    assert_int_equal(sheen_panel_target(&panel, &target), 0);
    canvas.target = &target;
    int error = canvas_push_all(&canvas, BAND);
    assert_true(error == 0 || error == expected);
    if (power)
        sheen_sim_power_cycle(sheen_sim_panel_bus(canvas.panel)->controller);
    if (error < 0 && off) {
        assert_int_equal(sheen_panel_off(&panel), 0);
        assert_dark(&canvas, name, n);
    }
    if (error < 0)
        assert_int_equal(canvas_push_all(&canvas, BAND), 0);
    if (error < 0 && canvas_differences(&canvas))
        fail_msg("%s, call %d, power %d: the next frame is wrong", name, n, power);
    /*
     * A controller that kept its power notices that a command or pixel was cut off, and that AE (174) was taken for a
     * parameter that it cannot be.
     */
    static const char *const allowed[] = {"misses",           "half a pixel", "half a column", "multiplex ratio 175",
                                          "address mode 174", "remap 0xAE"};
    const char *complaint = sheen_sim_panel_complaint(canvas.panel);
    int cut_off = 0;
    for (size_t i = 0; i < sizeof allowed / sizeof allowed[0]; i++)
        cut_off |= !power && strstr(complaint, allowed[i]);
    if (sheen_sim_panel_complaints(canvas.panel) != (unsigned)cut_off)
        fail_msg("%s, call %d, power %d: %s", name, n, power, sheen_sim_panel_complaint(canvas.panel));
    canvas_close(&canvas);
    return error;
}

static void own_code_and_no_reset_line(void **state)
{
    (void)state;
    for (size_t p = 0; p < PANELS; p++) {
        int n = 0;

        while (fail_without_reset_line(panels[p], n, -77, 0, 0) < 0 &&
               fail_without_reset_line(panels[p], n, -77, 0, 1) < 0 &&
               fail_without_reset_line(panels[p], n, 1, 1, n % 2) < 0)
            n++;
        assert_true(n > 20);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_operation_and_fault),
        cmocka_unit_test(cut_after_every_operation),
        cmocka_unit_test(own_code_and_no_reset_line),
    };

    return cmocka_run_group_tests_name("panel_faults", tests, NULL, NULL);
}
