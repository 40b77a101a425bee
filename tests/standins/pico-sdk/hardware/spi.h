/*
 * spi.h - stands for pico-sdk's hardware/spi.h.
 */
#ifndef HARDWARE_SPI_H
#define HARDWARE_SPI_H

#include <assert.h>

#include "pico/stdlib.h"

typedef struct {
    volatile uint32_t dr;
} spi_hw_t;
typedef struct spi_inst spi_inst_t;

#define spi0 ((spi_inst_t *)0)

typedef enum {
    SPI_CPHA_0,
    SPI_CPHA_1
} spi_cpha_t;
typedef enum {
    SPI_CPOL_0,
    SPI_CPOL_1
} spi_cpol_t;
typedef enum {
    SPI_LSB_FIRST,
    SPI_MSB_FIRST
} spi_order_t;

static unsigned standin_mode; /* the SPI mode; 0 after spi_init() */

static inline uint spi_init(spi_inst_t *spi, uint baudrate)
{
    (void)spi;
    standin_mode = 0;
    return baudrate;
}

static inline void spi_set_format(spi_inst_t *spi, uint bits, spi_cpol_t cpol, spi_cpha_t cpha, spi_order_t order)
{
    (void)spi;
    assert(bits == 8 && order == SPI_MSB_FIRST);
    standin_mode = 2u * cpol + cpha;
}

static inline int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t count)
{
    (void)spi;
    assert(standin_mode == 3); /* required by the display, which has no CS */
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
