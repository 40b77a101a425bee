/*
 * bus_bitbang.c - SPI on GPIO lines, for boards without spidev: one ioctl per change of a line.
 *
 *   mode 0   MOSI ==<  b7  ><  b6  >      a bit is set before its clock's first edge;
 *            SCLK ____/--\____/--\__      the panel reads it at that edge (CPHA 0)
 *
 *   mode 3   SCLK ---\___/---\___/--      a bit is set after its clock's first edge;
 *            MOSI ====<  b7  ><  b6       the panel reads it at the second (CPHA 1)
 *
 * The kernel needs about a microsecond per change, more than the set-up and hold
 * times of any panel (ST7789V data sheet, table 6: 10 ns each), so no delays are
 * needed.
 */
#include "sheen_linux_bus.h"

#include "sheen_target.h"

static int send_bit(struct sheen_linux_bus *bus, int bit)
{
    int idle = bus->spi_mode >> 1, late = bus->spi_mode & 1; /* CPOL, CPHA */
    int error = late ? 0 : sheen_pin_set(&bus->mosi, bit, bus->why);

    if (error == 0)
        error = sheen_pin_set(&bus->sclk, !idle, bus->why);
    if (error == 0 && late)
        error = sheen_pin_set(&bus->mosi, bit, bus->why);
    return error < 0 ? error : sheen_pin_set(&bus->sclk, idle, bus->why);
}

static int put(struct sheen_linux_bus *bus, const uint8_t *bytes, size_t count)
{
    int error = 0;

    for (size_t i = 0; i < count && error == 0; i++)
        for (unsigned mask = 0x80; mask && error == 0; mask >>= 1)
            error = send_bit(bus, (bytes[i] & mask) != 0);
    return error;
}

int sheen_bitbang_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    int error;

    if (!wiring->sclk || !wiring->mosi)
        return sheen_failed(bus->why, SHEEN_ERR_ARGUMENT,
                            "neither an SPI device nor lines for SCLK and MOSI are named");
    error = sheen_pin_output(&bus->sclk, wiring->sclk, bus->spi_mode >> 1, bus->why);
    if (error == 0)
        error = sheen_pin_output(&bus->mosi, wiring->mosi, 0, bus->why);
    bus->put = put;
    return error;
}
