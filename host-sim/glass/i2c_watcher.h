/*
 * i2c_watcher.h - edges on SCL and SDA to messages: the receiving half of an I2C panel, beside pin_watcher.h.
 *
 * SDA moves while SCL is low, but for a start (it falls while SCL is high) and a stop
 * (it rises); a bit is taken when SCL rises, high bit first, the ninth is the
 * acknowledgement (UM10204, 3.1). What comes out at each stop is a call of a bus: the
 * message without its address, as sim_bus.h takes them. A target's own pulling of SDA
 * is not in such a trace: whether a byte was acknowledged is not judged here.
 */
#ifndef SHEEN_I2C_WATCHER_H
#define SHEEN_I2C_WATCHER_H

#include "sheen_bus.h"

#ifdef __cplusplus
extern "C" {
#endif

struct sheen_i2c_watcher {
    const struct sheen_bus *to; /* gets each message as a call without command */
    uint8_t address;            /* of 7 bits: messages to others are not for this panel, and complained about */
    uint8_t scl, sda;           /* levels */
    uint8_t inside;             /* between start and stop */
    uint8_t shift, bits;        /* the byte under way: bits so far, 0..8 */
    size_t count;               /* bytes of the message, its address included */
    uint8_t message[256];
    size_t messages, bytes; /* so far; bytes without addresses */
    const char *complaint;  /* the first broken rule, or NULL */
};

/* Both lines high, as the bus stands idle. */
void sheen_i2c_watcher_init(struct sheen_i2c_watcher *watcher, const struct sheen_bus *to, unsigned address);

/* Lines at these levels; at most one of them changes. As sheen_pin_watcher_edge(). */
int sheen_i2c_watcher_levels(struct sheen_i2c_watcher *watcher, int scl, int sda);

/* The trace is over: SHEEN_ERR_BUS where it ends inside a message or held none. */
int sheen_i2c_watcher_finish(struct sheen_i2c_watcher *watcher);

#ifdef __cplusplus
}
#endif
#endif
