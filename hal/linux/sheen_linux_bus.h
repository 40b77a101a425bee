/*
 * sheen_linux_bus.h - a struct sheen_bus on a Linux board: spidev, SPI bit-banged on GPIO lines, or I2C.
 *
 * Fill in the wiring, open the bus, hand &bus.bus to sheen_panel_open():
 *
 *   struct sheen_wiring wiring = {.spi = "/dev/spidev0.0", .dc = "GPIO25", .reset = "GPIO27",
 *                                 .clock_hz = record->clock_hz, .spi_mode = record->spi_mode};
 *
 *   struct sheen_wiring wiring = {.i2c = "/dev/i2c-1"};
 *
 * Calls of send return when the bytes have left (wait is NULL); sheen_sender.h sends
 * from a thread. If a function of the bus fails, *why holds the message for its code.
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
    const char *spi;   /* "/dev/spidev0.0"; NULL: i2c, or SPI bit-banged on sclk and mosi */
    const char *i2c;   /* "/dev/i2c-1"; then spi, sclk, mosi, cs and dc are not used */
    const char *sclk;  /* for bit-banged SPI only */
    const char *mosi;  /* for bit-banged SPI only */
    const char *cs;    /* chip select, active low; NULL: the SPI controller's own, or tied low. With spi: nothing else
                          may send on that SPI, because the kernel does not know of this line */
    const char *dc;    /* data/command; may be NULL with i2c only */
    const char *reset; /* NULL: not wired (sheen_bus.h) */
    const char *te;    /* the panel's TE (tearing effect) output: an input here */
    uint32_t clock_hz; /* for spidev, from 1 Hz; bit-banging runs as fast as the kernel lets it, below 1 MHz */
    uint8_t spi_mode;  /* 0..3 */
    uint8_t address;   /* for i2c, 7 bits; 0: SHEEN_I2C_ADDRESS */
};

#define SHEEN_I2C_ADDRESS 0x3Cu /* the address of most OLEDs */

/* Private to hal/linux, except bus. All zero: closed. */
struct sheen_linux_bus {
    struct sheen_bus bus;  /* give this to the panel: a copy of wire, or the I2C layer around it; must not be moved */
    struct sheen_bus wire; /* the bus without the I2C layer */
    struct sheen_i2c i2c;  /* the layer around wire, for I2C */
    struct sheen_pin sclk, mosi, cs, dc, reset, te; /* those that are not wired are closed */
    int (*put)(struct sheen_linux_bus *bus, const uint8_t *bytes, size_t count); /* sends bytes of SPI */
    struct sheen_failure *why;                                                   /* borrowed, for messages */
    int fd;                    /* the device, spidev or i2c; -1: none */
    size_t chunk;              /* the largest transfer that spidev accepts, B */
    uint32_t clock_hz;         /* for spidev */
    uint8_t spi_mode, address; /* as in the wiring */
    const char *path;          /* borrowed, for messages */
};

/*
 * Opens the device and takes the lines: CS and RESET high, D/C low, clock idle. Give
 * &bus->bus to the panel. On an error nothing stays open. *why and the strings of the
 * wiring must outlive the bus. Returns 0, or a negative code (enum sheen_error) with
 * a message in *why.
 */
int sheen_linux_bus_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring, struct sheen_failure *why);
/* Closes the device and releases the lines. The panel stays on: call sheen_panel_off() first to darken it. */
void sheen_linux_bus_close(struct sheen_linux_bus *bus);

/*
 * Private: the three kinds of bus. SPI of either kind fills in put, which sends bytes of
 * one D/C level and returns when they have left. I2C fills in wire.send.
 * sheen_device_open() sets bus->fd; its error message names the group that may open the
 * device, or what to switch on.
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
