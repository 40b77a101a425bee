/*
 * sheen_bus.h - what a board provides for a panel: sending of whole commands, a reset line, delays.
 *
 * A panel driver reaches its panel through this struct only. A board fills it in
 * with its SPI and two pins, the simulator with a simulated controller, Linux with
 * spidev, bit-banged lines or I2C. Two functions are enough:
 *
 *   const struct sheen_bus bus = {.ctx = &spi, .send = send, .delay = delay};
 *
 * Clock, SPI mode and chip select are the bus's own business: set it up with the clock
 * and mode from the panel's record, and select the panel during each call of send.
 *
 * One call of send is one whole command, so it maps directly to other interfaces:
 *
 *   4-wire SPI      CS low; D/C low, the command; D/C high, the data; CS high
 *   I2C             one message, or a few, with control bytes (sheen_i2c.h)
 *   ESP-IDF         esp_lcd_panel_io_tx_param(io, command[0], data, count), or tx_color for pixels; if there are no
 *                   data, tx_param(io, command[0], command + 1, commands - 1) on an IO with dc_low_on_param; if there
 *                   is no command, -1 in place of command[0]
 *   Zephyr          mipi_dbi_command_write(), once for each of several command bytes, because it sends parameters with
 *                   D/C high; mipi_dbi_write_display() if there is no command
 */
#ifndef SHEEN_BUS_H
#define SHEEN_BUS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The most command bytes in one call: a command and 15 parameters. */
#define SHEEN_BUS_COMMANDS 16

/*
 * Functions that return int return 0 or a negative code (enum sheen_error or one of the
 * bus's own), which sheen_end() passes on unchanged. A positive code, such as STM32's
 * HAL_ERROR, counts as SHEEN_ERR_BUS.
 */
struct sheen_bus {
    void *ctx; /* handed to each function */

    /*
     * Sends `commands` (0..SHEEN_BUS_COMMANDS) bytes with D/C low, then `count` bytes
     * with D/C high; the panel stays selected, or is deselected between whole bytes.
     * `commands` and `count` are not both 0; if one is 0, its pointer may be NULL. The
     * command bytes may change as soon as send returns. The data MAY leave later (DMA):
     * nobody touches them until wait returns. The driver calls wait between any two
     * calls of send.
     */
    int (*send)(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count);

    /* Lets at least us microseconds pass. */
    int (*delay)(void *ctx, uint32_t us);

    /* All functions below may be NULL. */

    /*
     * Blocks until everything from the last send has left, or returns SHEEN_ERR_TIMEOUT
     * after a time that the bus chooses. NULL: send itself returns only then.
     */
    int (*wait)(void *ctx);

    /*
     * Drives the panel's reset line, level 0 = asserted. NULL: not wired; controllers with a reset command (DCS) are
     * then reset by that command, others are initialised without a reset.
     */
    int (*reset)(void *ctx, int level);

    /*
     * For a bus that other devices share. acquire is called before each push, initialisation
     * or other call of sheen_panel.h that sends, release when its last byte has left. If
     * acquire fails, nothing is sent and release is not called. NULL: not shared.
     */
    int (*acquire)(void *ctx);
    void (*release)(void *ctx);

    /*
     * Blocks until the next rising edge of the panel's TE line, or returns SHEEN_ERR_TIMEOUT
     * after a time that the bus chooses. Called for sheen_panel_sync() only. NULL: TE is
     * not wired.
     */
    int (*tearing)(void *ctx);
};

/*
 * A bus around another bus (sheen_i2c.h, or a thread that sends): it passes on the calls
 * that it does not handle itself. Its functions get the layer as ctx, so the layer must
 * not be moved.
 */
struct sheen_bus_layer {
    struct sheen_bus bus;       /* what the panel driver is given */
    const struct sheen_bus *to; /* must outlive the layer */
};

/* Makes a layer that passes on every call (NULL where *to has NULL); replace functions by your own afterwards. */
void sheen_bus_layer_open(struct sheen_bus_layer *layer, const struct sheen_bus *to);

#ifdef __cplusplus
}
#endif
#endif
