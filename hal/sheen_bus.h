/*
 * sheen_bus.h - bytes with a D/C flag, a reset line, time: the seam where a board plugs in.
 *
 * A panel driver speaks to its panel through this struct only. A board fills it
 * in with its SPI and two pins; the simulator with a simulated controller; Linux
 * with spidev or bit-banged lines of libgpiod.
 *
 * Chip select, clock and SPI mode are the bus's own: it is opened with the clock
 * and mode of the panel's record and selects the panel around each write.
 */
#ifndef SHEEN_BUS_H
#define SHEEN_BUS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the bytes of a write are: the level of the D/C line while they leave. */
enum sheen_dc {
    SHEEN_COMMAND = 0,
    SHEEN_DATA = 1
};

/*
 * Every function returns 0 or a negative code (enum sheen_error or the bus's
 * own), which reaches the caller of sheen_end() unchanged.
 *
 * write: send count (>= 1) bytes, all with the same D/C level. It MAY return
 *   before they have left (DMA): the bytes then stay untouched by the driver
 *   until wait returns. The driver calls wait between any two writes.
 * wait: block, within a bound of the bus's choice, until the last write has
 *   left; SHEEN_ERR_TIMEOUT past that bound. NULL where write always finishes.
 * reset: drive the panel's reset line, level 0 = asserted. NULL where the
 *   board has none: the driver then resets by command.
 * delay: let at least us microseconds pass.
 */
struct sheen_bus {
    void *ctx;
    int (*write)(void *ctx, enum sheen_dc dc, const void *bytes, size_t count);
    int (*wait)(void *ctx);
    int (*reset)(void *ctx, int level);
    int (*delay)(void *ctx, uint32_t us);
};

#ifdef __cplusplus
}
#endif
#endif
