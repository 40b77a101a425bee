/*
 * linux_bus.c - what spidev and bit-bang share: D/C, chip select, reset and time.
 *
 * D/C changes only here, before the first bit of a write; the kinds' send()
 * returns when the last bit has left.
 */
#include "linux_bus.h"

#include "sheen_target.h"

#include <errno.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static int write_bytes(void *ctx, enum sheen_dc dc, const void *bytes, size_t count)
{
    struct sheen_linux_bus *bus = ctx;
    int error = sheen_pin_set(&bus->dc, dc == SHEEN_DATA, bus->why);

    if (error == 0 && sheen_pin_is_open(&bus->cs))
        error = sheen_pin_set(&bus->cs, 0, bus->why);
    if (error == 0)
        error = bus->send(bus, bytes, count);
    /* After an error too: nothing on a shared bus may go on speaking to the panel. */
    if (sheen_pin_is_open(&bus->cs)) {
        int released = sheen_pin_set(&bus->cs, 1, error ? NULL : bus->why);

        error = error ? error : released;
    }
    return error;
}

static int reset(void *ctx, int level)
{
    struct sheen_linux_bus *bus = ctx;

    return sheen_pin_set(&bus->reset, level, bus->why);
}

/* A signal shortens no delay: the end is an absolute time. */
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

static int open_lines(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    int error = 0;

    /* CS first: from here on the panel hears nothing by mistake. */
    if (wiring->cs)
        error = sheen_pin_output(&bus->cs, wiring->cs, 1, bus->why);
    if (error == 0)
        error = sheen_pin_output(&bus->dc, wiring->dc, 0, bus->why);
    if (error == 0 && wiring->reset)
        error = sheen_pin_output(&bus->reset, wiring->reset, 1, bus->why);
    return error;
}

int sheen_linux_bus_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring, struct sheen_failure *why)
{
    int error;

    *bus = (struct sheen_linux_bus){.why = why, .fd = -1, .clock_hz = wiring->clock_hz, .spi_mode = wiring->spi_mode};
    if (!wiring->dc)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "the D/C line is not named");
    if (wiring->spi_mode > 3)
        return sheen_failed(why, SHEEN_ERR_ARGUMENT, "SPI mode %u: there are 0 to 3", wiring->spi_mode);
    bus->bus = (struct sheen_bus){.ctx = bus, .write = write_bytes, .delay = delay};
    bus->bus.reset = wiring->reset ? reset : NULL;

    error = open_lines(bus, wiring);
    if (error == 0)
        error = wiring->spi ? sheen_spidev_open(bus, wiring) : sheen_bitbang_open(bus, wiring);
    if (error < 0)
        sheen_linux_bus_close(bus);
    return error;
}

void sheen_linux_bus_close(struct sheen_linux_bus *bus)
{
    if (bus->bus.write == NULL)
        return;
    if (bus->fd >= 0)
        close(bus->fd);
    sheen_pin_close(&bus->sclk);
    sheen_pin_close(&bus->mosi);
    sheen_pin_close(&bus->dc);
    sheen_pin_close(&bus->reset);
    sheen_pin_close(&bus->cs);
    *bus = (struct sheen_linux_bus){.fd = -1};
}
