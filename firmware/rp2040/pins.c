/*
 * pins.c - clocks and pins of a Raspberry Pi Pico with a display on SPI0, before main.
 */
#include "registers.h"
#include "start.h"

#define SRC_XOSC 2u          /* for CLK_REF_CTRL */
#define SRC_AUX 1u           /* for CLK_SYS_CTRL; aux source 0 is the PLL */
#define PERI_ENABLE 0x800u   /* for CLK_PERI_CTRL; aux source 0 is the system clock */
#define XOSC_1_15_MHZ 0xAA0u /* for XOSC_CTRL: the crystal's range, and below the code that enables the oscillator */
#define XOSC_ENABLE 0xFAB000u
#define XOSC_STABLE 0x80000000u
#define PLL_LOCK 0x80000000u
#define PLL_PD 0x01u /* bits of PLL_SYS_PWR: power down the PLL, its post dividers, its VCO */
#define PLL_POSTDIVPD 0x08u
#define PLL_VCOPD 0x20u
#define TICK_1_US (0x200u | 12u) /* the watchdog's tick: enabled, every 12 clocks of the crystal */

#define PAD_OUTPUT 0x73u /* fast, 12 mA: for SPI at 62.5 MHz over 10 cm of wire */
#define PAD_SLOW 0x56u   /* 4 mA, the reset value */
#define PAD_KEY 0x4Au    /* input, pulled up */

static void unreset(uint32_t blocks)
{
    CLEAR(RESETS) = blocks;
    while ((RESETS_DONE & blocks) != blocks)
        ;
}

/* 12 MHz crystal * 125 = 1500 MHz, / 6 / 2 = 125 MHz (2.18.2: the VCO runs at 750..1600 MHz). */
static void clock_open(void)
{
    XOSC_STARTUP = 47; /* 1 ms in units of 256 clocks (2.16.3) */
    REG(XOSC_CTRL) = XOSC_1_15_MHZ;
    SET(XOSC_CTRL) = XOSC_ENABLE;
    while (!(XOSC_STATUS & XOSC_STABLE))
        ;
    /* No clock may run on the PLL while it is set up. A SELECTED register has one bit per source. */
    CLEAR(CLK_SYS_CTRL) = SRC_AUX;
    while (CLK_SYS_SELECTED != 1u)
        ;
    REG(CLK_REF_CTRL) = SRC_XOSC;
    while (CLK_REF_SELECTED != 1u << SRC_XOSC)
        ;
    SET(RESETS) = RESET_PLL_SYS;
    unreset(RESET_PLL_SYS);
    PLL_SYS_CS = 1; /* the crystal, undivided */
    PLL_SYS_FBDIV = 125;
    CLEAR(PLL_SYS_PWR) = PLL_PD | PLL_VCOPD;
    while (!(PLL_SYS_CS & PLL_LOCK))
        ;
    PLL_SYS_PRIM = 6u << 16 | 2u << 12;
    CLEAR(PLL_SYS_PWR) = PLL_POSTDIVPD;
    REG(CLK_SYS_CTRL) = 0;
    SET(CLK_SYS_CTRL) = SRC_AUX;
    while (CLK_SYS_SELECTED != 1u << SRC_AUX)
        ;
    CLK_PERI_CTRL = PERI_ENABLE;
    WATCHDOG_TICK = TICK_1_US;
}

static void pin_open(unsigned pin, uint32_t function, uint32_t pad)
{
    PAD(pin) = pad;
    GPIO_CTRL(pin) = function;
}

void start_board(void)
{
    SET(PSM_FRCE_OFF) = PSM_PROC1; /* stop core 1, which still runs if a debugger has restarted core 0 alone */
    clock_open();
    unreset(RESET_IO_BANK0 | RESET_PADS_BANK0 | RESET_DMA | RESET_SPI0 | RESET_TIMER | RESET_UART0);
    SIO_OUT_SET = 1u << PIN_CS | 1u << PIN_RESET | 1u << PIN_DC;
    SIO_OE_SET = 1u << PIN_CS | 1u << PIN_RESET | 1u << PIN_DC | 1u << PIN_BACKLIGHT;
    pin_open(PIN_CS, FUNCTION_SIO, PAD_OUTPUT);
    pin_open(PIN_DC, FUNCTION_SIO, PAD_OUTPUT);
    pin_open(PIN_RESET, FUNCTION_SIO, PAD_SLOW);
    pin_open(PIN_BACKLIGHT, FUNCTION_SIO, PAD_SLOW);
    pin_open(PIN_SCK, FUNCTION_SPI, PAD_OUTPUT);
    pin_open(PIN_TX, FUNCTION_SPI, PAD_OUTPUT);
    pin_open(PIN_UART_TX, FUNCTION_UART, PAD_SLOW);
    pin_open(PIN_UART_RX, FUNCTION_UART, PAD_KEY);
    for (unsigned pin = PIN_KEYS; pin < PIN_KEYS + 4; pin++)
        pin_open(pin, FUNCTION_SIO, PAD_KEY);
}
