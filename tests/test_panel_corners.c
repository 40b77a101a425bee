/*
 * test_panel_corners.c - where the corners of a picture go, and whether a wrong record is noticed.
 *
 * The literals were written by hand from the published MADCTL and offset tables (TFT_eSPI's rotation files, Pimoroni,
 * Adafruit). Mirrored orientations exchange the two ends of the axis that the picture's x runs along.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "glass.h"
#include "test_panel_canvas.h"

/* For each orientation: MADCTL, and the column and row that are sent for the picture's top left pixel. */
static const struct {
    const char *panel;
    uint16_t wire[8][3];
} dcs_wire[] = {
    {"ili9341",
     {{0x48, 0, 0}, {0x28, 0, 0}, {0x88, 0, 0}, {0xE8, 0, 0}, {0x08, 0, 0}, {0xA8, 0, 0}, {0xC8, 0, 0}, {0x68, 0, 0}}},
    {"ili9488",
     {{0x48, 0, 0}, {0x28, 0, 0}, {0x88, 0, 0}, {0xE8, 0, 0}, {0x08, 0, 0}, {0xA8, 0, 0}, {0xC8, 0, 0}, {0x68, 0, 0}}},
    {"st7789-128x128",
     {{0x00, 0, 0},
      {0x60, 0, 112},
      {0xC0, 112, 192},
      {0xA0, 192, 0},
      {0x40, 112, 0},
      {0xE0, 192, 112},
      {0x80, 0, 192},
      {0x20, 0, 0}}},
    {"st7789-240x240",
     {{0x00, 0, 0},
      {0x60, 0, 0},
      {0xC0, 0, 80},
      {0xA0, 80, 0},
      {0x40, 0, 0},
      {0xE0, 80, 0},
      {0x80, 0, 80},
      {0x20, 0, 0}}},
    {"st7789-240x240-round",
     {{0x00, 0, 40},
      {0x60, 40, 0},
      {0xC0, 0, 40},
      {0xA0, 40, 0},
      {0x40, 0, 40},
      {0xE0, 40, 0},
      {0x80, 0, 40},
      {0x20, 40, 0}}},
    {"st7789-135x240",
     {{0x00, 52, 40},
      {0x60, 40, 53},
      {0xC0, 53, 40},
      {0xA0, 40, 52},
      {0x40, 53, 40},
      {0xE0, 40, 53},
      {0x80, 52, 40},
      {0x20, 40, 52}}},
    {"st7789-172x320",
     {{0x00, 34, 0},
      {0x60, 0, 34},
      {0xC0, 34, 0},
      {0xA0, 0, 34},
      {0x40, 34, 0},
      {0xE0, 0, 34},
      {0x80, 34, 0},
      {0x20, 0, 34}}},
    {"st7735-128x160",
     {{0xC0, 0, 0}, {0xA0, 0, 0}, {0x00, 0, 0}, {0x60, 0, 0}, {0x80, 0, 0}, {0x20, 0, 0}, {0x40, 0, 0}, {0xE0, 0, 0}}},
    {"st7735-128x160-green",
     {{0xC8, 2, 1}, {0xA8, 1, 2}, {0x08, 2, 1}, {0x68, 1, 2}, {0x88, 2, 1}, {0x28, 1, 2}, {0x48, 2, 1}, {0xE8, 1, 2}}},
    {"st7735-128x128",
     {{0xC8, 0, 32},
      {0xA8, 32, 0},
      {0x08, 0, 0},
      {0x68, 0, 0},
      {0x88, 0, 32},
      {0x28, 0, 0},
      {0x48, 0, 0},
      {0xE8, 32, 0}}},
    {"st7735-128x128-green",
     {{0xC8, 2, 3}, {0xA8, 3, 2}, {0x08, 2, 1}, {0x68, 1, 2}, {0x88, 2, 3}, {0x28, 1, 2}, {0x48, 2, 1}, {0xE8, 3, 2}}},
    {"st7735-80x160-green",
     {{0xC8, 26, 1},
      {0xA8, 1, 26},
      {0x08, 26, 1},
      {0x68, 1, 26},
      {0x88, 26, 1},
      {0x28, 1, 26},
      {0x48, 26, 1},
      {0xE8, 1, 26}}},
    {"gc9a01",
     {{0x08, 0, 0}, {0x68, 0, 0}, {0xC8, 0, 0}, {0xA8, 0, 0}, {0x48, 0, 0}, {0xE8, 0, 0}, {0x88, 0, 0}, {0x28, 0, 0}}},
};

