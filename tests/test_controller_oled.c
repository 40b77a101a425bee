/*
 * test_controller_oled.c - the simulated OLED controllers, fed by hand: no driver is involved.
 *
 * What must be seen where is literal, from data sheets and from the settings that
 * public drivers use upright and flipped.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "glass.h"

static struct sheen_sim_controller chip;

static void open_panel(const char *name)
{
    assert_int_equal(sheen_sim_controller_open(&chip, sheen_sim_module_find(name)), 0);
    sheen_sim_advance(&chip, 1000);
}

static void close_panel(void)
{
    sheen_sim_controller_close(&chip);
}

static void send(enum sheen_sim_dc dc, const char *bytes, size_t count)
{
    sheen_sim_receive(&chip, dc, (const uint8_t *)bytes, count);
}

#define COMMANDS(bytes) send(SHEEN_SIM_COMMAND, bytes, sizeof(bytes) - 1)
#define DATA(bytes) send(SHEEN_SIM_DATA, bytes, sizeof(bytes) - 1)

static void assert_glass(unsigned column, unsigned row, uint16_t value)
{
    assert_int_equal(sheen_sim_glass(&chip, column, row), value);
}

static void quiet(void)
{
    assert_string_equal(chip.first_complaint, "");
}

static void complained(const char *text)
{
    if (!strstr(chip.first_complaint, text))
        fail_msg("expected a complaint with '%s', got '%s'", text, chip.first_complaint);
    chip.complaints = 0;
    chip.first_complaint[0] = '\0';
}

/* 128x64 of OSRAM: A2 40 with A0 52 upright; A2 50 with A0 41 upside down. */
static void ssd0323(void **state)
{
    (void)state;
    open_panel("ssd0323-128x64");
    COMMANDS("\xA8\x3F\xA2\x40\xA1\x00\xA0\x52\xAF");
    COMMANDS("\x15\x00\x01\x75\x00\x01");
    DATA("\x12\x34\x56\x78");
    for (unsigned x = 0; x < 4; x++) {
        assert_glass(x, 0, (uint16_t)(1 + x));
        assert_glass(x, 1, (uint16_t)(5 + x));
    }
    COMMANDS("\x15\x3F\x3F\x75\x3F\x3F");
    DATA("\x9A");
    assert_glass(126, 63, 9);
    assert_glass(127, 63, 10);

    COMMANDS("\xA2\x50\xA0\x41\x15\x00\x00\x75\x00\x00");
    DATA("\xBC");
    assert_glass(127, 63, 11); /* the viewer who turned it sees B, then C, top left */
    assert_glass(126, 63, 12);
    quiet();
    close_panel();
}

/* Newhaven's glass: A2 4C both ways round; upside down its first row is RAM row 8. */
static void ssd1325(void **state)
{
    (void)state;
    open_panel("ssd1325-128x64");
    COMMANDS("\xA8\x3F\xA2\x4C\xA0\x52\xAF\x15\x00\x00\x75\x00\x00");
    DATA("\x12");
    assert_glass(0, 0, 1);
    assert_glass(1, 0, 2);
    COMMANDS("\x75\x3F\x3F");
    DATA("\x34");
    assert_glass(0, 63, 3);
    COMMANDS("\xA0\x41\x15\x00\x00\x75\x08\x08");
    DATA("\x56");
    assert_glass(127, 63, 5);
    assert_glass(126, 63, 6);
    quiet();
    close_panel();
}

static void grey_modes_and_addresses(void **state)
{
    (void)state;
    open_panel("ssd0323-128x64");
    COMMANDS("\xA8\x3F\xA2\x40\xA0\x56\xAE\x15\x00\x01\x75\x00\x01"); /* down first */
    DATA("\x12\x34\x56\x78\x9A");                                     /* and round to the start */
    assert_glass(0, 0, 0);
    COMMANDS("\xAF");
    assert_glass(0, 0, 9);
    assert_glass(0, 1, 3);
    assert_glass(2, 0, 5);
    assert_glass(2, 1, 7);
    COMMANDS("\xA7");
    assert_glass(0, 1, 12);
    COMMANDS("\xA6");
    assert_glass(0, 1, 0);
    COMMANDS("\xA5");
    assert_glass(0, 1, 15);
    COMMANDS("\xA4");
    assert_glass(0, 1, 3);
    COMMANDS("\x81\x40\xB8\x01\x02\x03\x04\x05\x06\x07\x08\xE3");
    quiet();
    assert_int_equal(chip.rectangles, 2);
    COMMANDS("\x15\x02\x01");
    DATA("\0");
    complained("window 2..1, 0..1 of 64x80");
    COMMANDS("\x15\x00\x40");
    DATA("\0");
    complained("window 0..64, 0..1 of 64x80");
    COMMANDS("\x75\x00");
    DATA("\0");
    complained("data where command 0x75 misses 1");
    COMMANDS("\x00\xFD");
    complained("unknown command 0xFD");
    close_panel();
}

