/*
 * board.c - Raspberry Pi Pico: a display on SPI0 fed by DMA, UART0, four keys, watchdog.
 */
#include "board.h"

#include "both.h"
#include "cores.h"
#include "pl011.h"
#include "pl022.h"
#include "registers.h"
#include "ticks.h"

/* DMA channel 0: bytes from memory to SPI0, whenever its FIFO asks for one (TREQ 16); not chained to a channel. */
#define DMA_SPI0_BYTES (16u << 15 | 1u << 4 | 1u)
#define DMA_BUSY (1u << 24)
#define BUS_SLACK_US 1000u /* added to twice the time that the bytes need */
#define WATCHDOG_ENABLE (1u << 30)
#define WATCHDOG_RESETS 0x1FFFCu  /* all blocks except the two oscillators */
#define WATCHDOG_OURS 0x73686565u /* marks our restarts: the boot ROM too restarts by the watchdog, after a UF2 */

const char board_name[] = "rp2040";
const struct sheen_panel_record *const board_panel = &BOARD_PANEL;
const uint8_t board_buffers = 2;
uint32_t board_bus_bytes;

static struct {
    uint32_t hz, clocks_a_byte; /* bus clock asked for; processor clocks per byte at the clock that resulted */
    uint32_t since, patience;   /* start of the call under way and its time limit, clocks */
    unsigned mode;
} bus;

/* ---- the bus ---- */

uint32_t board_bus_clock(uint32_t clock_hz)
{
    uint32_t hz = pl022_open(SPI0, CLOCK_HZ, clock_hz, bus.mode);

    SPI0->dma = PL022_DMA_TX;
    bus.hz = clock_hz;
    bus.clocks_a_byte = CLOCK_HZ / hz * 8u;
    return hz;
}

/* Whether the call under way has exceeded its time limit. */
static int late(void)
{
    return ticks() - bus.since > bus.patience;
}

/* Stops the DMA channel and resets the SPI, so that both are as after power-on. */
static void bus_restart(void)
{
    DMA_ABORT = 1;
    while (DMA_TRIGGER & DMA_BUSY)
        ;
    SET(RESETS) = RESET_SPI0;
    CLEAR(RESETS) = RESET_SPI0;
    while (!(RESETS_DONE & RESET_SPI0))
        ;
    board_bus_clock(bus.hz);
}

/* Drops the call under way and deselects the panel. */
static int bus_give_up(void)
{
    bus_restart();
    SIO_OUT_SET = 1u << PIN_CS;
    return SHEEN_ERR_TIMEOUT;
}

/* Waits until the last bit has left, because the panel reads D/C with the last bit of each byte. */
static int bus_idle(void)
{
    while (DMA_TRIGGER & DMA_BUSY || SPI0->status & PL022_BUSY)
        if (late())
            return bus_give_up();
    return SHEEN_OK;
}

/*
 * The DMA channel reads memory without the compiler's knowledge. The compiler must finish all
 * writes before the transfer starts and begin no others until it has ended. The processor
 * itself writes in order.
 */
static inline void memory_barrier(void)
{
    __asm volatile("" ::: "memory");
}

static void dma_start(const void *bytes, size_t count)
{
    memory_barrier();
    DMA_READ = (uint32_t)(uintptr_t)bytes;
    DMA_WRITE = (uint32_t)(uintptr_t)&SPI0->data;
    DMA_COUNT = (uint32_t)count;
    DMA_TRIGGER = DMA_SPI0_BYTES;
}

/* The processor sends the command, DMA the data. */
static int bus_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    int error = SHEEN_OK;

    (void)ctx;
    bus.since = ticks();
    bus.patience = 2u * bus.clocks_a_byte * (uint32_t)(commands + count) + ticks_of_us(BUS_SLACK_US);
    board_bus_bytes += (uint32_t)(commands + count);
    SIO_OUT_CLEAR = 1u << PIN_DC;
    SIO_OUT_CLEAR = 1u << PIN_CS;
    for (; commands; commands--) {
        while (!(SPI0->status & PL022_ROOM))
            if (late())
                return bus_give_up();
        SPI0->data = *command++;
    }
    if (count) {
        error = bus_idle();
        SIO_OUT_SET = 1u << PIN_DC;
    }
    if (count && error == SHEEN_OK)
        dma_start(data, count);
    return error;
}

static int bus_wait(void *ctx)
{
    int error = bus_idle();

    (void)ctx;
    memory_barrier();
    SIO_OUT_SET = 1u << PIN_CS;
    return error;
}

static int bus_reset(void *ctx, int level)
{
    (void)ctx;
    if (level)
        SIO_OUT_SET = 1u << PIN_RESET;
    else
        SIO_OUT_CLEAR = 1u << PIN_RESET;
    return SHEEN_OK;
}

const struct sheen_bus board_bus = {.send = bus_send, .delay = both_delay, .wait = bus_wait, .reset = bus_reset};

/* ---- serial line, keys, watchdog ---- */

int board_open(uint32_t clock_hz, unsigned spi_mode)
{
    int restarted = (WATCHDOG_REASON & 1u) != 0 && WATCHDOG_SCRATCH0 == WATCHDOG_OURS;

    ticks_open(CLOCK_HZ);
    pl011_open(UART0, CLOCK_HZ, 115200);
    bus.mode = spi_mode;
    board_bus_clock(clock_hz);
    SIO_OUT_SET = 1u << PIN_BACKLIGHT;
    PSM_WDSEL = WATCHDOG_RESETS;
    board_feed();
    WATCHDOG_SCRATCH0 = WATCHDOG_OURS;
    SET(WATCHDOG_CTRL) = WATCHDOG_ENABLE;
    if (BOARD_CORES == 2)
        cores_open();
    return restarted;
}

void board_feed(void)
{
    WATCHDOG_LOAD = 2u * BOARD_WATCHDOG_US;
}

void board_put(char c)
{
    pl011_put(UART0, c);
}

int board_key(void)
{
    int c = pl011_get(UART0);

    return c >= 0 ? c : both_pressed((uint8_t)(~SIO_IN >> PIN_KEYS & 15u), "slnh");
}
