/*
 * ssd1327.c - records of the SSD1327: 16 greys.
 *
 * Values that the data sheet leaves to the module's maker are those of u8g2 and TFT_eSPI.
 * Multiplex ratio, offset and remap are such that RAM column gap_x, row gap_y is the top
 * left pixel of the upright glass.
 */
#include "record.h"

/* clang-format off */
#define INIT_SSD1327(lines, offset) {                           \
    {0xFD, 0, BYTES(0x12)},   /* unlock */                      \
    {0xAE, 0, BARE},          /* off */                         \
    {0xA8, 0, BYTES(lines)},  /* lines - 1 */                   \
    {0xA1, 0, BYTES(0x00)},   /* start line */                  \
    {0xA2, 0, BYTES(offset)}, /* display offset */              \
    {0xAB, 0, BYTES(0x01)},   /* internal supply */             \
    {0x81, 0, BYTES(0x53)},   /* contrast */                    \
    {0xB1, 0, BYTES(0x51)},   /* phases */                      \
    {0xB3, 0, BYTES(0x01)},   /* clock */                       \
    {0xB9, 0, BARE},          /* linear grey table */           \
    {0xBC, 0, BYTES(0x08)},   /* precharge */                   \
    {0xBE, 0, BYTES(0x07)},   /* VCOMH */                       \
    {0xB6, 0, BYTES(0x01)},   /* second precharge: strength, */ \
    {0xD5, 0, BYTES(0x62)},   /* and on */                      \
    {0xA4, 0, BARE},          /* show the RAM */                \
}
/* clang-format on */

static const struct sheen_panel_step init_ssd1327[] = INIT_SSD1327(0x7F, 0x00);
static const struct sheen_panel_step init_ssd1327_96[] = INIT_SSD1327(0x5F, 0x20);

/*
 * Clock: u8g2 uses 4 MHz. Remap 51: columns and COM lines count from the last, so that
 * the left pixel is the high nibble; COM split.
 */
#define SSD1327                                                                                                        \
    .controller = TEXT("SSD1327"), .driver = &sheen_driver_grey, .brightness_command = 0x81, .pixel = SHEEN_GREY16,    \
    .clock_hz = 4000000, RAM(128, 128), OLED, I2C, .scan = {0x51}

const struct sheen_panel_record sheen_panel_ssd1327_128x128 = {
    .name = TEXT("ssd1327-128x128"), SSD1327, INIT(init_ssd1327), GLASS(128, 128)};
const struct sheen_panel_record sheen_panel_ssd1327_96x96 = {
    .name = TEXT("ssd1327-96x96"), SSD1327, INIT(init_ssd1327_96), GLASS(96, 96), .gap_x = 16};
