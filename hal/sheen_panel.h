/*
 * sheen_panel.h - small displays: a panel is a data record, its driver takes finished pixels.
 *
 * Open a panel with a record and a bus, ask it for its target, hand that to the
 * core. Nothing is sent before the first push, which initialises the panel; so
 * does the first push after an error. Several panels, each with its own struct,
 * record and bus, may be open at once: there is no global state.
 *
 * A bus that others use too is acquired for each push, until its pixels have left
 * (sheen_bus.h); an initialisation holds it for its quarter of a second.
 *
 * Memory: struct sheen_panel is the caller's (static, stack or heap), nothing is
 * allocated, nothing is to be released. Record and bus must outlive it.
 *
 * Orientation, 0..7: rotation 0 is the glass as its record's glass_w x glass_h
 * describes it; each further one turns the glass a quarter turn counter-clockwise
 * under an upright picture: the picture's top left corner stands at the glass's
 * top left (0), top right (1), bottom right (2), bottom left (3). 4..7 are 0..3
 * with the picture mirrored left to right, for a glass seen through a mirror.
 */
#ifndef SHEEN_PANEL_H
#define SHEEN_PANEL_H

#include "sheen_bus.h"
#include "sheen_target.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A command of an init table, its parameters, and the wait after it. */
struct sheen_panel_step {
    uint8_t command;     /* its first byte */
    uint8_t wait_ms;     /* ms after the last parameter, 0..255 */
    uint8_t count;       /* parameters, 0..255; at most 15 where they leave with D/C low (greys, black and white) */
    const uint8_t *data; /* count bytes; NULL where count is 0 */
};

/* Its last two fields, in C: {0x3A, 0, SHEEN_BYTES(0x55)}. */
#define SHEEN_BYTES(...) sizeof((const uint8_t[]){__VA_ARGS__}), ((const uint8_t[]){__VA_ARGS__})

/* The kinds of controllers. */
extern const struct sheen_panel_driver sheen_driver_dcs, /* MIPI-DCS colour: ILI9341, ST7789, ST7735, GC9A01 ... */
    sheen_driver_ssd1351,                                /* colour OLED */
    sheen_driver_grey,                                   /* 16 greys: SSD0323, SSD1325, SSD1327 */
    sheen_driver_ssd1322,                                /* 16 greys: SSD1322 */
    sheen_driver_ssd1306, sheen_driver_sh1106;           /* black and white */

/* Of scan, for sheen_driver_dcs: MADCTL's bits. */
#define SHEEN_SCAN_MY 0x80 /* rows from the last */
#define SHEEN_SCAN_MX 0x40 /* columns from the last */
#define SHEEN_SCAN_MV 0x20 /* the picture's x runs along RAM rows */

/*
 * What sets one module apart from another. Colour order, inversion, byte order
 * and gap are four different things; each has its own field. Initialise by name:
 * what is left out is 0 and means "none" or "no". glass, ram, name, driver, init and
 * reset_ms have no default, nor has pixel but on colour, where 0 is SHEEN_RGB565_BE.
 * A module of one's own: firmware/examples/own_module.
 *
 * RAM and gap are as the module is strapped: columns x rows of controller memory
 * and the lowest column and row that lie behind the glass. The offset of every
 * orientation follows from them (driver_dcs.c).
 */
struct sheen_panel_record {
    const char *name;                        /* controller-WxH of rotation 0, and -variant */
    const char *controller;                  /* as printed on a data sheet */
    const char *note;                        /* a line for who chooses a panel, or NULL */
    const struct sheen_panel_driver *driver; /* the kind of controller */
    const struct sheen_panel_step *init;     /* sent after reset, before orientation and display on */
    uint32_t clock_hz;                       /* rated write clock, 1 / minimum cycle of the data sheet */
    uint16_t glass_w, glass_h;               /* px, rotation 0 */
    uint16_t ram_w, ram_h;                   /* px */
    uint16_t gap_x, gap_y;                   /* RAM column and row, px; the SSD1351's is not looked at */
    uint16_t reset_low_us, reset_ms;         /* reset pulse; rest after it (and after a reset by command) */
    uint8_t steps;                           /* entries of init */
    uint8_t spi_mode;                        /* 0 or 3 */
    uint8_t i2c_address;                     /* 7 bits, as modules leave the factory; 0: no I2C */
    uint8_t pixel;                           /* enum sheen_pixel that the target asks for */
    uint8_t scan[4];            /* by rotation: MADCTL's MY, MX, MV or the SSD1351's remap. Grey: [0], on the
                                   SSD1322 [0] and [1], which stand the glass upright */
    uint8_t brightness_command; /* takes a byte; 0: it has none */
    uint8_t brightness_shift;   /* of 0..255, to the right, for registers of fewer bits */
    uint8_t bits_18;            /* 1: on the wire RGB565 becomes three bytes a pixel (DCS) */
    uint8_t bgr;                /* 1: the sub-pixels stand blue, green, red */
    uint8_t inverted;           /* 1: shows true colours with inversion on (IPS glass) */
    uint8_t round;              /* 1: only the disc that touches all four sides is glass */
};

/* The most bytes that a driver turns at once, for pages and nibbles. */
#define SHEEN_PANEL_PACK_BYTES 64u

