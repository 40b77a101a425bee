/*
 * test_bus.c - the simulated bus: late DMA, counters, each named fault.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "glass.h"
#include "sheen_target.h"
#include "sim_bus.h"

static const struct sheen_sim_module module = {
    .name = "ideal", .chip = &sheen_sim_chip_ideal, .ram_w = 8, .ram_h = 8, .glass_w = 8, .glass_h = 8};
static struct sheen_sim_controller chip;
static struct sheen_sim_bus sim;

static int set_up(void **state)
{
    (void)state;
    assert_int_equal(sheen_sim_controller_open(&chip, &module), 0);
    sheen_sim_bus_open(&sim, &chip, 1);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    sheen_sim_controller_close(&chip);
    return 0;
}

static int start(uint8_t command, const void *bytes, size_t count)
{
    return sim.bus.send(&sim, &command, 1, bytes, count);
}

static int start_data(const void *bytes, size_t count)
{
    return sim.bus.send(&sim, NULL, 0, bytes, count);
}

static int finish(void)
{
    return sim.bus.wait(&sim);
}

static void ram_write(void)
{
    assert_int_equal(start(0x2C, NULL, 0), 0);
    assert_int_equal(finish(), 0);
}

static void bytes_arrive_at_the_wait(void **state)
{
    (void)state;
    ram_write();
    assert_int_equal(start_data("\x12\x34", 2), 0);
    assert_int_equal(chip.ram[0], 0);
    assert_int_equal(finish(), 0);
    assert_int_equal(chip.ram[0], 0x1234);
    assert_int_equal(finish(), 0); /* nothing under way */
    assert_int_equal(chip.complaints, 0);
}

static void touched_buffer(void **state)
{
    uint8_t pixel[2] = {0x12, 0x34};

    (void)state;
    ram_write();
    assert_int_equal(start_data(pixel, 2), 0);
    pixel[1] = 0x35;
    assert_int_equal(finish(), 0);
    assert_int_equal(chip.complaints, 1);
    assert_non_null(strstr(chip.first_complaint, "touched before wait"));
    assert_int_equal(chip.ram[0], 0x1235); /* what a slow DMA sends */
}

static void missing_waits(void **state)
{
    (void)state;
    start(0x2C, NULL, 0);
    start_data("\x12\x34", 2);
    assert_non_null(strstr(chip.first_complaint, "send before the last one was waited for"));
    sim.bus.delay(&sim, 1);
    sim.bus.reset(&sim, 1);
    assert_int_equal(chip.complaints, 3);
    finish();
    assert_int_equal(start_data("", 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(chip.complaints, 4);
}

static void counters(void **state)
{
    struct sheen_sim_counters is;

    (void)state;
    ram_write();
    start_data("\1\2\3\4", 4);
    finish();
    is = sheen_sim_bus_counters(&sim);
    assert_int_equal(is.bytes, 5);
    assert_int_equal(is.commands, 1);
    assert_int_equal(is.transactions, 2);
    assert_int_equal(is.rectangles, 1);
    sheen_sim_bus_counters_reset(&sim);
    is = sheen_sim_bus_counters(&sim);
    assert_int_equal(is.bytes + is.commands + is.transactions + is.rectangles, 0);
}

static void fault_error(void **state)
{
    (void)state;
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_ERROR, 3); /* send, wait, send, then this wait */
    ram_write();
    assert_int_equal(start_data("\x12\x34", 2), 0);
    assert_int_equal(finish(), SHEEN_ERR_BUS);
    assert_int_equal(chip.ram[0], 0);
    assert_int_equal(finish(), 0); /* once only */
    assert_int_equal(chip.complaints, 0);
}

static void fault_short(void **state)
{
    (void)state;
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_SHORT, 3);
    ram_write();
    start_data("\x12\x34\x56\x78", 4);
    assert_int_equal(finish(), SHEEN_ERR_BUS);
    assert_int_equal(chip.ram[0], 0x1234);
    assert_int_equal(chip.ram[1], 0);
    assert_int_equal(chip.complaints, 0);
}

static void fault_timeout(void **state)
{
    (void)state;
    ram_write();
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_TIMEOUT, 1);
    start_data("\x12\x34", 2);
    assert_int_equal(finish(), SHEEN_ERR_TIMEOUT);
    assert_int_equal(chip.ram[0], 0);
    assert_int_equal(chip.now_us, 1000000);
}

static void fault_brown_out(void **state)
{
    (void)state;
    start(0x2A, "\0\3\0\4", 4);
    finish();
    assert_int_equal(chip.x0, 3);
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_BROWN_OUT, 0);
    assert_int_equal(start(0x2C, NULL, 0), SHEEN_ERR_BUS);
    assert_int_equal(chip.x0, 0); /* registers are lost */
    assert_int_equal(chip.streaming, 0);
}

