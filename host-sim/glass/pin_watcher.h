/*
 * pin_watcher.h - edges on five wires to bytes: the receiving half of an SPI panel.
 *
 * It takes a trace of what a board did to its pins, edge by edge and in order, and makes calls of a struct sheen_bus
 * from it, one per byte. They go to a simulated controller, which cannot tell them from a panel driver's own. This
 * tests the last stretch of wire as well, which no bus-level test sees: bit order, clock mode, chip select, and D/C
 * that changes at the wrong moment.
 *
 * Panels shift MOSI in on the sampling edge of SCLK, high bit first, while CS is low, and sample D/C with the eighth
 * bit (ILI9341 datasheet, "4-line serial interface": D/CX is sampled at the rising edge of the last bit).
 */
#ifndef SHEEN_PIN_WATCHER_H
#define SHEEN_PIN_WATCHER_H

#include "controller.h"
#include "sheen_bus.h"

#ifdef __cplusplus
extern "C" {
#endif

enum sheen_wire {
    SHEEN_WIRE_SCLK = 0,
    SHEEN_WIRE_MOSI,
    SHEEN_WIRE_CS,
    SHEEN_WIRE_DC,
    SHEEN_WIRE_RESET,
    SHEEN_WIRE_COUNT
};

struct sheen_pin_watcher {
    const struct sheen_bus *to;      /* gets each byte in a call, and the reset edges */
    uint8_t level[SHEEN_WIRE_COUNT]; /* the present levels, 0 or 1 */
    uint8_t mode;                    /* SPI mode 0..3 */
    uint8_t shift;                   /* the bits of the byte under way, right-aligned */
    uint8_t bits;                    /* how many bits, 0..7 */
    uint8_t dc;                      /* D/C at the byte's first bit */
    size_t bytes[2];                 /* decoded so far, by enum sheen_sim_dc */
    size_t resets;                   /* falling edges of RESET */
    size_t selections;               /* falling edges of CS */
    const char *complaint;           /* the first broken rule, or NULL */
};

/*
 * level: the wires' levels before the first edge; a wire that does not exist keeps the given level (CS 0: always
 * selected; RESET 1). mode: SPI mode 0..3.
 */
void sheen_pin_watcher_init(struct sheen_pin_watcher *watcher, const struct sheen_bus *to, unsigned mode,
                            const uint8_t level[SHEEN_WIRE_COUNT]);

/*
 * A wire was driven to a level; the same level again is no edge. Returns 0, a negative code of the controller's, or
 * SHEEN_ERR_BUS if no panel would have understood the edge; watcher->complaint then says why, and the byte under way
 * is lost.
 */
int sheen_pin_watcher_edge(struct sheen_pin_watcher *watcher, enum sheen_wire wire, int level);

/* The trace is over: 0, or SHEEN_ERR_BUS if it ends inside a byte, held no byte or broke a rule before. */
int sheen_pin_watcher_finish(struct sheen_pin_watcher *watcher);

#ifdef __cplusplus
}
#endif
#endif
