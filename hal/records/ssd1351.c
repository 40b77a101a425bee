/*
 * ssd1351.c - records of the colour OLED SSD1351.
 *
 * Values that the data sheet leaves to the module's maker are those of u8g2 and TFT_eSPI.
 * Multiplex ratio, offset and remap are such that RAM column 0, row 0 is the top left
 * pixel of the upright glass.
 */
#include "record.h"

static const struct sheen_panel_step init_ssd1351[] = {
    {0xFD, 0, BYTES(0x12)},             /* unlock commands, */
    {0xFD, 0, BYTES(0xB1)},             /* also A2, B1, B3, BE, C1 */
    {0xAE, 0, BARE},                    /* off */
    {0xB3, 0, BYTES(0xF1)},             /* clock */
    {0xCA, 0, BYTES(0x7F)},             /* 128 lines, on shorter glass too */
    {0xA2, 0, BYTES(0x00)},             /* offset */
    {0xB5, 0, BYTES(0x00)},             /* GPIO off */
    {0xAB, 0, BYTES(0x01)},             /* internal supply */
    {0xB1, 0, BYTES(0x32)},             /* precharge */
    {0xBE, 0, BYTES(0x05)},             /* VCOMH */
    {0xA6, 0, BARE},                    /* not inverted */
    {0xC1, 0, BYTES(0xC8, 0x80, 0xC8)}, /* contrast A, B, C */
    {0xC7, 0, BYTES(0x0F)},             /* master contrast */
    {0xB4, 0, BYTES(0xA0, 0xB5, 0x55)}, /* external VSL */
    {0xB6, 0, BYTES(0x01)},             /* second precharge */
};

/*
 * Clock: cycle 50 ns (SSD1351 data sheet, table 13-4). scan: remap 60 is 65k colours and
 * COM split; + 01 vertical addresses, + 02 columns from the last, + 10 COM lines from the
 * last (ibid., A0h).
 */
#define SSD1351                                                                                                        \
    .controller = TEXT("SSD1351"), .driver = &sheen_driver_ssd1351, .brightness_command = 0xC7, .brightness_shift = 4, \
    .pixel = SHEEN_RGB565_BE, INIT(init_ssd1351), .clock_hz = 20000000, RAM(128, 128), OLED,                           \
    .scan = {0x70, 0x73, 0x62, 0x61}, .bgr = 1

const struct sheen_panel_record sheen_panel_ssd1351_128x128 = {
    .name = TEXT("ssd1351-128x128"), SSD1351, GLASS(128, 128)};
const struct sheen_panel_record sheen_panel_ssd1351_128x96 = {.name = TEXT("ssd1351-128x96"), SSD1351, GLASS(128, 96)};
