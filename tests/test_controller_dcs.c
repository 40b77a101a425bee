/*
 * test_controller_dcs.c - the simulated DCS controller, fed by hand: no driver is involved.
 *
 * Corners are literals: where the first, last and third corner of a picture must
 * stand on the glass for a MADCTL byte, from the data sheets' address mapping.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "glass.h"
#include "sheen_target.h"

#define RED 0xF800
#define GREEN 0x07E0
#define BLUE 0x001F

static struct sheen_sim_controller chip;

static void command(uint8_t code, const char *data, size_t count)
{
    sheen_sim_receive(&chip, SHEEN_SIM_COMMAND, &code, 1);
    if (count)
        sheen_sim_receive(&chip, SHEEN_SIM_DATA, (const uint8_t *)data, count);
}

/* Parameters as a string of bytes. */
#define SEND(code, bytes) command(code, bytes, sizeof(bytes) - 1)

static void open_panel(const char *name)
{
    assert_int_equal(sheen_sim_controller_open(&chip, sheen_sim_module_find(name)), 0);
}

static void wake(void)
{
    sheen_sim_advance(&chip, 120000);
    SEND(0x11, "");
    sheen_sim_advance(&chip, 120000);
    SEND(0x3A, "\x55");
    SEND(0x29, "");
}

static int set_up(void **state)
{
    (void)state;
    open_panel("ili9341-240x320");
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    sheen_sim_controller_close(&chip);
    return 0;
}

static void quiet(void)
{
    assert_string_equal(chip.first_complaint, "");
    assert_int_equal(chip.complaints, 0);
}

/* Exactly the next complaint, which must contain the text; then starts afresh. */
static void complained(const char *text)
{
    if (!strstr(chip.first_complaint, text))
        fail_msg("expected a complaint with '%s', got '%s'", text, chip.first_complaint);
    chip.complaints = 0;
    chip.first_complaint[0] = '\0';
}

static void pixel(unsigned x, unsigned y, uint16_t value)
{
    char column[4] = {(char)(x >> 8), (char)x, (char)(x >> 8), (char)x};
    char row[4] = {(char)(y >> 8), (char)y, (char)(y >> 8), (char)y};
    char bytes[2] = {(char)(value >> 8), (char)value};

    command(0x2A, column, 4);
    command(0x2B, row, 4);
    command(0x2C, bytes, 2);
}

static void assert_glass(unsigned column, unsigned row, uint16_t value)
{
    assert_int_equal(sheen_sim_glass(&chip, column, row), value);
}

/* MADCTL of the 8 orientations of an ILI9341, and where top left, top right and bottom left stand on its glass. */
static const struct {
    const char madctl[2];
    uint16_t w, h, glass[3][2];
} ili9341_corners[8] = {
    {"\x48", 240, 320, {{0, 0}, {239, 0}, {0, 319}}},     {"\x28", 320, 240, {{239, 0}, {239, 319}, {0, 0}}},
    {"\x88", 240, 320, {{239, 319}, {0, 319}, {239, 0}}}, {"\xE8", 320, 240, {{0, 319}, {0, 0}, {239, 319}}},
    {"\x08", 240, 320, {{239, 0}, {0, 0}, {239, 319}}},   {"\xA8", 320, 240, {{239, 319}, {239, 0}, {0, 319}}},
    {"\xC8", 240, 320, {{0, 319}, {239, 319}, {0, 0}}},   {"\x68", 320, 240, {{0, 0}, {0, 319}, {239, 0}}},
};

static void corners(void **state)
{
    (void)state;
    wake();
    for (unsigned k = 0; k < 8; k++) {
        unsigned w = ili9341_corners[k].w, h = ili9341_corners[k].h;
        const uint16_t(*glass)[2] = ili9341_corners[k].glass;

        command(0x36, ili9341_corners[k].madctl, 1);
        pixel(0, 0, RED);
        pixel(w - 1, 0, GREEN);
        pixel(0, h - 1, BLUE);
        assert_glass(glass[0][0], glass[0][1], RED);
        assert_glass(glass[1][0], glass[1][1], GREEN);
        assert_glass(glass[2][0], glass[2][1], BLUE);
    }
    quiet();
}

/* The viewer of orientation k finds his corners at the same places. */
static void viewer(void **state)
{
    unsigned column, row;

    (void)state;
    for (unsigned k = 0; k < 8; k++) {
        const uint16_t(*glass)[2] = ili9341_corners[k].glass;
        const unsigned at[3][2] = {{0, 0}, {ili9341_corners[k].w - 1u, 0}, {0, ili9341_corners[k].h - 1u}};

        for (unsigned i = 0; i < 3; i++) {
            sheen_sim_glass_place(chip.module, k, at[i][0], at[i][1], &column, &row);
            assert_int_equal(column, glass[i][0]);
            assert_int_equal(row, glass[i][1]);
        }
    }
}

