/*
 * controller.h - simulated display controllers: bytes in, panel memory out.
 *
 * This is the simulator's own knowledge of the hardware: the RAM's size, the part of it that lies behind the glass, how
 * the glass is wired, and address counters. It shares nothing with hal's records, which say what a driver believes.
 *
 * Like a real controller, a simulated one does not stop at nonsense; it counts complaints and keeps the first one's
 * text.
 */
#ifndef SHEEN_CONTROLLER_H
#define SHEEN_CONTROLLER_H

#include <stddef.h>
#include <stdint.h>

struct sheen_sim_controller;

/* The level of the D/C line while bytes arrive. */
enum sheen_sim_dc {
    SHEEN_SIM_COMMAND = 0,
    SHEEN_SIM_DATA = 1
};

/* A command, or a range of them that differ in their low bits; run (or NULL) is called once all parameters are in. */
struct sheen_sim_command {
    uint8_t first, last;
    uint8_t params;
    void (*run)(struct sheen_sim_controller *controller);
};

/* A kind of controller. Times are minima, in us. */
struct sheen_sim_chip {
    const char *name;
    const struct sheen_sim_command *commands, *vendor; /* vendor: registers accepted, most without effect */
    size_t command_count, vendor_count;
    void (*defaults)(struct sheen_sim_controller *controller);             /* registers after power-on or reset */
    void (*pixels)(struct sheen_sim_controller *controller, uint8_t byte); /* a byte of picture data */
    void (*stream_end)(struct sheen_sim_controller *controller);           /* another command ends the picture data */
    uint16_t (*shown)(const struct sheen_sim_controller *controller, unsigned column, unsigned row);
    uint16_t max_level;          /* 0: RGB565; else grey levels 0..max_level */
    uint8_t reset_command;       /* a command that may interrupt any other; 0: there is none */
    uint8_t bits_18;             /* 1: colour comes in three bytes per pixel and no other format */
    uint8_t params_are_commands; /* 1: parameters come with D/C low, data is always picture data */
    uint32_t reset_low_us, reset_us;
};

/* A module: a chip behind a glass. Positions are RAM columns and rows (DCS) or segments and COM lines (OLED). */
struct sheen_sim_module {
    const char *name;
    const struct sheen_sim_chip *chip;
    uint16_t ram_w, ram_h, glass_w, glass_h; /* px */
    uint16_t gap_x, gap_y;                   /* lowest RAM column and row behind the glass */
    uint8_t mirror_x, mirror_y;              /* 1: RAM column (row) 0 is wired to the glass's right (bottom) */
    uint8_t bgr;                             /* 1: the glass's sub-pixels are blue, green, red */
    uint8_t inverted;                        /* 1: the glass shows the complement unless the chip inverts */
    uint8_t round;                           /* 1: the glass is the disc that touches all four sides */
    uint8_t i2c_address;                     /* 7 bits; 0: it has no I2C */
    uint8_t no_current; /* 1: no resistor at IREF, so that the chip has to make the segments' current */
};

struct sheen_sim_controller {
    const struct sheen_sim_module *module;
    uint16_t *ram;               /* ram_w * ram_h values: RGB565, or a level */
    uint64_t now_us;             /* the virtual clock: delays, TE pulses and timeouts move it, bytes do not */
    uint64_t quiet_until_us;     /* no command may come before this time */
    uint64_t sleep_out_from_us;  /* DCS: sleep out may not come before */
    uint64_t display_on_from_us; /* DCS: display on may not come before */
    uint32_t reset_fall_us;      /* how long a module's reset line takes to fall; 0: at the chip itself */
    uint64_t reset_since_us;     /* when the reset line fell */
    uint8_t reset_level;         /* the reset line's; 0 holds the chip in reset */
    uint8_t command, count, missing,
        streaming; /* the command under way, its parameters so far and to come; 1: picture data */
    uint8_t params[16];
    uint16_t x0, x1, y0, y1, x, y; /* window and address counter, in the chip's own units */
    uint8_t wrapped;               /* 1: the counter has been through the whole window */
    uint8_t half, half_set;        /* of a pixel's two or three bytes, the last one that came, and how many have */
    uint8_t red;                   /* the first of a pixel's three bytes */
    uint8_t awake, on, inverted, scan, format;
    uint8_t brightness, lit_by_it; /* the register; DCS: 1 if the backlight follows it */
    uint8_t tearing;               /* 1: the TE output is on */
    uint8_t com_remap, all_on;     /* OLED, 1: COM lines count downwards; 1: every pixel is lit */
    uint8_t unlocked, mode, multiplex, start_line, row_offset, pump, own_current; /* the SSD13xx and SH1106 families */
    unsigned rectangles;                                                          /* RAM writes begun */
    unsigned complaints;
    char first_complaint[160];
};

/* Allocates the RAM and switches the power on. 0, or SHEEN_ERR_MEMORY. */
int sheen_sim_controller_open(struct sheen_sim_controller *controller, const struct sheen_sim_module *module);
void sheen_sim_controller_close(struct sheen_sim_controller *controller);

/* Power off and on: noise in the RAM, registers at their defaults. */
void sheen_sim_power_cycle(struct sheen_sim_controller *controller);

/* The controller's inputs: bytes, the reset line's level, and the time that passes. */
void sheen_sim_receive(struct sheen_sim_controller *controller, enum sheen_sim_dc dc, const uint8_t *bytes,
                       size_t count);
void sheen_sim_reset_line(struct sheen_sim_controller *controller, int level);
void sheen_sim_advance(struct sheen_sim_controller *controller, uint32_t us);

/* Advances the clock to the next pulse of the TE output. 0, or SHEEN_ERR_TIMEOUT if it is off or the chip sleeps. */
int sheen_sim_tearing(struct sheen_sim_controller *controller);

/* For the chips: report a complaint; set the address counter to the window's start; store a pixel, if in the RAM. */
void sheen_sim_complain(struct sheen_sim_controller *controller, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void sheen_sim_window_start(struct sheen_sim_controller *controller);
void sheen_sim_store(struct sheen_sim_controller *controller, unsigned column, unsigned row, uint16_t value);

/* controller_oled.c: shared by the OLED chips. */
int sheen_sim_com_row(const struct sheen_sim_controller *controller, unsigned com, unsigned top);
void sheen_sim_next_address(struct sheen_sim_controller *controller, int vertical);
void sheen_sim_check_window(struct sheen_sim_controller *controller, unsigned width, unsigned height);
void sheen_sim_set_columns(struct sheen_sim_controller *controller);
void sheen_sim_set_rows(struct sheen_sim_controller *controller);
void sheen_sim_set_brightness(struct sheen_sim_controller *controller);
void sheen_sim_set_on(struct sheen_sim_controller *controller);
void sheen_sim_set_mode(struct sheen_sim_controller *controller);

extern const struct sheen_sim_chip sheen_sim_chip_ideal, sheen_sim_chip_ili9341, sheen_sim_chip_ili9488,
    sheen_sim_chip_ssd1322, sheen_sim_chip_st7789, sheen_sim_chip_st7735, sheen_sim_chip_st7796, sheen_sim_chip_gc9a01,
    sheen_sim_chip_ssd1351, sheen_sim_chip_ssd0323, sheen_sim_chip_ssd1325, sheen_sim_chip_ssd1327,
    sheen_sim_chip_ssd1306, sheen_sim_chip_sh1106;

/* The module of exactly that name; NULL if there is none. */
const struct sheen_sim_module *sheen_sim_module_find(const char *name);

#endif
