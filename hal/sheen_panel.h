/*
 * sheen_panel.h - small displays: a data record describes a panel, a driver sends it finished pixels.
 *
 * Open a panel with a record and a bus, fill in a target with sheen_panel_target()
 * and hand the target to the core. Opening sends nothing: the first push initialises
 * the panel, and so does the first push after an error. Several panels, each with its
 * own struct, record and bus, may be open at once: there is no global state.
 *
 * If other devices share the bus, it is acquired for each push until the pixels have
 * left (sheen_bus.h); an initialisation holds it for about a quarter of a second.
 *
 * Memory: the caller owns struct sheen_panel (static, stack or heap). Nothing is
 * allocated and nothing has to be released. Record and bus must outlive the panel.
 *
 * Orientation, 0..7: in rotation 0 the glass is as its record's glass_w x glass_h
 * describes it. Each further rotation turns the glass a quarter turn counter-clockwise
 * while the picture stays upright, so the picture's top left corner is at the glass's
 * top left (0), top right (1), bottom right (2) or bottom left (3). 4..7 are 0..3
 * with the picture mirrored left to right, for a glass seen through a mirror.
 */
#ifndef SHEEN_PANEL_H
#define SHEEN_PANEL_H

#include "sheen_bus.h"
#include "sheen_target.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One step of an init table: a command, its parameters, and the wait after them. */
struct sheen_panel_step {
    uint8_t command;     /* the command byte */
    uint8_t wait_ms;     /* wait after the last parameter, ms, 0..255 */
    uint8_t count;       /* parameters, 0..255; at most 15 if sent with D/C low (black and white, most greys) */
    const uint8_t *data; /* the parameters, count bytes; NULL if count is 0 */
};

/* The last two fields of a step, for initialisers in C: {0x3A, 0, SHEEN_BYTES(0x55)}. */
#define SHEEN_BYTES(...) sizeof((const uint8_t[]){__VA_ARGS__}), ((const uint8_t[]){__VA_ARGS__})

/* The drivers, one for each kind of controller. */
extern const struct sheen_panel_driver sheen_driver_dcs, /* MIPI-DCS colour: ILI9341, ST7789, ST7735, GC9A01 ... */
    sheen_driver_ssd1351,                                /* colour OLED */
    sheen_driver_grey,                                   /* 16 greys: SSD0323, SSD1325, SSD1327 */
    sheen_driver_ssd1322,                                /* 16 greys: SSD1322 */
    sheen_driver_ssd1306, sheen_driver_sh1106;           /* black and white */

/* Bits of a record's scan for sheen_driver_dcs; they are those of the register MADCTL. */
#define SHEEN_SCAN_MY 0x80 /* RAM rows count from the last */
#define SHEEN_SCAN_MX 0x40 /* RAM columns count from the last */
#define SHEEN_SCAN_MV 0x20 /* x and y exchanged: the picture's x selects the RAM row */

/*
 * Everything in which modules differ. Colour order, inversion, byte order and gap
 * are four different things; each has its own field. Initialise by field name: a
 * field that is left out is 0, which means "none" or "no". glass, ram, name, driver,
 * init and reset_ms have no default, and pixel has one on colour panels only, where
 * 0 is SHEEN_RGB565_BE. To add your own module, see firmware/examples/own_module.
 *
 * RAM and gap depend on how the module straps its controller: ram is the size of
 * the controller's memory, columns x rows, and gap is the lowest column and row
 * behind the glass. The driver computes the offset of every orientation from them
 * (driver_dcs.c).
 */
struct sheen_panel_record {
    const char *name;                        /* controller-WxH in rotation 0, or controller-WxH-variant */
    const char *controller;                  /* as its data sheet spells it */
    const char *note;                        /* one line to help in choosing a panel, or NULL */
    const struct sheen_panel_driver *driver; /* the kind of controller */
    const struct sheen_panel_step *init;     /* sent after reset, before orientation and display on */
    uint32_t clock_hz;                       /* rated write clock: 1 / the data sheet's minimum cycle */
    uint16_t glass_w, glass_h;               /* px, rotation 0 */
    uint16_t ram_w, ram_h;                   /* px */
    uint16_t gap_x, gap_y;                   /* RAM column and row, px; ignored on the SSD1351 */
    uint16_t reset_low_us, reset_ms;         /* reset pulse; wait after it (or after a reset by command) */
    uint8_t steps;                           /* number of entries in init */
    uint8_t spi_mode;                        /* 0 or 3 */
    uint8_t i2c_address;                     /* 7 bits, the factory setting; 0: no I2C */
    uint8_t pixel;                           /* pixel format of the target, enum sheen_pixel */
    uint8_t scan[4];            /* one per rotation: MADCTL's MY, MX, MV, or the SSD1351's remap. Greys: the remap
                                   that shows the picture upright, in [0], on the SSD1322 in [0] and [1] */
    uint8_t brightness_command; /* command with the brightness as its one parameter; 0: none */
    uint8_t brightness_shift;   /* right shift of the level 0..255, for registers of fewer bits */
    uint8_t bits_18;            /* 1: a pixel is sent as three bytes, made from RGB565 (DCS) */
    uint8_t bgr;                /* 1: sub-pixels are in the order blue, green, red */
    uint8_t inverted;           /* 1: colours are true with inversion on (IPS glass) */
    uint8_t round;              /* 1: the glass is only the disc that touches all four sides */
};