/* Run-time state of a panel. Private: touched by hal/ only. */
struct sheen_panel {
    const struct sheen_panel_record *record;     /* borrowed */
    const struct sheen_bus *bus;                 /* borrowed */
    void (*settings)(struct sheen_panel *panel); /* what an initialisation adds; NULL: nothing */
    void (*due)(struct sheen_panel *panel);      /* before the next push, once; NULL: nothing */
    int error;                                   /* the first of what is being said; nothing more is sent after it */
    uint32_t window[2];                   /* of x, y: first << 16 | last as sent, in the controller's own units */
    uint8_t orientation;                  /* 0..7 */
    uint8_t ready;                        /* initialised, and no error since */
    uint8_t tearing;                      /* init switches the TE output on */
    uint8_t dimmed, brightness;           /* 1: a brightness was asked for, this one */
    uint8_t flying;                       /* a call of the bus may still be under way */
    uint8_t held;                         /* the bus is acquired */
    uint8_t pack[SHEEN_PANEL_PACK_BYTES]; /* bytes that the packer turned; in flight until wait */
};

/*
 * Ties a panel to its record and bus; sends nothing. orientation: 0..7.
 * SHEEN_ERR_ARGUMENT: a NULL, an orientation above 7, or a record whose pixels are
 * none that its driver takes, or whose glass does not fit its RAM or their packing
 * (GREY16: width, height and gap_x even, multiples of 4 on the SSD1322; GREY2: width,
 * height and gap_y multiples of 8).
 */
int sheen_panel_open(struct sheen_panel *panel, const struct sheen_panel_record *record, const struct sheen_bus *bus,
                     unsigned orientation);

/* Fills in *target: size, pixel format and alignment in the panel's orientation, and its push and wait. */
int sheen_panel_target(struct sheen_panel *panel, struct sheen_target *target);

/*
 * Resets and initialises now rather than at the first push (before a clock is
 * raised, or to keep its quarter of a second out of the first frame). Then the
 * first push does not do it again. The glass is lit from here on, and shows what the
 * controller's RAM happens to hold until a frame has been sent: send one soon.
 */
int sheen_panel_init(struct sheen_panel *panel);

/* Darkens the glass and lets the controller sleep; the next push initialises it again. An unlit panel is left alone. */
int sheen_panel_off(struct sheen_panel *panel);

/*
 * Turns a panel that is open to orientation 0..7 (SHEEN_ERR_ARGUMENT above). What is
 * on the glass stays as it is: ask for the target again, make everything be sent
 * (sheen_invalidate()), and where width and height have changed places make the frame
 * anew (sheen_init()).
 */
int sheen_panel_turn(struct sheen_panel *panel, unsigned orientation);

/*
 * Brightness 0..255, now and after each initialisation: an OLED's contrast, or on a
 * DCS panel the output that may drive the backlight (most modules do not wire it).
 * SHEEN_ERR_UNSUPPORTED: the controller has none.
 */
int sheen_panel_brightness(struct sheen_panel *panel, unsigned level);

/*
 * From the next initialisation on the controller pulses its TE output once a
 * refresh, while the glass is not being read. SHEEN_ERR_UNSUPPORTED: it has none.
 */
int sheen_panel_tearing(struct sheen_panel *panel);

/*
 * Once a frame, before sheen_begin(): the next push begins with the bus's tearing(),
 * so that the panel is written while it is not being read. Does what
 * sheen_panel_tearing() does if that was not done. SHEEN_ERR_UNSUPPORTED: the
 * controller has no TE, or the bus does not have it wired.
 */
int sheen_panel_sync(struct sheen_panel *panel);

/* Width and height of the picture, px, in orientation 0..7. */
void sheen_panel_size(const struct sheen_panel_record *record, unsigned orientation, uint16_t *width, uint16_t *height);

/* The orientation taken where none is asked for: 1 (landscape) for glass taller than wide, else 0. */
unsigned sheen_panel_default_orientation(const struct sheen_panel_record *record);

/*
 * The record of that name, in small letters or large, or the first in the table whose
 * name goes on with a dash: "ILI9341" finds ili9341-240x320. NULL: no such panel.
 */
const struct sheen_panel_record *sheen_panel_find(const char *name);

/* The table's record index, from 0; NULL past the last. */
const struct sheen_panel_record *sheen_panel_at(size_t index);

/* The records by themselves: firmware that names one and links with --gc-sections holds no other, nor their drivers. */
extern const struct sheen_panel_record sheen_panel_ili9341, sheen_panel_ili9488, sheen_panel_st7789_240x320,
    sheen_panel_st7789_240x240, sheen_panel_st7789_240x240_round, sheen_panel_st7789_240x280,
    sheen_panel_st7789_135x240, sheen_panel_st7789_170x320, sheen_panel_st7789_172x320, sheen_panel_st7789_76x284,
    sheen_panel_st7789_128x128, sheen_panel_st7735_128x160, sheen_panel_st7735_128x160_red,
    sheen_panel_st7735_128x160_green, sheen_panel_st7735_128x128, sheen_panel_st7735_128x128_green,
    sheen_panel_st7735_80x160_green, sheen_panel_st7735_80x160_red, sheen_panel_st7796, sheen_panel_gc9a01,
    sheen_panel_ssd1351_128x128, sheen_panel_ssd1351_128x96, sheen_panel_ssd0323, sheen_panel_ssd1325,
    sheen_panel_ssd1322, sheen_panel_ssd1327_128x128, sheen_panel_ssd1327_96x96, sheen_panel_ssd1306_128x64,
    sheen_panel_ssd1306_128x32, sheen_panel_ssd1306_72x40, sheen_panel_ssd1306_64x48, sheen_panel_sh1106,
    sheen_panel_sh1106_nogap;

#ifdef __cplusplus
}
#endif
#endif
