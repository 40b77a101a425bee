/*
 * sh1106.c - records of the SH1106: black and white.
 *
 * A1 and C8 in the init table make the picture upright; all other orientations are
 * the driver's work. Values as in u8g2, registers as in the data sheet (reset: 10 us).
 */
#include "record.h"

static const struct sheen_panel_step init_sh1106[] = {
    {0xAE, 0, BARE},        /* off */
    {0xD5, 0, BYTES(0x80)}, /* clock */
    {0xA8, 0, BYTES(0x3F)}, /* 64 lines */
    {0xD3, 0, BYTES(0x00)}, /* offset */
    {0x40, 0, BARE},        /* start line 0 */
    {0xAD, 0, BYTES(0x8B)}, /* DC-DC on */
    {0xA1, 0, BARE},        /* columns from the last segment */
    {0xC8, 0, BARE},        /* rows from the last COM line */
    {0xDA, 0, BYTES(0x12)}, /* COM wiring: alternating */
    {0x81, 0, BYTES(0xCF)}, /* contrast */
    {0xD9, 0, BYTES(0xF1)}, /* precharge */
    {0xDB, 0, BYTES(0x40)}, /* VCOMH */
    {0xA4, 0, BARE},        /* show the RAM, */
    {0xA6, 0, BARE},        /* not inverted */
};

/* Clock: u8g2 uses 4 MHz (the Linux driver 2 MHz). */
#define SH1106                                                                                                         \
    .controller = TEXT("SH1106"), .driver = &sheen_driver_sh1106, .brightness_command = 0x81, .pixel = SHEEN_GREY2,    \
    OLED, I2C, INIT(init_sh1106), .clock_hz = 4000000, GLASS(128, 64), RAM(132, 64)

const struct sheen_panel_record sheen_panel_sh1106 = {
    .name = TEXT("sh1106-128x64"), SH1106, .gap_x = 2, .note = TEXT("the glass in the middle of 132 columns")};
const struct sheen_panel_record sheen_panel_sh1106_nogap = {
    .name = TEXT("sh1106-128x64-nogap"), SH1106, .note = TEXT("the glass at column 0")};