/* 96x96 of Seeed: columns from px 16; A2 20 with A0 51 upright, A2 60 with A0 42 upside down. */
static void ssd1327(void **state)
{
    (void)state;
    open_panel("ssd1327-96x96");
    COMMANDS("\xFD\x12\xA8\x5F\xA1\x00\xA2\x20\xA0\x51\xAF\x15\x08\x08\x75\x00\x00");
    DATA("\x12");
    assert_glass(0, 0, 1);
    assert_glass(1, 0, 2);
    COMMANDS("\x15\x37\x37\x75\x5F\x5F");
    DATA("\x34");
    assert_glass(94, 95, 3);
    assert_glass(95, 95, 4);
    COMMANDS("\xA2\x60\xA0\x42\x15\x08\x08\x75\x00\x00");
    DATA("\x56");
    assert_glass(95, 95, 5);
    assert_glass(94, 95, 6);
    quiet();
    close_panel();

    open_panel("ssd1327-128x128");
    COMMANDS("\xA8\x7F\xA2\x00\xA0\x51\xAF\x15\x3F\x3F\x75\x7F\x7F");
    DATA("\x78");
    assert_glass(126, 127, 7);
    assert_glass(127, 127, 8);
    sheen_sim_reset_line(&chip, 0);
    sheen_sim_advance(&chip, 99);
    sheen_sim_reset_line(&chip, 1);
    complained("reset low for 99 us, needs 100");
    close_panel();
}

static void ssd1306(void **state)
{
    (void)state;
    open_panel("ssd1306-128x64");
    COMMANDS("\xA8\x3F\xD3\x00\x40\x20\x00\xA1\xC8\xAF\x21\x00\x7F\x22\x00\x07");
    for (unsigned i = 0; i < 1024; i++)
        DATA("\0");
    COMMANDS("\x21\x05\x06\x22\x01\x02");
    DATA("\x01\x80\x02\x04");
    assert_glass(5, 8, 0); /* dark without the charge pump */
    COMMANDS("\x8D\x14");
    assert_glass(5, 8, 1);
    assert_glass(6, 8, 0);
    assert_glass(6, 15, 1);
    assert_glass(5, 17, 1);
    assert_glass(6, 18, 1);
    COMMANDS("\xA7");
    assert_glass(5, 8, 0);
    assert_glass(6, 8, 1);
    COMMANDS("\xA6\xA5");
    assert_glass(6, 8, 1);
    COMMANDS("\xA4\xC0"); /* COM lines the other way: top and bottom change at once */
    assert_glass(5, 63 - 8, 1);
    COMMANDS("\xC8\xA0\x21\x00\x00\x22\x00\x00"); /* segments the other way: only for new bytes */
    DATA("\x01");
    assert_glass(127, 0, 1);
    assert_glass(5, 8, 1);
    quiet();
    COMMANDS("\x22\x00\x08");
    DATA("\0");
    complained("window 0..0, 0..8 of 128x8");
    COMMANDS("\x23");
    complained("unknown command 0x23");
    close_panel();
}

static void ssd1306_page_mode(void **state)
{
    (void)state;
    open_panel("ssd1306-128x32");
    COMMANDS("\xA8\x1F\x8D\x14\xA1\xC8\xAF\x02\x11\xB3"); /* column 0x12, page 3 */
    DATA("\xFF");
    DATA("\x80");
    for (unsigned y = 24; y < 32; y++)
        assert_glass(18, y, 1);
    assert_glass(19, 31, 1);
    assert_glass(19, 24, 0);
    assert_int_equal(chip.rectangles, 1); /* a run */
    COMMANDS("\x1F\x0F");
    DATA("\0");
    complained("pixel outside the RAM");
    close_panel();
}

static void sh1106(void **state)
{
    (void)state;
    open_panel("sh1106-128x64");
    COMMANDS("\xA8\x3F\xA1\xC8\xAF\xB7\x02\x10"); /* its glass begins at column 2 */
    DATA("\x80");
    assert_glass(0, 63, 0);
    COMMANDS("\xAD\x8B");
    assert_glass(0, 63, 1);
    COMMANDS("\x01\x18");
    DATA("\x40");
    assert_glass(127, 62, 1); /* column 0x81 = 129 */
    quiet();
    COMMANDS("\x21");
    complained("unknown command 0x21");
    close_panel();
}

/* One byte of command, then data, as for the pixels. */
static void word(uint8_t command, const char *data, size_t count)
{
    sheen_sim_receive(&chip, SHEEN_SIM_COMMAND, &command, 1);
    if (count)
        send(SHEEN_SIM_DATA, data, count);
}

#define WORD(command, data) word(command, data, sizeof(data) - 1)

