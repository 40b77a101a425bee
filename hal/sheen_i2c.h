/*
 * sheen_i2c.h - panels on I2C: turns each call of a bus into I2C messages with control bytes.
 *
 *   00 command ...     commands and their parameters, to the message's end
 *   40 pixel ...       data, to the message's end (SSD1306 data sheet, 8.1.5.2)
 *
 * A board with I2C fills in a struct sheen_bus whose send() is always called without a
 * command: the data are one whole write message for the panel's 7-bit address, 3C or 3D
 * (some modules print 78 or 7A, the same with the write bit). send() fails if nobody
 * acknowledges. There is no D/C line and no chip select.
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

/* The longest message, B: a control byte and the most that a driver packs at once (SHEEN_PANEL_PACK_BYTES). */
#define SHEEN_I2C_MESSAGE 65u

/* A bus around a bus that sends I2C messages. */
struct sheen_i2c {
    struct sheen_bus_layer layer;       /* give layer.bus to the panel; must not be moved */
    size_t longest;                     /* longest message, B; private */
    uint8_t message[SHEEN_I2C_MESSAGE]; /* may be under way until wait returns */
};

/*
 * longest: the longest message that the board's I2C can send, B; 0: SHEEN_I2C_MESSAGE,
 * which is also the longest ever sent. SHEEN_ERR_ARGUMENT for 1..SHEEN_BUS_COMMANDS,
 * because a command must fit into one message.
 */
int sheen_i2c_open(struct sheen_i2c *i2c, const struct sheen_bus *to, size_t longest);

#ifdef __cplusplus
}
#endif
#endif
