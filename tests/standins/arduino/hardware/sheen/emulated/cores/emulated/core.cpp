/*
 * core.cpp - stands for an Arduino core: start-up, pins, time, the serial line.
 */
#include "Arduino.h"

SerialPort Serial;

#define BIT(n) (1u << (n))

#ifdef ARDUINO_RP2040
#define SIO 0xD0000000u
#define IO_BANK0 0x40014000u
#define CLOCKS_PER_US 125

static void board_begin()
{
    REGISTER(BOARD_UART + 0x30) = 0x301; /* the UART sends */
}

void pinMode(int pin, int)
{
    REGISTER(IO_BANK0 + 8u * (uint32_t)pin + 4) = 5; /* the pin belongs to SIO */
    REGISTER(SIO + 0x24) = BIT(pin);
}

void digitalWrite(int pin, int level)
{
    REGISTER(SIO + (level ? 0x14u : 0x18u)) = BIT(pin);
}
#else
#define PORT_A 0x40004000u
#define PORT_C 0x40006000u
#define PORT_D 0x40007000u
#define CLOCKS_PER_US 50

static void board_begin()
{
    REGISTER(0x400FE104u) = 0x11; /* clocks of SSI0 and UART0, of ports A, C, D */
    REGISTER(0x400FE108u) = 0x0D;
    (void)REGISTER(0x400FE108u);
    REGISTER(PORT_A + 0x420) |= 0x3C; /* PA2..PA5 are SSI0's */
    REGISTER(PORT_A + 0x51C) |= 0x3C;
    REGISTER(PORT_C + 0x51C) |= 0x80; /* PC7: D/C */
    REGISTER(PORT_C + 0x400) |= 0x80;
    REGISTER(PORT_D + 0x400) |= 1; /* PD0 high selects the OLED */
    REGISTER(PORT_D + 0x51C) |= 1;
    REGISTER(PORT_D + 4) = 1;
}

void pinMode(int, int)
{
}

/* Only pin 9 is wired. It changes once the last bit has left. */
void digitalWrite(int pin, int level)
{
    if (pin != 9)
        return;
    while (REGISTER(BOARD_SPI + 0xC) & 0x10)
        ;
    REGISTER(PORT_C + (0x80u << 2)) = level ? 0x80 : 0;
}
#endif

void delayMicroseconds(unsigned us)
{
    for (volatile unsigned turns = us * (CLOCKS_PER_US / 5); turns; turns = turns - 1)
        ;
}

void delay(unsigned long ms)
{
    for (; ms; ms--)
        delayMicroseconds(1000);
}

void SerialPort::println(const char *line)
{
    while (*line)
        REGISTER(BOARD_UART) = (uint8_t)*line++;
    REGISTER(BOARD_UART) = '\n';
#ifndef ARDUINO_RP2040
    delay(300); /* QEMU's screen is read while the machine runs, so each whole picture is shown for a while */
#endif
}

extern "C" {
extern uint32_t board_data[], board_data_end[], board_load[], board_bss[], board_bss_end[], board_stack[];

void board_start(void)
{
    for (uint32_t *to = board_data, *from = board_load; to < board_data_end;)
        *to++ = *from++;
    for (uint32_t *to = board_bss; to < board_bss_end;)
        *to++ = 0;
    typedef void (*constructor)();
    extern constructor board_init[], board_init_end[];
    for (constructor *call = board_init; call < board_init_end; call++)
        (*call)();
    board_begin();
    setup();
    for (;;)
        loop();
}

__attribute__((section(".vectors"), used)) const void *const vectors[16] = {board_stack, (void *)board_start};
}