/* Remap of 4 turns and start line of a 128x96 glass; where the RAM's (0, 0) must be seen. */
static void ssd1351(void **state)
{
    static const struct {
        const char remap[2], start[2];
        unsigned column, row;
    } turns[4] = {{"\x74", "\x60", 0, 0}, {"\x77", "\x60", 127, 0}, {"\x66", "\x00", 127, 95}, {"\x65", "\x00", 0, 95}};

    (void)state;
    open_panel("ssd1351-128x96");
    WORD(0xFD, "\x12");
    WORD(0xA2, "\x00");
    complained("command 0xA2 is locked");
    WORD(0xFD, "\xB1");
    WORD(0xA2, "\x00");
    WORD(0xCA, "\x7F");
    WORD(0xAF, "");
    for (unsigned r = 0; r < 4; r++) {
        word(0xA0, turns[r].remap, 1);
        word(0xA1, turns[r].start, 1);
        WORD(0x15, "\x00\x01");
        WORD(0x75, "\x00\x01");
        WORD(0x5C, "\xF8\x00\x07\xE0\x00\x1F\x12\x34");
        assert_glass(turns[r].column, turns[r].row, 0xF800);
    }
    assert_glass(0, 94, 0x07E0); /* the last turn runs along the rows first */
    assert_glass(1, 95, 0x001F);
    WORD(0xA0, "\x60");
    assert_glass(0, 95, 0x001F); /* red and blue change places: not C-B-A */
    WORD(0xA7, "");
    assert_glass(0, 95, 0xFFE0);
    WORD(0xA4, "");
    assert_glass(0, 95, 0);
    WORD(0xA5, "");
    assert_glass(0, 95, 0xFFFF);
    quiet();
    WORD(0x5C, "\x01");
    WORD(0xA6, "");
    complained("half a pixel");
    WORD(0x75, "\x00\x80");
    WORD(0x5C, "\x01\x02");
    complained("window 0..1, 0..128 of 128x128");
    WORD(0xA0, "\xB4");
    complained("only 65k colours");
    close_panel();
}

static void command_with(uint8_t code, const char *parameters, size_t count)
{
    sheen_sim_receive(&chip, SHEEN_SIM_COMMAND, &code, 1);
    send(SHEEN_SIM_DATA, parameters, count);
}

#define WITH(code, parameters) command_with(code, parameters, sizeof(parameters) - 1)

/* 256x64 of Newhaven: columns from address 1C; A0 06 11 upright, A0 14 11 upside down, both from 1C. */
static void ssd1322(void **state)
{
    (void)state;
    open_panel("ssd1322-256x64");
    WITH(0xFD, "\x12");
    WITH(0xCA, "\x3F");
    WITH(0xA0, "\x06\x11");
    WITH(0xAF, "");
    WITH(0x15, "\x1C\x1D");
    WITH(0x75, "\x00\x01");
    WITH(0x5C, "\x12\x34\x56\x78\x9A\xBC");
    for (unsigned x = 0; x < 8; x++)
        assert_glass(x, 0, (uint16_t)(1 + x));
    assert_glass(0, 1, 9);
    assert_glass(3, 1, 12);
    WITH(0x5C, "\xDE\xF0\x21\x43"); /* on where it was, then round to the start */
    assert_glass(4, 1, 13);
    assert_glass(6, 1, 15);
    assert_glass(0, 0, 2);
    assert_int_equal(chip.rectangles, 2);
    WITH(0x15, "\x5B\x5B");
    WITH(0x75, "\x3F\x3F");
    WITH(0x5C, "\x98\x76");
    assert_glass(252, 63, 9);
    assert_glass(255, 63, 6);

    WITH(0xA0, "\x14\x11");
    WITH(0x15, "\x1C\x1C");
    WITH(0x75, "\x00\x00");
    WITH(0x5C, "\xAB\xCD");
    assert_glass(255, 63, 10); /* the viewer who turned it sees A, B, C, D from the top left */
    assert_glass(254, 63, 11);
    assert_glass(252, 63, 13);
    WITH(0xA7, "");
    assert_glass(255, 63, 5);
    WITH(0xA4, "");
    assert_glass(255, 63, 0);
    quiet();

    WITH(0xA6, "");
    WITH(0x5C, "\x11");
    WITH(0x5C, "");
    complained("half a column before command");
    WITH(0x15, "\x1C\x78");
    WITH(0x5C, "\x11");
    complained("window 28..120");
    DATA("\x11"); /* the other half */
    chip.complaints = 0;
    chip.first_complaint[0] = '\0';
    WITH(0xA0, "\x06\x10");
    complained("remap 0x06 0x10");
    close_panel();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ssd0323),           cmocka_unit_test(ssd1325), cmocka_unit_test(grey_modes_and_addresses),
        cmocka_unit_test(ssd1327),           cmocka_unit_test(ssd1322), cmocka_unit_test(ssd1306),
        cmocka_unit_test(ssd1306_page_mode), cmocka_unit_test(sh1106),  cmocka_unit_test(ssd1351),
    };

    return cmocka_run_group_tests_name("controller_oled", tests, NULL, NULL);
}
