/*
 * board.h - what a board gives to main.c: pins and clocks behind a bus, a serial line, keys, a watchdog.
 */
#ifndef BOARD_H
#define BOARD_H

#include "demo.h"
#include "sheen_panel.h"

extern const char board_name[];
extern const struct sheen_panel_record *const board_panel;
extern const struct sheen_bus board_bus;
extern uint32_t board_bus_bytes;    /* sent since the start, modulo 2^32 */
extern const uint8_t board_buffers; /* 2 where the bus sends by itself while the core draws, else 1 */

#define BOARD_WATCHDOG_US 1000000u /* without board_feed() for so long, the board restarts */

/* Clocks, serial line, watchdog; the bus at clock_hz or less. Returns 1 after a restart by the watchdog, else 0. */
int board_open(uint32_t clock_hz, unsigned spi_mode);

/* The other core, which board_open has started; NULL where there is none. */
const struct demo_crew *board_crew(void);
unsigned board_core(void); /* which one this is, 0 or 1 */

/* Another clock for the bus, from the next write on. Returns what it really is, Hz. */
uint32_t board_bus_clock(uint32_t clock_hz);

void board_feed(void);

void board_put(char c);

/* A key from the serial line or the board's own keys, as demo_key() takes them, or -1. */
int board_key(void);

#endif
