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

#define PL022_ROOM 0x02u     /* status: the transmit FIFO has room */
#define PL022_RECEIVED 0x04u /* status: the receive FIFO is not empty */
#define PL022_BUSY 0x10u     /* status: a byte is being sent or waits to be sent */
#define PL022_DMA_TX 2u

/*
 * Sets the SPI up as master for bytes, high bit first. input_hz: the clock of the SPI
 * block; clock_hz: the highest clock allowed; mode: 0..3. Returns the clock that
 * results, >= input_hz / 65024.
 */
uint32_t pl022_open(struct pl022 *spi, uint32_t input_hz, uint32_t clock_hz, unsigned mode);

/* Empties the receive FIFO; what a panel sends is ignored. */
static inline void pl022_drain(struct pl022 *spi)
{
    while (spi->status & PL022_RECEIVED)
        (void)spi->data;
}

#endif
