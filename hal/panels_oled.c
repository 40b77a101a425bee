/*
 * panels_oled.c - records of the OLED panels: colour, 16 greys, black and white.
 *
 * Their controllers count the glass in segments and COM lines; the init tables
 * set multiplex ratio, offset and remap so that RAM column gap_x, row gap_y is
 * the upright glass's top left. Values as in u8g2 and TFT_eSPI where the data
 * sheets leave them to the module's maker.
 *
 * Reset: the data sheets ask for 2 to 100 us low ("Power ON and OFF sequence", t1),
 * u8g2 rests 100 ms after it, since some modules' supplies need it.
 */
#include "panel_driver.h"
#include "panel_tables.h"

#define RESET .reset_low_us = 100, .reset_ms = 100

static const struct sheen_panel_step init_ssd1351[] = {
    {0xFD, 0, BYTES(0x12)},             /* unlock, */
    {0xFD, 0, BYTES(0xB1)},             /* also A2, B1, B3, BE, C1 */
    {0xAE, 0, NONE},                    /* off */
    {0xB3, 0, BYTES(0xF1)},             /* clock */
    {0xCA, 0, BYTES(0x7F)},             /* 128 lines, on shorter glass too */
    {0xA2, 0, BYTES(0x00)},             /* offset */
    {0xB5, 0, BYTES(0x00)},             /* GPIO off */
    {0xAB, 0, BYTES(0x01)},             /* internal supply */
    {0xB1, 0, BYTES(0x32)},             /* precharge */
    {0xBE, 0, BYTES(0x05)},             /* VCOMH */
    {0xA6, 0, NONE},                    /* not inverted */
    {0xC1, 0, BYTES(0xC8, 0x80, 0xC8)}, /* contrast A, B, C */
    {0xC7, 0, BYTES(0x0F)},             /* master contrast */
    {0xB4, 0, BYTES(0xA0, 0xB5, 0x55)}, /* external VSL */
    {0xB6, 0, BYTES(0x01)},             /* second precharge */
};

/*
 * Clock: cycle 50 ns (SSD1351 data sheet, table 13-4). Remap 60: 65k colours, COM
 * split; + 01 vertical, 02 columns and 10 COM lines from the last (ibid., A0h).
 */
#define SSD1351                                                                                                        \
    .controller = "SSD1351", .driver = &sheen_driver_ssd1351, .pixel = SHEEN_RGB565_BE, INIT(init_ssd1351),            \
    .clock_hz = 20000000, RAM(128, 128), RESET, .scan = {0x70, 0x73, 0x62, 0x61}, .bgr = 1

const struct sheen_panel_record sheen_panel_ssd1351_128x128 = {.name = "ssd1351-128x128", SSD1351, GLASS(128, 128)};
const struct sheen_panel_record sheen_panel_ssd1351_128x96 = {.name = "ssd1351-128x96", SSD1351, GLASS(128, 96)};

/* B8: grey table that is linear to the eye; offset A2 as the glass's COM lines are wired. */
/* clang-format off */
#define INIT_SSD1325(offset) {                                        \
    {0xAE, 0, NONE},          /* off */                               \
    {0xB3, 0, BYTES(0x91)},   /* clock: 135 frames/s */               \
    {0xA8, 0, BYTES(0x3F)},   /* 64 lines */                          \
    {0xA2, 0, BYTES(offset)}, /* display offset */                    \
    {0xA1, 0, BYTES(0x00)},   /* start line */                        \
    {0xAD, 0, BYTES(0x02)},   /* external VCC */                      \
    {0x86, 0, NONE},          /* full current */                      \
    {0xB8, 0, BYTES(0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76)}, \
    {0x81, 0, BYTES(0x70)},   /* contrast */                          \
    {0xB2, 0, BYTES(0x51)},   /* row period */                        \
    {0xB1, 0, BYTES(0x55)},   /* phases */                            \
    {0xBC, 0, BYTES(0x10)},   /* precharge */                         \
    {0xBE, 0, BYTES(0x1C)},   /* VCOMH */                             \
    {0xBF, 0, BYTES(0x0F)},   /* VSL */                               \
    {0xA4, 0, NONE},          /* shows the RAM */                     \
}
/* clang-format on */

static const struct sheen_panel_step init_ssd0323[] = INIT_SSD1325(0x40);
static const struct sheen_panel_step init_ssd1325[] = INIT_SSD1325(0x4C);

/* Clock: cycle 250 ns (SSD1325 data sheet, serial interface). Remap 52: high nibble left, COM from the last, split. */
#define SSD1325                                                                                                        \
    .driver = &sheen_driver_grey, .pixel = SHEEN_GREY16, .clock_hz = 4000000, RAM(128, 80), GLASS(128, 64), RESET,     \
    .scan = {0x52}

const struct sheen_panel_record sheen_panel_ssd0323 = {.name = "ssd0323-128x64",
                                                       .controller = "SSD0323",
                                                       SSD1325,
                                                       INIT(init_ssd0323),
                                                       .note = "OSRAM Pictiva; QEMU's lm3s6965evb"};
const struct sheen_panel_record sheen_panel_ssd1325 = {
    .name = "ssd1325-128x64", .controller = "SSD1325", SSD1325, INIT(init_ssd1325)};

/* clang-format off */
#define INIT_SSD1327(lines, offset) {                           \
    {0xFD, 0, BYTES(0x12)},   /* unlock */                      \
    {0xAE, 0, NONE},          /* off */                         \
    {0xA8, 0, BYTES(lines)},  /* lines - 1 */                   \
    {0xA1, 0, BYTES(0x00)},   /* start line */                  \
    {0xA2, 0, BYTES(offset)}, /* display offset */              \
    {0xAB, 0, BYTES(0x01)},   /* internal supply */             \
    {0x81, 0, BYTES(0x53)},   /* contrast */                    \
    {0xB1, 0, BYTES(0x51)},   /* phases */                      \
    {0xB3, 0, BYTES(0x01)},   /* clock */                       \
    {0xB9, 0, NONE},          /* linear grey table */           \
    {0xBC, 0, BYTES(0x08)},   /* precharge */                   \
    {0xBE, 0, BYTES(0x07)},   /* VCOMH */                       \
    {0xB6, 0, BYTES(0x01)},   /* second precharge: strength, */ \
    {0xD5, 0, BYTES(0x62)},   /* and on */                      \
    {0xA4, 0, NONE},          /* shows the RAM */               \
}
/* clang-format on */

static const struct sheen_panel_step init_ssd1327[] = INIT_SSD1327(0x7F, 0x00);
static const struct sheen_panel_step init_ssd1327_96[] = INIT_SSD1327(0x5F, 0x20);

/*
 * Clock: u8g2 drives it at 4 MHz. Remap 51: columns and COM lines from the last, so
 * that the left pixel is the high nibble; COM split.
 */
#define SSD1327                                                                                                        \
    .controller = "SSD1327", .driver = &sheen_driver_grey, .pixel = SHEEN_GREY16, .clock_hz = 4000000, RAM(128, 128),  \
    RESET, .scan = {0x51}

const struct sheen_panel_record sheen_panel_ssd1327_128x128 = {
    .name = "ssd1327-128x128", SSD1327, INIT(init_ssd1327), GLASS(128, 128)};
const struct sheen_panel_record sheen_panel_ssd1327_96x96 = {
    .name = "ssd1327-96x96", SSD1327, INIT(init_ssd1327_96), GLASS(96, 96), .gap_x = 16};
