/*
 * board.c - Luminary's LM3S6965 evaluation board: OLED on SSI0, UART0, five keys, watchdog.
 */
#include "board.h"

#include "both.h"
#include "pl011.h"
#include "pl022.h"
#include "registers.h"
#include "ticks.h"

/*
 * How long to wait for room in a FIFO of 8 bytes, which take 0.64 ms at 100 kHz, 32,000 clocks. The unit is a turn of
 * the waiting loop, at least 10 clocks, because it reads two registers beyond the bus bridge. A timer would not do: in
 * an emulator it goes on while the host does something else, and would report a timeout of a bus that is not late.
 */
#define BUS_PATIENCE 50000u

const char board_name[] = "lm3s6965evb";
const struct sheen_panel_record *const board_panel = &sheen_panel_ssd0323;
const uint8_t board_buffers = 1;
uint32_t board_bus_bytes;

static uint32_t bus_hz;
static unsigned bus_mode;

/* ---- the bus ---- */

uint32_t board_bus_clock(uint32_t clock_hz)
{
    bus_hz = clock_hz;
    return pl022_open(SSI0, CLOCK_HZ, clock_hz, bus_mode);
}

/* Waits until the status bits in mask are as in value, emptying the receive FIFO. On a timeout the SSI is restarted. */
static int await(uint32_t mask, uint32_t value)
{
    for (uint32_t turns = 0; (SSI0->status & mask) != value; turns++) {
        pl022_drain(SSI0);
        if (turns == BUS_PATIENCE) {
            board_bus_clock(bus_hz);
            return SHEEN_ERR_TIMEOUT;
        }
    }
    return SHEEN_OK;
}

/* The OLED reads D/C with the last bit of each byte, so D/C must not change until all bytes before have left. */
static int put(uint32_t dc, const uint8_t *bytes, size_t count)
{
    int error = await(PL022_BUSY, 0);

    GPIO_DATA(PORT_C, PIN_DC) = dc;
    for (size_t i = 0; error == SHEEN_OK && i < count; i++) {
        error = await(PL022_ROOM | PL022_RECEIVED, PL022_ROOM);
        if (error == SHEEN_OK)
            SSI0->data = bytes[i];
    }
    return error;
}

static int bus_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    int error = commands ? put(0, command, commands) : SHEEN_OK;

    (void)ctx;
    board_bus_bytes += (uint32_t)(commands + count);
    return error < 0 || count == 0 ? error : put(PIN_DC, data, count);
}

static int bus_wait(void *ctx)
{
    (void)ctx;
    (void)ticks(); /* must be called now and then (ticks.h) */
    return await(PL022_BUSY, 0);
}

/* No reset: the board resets the OLED together with the processor, and there is no line for it. */
const struct sheen_bus board_bus = {.send = bus_send, .delay = both_delay, .wait = bus_wait};

/* ---- one core, serial line, keys, watchdog ---- */

const struct demo_crew *board_crew(void)
{
    return NULL;
}

unsigned board_core(void)
{
    return 0;
}

int board_open(uint32_t clock_hz, unsigned spi_mode)
{
    int restarted = (SYSCTL_RESC & 0x08u) != 0;

    SYSCTL_RESC = 0;
    ticks_open(CLOCK_HZ);
    pl011_open(UART0, CLOCK_HZ, 115200);
    bus_mode = spi_mode;
    board_bus_clock(clock_hz);
    WATCHDOG_LOAD = CLOCK_HZ / 1000000u * (BOARD_WATCHDOG_US / 2); /* half, because the second time-out resets */
    WATCHDOG_CTL = 3;
    return restarted;
}

void board_feed(void)
{
    WATCHDOG_ICR = 1;
}

void board_put(char c)
{
    pl011_put(UART0, c);
}

int board_key(void)
{
    int c = pl011_get(UART0);
    uint32_t up = GPIO_DATA(PORT_E, 0x0F) | GPIO_DATA(PORT_F, 2) << 3; /* up, down, left, right; select */

    return c >= 0 ? c : both_pressed((uint8_t)(~up & 0x1Fu), "sl0nh");
}
