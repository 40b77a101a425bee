/*
 * st7789.c - records of the ST7789 modules.
 *
 * Supply and gamma keep their power-on values, as in the driver collection mipidsi.
 */
#include "record.h"

/*
 * RAMCTRL B0 = 00 C0: when red and blue grow from 5 bits to 6, their high bit is copied
 * to the low one; otherwise greys show bands (Pimoroni pimoroni-pico issue 1040).
 */
static const struct sheen_panel_step init_st7789[] = {
    {SLPOUT, 120, BARE},
    {COLMOD, 0, BYTES(0x55)},
    {0xB0, 0, BYTES(0x00, 0xC0)},
};

/* Clock: write cycle 16 ns (ST7789V data sheet, 4-line serial interface, TSCYCW). All of these are IPS: inverted. */
#define ST7789                                                                                                         \
    .controller = TEXT("ST7789"), DCS, WRDISBV, INIT(init_st7789), .clock_hz = 62500000, RAM(240, 320),                \
    .scan = {0, MX | MV, MX | MY, MV | MY}, .inverted = 1

const struct sheen_panel_record sheen_panel_st7789_240x320 = {
    .name = TEXT("st7789-240x320"), ST7789, GLASS(240, 320), .note = TEXT("TN glass (2.8 in) is not inverted")};

/* Modules without CS lose count of bits unless the clock is high between bytes: mode 3, which suits all modules. */
const struct sheen_panel_record sheen_panel_st7789_240x240 = {.name = TEXT("st7789-240x240"),
                                                              ST7789,
                                                              GLASS(240, 240),
                                                              .spi_mode = 3,
                                                              .note = TEXT("mode 3 for modules without CS")};

const struct sheen_panel_record sheen_panel_st7789_240x240_round = {
    .name = TEXT("st7789-240x240-round"), ST7789, GLASS(240, 240), .gap_y = 40, .round = 1};

const struct sheen_panel_record sheen_panel_st7789_240x280 = {.name = TEXT("st7789-240x280"),
                                                              ST7789,
                                                              GLASS(240, 280),
                                                              .gap_y = 20,
                                                              .note = TEXT("rounded corners hide some pixels")};

const struct sheen_panel_record sheen_panel_st7789_135x240 = {
    .name = TEXT("st7789-135x240"), ST7789, GLASS(135, 240), .gap_x = 52, .gap_y = 40};

const struct sheen_panel_record sheen_panel_st7789_170x320 = {
    .name = TEXT("st7789-170x320"), ST7789, GLASS(170, 320), .gap_x = 35};

const struct sheen_panel_record sheen_panel_st7789_172x320 = {.name = TEXT("st7789-172x320"),
                                                              ST7789,
                                                              GLASS(172, 320),
                                                              .gap_x = 34,
                                                              .note = TEXT("rounded corners hide some pixels")};

const struct sheen_panel_record sheen_panel_st7789_76x284 = {.name = TEXT("st7789-76x284"),
                                                             ST7789,
                                                             GLASS(76, 284),
                                                             .gap_x = 82,
                                                             .gap_y = 18,
                                                             .note =
                                                                 TEXT("quarter turns by rule, not confirmed on glass")};

const struct sheen_panel_record sheen_panel_st7789_128x128 = {
    .name = TEXT("st7789-128x128"),
    ST7789,
    GLASS(128, 128),
    .note = TEXT("modules differ in their gap, and in inversion")};
