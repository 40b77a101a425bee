/*
 * pl022.h - Arm's PL022 SPI, which both boards have (TRM DDI 0194, chapter 3).
 */
#ifndef PL022_H
#define PL022_H

#include <stdint.h>

struct pl022 {
    volatile uint32_t control0, control1, data, status, prescale, interrupt_mask, raw_interrupts, interrupts,
        interrupt_clear, dma;
};

#define PL022_ROOM 0x02u     /* status: the transmit FIFO takes another */
#define PL022_RECEIVED 0x04u /* something lies in the receive FIFO */
#define PL022_BUSY 0x10u     /* a byte is leaving, or waits to */
#define PL022_DMA_TX 2u

/*
 * Bytes, high bit first, as master. mode: 0..3, clock_hz: not to be exceeded,
 * input_hz: the block's own. Returns the clock that results, >= input_hz / 65024.
 */
uint32_t pl022_open(struct pl022 *spi, uint32_t input_hz, uint32_t clock_hz, unsigned mode);

/* Empties the receive FIFO: nothing that a panel says is listened to. */
static inline void pl022_drain(struct pl022 *spi)
{
    while (spi->status & PL022_RECEIVED)
        (void)spi->data;
}

#endif
