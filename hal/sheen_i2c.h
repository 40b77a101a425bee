/*
 * sheen_i2c.h - panels on I2C: a bus's calls become messages with control bytes.
 *
 *   00 command ...     commands and their parameters, to the message's end
 *   40 pixel ...       data, to the message's end (SSD1306 data sheet, 8.1.5.2)
 *
 * A board with I2C fills in a struct sheen_bus whose send() is always called without
 * command: its data are one whole write message to the panel's address, 3C or 3D of
 * 7 bits (some modules print 78 or 7A, which is the same with the write bit). It
 * fails where nobody acknowledges. D/C and chip select do not exist.
 *
 *   const struct sheen_bus wire = {.ctx = &i2c0, .send = send_message, .delay = delay};
 *   static struct sheen_i2c i2c;
 *   sheen_i2c_open(&i2c, &wire, 0);
 *   sheen_panel_open(&panel, &sheen_panel_ssd1306_128x64, &i2c.layer.bus, 0);
 */
#ifndef SHEEN_I2C_H
#define SHEEN_I2C_H

#include "sheen_bus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The longest message, B: a control byte, and as much as a driver that packs sends at once (SHEEN_PANEL_PACK_BYTES). */
#define SHEEN_I2C_MESSAGE 65u

/* A bus around one that sends I2C messages. */
struct sheen_i2c {
    struct sheen_bus_layer layer;       /* layer.bus is what the panel driver is given; not to be moved */
    size_t longest;                     /* B of a message; private */
    uint8_t message[SHEEN_I2C_MESSAGE]; /* may be under way until wait */
};

/*
 * longest: what the board's I2C takes in a message, B; 0: SHEEN_I2C_MESSAGE, which is
 * also the most that is used. SHEEN_ERR_ARGUMENT below SHEEN_BUS_COMMANDS + 1, since a
 * command must not be divided.
 */
int sheen_i2c_open(struct sheen_i2c *i2c, const struct sheen_bus *to, size_t longest);

#ifdef __cplusplus
}
#endif
#endif
