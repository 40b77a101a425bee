/*
 * st7735.c - records of the ST7735 modules, told apart by the colour of the tab on their protective film.
 *
 * All have the same chip, but the module's maker straps it to a RAM size: 128x160 with
 * a black or red tab, the whole 132x162 or 132x132 with a green tab. This choice is what
 * looks like an offset of the glass. The green-tab 128x128 is said to break the gap rule
 * of sheen_panel.h (3 rows from one end, 1 from the other). It keeps the rule if its RAM
 * is taken as 132x132, which is how its mode pins are strapped.
 */
#include "record.h"

/*
 * Frame rate, power and gamma are from Adafruit's ST7735R tables, which all libraries
 * have copied; registers B1..C5, E0, E1 of the ST7735R data sheet. Waits are those of
 * record.h (ST7735R data sheet, reset timing and SLPOUT: 10 us, 120 ms, 120 ms).
 */
static const struct sheen_panel_step init_st7735[] = {
    {0x11, 120, BARE},                                    /* sleep out */
    {0xB1, 0, BYTES(0x01, 0x2C, 0x2D)},                   /* frame rate: normal, */
    {0xB2, 0, BYTES(0x01, 0x2C, 0x2D)},                   /* idle, */
    {0xB3, 0, BYTES(0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D)}, /* partial */
    {0xB4, 0, BYTES(0x07)},                               /* column inversion in all modes */
    {0xC0, 0, BYTES(0xA2, 0x02, 0x84)},                   /* power: GVDD, */
    {0xC1, 0, BYTES(0xC5)},                               /* VGH and VGL, */
    {0xC2, 0, BYTES(0x0A, 0x00)},                         /* amplifier and booster: normal, */
    {0xC3, 0, BYTES(0x8A, 0x2A)},                         /* idle, */
    {0xC4, 0, BYTES(0x8A, 0xEE)},                         /* partial */
    {0xC5, 0, BYTES(0x0E)},                               /* VCOM */
    {0xE0, 0, BYTES(0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10)},
    {0xE1, 0, BYTES(0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10)},
    {0x3A, 0, BYTES(0x05)}, /* 16 bits per pixel */
};

/* Clock: write cycle 66 ns (ST7735R data sheet, 4-line serial interface, TSCYCW). */
#define ST7735                                                                                                         \
    .controller = TEXT("ST7735"), DCS, INIT(init_st7735), .clock_hz = 15151515, .scan = {MX | MY, MY | MV, 0, MX | MV}

const struct sheen_panel_record sheen_panel_st7735_128x160 = {
    .name = TEXT("st7735-128x160"), ST7735, GLASS(128, 160), RAM(128, 160), .note = TEXT("black tab")};

const struct sheen_panel_record sheen_panel_st7735_128x160_red = {
    .name = TEXT("st7735-128x160-red"), ST7735, GLASS(128, 160), RAM(128, 160), .bgr = 1, .note = TEXT("red tab")};

const struct sheen_panel_record sheen_panel_st7735_128x160_green = {.name = TEXT("st7735-128x160-green"),
                                                                    ST7735,
                                                                    GLASS(128, 160),
                                                                    RAM(132, 162),
                                                                    .gap_x = 2,
                                                                    .gap_y = 1,
                                                                    .bgr = 1,
                                                                    .note = TEXT("green tab")};

const struct sheen_panel_record sheen_panel_st7735_128x128 = {.name = TEXT("st7735-128x128"),
                                                              ST7735,
                                                              GLASS(128, 128),
                                                              RAM(128, 160),
                                                              .bgr = 1,
                                                              .note = TEXT("32 rows of RAM unused")};

const struct sheen_panel_record sheen_panel_st7735_128x128_green = {
    .name = TEXT("st7735-128x128-green"),
    ST7735,
    GLASS(128, 128),
    RAM(132, 132),
    .gap_x = 2,
    .gap_y = 1,
    .bgr = 1,
    .note = TEXT("green tab; keeps the gap rule only as strapped to 132x132")};

const struct sheen_panel_record sheen_panel_st7735_80x160_green = {.name = TEXT("st7735-80x160-green"),
                                                                   ST7735,
                                                                   GLASS(80, 160),
                                                                   RAM(132, 162),
                                                                   .gap_x = 26,
                                                                   .gap_y = 1,
                                                                   .bgr = 1,
                                                                   .inverted = 1,
                                                                   .note = TEXT("IPS, 0.96 in")};

const struct sheen_panel_record sheen_panel_st7735_80x160_red = {.name = TEXT("st7735-80x160-red"),
                                                                 ST7735,
                                                                 GLASS(80, 160),
                                                                 RAM(128, 160),
                                                                 .gap_x = 24,
                                                                 .bgr = 1,
                                                                 .note = TEXT("red tab")};
