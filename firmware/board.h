/*
 * board.h - what a board provides to main.c: a panel and its bus, a serial line, keys, a watchdog.
 */
#ifndef BOARD_H
#define BOARD_H

#include "demo.h"
#include "sheen_panel.h"

extern const char board_name[];
extern const struct sheen_panel_record *const board_panel;
extern const struct sheen_bus board_bus;
extern uint32_t board_bus_bytes;    /* bytes sent since the start, modulo 2^32 */
extern const uint8_t board_buffers; /* 2 if the bus sends by DMA while sheen draws, else 1 */

#define BOARD_WATCHDOG_US 1000000u /* the board restarts after this time without board_feed() */

/* Opens timer, serial line, watchdog, and the bus at clock_hz or less. 1 after a restart by the watchdog, else 0. */
int board_open(uint32_t clock_hz, unsigned spi_mode);

/* The other core, which board_open has started; NULL if there is none. */
const struct demo_crew *board_crew(void);
unsigned board_core(void); /* the core that calls this, 0 or 1 */

/* Changes the clock of the bus, from the next write on. Returns the clock that results, Hz. */
uint32_t board_bus_clock(uint32_t clock_hz);

void board_feed(void); /* restarts the watchdog's count */

void board_put(char c); /* sends c on the serial line */

/* A key from the serial line or from the board's own keys, as a character for demo_key(); -1: none. */
int board_key(void);

#endif
