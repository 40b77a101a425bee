/*
 * record.c - a record for a module that sheen does not know, made from its data sheet and by a look at first light.
 *
 * This one is an IPS glass of 1.69 inch, 240x280, on an ST7789; its maker supplies an
 * init table. What you see in first light tells which field to change: hal/README.md.
 */
#include "record.h"

/* Command, wait after it in ms, parameters; sent after the reset, before orientation, inversion and display on. */
static const struct sheen_panel_step init[] = {
    {.command = 0x11, .wait_ms = 120},                    /* sleep out */
    {0x3A, 0, SHEEN_BYTES(0x55)},                         /* 16 bits per pixel */
    {0xB0, 0, SHEEN_BYTES(0x00, 0xC0)},                   /* copy the high bit of red and blue to the low one */
    {0xB2, 0, SHEEN_BYTES(0x0C, 0x0C, 0x00, 0x33, 0x33)}, /* porches, */
    {0xC6, 0, SHEEN_BYTES(0x0F)},                         /* and 60 frames per second, both the maker's values */
};

const struct sheen_panel_record own_module = {
    .name = "own-240x280",
    .controller = "ST7789",
    .driver = &sheen_driver_dcs,
    .init = init,
    .steps = sizeof init / sizeof init[0],
    .clock_hz = 40000000, /* as much as the wires allow here; the controller's limit is 62.5 MHz */
    .reset_low_us = 1000, /* the controller asks for 10, after a capacitor on the line is discharged */
    .reset_ms = 120,
    .pixel = SHEEN_RGB565_BE,
    .glass_w = 240,
    .glass_h = 280,
    .ram_w = 240,
    .ram_h = 320,
    .gap_y = 20, /* the glass begins at row 20 */
    .inverted = 1,
    .brightness_command = 0x51,
    .scan = {0, SHEEN_SCAN_MX | SHEEN_SCAN_MV, SHEEN_SCAN_MX | SHEEN_SCAN_MY, SHEEN_SCAN_MV | SHEEN_SCAN_MY},
};
