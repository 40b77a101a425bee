/*
 * pl022.c - opening the SPI: frame, mode, clock.
 */
#include "pl022.h"

#define CONTROL0_BYTES 7u /* 8 bits per frame, Motorola SPI */
#define CONTROL0_SPO 0x40u
#define CONTROL0_SPH 0x80u
#define CONTROL1_ENABLE 2u

/*
 * clock = input / (prescale * (1 + rate)), prescale even, 2..254, rate 0..255
 * (SSPCPSR and SSPCR0.SCR). The smallest prescale that can divide down far enough
 * gives the finest steps.
 */
uint32_t pl022_open(struct pl022 *spi, uint32_t input_hz, uint32_t clock_hz, unsigned mode)
{
    uint32_t divide = (input_hz + clock_hz - 1) / clock_hz, prescale = 2, rate;

    while (prescale < 254 && divide > prescale * 256)
        prescale += 2;
    rate = (divide + prescale - 1) / prescale - 1;
    if (rate > 255)
        rate = 255;
    spi->control1 = 0;
    spi->prescale = prescale;
    spi->control0 = rate << 8 | (mode & 1 ? CONTROL0_SPH : 0) | (mode & 2 ? CONTROL0_SPO : 0) | CONTROL0_BYTES;
    spi->control1 = CONTROL1_ENABLE;
    pl022_drain(spi);
    return input_hz / (prescale * (rate + 1));
}
