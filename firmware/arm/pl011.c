/*
 * pl011.c - a UART, polled.
 */
#include "pl011.h"

#define FLAG_NONE_RECEIVED 0x10u
#define FLAG_FULL 0x20u
#define LINE_8_BITS_FIFO 0x70u
#define CONTROL_ON 0x301u /* UARTEN, TXE, RXE */

/* The divisor is input_hz / (16 baud), rounded to 1/64 (TRM 3.3.6). */
void pl011_open(struct pl011 *uart, uint32_t input_hz, uint32_t baud)
{
    uint32_t divide_64ths = (input_hz * 4u + baud / 2u) / baud;

    uart->control = 0;
    uart->divide = divide_64ths / 64u;
    uart->divide_fraction = divide_64ths % 64u;
    uart->line = LINE_8_BITS_FIFO; /* this write makes the UART use the new divisor */
    uart->control = CONTROL_ON;
}

void pl011_put(struct pl011 *uart, char c)
{
    while (uart->flags & FLAG_FULL)
        ;
    uart->data = (uint8_t)c;
}

int pl011_get(struct pl011 *uart)
{
    return uart->flags & FLAG_NONE_RECEIVED ? -1 : (int)(uart->data & 0xFFu);
}
