/*
 * pl011.h - Arm's PL011 UART, which both boards have (TRM DDI 0183, chapter 3): 8 bits, no parity, 1 stop bit.
 */
#ifndef PL011_H
#define PL011_H

#include <stdint.h>

struct pl011 {
    volatile uint32_t data, receive_status, unused[4], flags, unused_too, low_power, divide, divide_fraction, line,
        control;
};

/* input_hz: the clock of the UART block. */
void pl011_open(struct pl011 *uart, uint32_t input_hz, uint32_t baud);

void pl011_put(struct pl011 *uart, char c);

/* The next character received, or -1. */
int pl011_get(struct pl011 *uart);

#endif
