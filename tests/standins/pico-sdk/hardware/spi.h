/*
 * spi.h - stands for pico-sdk's hardware/spi.h.
 */
#ifndef HARDWARE_SPI_H
#define HARDWARE_SPI_H

#include "pico/stdlib.h"

typedef struct {
    volatile uint32_t dr;
} spi_hw_t;
typedef struct spi_inst spi_inst_t;

#define spi0 ((spi_inst_t *)0)

static inline uint spi_init(spi_inst_t *spi, uint baudrate)
{
    (void)spi;
    return baudrate;
}

static inline int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t count)
{
    (void)spi;
    wire_bytes(bytes, count);
    return (int)count;
}

static inline uint spi_get_dreq(spi_inst_t *spi, bool transmit)
{
    (void)spi;
    return transmit ? 16 : 17;
}

static inline spi_hw_t *spi_get_hw(spi_inst_t *spi)
{
    static spi_hw_t hardware;

    (void)spi;
    return &hardware;
}

static inline bool spi_is_busy(const spi_inst_t *spi)
{
    (void)spi;
    return false;
}

#endif