/* The most bytes that a driver rearranges at once, for controllers with pages or nibbles. */
#define SHEEN_PANEL_PACK_BYTES 64u

/* Run-time state of a panel. Private: touched by hal/ only. */
struct sheen_panel {
    const struct sheen_panel_record *record;           /* borrowed */
    const struct sheen_bus *bus;                       /* borrowed */
    void (*apply_settings)(struct sheen_panel *panel); /* run at the end of each initialisation; NULL: nothing */
    void (*before_push)(struct sheen_panel *panel);    /* run once, before the next push; NULL: nothing */
    int error;                            /* the first error of the call in progress; nothing is sent after it */
    uint32_t window[2];                   /* last sent for x, y: first << 16 | last, in the controller's units */
    uint8_t orientation;                  /* 0..7 */
    uint8_t ready;                        /* initialised, and no error since */
    uint8_t lit;                          /* an initialisation has begun since it was last switched off */
    uint8_t te_on;                        /* each initialisation switches the TE output on */
    uint8_t has_brightness, brightness;   /* 1: a brightness was asked for; its level */
    uint8_t in_flight;                    /* a call of the bus may still be under way */
    uint8_t held;                         /* the bus is acquired */
    uint8_t pack[SHEEN_PANEL_PACK_BYTES]; /* bytes that a driver has rearranged; in flight until wait */
};

/*
 * Ties a panel to its record and bus; sends nothing. orientation: 0..7.
 * SHEEN_ERR_ARGUMENT: a NULL, an orientation above 7, a record whose pixel format its
 * driver does not support, or a record whose glass does not fit its RAM or its pixel
 * packing (GREY16: width, height and gap_x even, multiples of 4 on the SSD1322; GREY2:
 * width, height and gap_y multiples of 8).
 */
int sheen_panel_open(struct sheen_panel *panel, const struct sheen_panel_record *record, const struct sheen_bus *bus,
                     unsigned orientation);

/* Fills in *target: size, pixel format and alignment in the panel's orientation, and the functions push and wait. */
int sheen_panel_target(struct sheen_panel *panel, struct sheen_target *target);

/*
 * Resets and initialises the panel now, not at the first push: call it before you
 * raise the bus clock, or to keep this quarter of a second out of the first frame.
 * The glass is lit from here on, and shows what the controller's RAM happens to hold
 * until a frame has been sent: send one soon.
 */
int sheen_panel_init(struct sheen_panel *panel);

/*
 * Darkens the glass and puts the controller to sleep; the next push initialises it again. After an error it resets the
 * controller first, which takes a quarter of a second. No effect if the panel was never lit, or is off.
 */
int sheen_panel_off(struct sheen_panel *panel);

/*
 * Sets the orientation of an open panel, 0..7 (SHEEN_ERR_ARGUMENT above). This does not
 * redraw what is on the glass: call sheen_panel_target() again, then sheen_invalidate(),
 * so that the next frame sends everything. If width and height have changed places, the
 * frame itself must be made anew (sheen_init()).
 */
int sheen_panel_turn(struct sheen_panel *panel, unsigned orientation);

/*
 * Sets the brightness, 0..255, now and after each initialisation: an OLED's contrast,
 * or on a DCS panel the output that may drive the backlight (most modules do not wire
 * it). SHEEN_ERR_ARGUMENT: a level above 255. SHEEN_ERR_UNSUPPORTED: the controller has
 * no brightness command.
 */
int sheen_panel_brightness(struct sheen_panel *panel, unsigned level);

/*
 * From the next initialisation on, the controller pulses its TE output once per refresh,
 * during vertical blanking. SHEEN_ERR_UNSUPPORTED: the controller has no TE output.
 */
int sheen_panel_tearing(struct sheen_panel *panel);

/*
 * Call this once per frame, before sheen_begin(): the next push then starts with the
 * bus's tearing(), which waits for the vertical blanking, against tearing. It calls
 * sheen_panel_tearing() if you have not. SHEEN_ERR_UNSUPPORTED: the controller has no
 * TE output, or it is not wired to the bus.
 */
int sheen_panel_sync(struct sheen_panel *panel);

/* Width and height of the picture, px, in orientation 0..7. */
void sheen_panel_size(const struct sheen_panel_record *record, unsigned orientation, uint16_t *width, uint16_t *height);

/* The orientation to use if none is asked for: 1 (landscape) if the glass is taller than wide, else 0. */
unsigned sheen_panel_default_orientation(const struct sheen_panel_record *record);

/*
 * Finds a record by its name, in upper or lower case, or by the part of its name before
 * a dash; then the first one in the table counts: "ILI9341" finds ili9341-240x320.
 * NULL: no such panel.
 */
const struct sheen_panel_record *sheen_panel_find(const char *name);

/* Record number `index` of the table, from 0; NULL past the last. */
const struct sheen_panel_record *sheen_panel_at(size_t index);

/* The records one by one: firmware that names one and links with --gc-sections holds only that one and its driver. */
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
