/*
 * test_i2c.c - panels on I2C: the messages that the sender makes of a bus's calls, against literals; the simulated bus
 * that receives them; then every panel that has I2C through both.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "test_panel_canvas.h"

/* ---- the sending half: a bus's calls become messages ---- */

/* Writes down the messages, "00 21 0a | 40 01 | ", and a "w" for each wait. */
struct scribe {
    char text[512];
    int flying;
};

static int scribe_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct scribe *scribe = ctx;
    size_t used = strlen(scribe->text);

    assert_int_equal(commands, 0);
    (void)command;
    for (size_t i = 0; i < count; i++)
        used += (size_t)snprintf(scribe->text + used, sizeof scribe->text - used, "%02x ", ((const uint8_t *)data)[i]);
    snprintf(scribe->text + used, sizeof scribe->text - used, "| ");
    scribe->flying++;
    return 0;
}

static int scribe_wait(void *ctx)
{
    struct scribe *scribe = ctx;

    strcat(scribe->text, "w ");
    scribe->flying--;
    return 0;
}

static int scribe_delay(void *ctx, uint32_t us)
{
    (void)ctx;
    return (int)us;
}

static void calls_become_messages(void **state)
{
    struct scribe scribe = {{0}, 0};
    const struct sheen_bus wire = {.ctx = &scribe, .send = scribe_send, .delay = scribe_delay, .wait = scribe_wait};
    static const uint8_t bytes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
    struct sheen_i2c i2c;
    const struct sheen_bus *bus = &i2c.layer.bus;

    (void)state;
    assert_int_equal(sheen_i2c_open(&i2c, &wire, 16), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_i2c_open(&i2c, NULL, 0), SHEEN_ERR_ARGUMENT);
    struct sheen_bus timeless = wire; /* a layer offers only what the bus below it has */
    struct sheen_bus_layer layer;
    timeless.delay = NULL;
    assert_int_equal(sheen_i2c_open(&i2c, &timeless, 0), SHEEN_ERR_ARGUMENT);
    sheen_bus_layer_open(&layer, &timeless);
    assert_true(layer.bus.delay == NULL && layer.bus.send != NULL);
    assert_int_equal(sheen_i2c_open(&i2c, &wire, 17), 0);
    assert_int_equal(bus->send(bus->ctx, bytes, 3, NULL, 0), 0);
    assert_int_equal(bus->wait(bus->ctx), 0);
    assert_string_equal(scribe.text, "00 01 02 03 | w ");
    scribe.text[0] = '\0';
    assert_int_equal(bus->send(bus->ctx, NULL, 0, bytes, 18), 0); /* two messages, of 16 and 2 bytes */
    assert_string_equal(scribe.text, "40 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f 10 | w 40 11 12 | ");
    assert_int_equal(scribe.flying, 1); /* the last message may still be under way */
    bus->wait(bus->ctx);
    scribe.text[0] = '\0';
    assert_int_equal(bus->send(bus->ctx, bytes, 1, bytes + 5, 1), 0);
    assert_string_equal(scribe.text, "00 01 | w 40 06 | ");
    assert_int_equal(bus->send(bus->ctx, bytes, 17, NULL, 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(bus->delay(bus->ctx, 5), 5);
    assert_null(bus->reset);
    assert_null(bus->acquire);
    assert_null(bus->tearing);
}

/* ---- the receiving half: the simulated bus, fed by hand ---- */

static struct sheen_sim_controller chip;
static struct sheen_sim_bus sim;

static int message(const char *bytes, size_t count)
{
    int error = sim.bus.send(&sim, NULL, 0, bytes, count);

    return error < 0 ? error : sim.bus.wait(&sim);
}

#define MESSAGE(bytes) message(bytes, sizeof(bytes) - 1)

static void complained(const char *text)
{
    if (!strstr(chip.first_complaint, text))
        fail_msg("expected a complaint with '%s', got '%s'", text, chip.first_complaint);
    chip.complaints = 0;
    chip.first_complaint[0] = '\0';
}

static void control_bytes(void **state)
{
    (void)state;
    assert_int_equal(sheen_sim_controller_open(&chip, sheen_sim_module_find("ssd1306-128x64")), 0);
    sheen_sim_bus_open(&sim, &chip, 1);
    sheen_sim_bus_i2c(&sim, 0x3C);
    sheen_sim_advance(&chip, 1000);
    assert_int_equal(MESSAGE("\x00\x20\x00\x21\x05\x07\x22\x02\x03"), 0);
    assert_int_equal(chip.x0, 5);
    assert_int_equal(chip.x1, 7);
    assert_int_equal(chip.y0, 2);
    assert_int_equal(MESSAGE("\x40\x01\x80"), 0);
    assert_int_equal(chip.ram[16 * 128 + 5], 1);
    assert_int_equal(chip.ram[23 * 128 + 6], 1);
    /* A control byte before each byte, then one for the rest: 80 command, C0 a byte of data, 40 data. */
    assert_int_equal(MESSAGE("\x80\x21\x80\x09\x80\x0B\xC0\x01\x40\x00\x80"), 0);
    assert_int_equal(chip.x0, 9);
    assert_int_equal(chip.ram[16 * 128 + 9], 1);
    assert_int_equal(chip.ram[16 * 128 + 10], 0);
    assert_int_equal(chip.ram[23 * 128 + 11], 1);
    assert_int_equal(chip.complaints, 0);
    MESSAGE("\x01\xAE");
    complained("control byte 0x01");
    MESSAGE("\x40");
    complained("a message ends after control byte 0x40");
    MESSAGE("\x80\xAE\x80");
    complained("a message ends after control byte 0x80");
    assert_int_equal(sim.bus.send(&sim, (const uint8_t *)"\xAE", 1, NULL, 0), SHEEN_ERR_ARGUMENT);
    complained("an I2C message beside its bytes");
    /* A byte that is not acknowledged ends the message. */
    sheen_sim_bus_fault(&sim, SHEEN_FAULT_SHORT, 1);
    assert_int_equal(MESSAGE("\x00\x21\x01\x02"), SHEEN_ERR_BUS);
    assert_int_equal(chip.missing, 2);
    sheen_sim_controller_close(&chip);
}

static void nobody_at_the_address(void **state)
{
    (void)state;
    assert_int_equal(sheen_sim_controller_open(&chip, sheen_sim_module_find("ssd1306-128x64")), 0);
    sheen_sim_bus_open(&sim, &chip, 1);
    sheen_sim_bus_i2c(&sim, 0x3D);
    sheen_sim_advance(&chip, 1000);
    assert_int_equal(MESSAGE("\x00\xAF"), SHEEN_ERR_BUS);
    assert_int_equal(chip.on, 0);
    assert_int_equal(sim.flying, 0);
    sheen_sim_controller_close(&chip);
    /* A module without I2C answers at no address. */
    assert_int_equal(sheen_sim_controller_open(&chip, sheen_sim_module_find("ili9341-240x320")), 0);
    sheen_sim_bus_open(&sim, &chip, 1);
    sheen_sim_bus_i2c(&sim, 0x3C);
    assert_int_equal(MESSAGE("\x00\x11"), SHEEN_ERR_BUS);
    sheen_sim_controller_close(&chip);
}

/* ---- the shipped drivers, on every panel that has I2C ---- */

static int open_i2c(struct canvas *canvas, const struct sheen_panel_record *record, unsigned orientation)
{
    struct sheen_sim_choice choice = {.record = record, .orientation = orientation, .i2c = 0x3C};

    if (sheen_sim_module_find(record->name)->i2c_address == 0)
        return 0;
    sheen_panel_size(record, orientation, &choice.width, &choice.height);
    canvas_open_choice(canvas, &choice);
    return 1;
}

static void every_panel_and_orientation(void **state)
{
    const struct sheen_panel_record *record;
    unsigned panels = 0;

    (void)state;
    for (size_t i = 0; (record = sheen_panel_at(i)); i++) {
        for (unsigned k = 0; k < 8; k++) {
            struct canvas canvas;

            if (!open_i2c(&canvas, record, k))
                continue;
            panels++;
            assert_int_equal(canvas_push_all(&canvas, 16), 0);
            for (unsigned n = 0; n < 40; n++)
                assert_int_equal(canvas_push(&canvas, canvas_rect(&canvas)), 0);
            if (canvas_differences(&canvas))
                fail_msg("%s by I2C, orientation %u: %u pixels differ", record->name, k, canvas_differences(&canvas));
            canvas_quiet(&canvas);
            canvas_close(&canvas);
        }
    }
    assert_true(panels >= 7 * 8);
}

/* Each operation of a whole picture fails in each way; the next picture must be right. */
static void every_operation_and_fault(void **state)
{
    static const char *const names[] = {"ssd1327-96x96", "ssd1306-72x40", "sh1106"};

    (void)state;
    for (size_t p = 0; p < sizeof names / sizeof names[0]; p++) {
        for (unsigned fault = SHEEN_FAULT_ERROR; fault < SHEEN_FAULT_COUNT; fault++) {
            int error = SHEEN_ERR_BUS;

            for (uint64_t n = 0; error < 0; n++) {
                struct canvas canvas;

                assert_int_equal(open_i2c(&canvas, sheen_panel_find(names[p]), 1), 1);
                sheen_sim_bus_fault(sheen_sim_panel_bus(canvas.panel), (enum sheen_sim_fault)fault, n);
                error = canvas_push_all(&canvas, 96);
                sheen_sim_bus_fault(sheen_sim_panel_bus(canvas.panel), SHEEN_FAULT_NONE, 0);
                assert_int_equal(canvas_push_all(&canvas, 96), 0);
                if (canvas_differences(&canvas))
                    fail_msg("%s by I2C, %s at operation %u", names[p],
                             sheen_sim_fault_name((enum sheen_sim_fault)fault), (unsigned)n + 1);
                canvas_quiet(&canvas);
                canvas_close(&canvas);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_become_messages),     cmocka_unit_test(control_bytes),
        cmocka_unit_test(nobody_at_the_address),     cmocka_unit_test(every_panel_and_orientation),
        cmocka_unit_test(every_operation_and_fault),
    };

    return cmocka_run_group_tests_name("i2c", tests, NULL, NULL);
}
