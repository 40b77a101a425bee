/*
 * ssd1325.c - records of the SSD0323 and SSD1325, which are one chip: 16 greys.
 *
 * Values that the data sheet leaves to the module's maker are those of u8g2 and TFT_eSPI.
 * Multiplex ratio, offset and remap are such that RAM column gap_x, row gap_y is the top
 * left pixel of the upright glass.
 *
 * u8g2 sends E3 (no operation) after the last pixel, before chip select rises. Here a call
 * of the bus ends with the last pixel, and the next bytes are the next window's commands.
 * Whether the last pixels appear only with those bytes on SPI was not tested on glass.
 */
#include "record.h"

/* B8: a grey table that looks linear to the eye. offset: parameter of A2, depends on how the COM lines are wired. */
/* clang-format off */
#define INIT_SSD1325(offset) {                                        \
    {0xAE, 0, BARE},          /* off */                               \
    {0xB3, 0, BYTES(0x91)},   /* clock: 135 frames/s */               \
    {0xA8, 0, BYTES(0x3F)},   /* 64 lines */                          \
    {0xA2, 0, BYTES(offset)}, /* display offset */                    \
    {0xA1, 0, BYTES(0x00)},   /* start line */                        \
    {0xAD, 0, BYTES(0x02)},   /* external VCC */                      \
    {0x86, 0, BARE},          /* full current */                      \
    {0xB8, 0, BYTES(0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76)}, \
    {0x81, 0, BYTES(0x70)},   /* contrast */                          \
    {0xB2, 0, BYTES(0x51)},   /* row period */                        \
    {0xB1, 0, BYTES(0x55)},   /* phases */                            \
    {0xBC, 0, BYTES(0x10)},   /* precharge */                         \
    {0xBE, 0, BYTES(0x1C)},   /* VCOMH */                             \
    {0xBF, 0, BYTES(0x0F)},   /* VSL */                               \
    {0xA4, 0, BARE},          /* show the RAM */                      \
}
/* clang-format on */

static const struct sheen_panel_step init_ssd0323[] = INIT_SSD1325(0x40);
static const struct sheen_panel_step init_ssd1325[] = INIT_SSD1325(0x4C);

/*
 * Clock: cycle 250 ns (SSD1325 data sheet, serial interface). Remap 52: the left pixel is the high nibble, COM lines
 * count from the last; COM split.
 */
#define SSD1325                                                                                                        \
    .driver = &sheen_driver_grey, .brightness_command = 0x81, .brightness_shift = 1, .pixel = SHEEN_GREY16,            \
    .clock_hz = 4000000, RAM(128, 80), GLASS(128, 64), OLED, .scan = {0x52}

const struct sheen_panel_record sheen_panel_ssd0323 = {.name = TEXT("ssd0323-128x64"),
                                                       .controller = TEXT("SSD0323"),
                                                       SSD1325,
                                                       INIT(init_ssd0323),
                                                       .note = TEXT("QEMU's lm3s6965evb")};
const struct sheen_panel_record sheen_panel_ssd1325 = {
    .name = TEXT("ssd1325-128x64"), .controller = TEXT("SSD1325"), SSD1325, INIT(init_ssd1325)};
