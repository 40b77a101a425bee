/*
 * linux_bus.h - a struct sheen_bus on a Linux board: spidev, or SPI bit-banged on GPIO lines.
 *
 * Fill in the wiring, open, hand &bus.bus to sheen_panel_open():
 *
 *   struct sheen_wiring wiring = {.spi = "/dev/spidev0.0", .dc = "GPIO25", .reset = "GPIO27",
 *                                 .clock_hz = record->clock_hz, .spi_mode = record->spi_mode};
 *
 * Writes return when the bytes have left (wait is NULL); sender.h adds a thread.
 * When a function of the bus fails, *why has the sentence to its code.
 */
#ifndef SHEEN_LINUX_BUS_H
#define SHEEN_LINUX_BUS_H

#include "pins.h"
#include "sheen_bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Lines are named as in pins.h; NULL: not wired. */
struct sheen_wiring {
    const char *spi;   /* "/dev/spidev0.0"; NULL: bit-banged on sclk and mosi */
    const char *sclk;  /* bit-bang only */
    const char *mosi;  /* bit-bang only */
    const char *cs;    /* chip select, low selects; NULL: the controller's own, or tied low */
    const char *dc;    /* never NULL */
    const char *reset; /* NULL: the panel is reset by command */
    uint32_t clock_hz; /* of spidev; bit-bang runs as fast as the kernel lets it, below 1 MHz */
    uint8_t spi_mode;  /* 0..3 */
};

/* Private to hal/linux but for bus. All zero: closed. */
struct sheen_linux_bus {
    struct sheen_bus bus; /* ctx is this struct: it must not be moved */
    struct sheen_pin sclk, mosi, cs, dc, reset;
    int (*send)(struct sheen_linux_bus *bus, const uint8_t *bytes, size_t count);
    struct sheen_failure *why;
    int fd;       /* spidev; -1: none */
    size_t chunk; /* B, the largest transfer that spidev takes */
    uint32_t clock_hz;
    uint8_t spi_mode;
    const char *path; /* borrowed, for messages */
};

/*
 * Takes the device and the lines: CS and RESET high, D/C low, clock idle. On an
 * error nothing stays open. *why and the wiring's texts must outlive the bus.
 */
int sheen_linux_bus_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring, struct sheen_failure *why);
void sheen_linux_bus_close(struct sheen_linux_bus *bus);

/* Private: what the two kinds add. */
int sheen_spidev_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring);
int sheen_bitbang_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring);

#ifdef __cplusplus
}
#endif
#endif
