/*
 * linux_bus.c - what spidev, bit-banged SPI and I2C share: D/C, chip select, reset, TE and delays.
 *
 * D/C changes only here, before the first bit of a command or of data. All earlier bits
 * have left by then, because put() of spidev and of bit-banged SPI waits for the last.
 */
#include "sheen_linux_bus.h"

#include "sheen_target.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

/* Sends bytes with D/C at level dc. */
static int put(struct sheen_linux_bus *bus, int dc, const void *bytes, size_t count)
{
    int error = sheen_pin_set(&bus->dc, dc, bus->why);

    return error < 0 ? error : bus->put(bus, bytes, count);
}

/*
 * Puts a bit-banged clock back to its idle level, in case an error left it elsewhere. This
 * must happen while the panel is not selected, or before it is reset: otherwise the panel
 * would count the edge as a bit.
 */
static int rest_clock(struct sheen_linux_bus *bus)
{
    return sheen_pin_is_open(&bus->sclk) ? sheen_pin_set(&bus->sclk, bus->spi_mode >> 1, bus->why) : 0;
}

static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct sheen_linux_bus *bus = ctx;
    int own_cs = sheen_pin_is_open(&bus->cs);
    int error = rest_clock(bus);

    if (error == 0 && own_cs)
        error = sheen_pin_set(&bus->cs, 0, bus->why);
    if (error == 0 && commands)
        error = put(bus, 0, command, commands);
    if (error == 0 && count)
        error = put(bus, 1, data, count);
    /* Deselect after an error too: later traffic on a shared bus must not reach the panel. */
    if (own_cs) {
        int released = sheen_pin_set(&bus->cs, 1, error ? NULL : bus->why);

        error = error ? error : released;
    }
    return error;
}

static int reset(void *ctx, int level)
{
    struct sheen_linux_bus *bus = ctx;
    int error = rest_clock(bus);

    return error < 0 ? error : sheen_pin_set(&bus->reset, level, bus->why);
}

/* The end of the delay is an absolute time, so a signal does not change it. */
static int delay(void *ctx, uint32_t us)
{
    struct sheen_linux_bus *bus = ctx;
    struct timespec until;
    int error;

    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += us / 1000000;
    until.tv_nsec += us % 1000000 * 1000L;
    if (until.tv_nsec >= 1000000000L) {
        until.tv_nsec -= 1000000000L;
        until.tv_sec++;
    }
    do
        error = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
    while (error == EINTR);
    return error ? sheen_failed(bus->why, SHEEN_ERR_BUS, "clock_nanosleep: %s", strerror(error)) : 0;
}

#define TE_TIMEOUT_US 1000000u /* ample: panels refresh their glass 40 to 120 times a second */

static int tearing(void *ctx)
{
    struct sheen_linux_bus *bus = ctx;
    int error = sheen_pin_await(&bus->te, TE_TIMEOUT_US, bus->why);

    if (error == SHEEN_ERR_TIMEOUT)
        return sheen_failed(bus->why, error,
                            "line %s: no pulse in %u ms; is the panel's TE wired to it? else leave out --te",
                            bus->te.name, TE_TIMEOUT_US / 1000);
    return error;
}

int sheen_ioctl_again(int fd, unsigned long request, void *value)
{
    int tries = SHEEN_TRIES, result;

    do
        result = ioctl(fd, request, value);
    while (result < 0 && sheen_again(errno, &tries));
    return result;
}

int sheen_device_open(struct sheen_linux_bus *bus, const char *path, const char *group, const char *what)
{
    int tries = SHEEN_TRIES;

    bus->path = path;
    do
        bus->fd = open(path, O_RDWR | O_CLOEXEC);
    while (bus->fd < 0 && sheen_again(errno, &tries));
    if (bus->fd >= 0)
        return 0;
    switch (errno) {
    case EACCES:
    case EPERM:
        return sheen_failed(bus->why, SHEEN_ERR_BUS,
                            "%s: no permission; become a member of its group (usually %s) and log in again", path,
                            group);
    case ENOENT:
        return sheen_failed(bus->why, SHEEN_ERR_ARGUMENT, "%s: no such device; switch %s", path, what);
    case EBUSY:
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: in use by another program; end that first", path);
    default:
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: %s", path, strerror(errno));
    }
}

static int open_lines(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    int error = 0;

    /* CS first, so that the panel does not take changes of the other lines for data. */
    if (wiring->cs)
        error = sheen_pin_output(&bus->cs, wiring->cs, 1, bus->why);
    if (error == 0 && wiring->dc)
        error = sheen_pin_output(&bus->dc, wiring->dc, 0, bus->why);
    if (error == 0 && wiring->reset)
        error = sheen_pin_output(&bus->reset, wiring->reset, 1, bus->why);
    if (error == 0 && wiring->te)
        error = sheen_pin_rising(&bus->te, wiring->te, bus->why);
    return error;
}

/* Opens the device, or the lines of bit-banged SPI. */
static int open_kind(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    int error;

    if (!wiring->i2c)
        return wiring->spi ? sheen_spidev_open(bus, wiring) : sheen_bitbang_open(bus, wiring);
    error = sheen_i2cdev_open(bus, wiring);
    if (error == 0)
        error = sheen_i2c_open(&bus->i2c, &bus->wire, 0);
    bus->bus = bus->i2c.layer.bus;
    return error;
}

int sheen_linux_bus_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring, struct sheen_failure *why)
{
    int error;

    *bus = (struct sheen_linux_bus){.why = why, .fd = -1, .clock_hz = wiring->clock_hz, .spi_mode = wiring->spi_mode};
    if (!wiring->i2c && !wiring->dc)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "the D/C line is not named");
    if (wiring->spi_mode > 3)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "SPI mode %u: there are 0 to 3", wiring->spi_mode);
    bus->wire = (struct sheen_bus){.ctx = bus, .send = send, .delay = delay};
    bus->wire.reset = wiring->reset ? reset : NULL;
    bus->wire.tearing = wiring->te ? tearing : NULL;
    bus->bus = bus->wire;

    error = open_lines(bus, wiring);
    if (error == 0)
        error = open_kind(bus, wiring);
    if (error < 0)
        sheen_linux_bus_close(bus);
    return error;
}

void sheen_linux_bus_close(struct sheen_linux_bus *bus)
{
    if (bus->wire.send == NULL)
        return;
    if (bus->fd >= 0)
        close(bus->fd);
    sheen_pin_close(&bus->sclk);
    sheen_pin_close(&bus->mosi);
    sheen_pin_close(&bus->dc);
    sheen_pin_close(&bus->reset);
    sheen_pin_close(&bus->te);
    sheen_pin_close(&bus->cs);
    *bus = (struct sheen_linux_bus){.fd = -1};
}
