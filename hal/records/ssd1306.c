/*
 * ssd1306.c - records of the SSD1306: black and white.
 *
 * A1 and C8 in the init tables make the picture upright; all other orientations are the
 * driver's work. Values as in u8g2, registers as in the data sheet (reset: 8.9, t1, 3 us).
 */
#include "record.h"

/* lines: multiplex ratio - 1. pins: parameter of DA, how the COM lines are wired (12 alternating, 02 in sequence). */
/* clang-format off */
#define INIT_SSD1306(lines, pins, contrast, precharge, vcomh)    \
    {0xAE, 0, BARE},         /* off */                           \
    {0xD5, 0, BYTES(0x80)},  /* clock */                         \
    {0xA8, 0, BYTES(lines)}, /* multiplex ratio */               \
    {0xD3, 0, BYTES(0x00)},  /* offset */                        \
    {0x40, 0, BARE},         /* start line 0 */                  \
    {0x8D, 0, BYTES(0x14)},  /* charge pump on */                \
    {0x20, 0, BYTES(0x00)},  /* horizontal addresses */          \
    {0xA1, 0, BARE},         /* columns from the last segment */ \
    {0xC8, 0, BARE},         /* rows from the last COM line */   \
    {0xDA, 0, BYTES(pins)},  /* COM wiring */                    \
    {0x81, 0, BYTES(contrast)},                                  \
    {0xD9, 0, BYTES(precharge)},                                 \
    {0xDB, 0, BYTES(vcomh)},                                     \
    {0x2E, 0, BARE},         /* no scrolling */                  \
    {0xA4, 0, BARE},         /* show the RAM, */                 \
    {0xA6, 0, BARE}          /* not inverted */
/* clang-format on */

static const struct sheen_panel_step init_128x64[] = {INIT_SSD1306(0x3F, 0x12, 0xCF, 0xF1, 0x40)};
static const struct sheen_panel_step init_128x32[] = {INIT_SSD1306(0x1F, 0x02, 0x8F, 0xF1, 0x40)};
static const struct sheen_panel_step init_64x48[] = {INIT_SSD1306(0x2F, 0x12, 0xCF, 0x22, 0x00)};
static const struct sheen_panel_step init_72x40[] = {
    INIT_SSD1306(0x27, 0x12, 0xAF, 0x22, 0x20),
    {0xAD, 0, BYTES(0x30)}, /* internal current reference: the module has no resistor for the segments' current */
};

/* Clock: cycle 100 ns (SSD1306 data sheet, table 13-4). */
#define SSD1306                                                                                                        \
    .controller = TEXT("SSD1306"), .driver = &sheen_driver_ssd1306, .brightness_command = 0x81, .pixel = SHEEN_GREY2,  \
    OLED, I2C, .clock_hz = 10000000, RAM(128, 64)

const struct sheen_panel_record sheen_panel_ssd1306_128x64 = {
    .name = TEXT("ssd1306-128x64"), SSD1306, INIT(init_128x64), GLASS(128, 64)};
const struct sheen_panel_record sheen_panel_ssd1306_128x32 = {
    .name = TEXT("ssd1306-128x32"), SSD1306, INIT(init_128x32), GLASS(128, 32)};
const struct sheen_panel_record sheen_panel_ssd1306_72x40 = {
    .name = TEXT("ssd1306-72x40"), SSD1306, INIT(init_72x40), GLASS(72, 40), .gap_x = 28};
const struct sheen_panel_record sheen_panel_ssd1306_64x48 = {
    .name = TEXT("ssd1306-64x48"), SSD1306, INIT(init_64x48), GLASS(64, 48), .gap_x = 32};
