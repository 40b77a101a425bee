/*
 * pins.c - clocks, pins and SPI of the LM3S6965EVB, before main.
 */
#include "pl022.h"
#include "registers.h"
#include "start.h"

#define OLED_HZ 4000000u /* SSD0323 data sheet: a clock cycle of 250 ns */

/* RCC (data sheet, register 8): 8 MHz crystal, main oscillator, PLL 400 MHz / 2 / 4 = 50 MHz. */
#define RCC_BYPASS 0x00000800u
#define RCC_PWRDN 0x00002000u
#define RCC_USESYSDIV 0x00400000u
#define RCC_SYSDIV_4 0x01800000u
#define RCC_XTAL_8MHZ 0x00000380u

static void clock_open(void)
{
    uint32_t rcc = RCC_USESYSDIV | RCC_SYSDIV_4 | RCC_XTAL_8MHZ | RCC_BYPASS | RCC_PWRDN;

    SYSCTL_RCC = rcc; /* run on the crystal; then power up the PLL, wait for its lock, and switch to it */
    rcc &= ~RCC_PWRDN;
    SYSCTL_RCC = rcc;
    while (!(SYSCTL_RIS & 0x40u))
        ;
    SYSCTL_RCC = rcc & ~RCC_BYPASS;
}

void start_board(void)
{
    clock_open();
    SYSCTL_RCGC0 |= 0x08u;
    SYSCTL_RCGC1 |= 0x11u;
    SYSCTL_RCGC2 |= 0x3Du;
    (void)SYSCTL_RCGC2; /* a clock gate needs three clocks to open (data sheet, 5.1.5) */
    (void)SYSCTL_RCGC2;

    GPIO_AFSEL(PORT_A) = GPIO_DEN(PORT_A) = 0x3Fu; /* UART0: 0, 1; SSI0: clock 2, select 3, in 4, out 5 */
    GPIO_DIR(PORT_C) |= PIN_DC;                    /* |=, because pins 0..3 are the debugger's */
    GPIO_DEN(PORT_C) |= PIN_DC;
    GPIO_DIR(PORT_D) = GPIO_DEN(PORT_D) = PIN_SELECT;
    GPIO_DATA(PORT_D, PIN_SELECT) = PIN_SELECT;
    GPIO_DEN(PORT_E) = GPIO_PUR(PORT_E) = 0x0Fu; /* keys, low when pressed */
    GPIO_DEN(PORT_F) = GPIO_PUR(PORT_F) = 0x02u;
    pl022_open(SSI0, CLOCK_HZ, OLED_HZ, 0);
}