static void window_and_continuation(void **state)
{
    (void)state;
    wake();
    SEND(0x36, "\x48");
    SEND(0x2A, "\x00\x0A\x00\x0B"); /* columns 10, 11 */
    SEND(0x2B, "\x00\x05\x00\x06"); /* rows 5, 6 */
    SEND(0x2C, "\xF8\x00\x07\xE0\x00\x1F");
    SEND(0x3C, "\xFF\xFF");
    assert_glass(10, 5, RED);
    assert_glass(11, 5, GREEN);
    assert_glass(10, 6, BLUE);
    assert_glass(11, 6, 0xFFFF);
    SEND(0x2C, "\x12\x34"); /* starts over */
    assert_glass(10, 5, 0x1234);
    assert_glass(11, 5, GREEN);
    quiet();
    assert_int_equal(chip.rectangles, 2);
    SEND(0x2C, "\0\0\0\0\0\0\0\0\0\0");
    complained("pixel outside the window 10..11, 5..6");
}

static void dark_before_display_on(void **state)
{
    (void)state;
    sheen_sim_advance(&chip, 120000);
    SEND(0x36, "\x48");
    SEND(0x3A, "\x55");
    pixel(0, 0, RED);
    assert_glass(0, 0, 0);
    SEND(0x11, "");
    sheen_sim_advance(&chip, 120000);
    assert_glass(0, 0, 0);
    SEND(0x29, "");
    assert_glass(0, 0, RED);
    SEND(0x28, "");
    assert_glass(0, 0, 0);
    SEND(0x29, "");
    SEND(0x10, "");
    assert_glass(0, 0, 0);
    quiet();
}

static void colour_order_and_inversion(void **state)
{
    (void)state;
    wake();
    SEND(0x36, "\x40"); /* not BGR, but the glass is */
    pixel(3, 3, RED);
    assert_glass(3, 3, BLUE);
    SEND(0x36, "\x48");
    assert_glass(3, 3, RED);
    SEND(0x21, "");
    assert_glass(3, 3, 0x07FF);
    SEND(0x20, "");
    assert_glass(3, 3, RED);
    quiet();
}

static void reset_line(void **state)
{
    (void)state;
    wake();
    pixel(0, 0, RED);
    sheen_sim_reset_line(&chip, 0);
    SEND(0x29, "");
    complained("while the reset line is low");
    sheen_sim_advance(&chip, 10);
    sheen_sim_reset_line(&chip, 1);
    assert_glass(239, 0, 0); /* asleep again */
    sheen_sim_advance(&chip, 4999);
    SEND(0x36, "\x48");
    complained("command 0x36 comes 1 us too early");
    sheen_sim_advance(&chip, 1);
    SEND(0x36, "\x48");
    quiet();
    SEND(0x11, "");
    complained("sleep out comes 115000 us too early");

    sheen_sim_reset_line(&chip, 0);
    sheen_sim_advance(&chip, 9);
    sheen_sim_reset_line(&chip, 1);
    complained("reset low for 9 us, needs 10");
}

static void waits(void **state)
{
    (void)state;
    wake();
    quiet();
    SEND(0x01, "");
    sheen_sim_advance(&chip, 4000);
    SEND(0x20, "");
    complained("command 0x20 comes 1000 us too early");
    sheen_sim_advance(&chip, 116000);
    SEND(0x11, "");
    SEND(0x20, "");
    complained("5000 us too early");
    sheen_sim_advance(&chip, 119999);
    SEND(0x29, "");
    complained("display on comes 1 us too early after sleep out");
    sheen_sim_advance(&chip, 1);
    SEND(0x29, "");
    quiet();
    SEND(0x01, "");
    sheen_sim_advance(&chip, 5000);
    SEND(0x29, "");
    complained("display on in sleep mode");
}

static void nonsense(void **state)
{
    (void)state;
    wake();
    SEND(0xF7, "");
    complained("unknown command 0xF7");
    SEND(0x2A, "\0\x10\0\x0F");
    complained("CASET 16..15 of 240");
    SEND(0x2A, "\0\0\0\xF0");
    complained("CASET 0..240 of 240");
    SEND(0x2B, "\0\0\x01\x40");
    complained("RASET 0..320 of 320");
    SEND(0x36, "\x28"); /* turned: columns are the long side */
    SEND(0x2A, "\0\0\x01\x3F");
    SEND(0x2B, "\0\0\0\xEF");
    quiet();
    SEND(0x36, "\x48"); /* the window no longer fits */
    SEND(0x2A, "\x01\x3F\x01\x3F");
    complained("CASET 319..319 of 240");
    SEND(0x2C, "\0\0");
    complained("pixel outside the RAM");
    SEND(0x2A, "\0\0\0");
    SEND(0x20, "");
    complained("command 0x2A misses 1 of its parameters");
    SEND(0x20, "\x01");
    complained("data 0x01, but command 0x20 takes no more");
    SEND(0x36, "\x48\x00");
    complained("command 0x36 takes no more");
    SEND(0x36, "\x49");
    complained("reserved bits");
    SEND(0x2A, "\0\0\0\x01");
    SEND(0x2C, "\x01\x02\x03");
    SEND(0x20, "");
    complained("half a pixel");
    SEND(0x3A, "\x66");
    complained("COLMOD 0x66");
    SEND(0x2C, "");
    complained("pixels at COLMOD 0x66");
}

