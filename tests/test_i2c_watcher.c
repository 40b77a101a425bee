/*
 * test_i2c_watcher.c - the watcher that decodes I2C levels in other tests, itself tested with edges as literals,
 * against the messages that they form and the violations that it has to report.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "i2c_watcher.h"
#include "sheen_target.h"

/* Writes down the messages: "00ae | ". */
struct scribe {
    struct sheen_bus bus;
    char text[256];
};

static int scribe_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct scribe *scribe = ctx;
    size_t used = strlen(scribe->text);

    (void)command;
    assert_int_equal(commands, 0);
    for (size_t i = 0; i < count; i++)
        used += (size_t)snprintf(scribe->text + used, sizeof scribe->text - used, "%02x", ((const uint8_t *)data)[i]);
    snprintf(scribe->text + used, sizeof scribe->text - used, " | ");
    return 0;
}

static struct scribe scribe;
static struct sheen_i2c_watcher watcher;

static void begin(void)
{
    scribe = (struct scribe){.bus = {.ctx = &scribe, .send = scribe_send}};
    sheen_i2c_watcher_init(&watcher, &scribe.bus, 0x3C);
}

/*
 * Plays edges. c, C: SCL low, high; d, D: SDA low, high; s: a start (d c), p: a stop (d C D); 0, 1: a bit (its level,
 * C, c); n: the ninth bit, released (D C c). Returns the first code that is not 0.
 */
static int play(const char *edges)
{
    int scl = watcher.scl, sda = watcher.sda, first = 0;

    for (; *edges; edges++) {
        const char *moves = *edges == 's'   ? "dc"
                            : *edges == 'p' ? "dCD"
                            : *edges == '0' ? "dCc"
                            : *edges == '1' ? "DCc"
                            : *edges == 'n' ? "DCc"
                            : *edges == ' ' ? ""
                                            : (const char[2]){*edges, 0};
        for (; *moves; moves++) {
            if ((*moves | 0x20) == 'c')
                scl = *moves == 'C';
            else
                sda = *moves == 'D';
            int code = sheen_i2c_watcher_levels(&watcher, scl, sda);
            first = first ? first : code;
        }
    }
    return first;
}

#define TO_3C "s 01111000 n "

static void messages(void **state)
{
    (void)state;
    begin();
    assert_int_equal(play(TO_3C "00000000 n 10101110 n p"), 0);
    assert_int_equal(play(TO_3C "01000000 n 00000001 n 11111111 n p"), 0);
    assert_string_equal(scribe.text, "00ae | 4001ff | ");
    assert_int_equal(watcher.messages, 2);
    assert_int_equal(watcher.bytes, 5);
    assert_int_equal(sheen_i2c_watcher_finish(&watcher), 0);
    assert_int_equal(play(TO_3C "p"), 0); /* only asks whether a device is there */
    assert_int_equal(watcher.messages, 3);
}

static void broken_rules(void **state)
{
    static const struct {
        const char *edges, *complaint;
    } cases[] = {
        {"s 01111010 n 00000000 n p", "a message to another address"},
        {"s 01111001 n p", "a read"},
        {"s p", "a message to another address"},
        {TO_3C "000 p", "a stop inside a byte"},
        {TO_3C "00000000 p", "a stop inside a byte"}, /* the acknowledge bit is missing */
        {TO_3C "000 D C d", "a start inside a byte"},
        {TO_3C "D C d c", "a second start without a stop"},
        {"c d C D", "a stop without a start"},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        begin();
        assert_int_equal(play(cases[i].edges), SHEEN_ERR_BUS);
        assert_string_equal(watcher.complaint ? watcher.complaint : "none", cases[i].complaint);
    }
    begin();
    assert_int_equal(sheen_i2c_watcher_levels(&watcher, 0, 0), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "SCL and SDA change at once");
}

static void ends(void **state)
{
    (void)state;
    begin();
    assert_int_equal(sheen_i2c_watcher_finish(&watcher), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "no byte was sent");
    begin();
    assert_int_equal(play(TO_3C "00000000 n"), 0);
    assert_int_equal(sheen_i2c_watcher_finish(&watcher), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "the trace ends inside a message");
    begin();
    assert_int_equal(play(TO_3C), 0);
    for (int i = 0; i < 255; i++)
        assert_int_equal(play("00000000 n"), 0);
    assert_int_equal(play("00000000 n"), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "a message of more than 256 bytes");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(messages),
        cmocka_unit_test(broken_rules),
        cmocka_unit_test(ends),
    };

    return cmocka_run_group_tests_name("i2c watcher", tests, NULL, NULL);
}
