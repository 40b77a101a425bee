/*
 * ssd1322.c - the record of the SSD1322: 256x64, 16 greys.
 *
 * Values as in u8g2 (for Newhaven's glass), which has driven many of these modules; the
 * data sheet was not at hand. The RAM is 480 columns wide; the glass is in its middle,
 * from column address 1C on (4 px per address). Remap 06 11 makes the picture upright:
 * segments count from the last, the first nibble is the left pixel, COM lines are in
 * pairs; 14 11 would be upside down.
 */
#include "record.h"

static const struct sheen_panel_step init_ssd1322[] = {
    {0xFD, 0, BYTES(0x12)},       /* unlock */
    {0xAE, 0, BARE},              /* off */
    {0xB3, 0, BYTES(0x91)},       /* clock: 80 frames/s */
    {0xCA, 0, BYTES(0x3F)},       /* 64 lines */
    {0xA2, 0, BYTES(0x00)},       /* offset */
    {0xA1, 0, BYTES(0x00)},       /* start line */
    {0xAB, 0, BYTES(0x01)},       /* internal supply */
    {0xB4, 0, BYTES(0xA0, 0xFD)}, /* enhancement A: external VSL */
    {0xC1, 0, BYTES(0x9F)},       /* contrast */
    {0xC7, 0, BYTES(0x0F)},       /* master contrast */
    {0xB9, 0, BARE},              /* linear grey table */
    {0xB1, 0, BYTES(0xE2)},       /* phases */
    {0xD1, 0, BYTES(0xA2, 0x20)}, /* enhancement B: none */
    {0xBB, 0, BYTES(0x1F)},       /* precharge, */
    {0xB6, 0, BYTES(0x08)},       /* second precharge */
    {0xBE, 0, BYTES(0x07)},       /* VCOMH */
    {0xA6, 0, BARE},              /* show the RAM, */
    {0xA9, 0, BARE},              /* all of it */
};

/* Clock: cycle 100 ns, which u8g2 quotes from the data sheet. */
const struct sheen_panel_record sheen_panel_ssd1322 = {
    .name = TEXT("ssd1322-256x64"),
    .controller = TEXT("SSD1322"),
    .driver = &sheen_driver_ssd1322,
    .pixel = SHEEN_GREY16,
    OLED,
    INIT(init_ssd1322),
    .clock_hz = 10000000,
    GLASS(256, 64),
    RAM(480, 128),
    .gap_x = 112,
    .scan = {0x06, 0x11},
    .brightness_command = 0xC1,
};
