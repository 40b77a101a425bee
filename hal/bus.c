/*
 * bus.c - a bus layer that passes on every call.
 */
#include "sheen_bus.h"

static int pass_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->send(to->ctx, command, commands, data, count);
}

static int pass_delay(void *ctx, uint32_t us)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->delay(to->ctx, us);
}

static int pass_wait(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->wait(to->ctx);
}

static int pass_reset(void *ctx, int level)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->reset(to->ctx, level);
}

static int pass_acquire(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->acquire(to->ctx);
}

static void pass_release(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    to->release(to->ctx);
}

static int pass_tearing(void *ctx)
{
    const struct sheen_bus *to = ((struct sheen_bus_layer *)ctx)->to;

    return to->tearing(to->ctx);
}

void sheen_bus_layer_open(struct sheen_bus_layer *layer, const struct sheen_bus *to)
{
    layer->to = to;
    layer->bus = (struct sheen_bus){.ctx = layer};
    layer->bus.send = to->send ? pass_send : NULL;
    layer->bus.delay = to->delay ? pass_delay : NULL;
    layer->bus.wait = to->wait ? pass_wait : NULL;
    layer->bus.reset = to->reset ? pass_reset : NULL;
    layer->bus.acquire = to->acquire ? pass_acquire : NULL;
    layer->bus.release = to->release ? pass_release : NULL;
    layer->bus.tearing = to->tearing ? pass_tearing : NULL;
}
