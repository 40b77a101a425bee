/*
 * spi_master.h - stands for ESP-IDF's SPI bus.
 */
#ifndef SPI_MASTER_H
#define SPI_MASTER_H

#include <stdlib.h>

typedef struct {
    int mosi_io_num, miso_io_num, sclk_io_num, quadwp_io_num, quadhd_io_num, max_transfer_sz;
} spi_bus_config_t;
typedef enum {
    SPI2_HOST = 1
} spi_host_device_t;
#define SPI_DMA_CH_AUTO 3

static inline int spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t *wires, int dma)
{
    (void)host;
    (void)dma;
    return wires->max_transfer_sz > 0 ? 0 : 1;
}

#define ESP_ERROR_CHECK(code) ((code) == 0 ? (void)0 : abort())

#endif