static void fault_stuck_reset(void **state)
{
    (void)state;
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_STUCK_RESET, 0);
    assert_int_equal(sim.bus.delay(&sim, 5), SHEEN_ERR_BUS);
    assert_int_equal(chip.reset_level, 0);
    assert_int_equal(sim.bus.reset(&sim, 0), 0);
    assert_int_equal(sim.bus.reset(&sim, 1), SHEEN_ERR_BUS);
    assert_int_equal(sim.bus.reset(&sim, 1), SHEEN_ERR_BUS);
    assert_int_equal(chip.reset_level, 0);
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_NONE, 0);
    assert_int_equal(sim.bus.reset(&sim, 1), 0);
    assert_int_equal(chip.reset_level, 1);
}

/* An ILI9341 needs 10 us, which begin when the module's capacitor is discharged. */
static void reset_line_falls_slowly(void **state)
{
    struct sheen_sim_controller ili9341;
    struct sheen_sim_bus bus;

    (void)state;
    assert_int_equal(sheen_sim_controller_open(&ili9341, sheen_sim_module_find("ili9341-240x320")), 0);
    sheen_sim_bus_open(&bus, &ili9341, 1);
    for (uint32_t low_us = 110; low_us >= 109; low_us--) {
        assert_int_equal(ili9341.complaints, 0);
        bus.bus.reset(&bus, 0);
        bus.bus.delay(&bus, low_us);
        bus.bus.reset(&bus, 1);
    }
    assert_string_equal(ili9341.first_complaint, "ili9341-240x320: reset low for 9 us, needs 10");
    sheen_sim_controller_close(&ili9341);
}

/* One call: the command's bytes, read at once, then the data, read at the wait. */
static void a_command_with_its_data(void **state)
{
    uint8_t command = 0x2C;

    (void)state;
    assert_int_equal(sim.bus.send(&sim, &command, 1, "\x12\x34", 2), 0);
    command = 0;
    assert_int_equal(finish(), 0);
    assert_int_equal(chip.ram[0], 0x1234);
    assert_int_equal(sheen_sim_bus_counters(&sim).transactions, 1);
    assert_int_equal(chip.complaints, 0);
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_SHORT, 1); /* 3 of 6 bytes: the command and a pixel */
    command = 0x2C;
    sim.bus.send(&sim, &command, 1, "\x56\x78\x9A\xBC\xDE", 5);
    assert_int_equal(finish(), SHEEN_ERR_BUS);
    assert_int_equal(chip.ram[0], 0x5678);
    assert_int_equal(sim.bus.send(&sim, (const uint8_t *)"12345678901234567", 17, NULL, 0), SHEEN_ERR_ARGUMENT);
    assert_non_null(strstr(chip.first_complaint, "more bytes than a bus takes"));
}

static void a_shared_bus(void **state)
{
    (void)state;
    sheen_sim_bus_share(&sim);
    assert_int_equal(sim.bus.acquire(&sim), 0);
    start(0x2C, NULL, 0);
    finish();
    sim.bus.release(&sim);
    assert_int_equal(chip.complaints, 0);
    start(0x2C, NULL, 0);
    assert_non_null(strstr(chip.first_complaint, "not acquired"));
    sim.bus.acquire(&sim);
    sim.bus.acquire(&sim);
    assert_int_equal(chip.complaints, 2);
    sim.bus.release(&sim); /* the call still flies */
    assert_int_equal(chip.complaints, 3);
    finish();
    sim.bus.release(&sim);
    assert_int_equal(chip.complaints, 4);
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_ERROR, 0);
    assert_int_equal(sim.bus.acquire(&sim), SHEEN_ERR_BUS);
    assert_int_equal(sim.held, 0);
}

/* Hand-fed: the memory behind the bus minds its limits. */
static void ideal_limits(void **state)
{
    (void)state;
    start(0x2A, "\0\6\0\7", 4);
    finish();
    ram_write();
    start_data("\1\2\3\4\5\6", 6);
    finish();
    assert_int_equal(chip.complaints, 0);
    assert_int_equal(chip.ram[6], 0x0102);
    assert_int_equal(chip.ram[7], 0x0304);
    assert_int_equal(chip.ram[8 + 6], 0x0506);
    for (int i = 0; i < 7; i++) {
        start_data("\0\0\0\0", 4);
        finish();
    }
    assert_non_null(strstr(chip.first_complaint, "more pixels than the window holds"));
    assert_int_equal(chip.complaints, 1); /* 3 + 14 pixels into 16 places */
    start(0x2A, "\0\0\0\x08", 4);
    finish();
    assert_int_equal(chip.complaints, 2);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(bytes_arrive_at_the_wait),
        TEST(touched_buffer),
        TEST(missing_waits),
        TEST(counters),
        TEST(a_command_with_its_data),
        TEST(a_shared_bus),
        TEST(ideal_limits),
        TEST(fault_error),
        TEST(fault_short),
        TEST(fault_timeout),
        TEST(fault_brown_out),
        TEST(fault_stuck_reset),
        TEST(reset_line_falls_slowly),
    };

    return cmocka_run_group_tests_name("bus", tests, NULL, NULL);
}
