/*
 * registers.h - the registers of the LM3S6965 that are used (data sheet, chapters 5 system control, 8 GPIO, 10
 * watchdog).
 */
#ifndef REGISTERS_H
#define REGISTERS_H

#include <stdint.h>

#define REG(address) (*(volatile uint32_t *)(address))

#define SYSCTL_RIS REG(0x400FE050u)  /* bit 6: the PLL has locked */
#define SYSCTL_RESC REG(0x400FE05Cu) /* cause of the last reset: bit 3, watchdog */
#define SYSCTL_RCC REG(0x400FE060u)
#define SYSCTL_RCGC0 REG(0x400FE100u) /* clock gates: bit 3 watchdog */
#define SYSCTL_RCGC1 REG(0x400FE104u) /* bit 0 UART0, bit 4 SSI0 */
#define SYSCTL_RCGC2 REG(0x400FE108u) /* from bit 0: ports A, B, C ... */

#define WATCHDOG_LOAD REG(0x40000000u)
#define WATCHDOG_CTL REG(0x40000008u) /* bit 0: count, bit 1: the second time-out resets */
#define WATCHDOG_ICR REG(0x4000000Cu) /* any write restarts the count */

/* Bits in the address of a port's data register select the pins that an access reads or writes. */
#define PORT_A 0x40004000u
#define PORT_C 0x40006000u
#define PORT_D 0x40007000u
#define PORT_E 0x40024000u
#define PORT_F 0x40025000u
#define GPIO_DATA(port, pins) REG((port) + ((uint32_t)(pins) << 2))
#define GPIO_DIR(port) REG((port) + 0x400u)
#define GPIO_AFSEL(port) REG((port) + 0x420u)
#define GPIO_PUR(port) REG((port) + 0x510u)
#define GPIO_DEN(port) REG((port) + 0x51Cu)

#define SSI0 ((struct pl022 *)0x40008000u)
#define UART0 ((struct pl011 *)0x4000C000u)

#define PIN_DC 0x80u     /* port C: high for data */
#define PIN_SELECT 0x01u /* port D: low selects the SD card, high the OLED */

#define CLOCK_HZ 50000000u

#endif
