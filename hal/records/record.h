/*
 * record.h - private to hal/records: short forms for writing records.
 */
#ifndef SHEEN_RECORD_H
#define SHEEN_RECORD_H

#include "sheen_panel.h"

/* The last two fields of a step: no parameters, or the bytes given. */
#define BARE 0, NULL
#define BYTES SHEEN_BYTES

/* An array instead of a string literal: literals of a file are linked all together, even if one record is named. */
#define TEXT(string) ((const char[]){string})

#define INIT(table) .init = table, .steps = sizeof table / sizeof table[0]
#define GLASS(w, h) .glass_w = w, .glass_h = h
#define RAM(w, h) .ram_w = w, .ram_h = h

#define MY SHEEN_SCAN_MY
#define MX SHEEN_SCAN_MX
#define MV SHEEN_SCAN_MV

/* Commands of the MIPI-DCS panels. */
#define WRDISBV .brightness_command = 0x51
#define SLPOUT 0x11
#define COLMOD 0x3A

/*
 * How long the reset line is driven low. Controllers ask for 2 to 100 us, but many
 * modules have a capacitor of 100 nF on the line, which a pin of 4 mA discharges in 83 us.
 */
#define RESET_LOW .reset_low_us = 1000

/*
 * MIPI-DCS. Reset: low for at least 10 us, then 120 ms before sleep out: the longer of
 * the two waits given, because the state before the reset is unknown (ILI9341 data sheet,
 * reset timing, tRW and tRT; ST7789V data sheet likewise). Sleep out: 120 ms before
 * display on (ibid., SLPOUT). COLMOD: 16 bits per pixel (ibid., COLMOD).
 */
#define DCS .driver = &sheen_driver_dcs, .pixel = SHEEN_RGB565_BE, RESET_LOW, .reset_ms = 120

/*
 * OLED. Reset: the data sheets ask for 2 to 100 us low ("Power ON and OFF sequence",
 * t1); u8g2 waits 100 ms after it, because the supply of some modules needs that.
 */
#define I2C .i2c_address = 0x3C
#define OLED RESET_LOW, .reset_ms = 100

#endif
