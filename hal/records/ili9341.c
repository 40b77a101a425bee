/*
 * ili9341.c - the record of the ILI9341.
 *
 * The shortest init table that brings the glass to life: supply and gamma stay as
 * they power on, as in the driver collection mipidsi.
 */
#include "record.h"

static const struct sheen_panel_step init_ili9341[] = {
    {SLPOUT, 120, NONE},
    {COLMOD, 0, BYTES(0x55)},
};

/* Clock: write cycle 100 ns (ILI9341 data sheet, 4-line serial interface, twc). */
const struct sheen_panel_record sheen_panel_ili9341 = {
    .name = "ili9341-240x320",
    .controller = "ILI9341",
    .note = "commonly run at 40 MHz and above",
    DCS,
    WRDISBV,
    INIT(init_ili9341),
    .clock_hz = 10000000,
    GLASS(240, 320),
    RAM(240, 320),
    .scan = {MX, MV, MY, MX | MY | MV}, /* the source driver counts from the right */
    .bgr = 1,
};
