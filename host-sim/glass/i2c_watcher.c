/*
 * i2c_watcher.c - see i2c_watcher.h.
 */
#include "i2c_watcher.h"

#include "sheen_target.h"

#include <string.h>

static int complain(struct sheen_i2c_watcher *watcher, const char *what)
{
    watcher->inside = watcher->bits = 0;
    if (watcher->complaint == NULL)
        watcher->complaint = what;
    return SHEEN_ERR_BUS;
}

/* 1 if a start or stop comes inside a byte. Its own rise of SCL, before SDA moved, was counted as one bit. */
static int cuts_a_byte(const struct sheen_i2c_watcher *watcher)
{
    return watcher->inside && watcher->bits != 1;
}

static int start(struct sheen_i2c_watcher *watcher)
{
    if (cuts_a_byte(watcher))
        return complain(watcher, "a start inside a byte");
    if (watcher->inside && watcher->count)
        return complain(watcher, "a second start without a stop");
    watcher->inside = 1;
    watcher->bits = 0;
    watcher->count = 0;
    return 0;
}

static int stop(struct sheen_i2c_watcher *watcher)
{
    int cut = cuts_a_byte(watcher), inside = watcher->inside;

    watcher->inside = watcher->bits = 0;
    if (!inside)
        return complain(watcher, "a stop without a start");
    if (cut)
        return complain(watcher, "a stop inside a byte");
    if (watcher->count == 0 || watcher->message[0] >> 1 != watcher->address)
        return complain(watcher, "a message to another address");
    if (watcher->message[0] & 1)
        return complain(watcher, "a read");
    watcher->messages++;
    watcher->bytes += watcher->count - 1;
    if (watcher->count == 1)
        return 0;
    return watcher->to->send(watcher->to->ctx, NULL, 0, watcher->message + 1, watcher->count - 1);
}

static int take_bit(struct sheen_i2c_watcher *watcher)
{
    if (!watcher->inside)
        return 0;
    if (watcher->bits < 8) {
        watcher->shift = (uint8_t)(watcher->shift << 1 | watcher->sda);
        watcher->bits++;
        return 0;
    }
    watcher->bits = 0; /* the ninth, the acknowledgement */
    if (watcher->count == sizeof watcher->message)
        return complain(watcher, "a message of more than 256 bytes");
    watcher->message[watcher->count++] = watcher->shift;
    return 0;
}

void sheen_i2c_watcher_init(struct sheen_i2c_watcher *watcher, const struct sheen_bus *to, unsigned address)
{
    memset(watcher, 0, sizeof *watcher);
    watcher->to = to;
    watcher->address = (uint8_t)address;
    watcher->scl = watcher->sda = 1;
}

int sheen_i2c_watcher_levels(struct sheen_i2c_watcher *watcher, int scl, int sda)
{
    int clock = watcher->scl != (scl != 0), data = watcher->sda != (sda != 0);

    watcher->scl = scl != 0;
    watcher->sda = sda != 0;
    if (clock && data)
        return complain(watcher, "SCL and SDA change at once");
    if (clock)
        return scl ? take_bit(watcher) : 0;
    if (data && scl)
        return sda ? stop(watcher) : start(watcher);
    return 0;
}

int sheen_i2c_watcher_finish(struct sheen_i2c_watcher *watcher)
{
    if (watcher->inside)
        return complain(watcher, "the trace ends inside a message");
    if (watcher->bytes == 0)
        return complain(watcher, "no byte was sent");
    return watcher->complaint ? SHEEN_ERR_BUS : 0;
}
