/*
 * bus.c - a layer that passes everything on.
 */
#include "sheen_bus.h"

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->send(to->ctx, command, commands, data, count);
}

static int delay(void *ctx, uint32_t us)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->delay(to->ctx, us);
}

static int wait(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->wait(to->ctx);
}

static int reset(void *ctx, int level)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->reset(to->ctx, level);
}

static int acquire(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->acquire(to->ctx);
}

static void release(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    to->release(to->ctx);
}

static int tearing(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->tearing(to->ctx);
}

void sheen_bus_layer_open(struct sheen_bus_layer *layer, const struct sheen_bus *to)
{
    layer->to = to;
    layer->bus = (struct sheen_bus){.ctx = layer, .send = send, .delay = delay};
    layer->bus.wait = to->wait ? wait : NULL;
    layer->bus.reset = to->reset ? reset : NULL;
    layer->bus.acquire = to->acquire ? acquire : NULL;
    layer->bus.release = to->release ? release : NULL;
    layer->bus.tearing = to->tearing ? tearing : NULL;
}
