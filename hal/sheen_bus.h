/*
 * sheen_bus.h - whole commands, a reset line, time: the seam where a board plugs in.
 *
 * A panel driver speaks to its panel through this struct only. A board fills it
 * in with its SPI and two pins; the simulator with a simulated controller; Linux
 * with spidev, bit-banged lines or I2C. Two functions are enough:
 *
 *   const struct sheen_bus bus = {.ctx = &spi, .send = send, .delay = delay};
 *
 * Clock, SPI mode and chip select are the bus's own: it is opened with the clock
 * and mode of the panel's record and selects the panel around each call.
 *
 * One call is a whole command, so it maps one to one to what others offer:
 *
 *   4-wire SPI      CS low; D/C low, the command; D/C high, the data; CS high
 *   I2C             one message, or a few, with control bytes (sheen_i2c.h)
 *   ESP-IDF         esp_lcd_panel_io_tx_param(io, command[0], data, count), or tx_color for pixels; without data
 *                   tx_param(io, command[0], command + 1, commands - 1) and dc_low_on_param; without command -1
 *   Zephyr          mipi_dbi_command_write(), or mipi_dbi_write_display() without command
 */
#ifndef SHEEN_BUS_H
#define SHEEN_BUS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The most command bytes of a call: a command and 15 parameters. */
#define SHEEN_BUS_COMMANDS 16

/*
 * Functions that return int return 0 or a negative code (enum sheen_error or the
 * bus's own), which reaches the caller of sheen_end() unchanged. A positive one, such
 * as HAL_ERROR of STM32, counts as SHEEN_ERR_BUS.
 */
struct sheen_bus {
    void *ctx; /* handed to each function */

    /*
     * Sends `commands` (0..SHEEN_BUS_COMMANDS) bytes with D/C low, then `count` bytes
     * with D/C high; the panel stays selected in between. Not both are 0; the pointer
     * of a 0 may be NULL. The command has been read when send returns. The data MAY
     * leave later (DMA): they stay untouched until wait returns. The driver calls wait
     * between any two calls of send.
     */
    int (*send)(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count);

    /* Lets at least us microseconds pass. */
    int (*delay)(void *ctx, uint32_t us);

    /* All that follow may be NULL. */

    /*
     * Blocks, within a bound of the bus's choice, until all of the last send has left;
     * SHEEN_ERR_TIMEOUT past that bound. NULL: send returns when everything has left.
     */
    int (*wait)(void *ctx);

    /*
     * Drives the panel's reset line, level 0 = asserted. NULL: none; controllers that have a command for it (DCS) are
     * reset by that, others are initialised as they are.
     */
    int (*reset)(void *ctx, int level);

    /*
     * Around each push, initialisation or other call of sheen_panel.h, until its last
     * byte has left: for a bus that others use too. After an error of acquire nothing
     * is sent and release is not called. NULL: the bus is the panel's alone.
     */
    int (*acquire)(void *ctx);
    void (*release)(void *ctx);

    /*
     * Blocks, within a bound, until the panel's TE line rises next; SHEEN_ERR_TIMEOUT
     * past that bound. Called for sheen_panel_sync() only. NULL: TE is not wired.
     */
    int (*tearing)(void *ctx);
};

/*
 * A bus around a bus (sheen_i2c.h, a thread that sends): what it does not do itself
 * it passes on. ctx of its functions is the layer, which must not be moved.
 */
struct sheen_bus_layer {
    struct sheen_bus bus;       /* what the panel driver is given */
    const struct sheen_bus *to; /* must outlive the layer */
};

/* Everything is passed on, and NULL where *to has NULL; then put functions of one's own in its place. */
void sheen_bus_layer_open(struct sheen_bus_layer *layer, const struct sheen_bus *to);

#ifdef __cplusplus
}
#endif
#endif
