/*
 * dma.h - stands for pico-sdk's hardware/dma.h: one channel, whose bytes leave when the program waits for them.
 */
#ifndef HARDWARE_DMA_H
#define HARDWARE_DMA_H

#include "pico/stdlib.h"

typedef struct {
    uint dreq;
} dma_channel_config;

enum dma_channel_transfer_size {
    DMA_SIZE_8 = 0
};

static inline int dma_claim_unused_channel(bool required)
{
    (void)required;
    return 0;
}

static inline dma_channel_config dma_channel_get_default_config(uint channel)
{
    (void)channel;
    return (dma_channel_config){0};
}

static inline void channel_config_set_transfer_data_size(dma_channel_config *config,
                                                         enum dma_channel_transfer_size size)
{
    (void)config;
    (void)size;
}

static inline void channel_config_set_dreq(dma_channel_config *config, uint dreq)
{
    config->dreq = dreq;
}

static inline void dma_channel_configure(uint channel, const dma_channel_config *config, volatile void *to,
                                         const volatile void *from, uint count, bool trigger)
{
    (void)channel;
    (void)to;
    if (trigger && config->dreq == 16)
        wire_launch((const void *)from, count);
}

static inline void dma_channel_wait_for_finish_blocking(uint channel)
{
    (void)channel;
    wire_land();
}

#endif
