/*
 * panels_dcs.c - records of the MIPI-DCS panels.
 *
 * The init tables are the shortest that bring a glass to life. ILI9341, ST7789
 * and ST7796 keep their power-on supply and gamma registers, as the driver
 * collection mipidsi does; ST7735 and GC9A01 need theirs set.
 *
 * By the gap rule of panel_driver.h every published offset of these modules
 * follows from three pairs: RAM, glass and gap. The one that is said to break it,
 * the green-tab 128x128 ST7735 (rows 3 from one end, 1 from the other), keeps it
 * once its RAM is taken as 132x132, which is how its mode pins are strapped.
 */
#include "panel_driver.h"
#include "panel_tables.h"

#define SLPOUT 0x11
#define COLMOD 0x3A

#define MY 0x80
#define MX 0x40
#define MV 0x20

/*
 * Reset: low for 10 us at least, then 120 ms before sleep out, the longer of the
 * two rests since the state before is unknown (ILI9341 data sheet, reset timing,
 * tRW and tRT; ST7789V data sheet likewise). Sleep out: 120 ms before display on
 * (ibid., SLPOUT). COLMOD: 16 bits a pixel (ibid., COLMOD).
 */
#define RESET .reset_low_us = 10, .reset_ms = 120
#define DCS .driver = &sheen_driver_dcs, .pixel = SHEEN_RGB565_BE, RESET

static const struct sheen_panel_step init_short[] = {
    {SLPOUT, 120, NONE},
    {COLMOD, 0, BYTES(0x55)},
};

/* Clock: write cycle 100 ns (ILI9341 data sheet, 4-line serial interface, twc). */
const struct sheen_panel_record sheen_panel_ili9341 = {
    .name = "ili9341-240x320",
    .controller = "ILI9341",
    .note = "commonly run at 40 MHz and above",
    DCS,
    INIT(init_short),
    .clock_hz = 10000000,
    GLASS(240, 320),
    RAM(240, 320),
    .scan = {MX, MV, MY, MX | MY | MV}, /* the source driver counts from the right */
    .bgr = 1,
};

/* Clock: write cycle 16 ns (ST7796S data sheet, serial interface, as reported in MicroPythonOS issue 303). */
const struct sheen_panel_record sheen_panel_st7796 = {
    .name = "st7796-320x480",
    .controller = "ST7796S",
    DCS,
    INIT(init_short),
    .clock_hz = 62500000,
    GLASS(320, 480),
    RAM(320, 480),
    .scan = {MX, MV, MY, MX | MY | MV},
    .bgr = 1,
};

/*
 * RAMCTRL B0 = 00 C0: the low bit of red and blue is copied from the high one when
 * 5 bits become 6 (Pimoroni pimoroni-pico issue 1040: else greys show bands).
 */
static const struct sheen_panel_step init_st7789[] = {
    {SLPOUT, 120, NONE},
    {COLMOD, 0, BYTES(0x55)},
    {0xB0, 0, BYTES(0x00, 0xC0)},
};

/* Clock: write cycle 16 ns (ST7789V data sheet, 4-line serial interface, TSCYCW). All of these are IPS: inverted. */
#define ST7789                                                                                                         \
    .controller = "ST7789", DCS, INIT(init_st7789), .clock_hz = 62500000, RAM(240, 320),                               \
    .scan = {0, MX | MV, MX | MY, MV | MY}, .inverted = 1

const struct sheen_panel_record sheen_panel_st7789_240x320 = {
    .name = "st7789-240x320", ST7789, GLASS(240, 320), .note = "TN glass (2.8 in) is not inverted"};

/* Modules without CS hold the clock high between bytes, else they lose count: mode 3. It suits those with CS too. */
const struct sheen_panel_record sheen_panel_st7789_240x240 = {
    .name = "st7789-240x240", ST7789, GLASS(240, 240), .spi_mode = 3, .note = "mode 3 for modules without CS"};

const struct sheen_panel_record sheen_panel_st7789_240x240_round = {
    .name = "st7789-240x240-round", ST7789, GLASS(240, 240), .gap_y = 40, .round = 1};

const struct sheen_panel_record sheen_panel_st7789_240x280 = {
    .name = "st7789-240x280", ST7789, GLASS(240, 280), .gap_y = 20, .note = "rounded corners hide some pixels"};

const struct sheen_panel_record sheen_panel_st7789_135x240 = {
    .name = "st7789-135x240", ST7789, GLASS(135, 240), .gap_x = 52, .gap_y = 40};

const struct sheen_panel_record sheen_panel_st7789_170x320 = {
    .name = "st7789-170x320", ST7789, GLASS(170, 320), .gap_x = 35};

const struct sheen_panel_record sheen_panel_st7789_172x320 = {
    .name = "st7789-172x320", ST7789, GLASS(172, 320), .gap_x = 34, .note = "rounded corners hide some pixels"};

const struct sheen_panel_record sheen_panel_st7789_76x284 = {.name = "st7789-76x284",
                                                             ST7789,
                                                             GLASS(76, 284),
                                                             .gap_x = 82,
                                                             .gap_y = 18,
                                                             .note = "quarter turns by rule, not confirmed on glass"};
