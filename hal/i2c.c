/*
 * i2c.c - see sheen_i2c.h. There is one buffer, so a message is built only after the one before has left; the last one
 * of a call may still be under way when the call returns.
 */
#include "sheen_i2c.h"

#include "sheen_target.h"

#include <string.h>

#define CONTROL_COMMANDS 0x00u
#define CONTROL_DATA 0x40u

static int send_message(struct sheen_i2c *i2c, uint8_t control, const void *bytes, size_t count)
{
    const struct sheen_bus *to = i2c->layer.to;

    i2c->message[0] = control;
    memcpy(&i2c->message[1], bytes, count);
    return to->send(to->ctx, NULL, 0, i2c->message, count + 1);
}

static int landed(const struct sheen_bus *to)
{
    return to->wait ? to->wait(to->ctx) : SHEEN_OK;
}

static int i2c_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_i2c *i2c = ctx;
    const uint8_t *byte = data;
    int error = SHEEN_OK;

    if (commands > SHEEN_BUS_COMMANDS)
        return SHEEN_ERR_ARGUMENT;
    if (commands)
        error = send_message(i2c, CONTROL_COMMANDS, command, commands);
    if (error == SHEEN_OK && commands && count)
        error = landed(i2c->layer.to);
    while (error == SHEEN_OK && count) {
        size_t part = count < i2c->longest - 1 ? count : i2c->longest - 1;

        error = send_message(i2c, CONTROL_DATA, byte, part);
        byte += part;
        count -= part;
        if (error == SHEEN_OK && count)
            error = landed(i2c->layer.to);
    }
    return error;
}

int sheen_i2c_open(struct sheen_i2c *i2c, const struct sheen_bus *to, size_t longest)
{
    if (!i2c || !to || !to->send || !to->delay || (longest && longest <= SHEEN_BUS_COMMANDS))
        return SHEEN_ERR_ARGUMENT;
    i2c->longest = longest && longest < SHEEN_I2C_MESSAGE ? longest : SHEEN_I2C_MESSAGE;
    sheen_bus_layer_open(&i2c->layer, to);
    i2c->layer.bus.send = i2c_send;
    return SHEEN_OK;
}
