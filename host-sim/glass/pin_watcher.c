/*
 * pin_watcher.c - see pin_watcher.h.
 */
#include "pin_watcher.h"

#include "sheen_target.h"

#include <string.h>

static int complain(struct sheen_pin_watcher *watcher, const char *what)
{
    watcher->bits = 0;
    if (watcher->complaint == NULL)
        watcher->complaint = what;
    return SHEEN_ERR_BUS;
}

/* 1 if SCLK's rising edge samples, as in modes 0 and 3; 0 if the falling one, as in 1 and 2: CPOL xor CPHA. */
static int samples_on(const struct sheen_pin_watcher *watcher)
{
    return watcher->mode == 0 || watcher->mode == 3;
}

static int sample(struct sheen_pin_watcher *watcher)
{
    if (watcher->level[SHEEN_WIRE_CS])
        return 0;
    if (!watcher->level[SHEEN_WIRE_RESET])
        return complain(watcher, "bits clocked while RESET is low");
    if (watcher->bits == 0)
        watcher->dc = watcher->level[SHEEN_WIRE_DC];
    watcher->shift = (uint8_t)(watcher->shift << 1 | watcher->level[SHEEN_WIRE_MOSI]);
    if (++watcher->bits < 8)
        return 0;
    watcher->bits = 0;
    watcher->bytes[watcher->dc]++;
    if (watcher->dc)
        return watcher->to->send(watcher->to->ctx, NULL, 0, &watcher->shift, 1);
    return watcher->to->send(watcher->to->ctx, &watcher->shift, 1, NULL, 0);
}

void sheen_pin_watcher_init(struct sheen_pin_watcher *watcher, const struct sheen_bus *to, unsigned mode,
                            const uint8_t level[SHEEN_WIRE_COUNT])
{
    memset(watcher, 0, sizeof *watcher);
    watcher->to = to;
    watcher->mode = (uint8_t)mode;
    memcpy(watcher->level, level, sizeof watcher->level);
}

int sheen_pin_watcher_edge(struct sheen_pin_watcher *watcher, enum sheen_wire wire, int level)
{
    int inside = watcher->bits != 0;

    level = level != 0;
    if (watcher->level[wire] == level)
        return 0;
    watcher->level[wire] = (uint8_t)level;

    switch (wire) {
    case SHEEN_WIRE_SCLK:
        return level == samples_on(watcher) ? sample(watcher) : 0;
    case SHEEN_WIRE_CS:
        watcher->selections += !level;
        return level && inside ? complain(watcher, "CS rose inside a byte") : 0;
    case SHEEN_WIRE_DC:
        return inside ? complain(watcher, "D/C changed inside a byte") : 0;
    case SHEEN_WIRE_RESET:
        watcher->resets += !level;
        if (!level && inside)
            return complain(watcher, "RESET fell inside a byte");
        return watcher->to->reset ? watcher->to->reset(watcher->to->ctx, level) : 0;
    case SHEEN_WIRE_MOSI:
    case SHEEN_WIRE_COUNT:
        break;
    }
    return 0;
}

int sheen_pin_watcher_finish(struct sheen_pin_watcher *watcher)
{
    if (watcher->bits != 0)
        return complain(watcher, "the trace ends inside a byte");
    if (watcher->bytes[SHEEN_SIM_COMMAND] + watcher->bytes[SHEEN_SIM_DATA] == 0)
        return complain(watcher, "no byte was sent");
    return watcher->complaint ? SHEEN_ERR_BUS : 0;
}
