/*
 * bus_spidev.c - SPI through /dev/spidevB.C.
 *
 * spidev copies each transfer into a buffer of its own (4096 bytes unless a module
 * parameter says otherwise) and refuses longer ones with EMSGSIZE, so bytes are sent
 * in chunks of that size. Chip select rises between chunks, and between a command and
 * its data, which panels accept (ST7789V data sheet, "data transfer pause"); it is how
 * the kernel's own display drivers send. cs_change on a message's last transfer would
 * keep it low, but the kernel does not raise it before it sends another device's
 * message (spi.c, spi_set_cs): the panel would take a touch controller's bytes for its
 * own.
 */
#include "sheen_linux_bus.h"

#include "sheen_target.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <stdio.h>
#include <string.h>

#define BUFSIZ_PATH "/sys/module/spidev/parameters/bufsiz"
#define BUFSIZ_DEFAULT 4096u /* B; spidev.c */
#define CHUNK_MAX 65536u     /* B; longer chunks gain nothing, and the DMA of some controllers ends here */

/* The size of spidev's buffer; the default if the parameter cannot be read, as may be if spidev is not a module. */
static size_t chunk_size(void)
{
    FILE *file = fopen(BUFSIZ_PATH, "re");
    unsigned size = 0;

    if (!file)
        return BUFSIZ_DEFAULT;
    if (fscanf(file, "%u", &size) != 1 || size == 0)
        size = BUFSIZ_DEFAULT;
    fclose(file);
    return size < CHUNK_MAX ? size : CHUNK_MAX;
}

static int transfer_fail(struct sheen_linux_bus *bus, int error)
{
    if (error == EMSGSIZE)
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: a transfer of %zu bytes is too long; see " BUFSIZ_PATH,
                            bus->path, bus->chunk);
    return sheen_failed(bus->why, error == ETIMEDOUT ? SHEEN_ERR_TIMEOUT : SHEEN_ERR_BUS, "%s: %s", bus->path,
                        strerror(error));
}

/* A short transfer continues where it stopped; SHEEN_TRIES transfers in a row that send nothing are an error. */
static int put(struct sheen_linux_bus *bus, const uint8_t *bytes, size_t count)
{
    int idle = 0;

    while (count > 0) {
        size_t chunk = count < bus->chunk ? count : bus->chunk;
        struct spi_ioc_transfer transfer = {
            .tx_buf = (uintptr_t)bytes, .len = (uint32_t)chunk, .speed_hz = bus->clock_hz, .bits_per_word = 8};
        int sent = sheen_ioctl_again(bus->fd, SPI_IOC_MESSAGE(1), &transfer);

        if (sent < 0)
            return transfer_fail(bus, errno);
        idle = sent > 0 ? 0 : idle + 1;
        if (idle == SHEEN_TRIES || (size_t)sent > chunk)
            return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: sent %d of %zu bytes", bus->path, sent, chunk);
        bytes += sent;
        count -= (size_t)sent;
    }
    return 0;
}

/* Sets mode, word size and clock. own_cs: a GPIO line selects the panel, so the controller's CS should not move. */
static int set_up(struct sheen_linux_bus *bus, int own_cs)
{
    uint8_t mode = bus->spi_mode, quiet = (uint8_t)(mode | SPI_NO_CS), bits = 8;
    int result = sheen_ioctl_again(bus->fd, SPI_IOC_WR_MODE, own_cs ? &quiet : &mode);

    /* A controller that cannot keep its CS still refuses; then that CS moves on a pin that is not wired. */
    if (result < 0 && own_cs && errno == EINVAL)
        result = sheen_ioctl_again(bus->fd, SPI_IOC_WR_MODE, &mode);
    if (result < 0 && (errno == ENOTTY || errno == ENODEV))
        return sheen_failed(bus->why, SHEEN_ERR_ARGUMENT, "%s is not an SPI device (/dev/spidev0.0 is one)", bus->path);
    if (result < 0)
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: SPI mode %u: %s", bus->path, mode, strerror(errno));
    if (sheen_ioctl_again(bus->fd, SPI_IOC_WR_BITS_PER_WORD, &bits) < 0)
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: words of 8 bits: %s", bus->path, strerror(errno));
    if (sheen_ioctl_again(bus->fd, SPI_IOC_WR_MAX_SPEED_HZ, &bus->clock_hz) < 0)
        return sheen_failed(bus->why, SHEEN_ERR_BUS, "%s: a clock of %u Hz: %s", bus->path, bus->clock_hz,
                            strerror(errno));
    return 0;
}

int sheen_spidev_open(struct sheen_linux_bus *bus, const struct sheen_wiring *wiring)
{
    int error = sheen_device_open(bus, wiring->spi, "spi",
                                  "SPI on (Raspberry Pi: dtparam=spi=on in config.txt, restart), or name lines for "
                                  "SCLK and MOSI instead");

    if (error < 0)
        return error;
    bus->put = put;
    bus->chunk = chunk_size();
    return set_up(bus, wiring->cs != NULL);
}
