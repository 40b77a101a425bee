/*
 * st7796.c - the record of the ST7796S. Supply and gamma keep their power-on values, as in the driver collection
 * mipidsi.
 */
#include "record.h"

static const struct sheen_panel_step init_st7796[] = {
    {SLPOUT, 120, BARE},
    {COLMOD, 0, BYTES(0x55)},
};

/* Clock: write cycle 16 ns (ST7796S data sheet, serial interface, as reported in MicroPythonOS issue 303). */
const struct sheen_panel_record sheen_panel_st7796 = {
    .name = TEXT("st7796-320x480"),
    .controller = TEXT("ST7796S"),
    DCS,
    WRDISBV,
    INIT(init_st7796),
    .clock_hz = 62500000,
    GLASS(320, 480),
    RAM(320, 480),
    .scan = {MX, MV, MY, MX | MY | MV},
    .bgr = 1,
};
