/*
 * i2c_watcher.h - edges on SCL and SDA to messages: the receiving half of an I2C panel, as pin_watcher.h is for SPI.
 *
 * SDA moves while SCL is low, except for a start (SDA falls while SCL is high) and a stop (SDA rises while SCL is
 * high); a bit is sampled when SCL rises, high bit first, and the ninth is the acknowledgement (UM10204, 3.1). At each
 * stop the message is passed to a bus in one call, without its address, as sim_bus.h takes it. Such a trace does not
 * contain what a target does to SDA, so whether a byte was acknowledged is not judged here.
 */
#ifndef SHEEN_I2C_WATCHER_H
#define SHEEN_I2C_WATCHER_H

#include "sheen_bus.h"

#ifdef __cplusplus
extern "C" {
#endif

struct sheen_i2c_watcher {
    const struct sheen_bus *to; /* gets each message as a call without command */
    uint8_t address;            /* 7 bits; a message to another address is complained about */
    uint8_t scl, sda;           /* present levels */
    uint8_t inside;             /* 1 between start and stop */
    uint8_t shift, bits;        /* the byte under way: bits so far, 0..8 */
    size_t count;               /* bytes of the message, its address included */
    uint8_t message[256];
    size_t messages, bytes; /* so far; bytes without addresses */
    const char *complaint;  /* the first broken rule, or NULL */
};

/* Both lines start high, as on an idle bus. */
void sheen_i2c_watcher_init(struct sheen_i2c_watcher *watcher, const struct sheen_bus *to, unsigned address);

/* The lines are driven to these levels; at most one may change at a time. Returns as sheen_pin_watcher_edge(). */
int sheen_i2c_watcher_levels(struct sheen_i2c_watcher *watcher, int scl, int sda);

/* The trace is over: 0, or SHEEN_ERR_BUS if it ends inside a message, held no byte or broke a rule before. */
int sheen_i2c_watcher_finish(struct sheen_i2c_watcher *watcher);

#ifdef __cplusplus
}
#endif
#endif
