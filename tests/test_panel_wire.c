/*
 * test_panel_wire.c - the bus calls that drivers make, as literals: each is a command with its parameters or pixels.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "sheen_panel.h"

/* Writes down the calls: "2a:0000 0001" is command, colon, data; more than 8 bytes of data are only counted. */
struct scribe {
    char text[2048];
    size_t used;
};

static void note(struct scribe *scribe, const char *format, unsigned value)
{
    scribe->used += (size_t)snprintf(scribe->text + scribe->used, sizeof scribe->text - scribe->used, format, value);
}

static int scribe_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct scribe *scribe = ctx;

    for (size_t i = 0; i < commands; i++)
        note(scribe, "%02x", command[i]);
    note(scribe, ":", 0);
    for (size_t i = 0; i < count && count <= 8; i++)
        note(scribe, "%02x", ((const uint8_t *)data)[i]);
    if (count > 8)
        note(scribe, "%u bytes", (unsigned)count);
    note(scribe, " ", 0);
    return 0;
}

static int scribe_delay(void *ctx, uint32_t us)
{
    (void)ctx;
    (void)us;
    return 0;
}

/* Checks what a push to a rectangle of an initialised panel sends; first: the first four bytes of its pixels. */
static void assert_push(const char *name, unsigned orientation, struct sheen_rect rect, const char *first,
                        const char *expected)
{
    static uint8_t pixels[4096];
    struct scribe scribe = {.used = 0};
    const struct sheen_bus bus = {.ctx = &scribe, .send = scribe_send, .delay = scribe_delay};
    struct sheen_panel panel;
    struct sheen_target target;

    memset(pixels, 0, sizeof pixels);
    memcpy(pixels, first, 4);
    assert_int_equal(sheen_panel_open(&panel, sheen_panel_find(name), &bus, orientation), 0);
    assert_int_equal(sheen_panel_target(&panel, &target), 0);
    assert_int_equal(sheen_panel_init(&panel), 0);
    scribe.used = 0;
    scribe.text[0] = '\0';
    assert_int_equal(target.push(target.ctx, rect, pixels), 0);
    assert_string_equal(scribe.text, expected);
}

static void pushes(void **state)
{
    (void)state;
    assert_push("ili9341", 0, (struct sheen_rect){1, 2, 3, 3}, "\xF8\x00\x07\xE0",
                "2a:00010002 2b:00020002 2c:f80007e0 ");
    assert_push("ili9341", 0, (struct sheen_rect){0, 0, 240, 4}, "\0\0\0\0", "2a:000000ef 2b:00000003 2c:1920 bytes ");
    /* Red and half grey; the low bits repeat the high ones. */
    assert_push("ili9488", 0, (struct sheen_rect){0, 0, 2, 1}, "\xF8\x00\x84\x10",
                "2a:00000001 2b:00000000 2c:ff0000848284 ");
    assert_push("ili9488", 0, (struct sheen_rect){0, 0, 50, 1}, "\0\0\0\0",
                "2a:00000031 2b:00000000 2c:63 bytes 3c:63 bytes 3c:24 bytes ");
    assert_push("ssd1351-128x128", 0, (struct sheen_rect){4, 5, 6, 6}, "\x12\x34\x56\x78",
                "15:0405 75:0505 5c:12345678 ");
    assert_push("ssd1322", 0, (struct sheen_rect){4, 4, 12, 8}, "\x12\x34\x56\x78", "15:1d1e 75:0407 5c:16 bytes ");
    assert_push("ssd1322", 2, (struct sheen_rect){0, 0, 64, 4}, "\0\0\0\0", "15:4c5b 75:3c3f 5c:64 bytes 5c:64 bytes ");
    assert_push("ssd1327-128x128", 0, (struct sheen_rect){2, 4, 6, 6}, "\x12\x34\x56\x78",
                "150102: 750405: :12345678 ");
    /* A white pixel top left of 8 by 8 is bit 0 of the first column. */
    assert_push("ssd1306", 0, (struct sheen_rect){8, 16, 16, 24}, "\x80\0\0\0", "21080f: 220202: :0100000000000000 ");
    assert_push("sh1106", 0, (struct sheen_rect){8, 16, 16, 24}, "\x80\0\0\0", "b20a10: :0100000000000000 ");
}

/* Init tables: one call per command, with its parameters. */
static void initialisations(void **state)
{
    static const char *const ends[][2] = {
        {"st7789-240x240", "11: 3a:55 b0:00c0 36:60 21: 13: 29: "},
        {"ili9488", "01: 11: 3a:66 36:28 20: 13: 29: "},
        {"sh1106", "ad8b: a1: c8: da12: 81cf: d9f1: db40: a4: a6: af: "},
        {"ssd1327-96x96", "b601: d562: a4: a051: af: "},
        {"ssd1322", "bb:1f b6:08 be:07 a6: a9: a0:0611 af: "},
    };

    (void)state;
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        struct scribe scribe = {.used = 0};
        const struct sheen_bus bus = {.ctx = &scribe, .send = scribe_send, .delay = scribe_delay};
        struct sheen_panel panel;
        size_t length = strlen(ends[i][1]);

        assert_int_equal(sheen_panel_open(&panel, sheen_panel_find(ends[i][0]), &bus, 1), 0);
        assert_int_equal(sheen_panel_init(&panel), 0);
        assert_true(scribe.used >= length);
        assert_string_equal(scribe.text + scribe.used - length, ends[i][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pushes), cmocka_unit_test(initialisations)};

    return cmocka_run_group_tests_name("panel wire", tests, NULL, NULL);
}
