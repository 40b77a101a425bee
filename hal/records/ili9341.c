/*
 * ili9341.c - records of the ILI9341 and of its larger relative, the ILI9488.
 *
 * The init tables are the shortest that light the glass: supply and gamma keep
 * their power-on values, as in the driver collection mipidsi.
 */
#include "record.h"

static const struct sheen_panel_step init_ili9341[] = {
    {SLPOUT, 120, BARE},
    {COLMOD, 0, BYTES(0x55)},
};

/* Clock: write cycle 100 ns (ILI9341 data sheet, 4-line serial interface, twc). */
const struct sheen_panel_record sheen_panel_ili9341 = {
    .name = TEXT("ili9341-240x320"),
    .controller = TEXT("ILI9341"),
    .note = TEXT("commonly run at 40 MHz and above"),
    DCS,
    WRDISBV,
    INIT(init_ili9341),
    .clock_hz = 10000000,
    GLASS(240, 320),
    RAM(240, 320),
    .scan = {MX, MV, MY, MX | MY | MV}, /* the source driver counts from the right */
    .bgr = 1,
};

/* On SPI it has 18 bits per pixel or 8 colours, not 16 bits (ILI9488 data sheet, "4-line serial interface"). */
static const struct sheen_panel_step init_ili9488[] = {
    {SLPOUT, 120, BARE},
    {COLMOD, 0, BYTES(0x66)},
};

/* Clock: write cycle 66 ns; this is the ILI9486's, the nearest controller with a published value. */
const struct sheen_panel_record sheen_panel_ili9488 = {
    .name = TEXT("ili9488-320x480"),
    .controller = TEXT("ILI9488"),
    .note = TEXT("three bytes a pixel; 27 to 40 MHz in use"),
    DCS,
    WRDISBV,
    .bits_18 = 1,
    INIT(init_ili9488),
    .clock_hz = 15151515,
    GLASS(320, 480),
    RAM(320, 480),
    .scan = {MX, MV, MY, MX | MY | MV},
    .bgr = 1,
};
