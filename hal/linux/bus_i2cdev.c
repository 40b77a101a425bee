/*
 * bus_i2cdev.c - I2C through /dev/i2c-N: each send from the layer of sheen_i2c.h is one write message.
 */
#include "sheen_linux_bus.h"

#include "sheen_target.h"

#include <errno.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <string.h>
#include <sys/ioctl.h>

/* The range of 7-bit addresses that are not reserved (I2C specification UM10204, 3.1.12). */
#define ADDRESS_FIRST 0x08u
#define ADDRESS_LAST 0x77u

static int message_fail(struct sheen_linux_bus *bus, int error)
{
    switch (error) {
    case ENXIO: /* nobody acknowledged; which of these three codes comes depends on the adapter's driver */
    case EREMOTEIO:
    case EIO:
        return sheen_failed(
            bus->why, SHEEN_ERR_BUS,
            "%s: %s: no device answers at address 0x%02x; see `i2cdetect`, the wiring, or another --address", bus->path,
            strerror(error), bus->address);
    case ETIMEDOUT:
        return sheen_failed(bus->why, SHEEN_ERR_TIMEOUT, "%s: the bus is stuck (SCL or SDA low); are both pulled up?",
                            bus->path);
    default:
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: %s", bus->path, strerror(error));
    }
}

/* A message must be sent as a whole: the rest of a cut message would lack its control byte. */
static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_linux_bus *bus = ctx;
    uint8_t bytes[SHEEN_I2C_MESSAGE]; /* a copy, because the kernel's struct has no const pointer */
    struct i2c_msg message = {.addr = bus->address, .len = (uint16_t)count, .buf = bytes};
    struct i2c_rdwr_ioctl_data messages = {.msgs = &message, .nmsgs = 1};

    (void)command;
    (void)commands;
    if (count > sizeof bytes)
        return SHEEN_ERR_ARGUMENT;
    memcpy(bytes, data, count);
    return sheen_ioctl_again(bus->fd, I2C_RDWR, &messages) < 0 ? message_fail(bus, errno) : 0;
}

static int set_address(struct sheen_linux_bus *bus)
{
    unsigned long functions = 0;

    if (sheen_ioctl_again(bus->fd, I2C_FUNCS, &functions) < 0)
        return errno == ENOTTY || errno == ENODEV || errno == EINVAL
                   ? sheen_failed(bus->why, SHEEN_ERR_ARGUMENT, "%s is not an I2C bus (/dev/i2c-1 is one)", bus->path)
                   : message_fail(bus, errno);
    if (!(functions & I2C_FUNC_I2C))
        return sheen_failed(bus->why, SHEEN_ERR_UNSUPPORTED, "%s: its adapter speaks SMBus only", bus->path);
    if (sheen_ioctl_again(bus->fd, I2C_SLAVE, (void *)(uintptr_t)bus->address) == 0)
        return 0;
    if (errno == EBUSY)
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: a driver of the kernel has address 0x%02x; unbind it first",
                            bus->path, bus->address);
    return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: address 0x%02x: %s", bus->path, bus->address, strerror(errno));
}

int sheen_i2cdev_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    bus->address = wiring->address ? wiring->address : SHEEN_I2C_ADDRESS;
    if (bus->address < ADDRESS_FIRST || bus->address > ADDRESS_LAST)
        return sheen_failed(bus->why, SHEEN_ERR_ARGUMENT, "I2C address 0x%02x is not in 0x%02x..0x%02x", bus->address,
                            ADDRESS_FIRST, ADDRESS_LAST);
    int error = sheen_device_open(bus, wiring->i2c, "i2c",
                                  "I2C on (Raspberry Pi: dtparam=i2c_arm=on in config.txt, restart), and load the "
                                  "module i2c-dev");
    if (error < 0)
        return error;
    bus->wire.send = send;
    return set_address(bus);
}