static void offsets_on_the_wire(void **state)
{
    struct canvas canvas;

    (void)state;
    for (size_t i = 0; i < sizeof dcs_wire / sizeof dcs_wire[0]; i++) {
        for (unsigned k = 0; k < 8; k++) {
            const uint16_t *expected = dcs_wire[i].wire[k];
            const struct sheen_sim_controller *chip;

            canvas_open(&canvas, dcs_wire[i].panel, (int)k, 0, 0);
            chip = sheen_sim_panel_bus(canvas.panel)->controller;
            assert_int_equal(canvas_push(&canvas, (struct sheen_rect){0, 0, 1, 1}), 0);
            if (chip->scan != expected[0] || chip->x0 != expected[1] || chip->y0 != expected[2])
                fail_msg("%s, orientation %u: MADCTL %02X, column %u, row %u", dcs_wire[i].panel, k, chip->scan,
                         chip->x0, chip->y0);
            canvas_close(&canvas);
        }
    }
}

/*
 * Where the picture's top left, top right, bottom left are on the glass at rotation 0: t top, b bottom, l left, r
 * right.
 */
static const char *const corners[8] = {"tl tr bl", "tr br tl", "br bl tr", "bl tl br",
                                       "tr tl br", "br tr bl", "bl br tl", "tl bl tr"};

/* Checks one corner of the glass. Its value differs from 0 and from the noise around it. */
static void assert_corner(const struct canvas *canvas, const char *corner, uint16_t value, unsigned k)
{
    const struct sheen_sim_controller *chip = sheen_sim_panel_bus(canvas->panel)->controller;
    unsigned column = corner[1] == 'l' ? 0 : chip->module->glass_w - 1u;
    unsigned row = corner[0] == 't' ? 0 : chip->module->glass_h - 1u;

    if (sheen_sim_glass(chip, column, row) != value)
        fail_msg("%s, orientation %u: glass %.2s is %04X, not %04X", chip->module->name, k, corner,
                 sheen_sim_glass(chip, column, row), value);
}

static void corners_on_the_glass(void **state)
{
    static const char *const panels[] = {
        "ili9341", "st7789-135x240", "st7735-128x128-green", "st7796", "ssd1351-128x96",      "ssd0323",
        "ssd1325", "ssd1327-96x96",  "ssd1306-72x40",        "sh1106", "sh1106-128x64-nogap", "ili9488",
        "ssd1322", "st7789-128x128"};
    struct canvas canvas;

    (void)state;
    for (size_t i = 0; i < sizeof panels / sizeof panels[0]; i++) {
        for (unsigned k = 0; k < 8; k++) {
            canvas_open(&canvas, panels[i], (int)k, 0, 0);
            assert_int_equal(canvas_push_all(&canvas, 64), 0);
            unsigned w = canvas.target->width, h = canvas.target->height;

            assert_corner(&canvas, corners[k], canvas.ideal[0], k);
            assert_corner(&canvas, corners[k] + 3, canvas.ideal[w - 1], k);
            assert_corner(&canvas, corners[k] + 6, canvas.ideal[(h - 1) * w], k);
            canvas_close(&canvas);
        }
    }
}

/* Pushes with `record`, which has one fault: pixels must differ or the controller must complain. */
static void assert_seen(const struct sheen_panel_record *record, const char *what)
{
    for (unsigned k = 0; k < 8; k++) {
        struct sheen_sim_choice choice = {.record = record, .orientation = k};
        struct canvas canvas;

        sheen_panel_size(record, k, &choice.width, &choice.height);
        canvas_open_choice(&canvas, &choice);
        assert_int_equal(canvas_push_all(&canvas, 64), 0);
        if (canvas_differences(&canvas) == 0 && sheen_sim_panel_complaints(canvas.panel) == 0)
            fail_msg("%s, orientation %u: nobody sees %s", record->name, k, what);
        canvas_close(&canvas);
    }
}

