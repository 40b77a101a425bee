/*
 * sim_panel_modules.c - the hardware that can be simulated: which chip is behind which glass, and how it is wired.
 *
 * Written from data sheets and module drawings, not from hal's records, so that tests notice where the two differ. Gap:
 * the first RAM column and row (OLED: segment and COM line) behind the glass. Mirrored: RAM column 0 is wired to the
 * right, row 0 to the bottom, so that the upright picture needs MX, MY.
 */
#include <string.h>

#include "controller.h"

#define CHIP(id) .chip = &sheen_sim_chip_##id
#define RAM(w, h) .ram_w = w, .ram_h = h
#define GLASS(w, h, x, y) .glass_w = w, .glass_h = h, .gap_x = x, .gap_y = y
#define I2C .i2c_address = 0x3C
#define MIRROR(x, y) .mirror_x = x, .mirror_y = y

#define ST7789(id, ...)                                                                                                \
    {                                                                                                                  \
        .name = id, CHIP(st7789), RAM(240, 320), .inverted = 1, __VA_ARGS__                                            \
    }
#define ST7735(id, ...)                                                                                                \
    {                                                                                                                  \
        .name = id, CHIP(st7735), MIRROR(1, 1), __VA_ARGS__                                                            \
    }
#define SSD1306(id, ...)                                                                                               \
    {                                                                                                                  \
        .name = id, CHIP(ssd1306), RAM(128, 64), MIRROR(1, 1), I2C, __VA_ARGS__                                        \
    }

static const struct sheen_sim_module modules[] = {
    {.name = "ili9341-240x320", CHIP(ili9341), RAM(240, 320), GLASS(240, 320, 0, 0), MIRROR(1, 0), .bgr = 1},
    {.name = "ili9488-320x480", CHIP(ili9488), RAM(320, 480), GLASS(320, 480, 0, 0), MIRROR(1, 0), .bgr = 1},
    ST7789("st7789-240x320", GLASS(240, 320, 0, 0)),
    ST7789("st7789-240x240", GLASS(240, 240, 0, 0)),
    ST7789("st7789-240x240-round", GLASS(240, 240, 0, 40), .round = 1),
    ST7789("st7789-240x280", GLASS(240, 280, 0, 20)),
    ST7789("st7789-135x240", GLASS(135, 240, 52, 40)),
    ST7789("st7789-170x320", GLASS(170, 320, 35, 0)),
    ST7789("st7789-172x320", GLASS(172, 320, 34, 0)),
    ST7789("st7789-76x284", GLASS(76, 284, 82, 18)),
    ST7789("st7789-128x128", GLASS(128, 128, 0, 0)),
    ST7735("st7735-128x160", RAM(128, 160), GLASS(128, 160, 0, 0)),
    ST7735("st7735-128x160-red", RAM(128, 160), GLASS(128, 160, 0, 0), .bgr = 1),
    ST7735("st7735-128x160-green", RAM(132, 162), GLASS(128, 160, 2, 1), .bgr = 1),
    ST7735("st7735-128x128", RAM(128, 160), GLASS(128, 128, 0, 0), .bgr = 1),
    ST7735("st7735-128x128-green", RAM(132, 132), GLASS(128, 128, 2, 1), .bgr = 1),
    ST7735("st7735-80x160-green", RAM(132, 162), GLASS(80, 160, 26, 1), .bgr = 1, .inverted = 1),
    ST7735("st7735-80x160-red", RAM(128, 160), GLASS(80, 160, 24, 0), .bgr = 1),
    {.name = "st7796-320x480", CHIP(st7796), RAM(320, 480), GLASS(320, 480, 0, 0), MIRROR(1, 0), .bgr = 1},
    {.name = "gc9a01-240x240", CHIP(gc9a01), RAM(240, 240), GLASS(240, 240, 0, 0), .bgr = 1, .inverted = 1, .round = 1},
    {.name = "ssd1351-128x128", CHIP(ssd1351), RAM(128, 128), GLASS(128, 128, 0, 0), MIRROR(0, 1), .bgr = 1},
    {.name = "ssd1351-128x96", CHIP(ssd1351), RAM(128, 128), GLASS(128, 96, 0, 0), MIRROR(0, 1), .bgr = 1},
    {.name = "ssd0323-128x64", CHIP(ssd0323), RAM(128, 80), GLASS(128, 64, 0, 0), MIRROR(0, 1)},
    {.name = "ssd1325-128x64", CHIP(ssd1325), RAM(128, 80), GLASS(128, 64, 0, 12), MIRROR(0, 1)},
    {.name = "ssd1322-256x64", CHIP(ssd1322), RAM(480, 128), GLASS(256, 64, 112, 0), MIRROR(1, 0)},
    {.name = "ssd1327-128x128", CHIP(ssd1327), RAM(128, 128), GLASS(128, 128, 0, 0), MIRROR(1, 1), I2C},
    {.name = "ssd1327-96x96", CHIP(ssd1327), RAM(128, 128), GLASS(96, 96, 16, 32), MIRROR(1, 1), I2C},
    SSD1306("ssd1306-128x64", GLASS(128, 64, 0, 0)),
    SSD1306("ssd1306-128x32", GLASS(128, 32, 0, 0)),
    SSD1306("ssd1306-72x40", GLASS(72, 40, 28, 0), .no_current = 1),
    SSD1306("ssd1306-64x48", GLASS(64, 48, 32, 0)),
    {.name = "sh1106-128x64", CHIP(sh1106), RAM(132, 64), GLASS(128, 64, 2, 0), MIRROR(1, 1), I2C},
    {.name = "sh1106-128x64-nogap", CHIP(sh1106), RAM(132, 64), GLASS(128, 64, 4, 0), MIRROR(1, 1), I2C},
};

const struct sheen_sim_module *sheen_sim_module_find(const char *name)
{
    for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++)
        if (strcmp(modules[i].name, name) == 0)
            return &modules[i];
    return NULL;
}
