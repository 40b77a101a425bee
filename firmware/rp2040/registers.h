/*
 * registers.h - the registers of the RP2040 that are used (data sheet, chapters 2 and 4).
 */
#ifndef REGISTERS_H
#define REGISTERS_H

#include <stdint.h>

#define REG(address) (*(volatile uint32_t *)(address))

/* Writes to these aliases set or clear bits of the register (2.1.2). */
#define SET(address) REG((address) + 0x2000u)
#define CLEAR(address) REG((address) + 0x3000u)

#define RESETS 0x4000C000u /* 2.14.3: one bit per block; RESET_DONE is at + 8 */
#define RESETS_DONE REG(RESETS + 8u)
#define RESET_DMA (1u << 2)
#define RESET_IO_BANK0 (1u << 5)
#define RESET_PADS_BANK0 (1u << 8)
#define RESET_PLL_SYS (1u << 12)
#define RESET_SPI0 (1u << 16)
#define RESET_TIMER (1u << 21)
#define RESET_UART0 (1u << 22)

#define XOSC_CTRL 0x40024000u /* 2.16.7 */
#define XOSC_STATUS REG(0x40024004u)
#define XOSC_STARTUP REG(0x4002400Cu)

#define CLK_REF_CTRL 0x40008030u /* 2.15.7 */
#define CLK_REF_SELECTED REG(0x40008038u)
#define CLK_SYS_CTRL 0x4000803Cu
#define CLK_SYS_SELECTED REG(0x40008044u)
#define CLK_PERI_CTRL REG(0x40008048u)

#define PLL_SYS_CS REG(0x40028000u) /* 2.18.4 */
#define PLL_SYS_PWR 0x40028004u
#define PLL_SYS_FBDIV REG(0x40028008u)
#define PLL_SYS_PRIM REG(0x4002800Cu)

#define PSM_FRCE_OFF 0x40010004u /* 2.13.5 */
#define PSM_PROC1 (1u << 16)
#define PSM_WDSEL REG(0x40010008u)
#define TIMER_RAW_LOW REG(0x40054028u) /* 4.6.5: counts microseconds, with the watchdog's tick */
#define WATCHDOG_CTRL 0x40058000u      /* 4.7.6 */
#define WATCHDOG_LOAD REG(0x40058004u) /* counts down by 2 per tick (erratum RP2040-E1) */
#define WATCHDOG_REASON REG(0x40058008u)
#define WATCHDOG_SCRATCH0 REG(0x4005800Cu) /* 0 after power-on; survives a restart by the watchdog */
#define WATCHDOG_TICK REG(0x4005802Cu)

#define GPIO_CTRL(pin) REG(0x40014004u + 8u * (pin)) /* 2.19.6 */
#define PAD(pin) REG(0x4001C004u + 4u * (pin))
#define FUNCTION_SPI 1u
#define FUNCTION_UART 2u
#define FUNCTION_SIO 5u

#define SIO_CPUID REG(0xD0000000u) /* 2.3.1.7: the number of the core that reads it */
#define SIO_IN REG(0xD0000004u)
#define SIO_OUT_SET REG(0xD0000014u)
#define SIO_OUT_CLEAR REG(0xD0000018u)
#define SIO_OE_SET REG(0xD0000024u)
#define SIO_FIFO_STATUS REG(0xD0000050u) /* each core has its own */
#define SIO_FIFO_WRITE REG(0xD0000054u)
#define SIO_FIFO_READ REG(0xD0000058u)
#define SIO_LOCK REG(0xD0000100u) /* spinlock 0: a read that is not 0 has taken the lock; any write releases it */

#define DMA_READ REG(0x50000000u) /* channel 0, 2.5.7 */
#define DMA_WRITE REG(0x50000004u)
#define DMA_COUNT REG(0x50000008u)
#define DMA_TRIGGER REG(0x5000000Cu)
#define DMA_ABORT REG(0x50000444u)

#define SPI0 ((struct pl022 *)0x4003C000u)
#define UART0 ((struct pl011 *)0x40034000u)

#define CLOCK_HZ 125000000u

/* Pin numbers, as on the usual display packs for the Pico. */
#define PIN_UART_TX 0u
#define PIN_UART_RX 1u
#define PIN_KEYS 12u /* four of them, 12..15, to ground */
#define PIN_DC 16u
#define PIN_CS 17u
#define PIN_SCK 18u
#define PIN_TX 19u
#define PIN_BACKLIGHT 20u
#define PIN_RESET 21u

#endif
