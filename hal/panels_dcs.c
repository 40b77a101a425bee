/*
 * panels_dcs.c - records of the MIPI-DCS panels.
 *
 * The init tables are the shortest that bring the glass to life: sleep out and
 * 16-bit pixels; the driver adds orientation, inversion and display on. Power,
 * VCOM and gamma registers keep their power-on values.
 */
#include "panel_driver.h"

#define SLPOUT 0x11
#define COLMOD 0x3A

#define MY 0x80
#define MX 0x40
#define MV 0x20

/* The last two fields of a step. */
#define NONE 0, NULL
#define BYTES(...) sizeof((const uint8_t[]){__VA_ARGS__}), ((const uint8_t[]){__VA_ARGS__})
#define INIT(table) .init = table, .steps = sizeof table / sizeof table[0]

/*
 * Reset: 10 us low at least (ILI9341 data sheet v1.11, 15.4 "Reset Timing", tRW),
 * then 120 ms before sleep out, the longer of its two tRT: the state before is unknown.
 * Sleep out: 120 ms before display on lets the supply settle (ibid. 8.2.12, SLPOUT).
 * COLMOD 55: 16 bits for both interfaces (ibid. 8.2.33).
 */
#define RESET_DCS .reset_low_us = 10, .reset_ms = 120

static const struct sheen_panel_step init_ili9341[] = {
    {SLPOUT, 120, NONE},
    {COLMOD, 0, BYTES(0x55)},
};

/*
 * Clock: write cycle tWC 100 ns at least (ibid. 19.3.4, 4-line serial). Many modules
 * run at 40 MHz. The source driver counts from the right, so that upright is MX.
 */
const struct sheen_panel_record sheen_panel_ili9341 = {
    .name = "ili9341-240x320",
    .controller = "ILI9341",
    .note = "modules are run at 40 MHz and above",
    .driver = &sheen_driver_dcs,
    INIT(init_ili9341),
    .clock_hz = 10000000,
    .glass_w = 240,
    .glass_h = 320,
    .ram_w = 240,
    .ram_h = 320,
    RESET_DCS,
    .pixel = SHEEN_RGB565_BE,
    .scan = {MX, MV, MY, MX | MY | MV},
    .bgr = 1,
};
