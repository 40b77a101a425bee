/*
 * sheen_linux_bus.h - a struct sheen_bus on a Linux board: spidev, SPI bit-banged on GPIO lines, or I2C.
 *
 * Fill in the wiring, open, hand &bus.bus to sheen_panel_open():
 *
 *   struct sheen_wiring wiring = {.spi = "/dev/spidev0.0", .dc = "GPIO25", .reset = "GPIO27",
 *                                 .clock_hz = record->clock_hz, .spi_mode = record->spi_mode};
 *
 *   struct sheen_wiring wiring = {.i2c = "/dev/i2c-1"};
 *
 * Calls return when the bytes have left (wait is NULL); sheen_sender.h adds a thread.
 * When a function of the bus fails, *why has the sentence to its code.
 */
#ifndef SHEEN_LINUX_BUS_H
#define SHEEN_LINUX_BUS_H

#include "sheen_bus.h"
#include "sheen_i2c.h"
#include "sheen_pins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Lines are named as in sheen_pins.h; NULL: not wired. */
struct sheen_wiring {
    const char *spi;   /* "/dev/spidev0.0"; NULL, and no i2c: bit-banged on sclk and mosi */
    const char *i2c;   /* "/dev/i2c-1": in place of spi, sclk, mosi, cs and dc */
    const char *sclk;  /* bit-bang only */
    const char *mosi;  /* bit-bang only */
    const char *cs;    /* chip select, low selects; NULL: the controller's own, or tied low */
    const char *dc;    /* NULL with i2c only */
    const char *reset; /* NULL: not wired (sheen_bus.h) */
    const char *te;    /* tearing effect, an input */
    uint32_t clock_hz; /* of spidev, from 1 Hz; bit-bang runs as fast as the kernel lets it, below 1 MHz */
    uint8_t spi_mode;  /* 0..3 */
    uint8_t address;   /* of i2c, 7 bits; 0: SHEEN_I2C_ADDRESS */
};

#define SHEEN_I2C_ADDRESS 0x3Cu /* of most OLEDs */

/* Private to hal/linux but for bus. All zero: closed. */
struct sheen_linux_bus {
    struct sheen_bus bus;  /* what a panel driver is given: of wire, or around it; must not be moved */
    struct sheen_bus wire; /* the wires themselves */
    struct sheen_i2c i2c;  /* around wire */
    struct sheen_pin sclk, mosi, cs, dc, reset, te; /* closed where they are not wired */
    int (*put)(struct sheen_linux_bus *bus, const uint8_t *bytes, size_t count,
               int more);                          /* sends bytes; more: CS stays */
    void (*deselect)(struct sheen_linux_bus *bus); /* ends a command whose data do not follow; NULL: nothing to do */
    struct sheen_failure *why;                     /* borrowed, for messages */
    int fd;                                        /* of spidev or i2c; -1: none */
    size_t chunk;                                  /* B, the largest transfer that spidev takes */
    uint32_t clock_hz;                             /* of spidev */
    uint8_t spi_mode, address;                     /* as in the wiring */
    const char *path;                              /* borrowed, for messages */
};

/*
 * Takes the device and the lines: CS and RESET high, D/C low, clock idle. The panel
 * driver is given &bus->bus. On an error nothing stays open. *why and the wiring's
 * texts must outlive the bus. 0, or a negative code (enum sheen_error) with its
 * sentence in *why.
 */
int sheen_linux_bus_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring, struct sheen_failure *why);
/* Gives back the device and the lines; the panel is left as it is (sheen_panel_off() first). */
void sheen_linux_bus_close(struct sheen_linux_bus *bus);

/*
 * Private: what the kinds add. put sends bytes of one D/C level and returns when they
 * have left; more: the controller's own chip select is to stay low after them. A device
 * becomes bus->fd; else the line names the group that may open it, or what to switch.
 */
int sheen_ioctl_again(int fd, unsigned long request, void *value);
int sheen_device_open(struct sheen_linux_bus *bus, const char *path, const char *group, const char *what);
int sheen_spidev_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring);
int sheen_i2cdev_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring);
int sheen_bitbang_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring);

#ifdef __cplusplus
}
#endif
#endif