/* Complaints are counted; the text is the first's. */
static void first_text_stays(void **state)
{
    (void)state;
    wake();
    SEND(0xF7, "");
    SEND(0xF8, "");
    assert_int_equal(chip.complaints, 2);
    assert_string_equal(chip.first_complaint, "ili9341-240x320: unknown command 0xF7");
}

static void power_cycle(void **state)
{
    (void)state;
    wake();
    SEND(0x36, "\x48");
    for (unsigned x = 0; x < 240; x++)
        pixel(x, 0, 0);
    sheen_sim_power_cycle(&chip);
    assert_glass(0, 0, 0);
    wake();
    SEND(0x36, "\x48");
    unsigned lit = 0;
    for (unsigned x = 0; x < 240; x++)
        lit += sheen_sim_glass(&chip, x, 0) != 0;
    assert_true(lit > 200); /* noise, not the black that was there */
    quiet();
}

static void expansion(void **state)
{
    uint8_t rgb[3];

    (void)state;
    sheen_sim_expand(0x8410, 0, rgb); /* 16, 32, 16 */
    assert_memory_equal(rgb, ((uint8_t[]){0x84, 0x82, 0x84}), 3);
    sheen_sim_expand(0xFFFF, 0, rgb);
    assert_memory_equal(rgb, ((uint8_t[]){255, 255, 255}), 3);
    sheen_sim_expand(7, 15, rgb);
    assert_memory_equal(rgb, ((uint8_t[]){119, 119, 119}), 3);
    sheen_sim_expand(1, 1, rgb);
    assert_memory_equal(rgb, ((uint8_t[]){255, 255, 255}), 3);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

/* Three bytes a pixel, their upper six bits; nothing else is taken by SPI. */
static void eighteen_bits(void **state)
{
    (void)state;
    tear_down(state);
    open_panel("ili9488-320x480");
    sheen_sim_advance(&chip, 120000);
    SEND(0x11, "");
    sheen_sim_advance(&chip, 120000);
    SEND(0x29, "");
    SEND(0x2C, "");
    complained("pixels at COLMOD 0x55");
    SEND(0x3A, "\x55");
    complained("only 18 bits");
    SEND(0x3A, "\x66");
    SEND(0x36, "\x48");
    SEND(0x2A, "\0\0\0\1");
    SEND(0x2B, "\0\0\0\1");
    SEND(0x2C, "\xFF\0\0\0\xFF\0");
    assert_glass(0, 0, RED);
    assert_glass(1, 0, GREEN);
    SEND(0x3C, "\3\3\xFF\x84\x82\x84"); /* on where it stopped; the low two bits do not count */
    assert_glass(0, 1, BLUE);
    assert_glass(1, 1, 0x8410);
    quiet();
    SEND(0x2C, "\xFF\xFF");
    SEND(0x13, "");
    complained("half a pixel");
}

/* 53 has the backlight follow 51, 35 switches the TE output on; a reset ends both. */
static void brightness_and_tearing(void **state)
{
    (void)state;
    wake();
    SEND(0x51, "\x80");
    assert_int_equal(chip.brightness, 0x80);
    assert_int_equal(chip.lit_by_it, 0);
    SEND(0x53, "\x2C");
    assert_int_equal(chip.lit_by_it, 1);
    assert_int_equal(sheen_sim_tearing(&chip), SHEEN_ERR_TIMEOUT);
    SEND(0x35, "\0");
    assert_int_equal(sheen_sim_tearing(&chip), 0);
    assert_int_equal(chip.now_us % 16667, 0);
    SEND(0x34, "");
    assert_int_equal(sheen_sim_tearing(&chip), SHEEN_ERR_TIMEOUT);
    SEND(0x01, "");
    assert_int_equal(chip.brightness + chip.lit_by_it, 0);
    quiet();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(corners),
        TEST(viewer),
        TEST(window_and_continuation),
        TEST(dark_before_display_on),
        TEST(colour_order_and_inversion),
        TEST(reset_line),
        TEST(waits),
        TEST(nonsense),
        TEST(first_text_stays),
        TEST(power_cycle),
        TEST(expansion),
        TEST(eighteen_bits),
        TEST(brightness_and_tearing),
    };

    return cmocka_run_group_tests_name("controller_dcs", tests, NULL, NULL);
}