static void wrong_records_are_seen(void **state)
{
    static const char *const panels[] = {"ili9341", "st7789-135x240", "st7735-80x160-green", "gc9a01",
                                         "ssd1351-128x96"};

    (void)state;
    for (size_t i = 0; i < sizeof panels / sizeof panels[0]; i++) {
        const struct sheen_panel_record right = *sheen_panel_find(panels[i]);
        int dcs = strncmp(panels[i], "ssd", 3) != 0;
        struct sheen_panel_record wrong = right;

        wrong.bgr = !wrong.bgr;
        assert_seen(&wrong, "the colour order");
        for (unsigned bit = 0; bit < 3; bit++) {
            static const uint8_t dcs_bits[3] = {0x80, 0x40, 0x20}, ssd_bits[3] = {0x10, 0x02, 0x01};

            wrong = right;
            for (unsigned r = 0; r < 4; r++)
                wrong.scan[r] ^= dcs ? dcs_bits[bit] : ssd_bits[bit];
            assert_seen(&wrong, "a scan bit");
        }
        if (!dcs)
            continue;
        wrong = right;
        wrong.inverted = !wrong.inverted;
        assert_seen(&wrong, "the inversion");
        if (wrong.ram_w == wrong.glass_w)
            continue;
        wrong = right;
        wrong.gap_x++;
        assert_seen(&wrong, "the column offset");
        wrong = right;
        wrong.gap_y--;
        assert_seen(&wrong, "the row offset");
    }
}

static void wrong_grey_and_mono_records_are_seen(void **state)
{
    struct sheen_panel_record wrong;

    (void)state;
    for (unsigned bit = 0; bit < 5; bit++) {
        if (bit == 3)
            continue;
        wrong = *sheen_panel_find("ssd1327-96x96");
        wrong.scan[0] ^= (uint8_t)(1u << bit);
        assert_seen(&wrong, "a remap bit");
    }
    wrong = *sheen_panel_find("ssd1327-96x96");
    wrong.gap_x = 14;
    assert_seen(&wrong, "the column offset");
    for (unsigned bit = 0; bit < 5; bit++) {
        if (bit == 3)
            continue;
        wrong = *sheen_panel_find("ssd1322");
        wrong.scan[0] ^= (uint8_t)(1u << bit);
        assert_seen(&wrong, "a remap bit");
    }
    wrong = *sheen_panel_find("ssd1322");
    wrong.gap_x = 108;
    assert_seen(&wrong, "the column offset");
    wrong = *sheen_panel_find("sh1106-128x64-nogap");
    wrong.gap_x = 2;
    assert_seen(&wrong, "the column offset");
    wrong = *sheen_panel_find("ili9488");
    wrong.bits_18 = 0;
    assert_seen(&wrong, "pixels of two bytes");
    wrong = *sheen_panel_find("sh1106");
    wrong.gap_x = 0;
    assert_seen(&wrong, "the column offset");
    wrong = *sheen_panel_find("ssd1306-72x40");
    wrong.gap_x = 27;
    assert_seen(&wrong, "the column offset");
    /* Leave out one init step: multiplex, charge pump, addresses, remap, COM lines, the segments' current. */
    for (const char *command = "\xA8\x8D\x20\xA1\xC8\xAD"; *command != 0; command++) {
        static struct sheen_panel_step steps[32];
        const struct sheen_panel_record *right = sheen_panel_find("ssd1306-72x40");
        unsigned used = 0;

        for (unsigned i = 0; i < right->steps; i++)
            if (right->init[i].command != (uint8_t)*command)
                steps[used++] = right->init[i];
        assert_int_equal(used, right->steps - 1u);
        wrong = *right;
        wrong.init = steps;
        wrong.steps = (uint8_t)used;
        assert_seen(&wrong, "a missing init step");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(offsets_on_the_wire),
        cmocka_unit_test(corners_on_the_glass),
        cmocka_unit_test(wrong_records_are_seen),
        cmocka_unit_test(wrong_grey_and_mono_records_are_seen),
    };

    return cmocka_run_group_tests_name("panel_corners", tests, NULL, NULL);
}
