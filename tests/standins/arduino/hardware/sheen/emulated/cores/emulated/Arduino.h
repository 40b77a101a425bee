/*
 * Arduino.h - stands for an Arduino core on the two boards that have emulators. Pin 9 is the LM3S6965EVB's D/C.
 */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define REGISTER(address) (*(volatile uint32_t *)(address))
#ifdef ARDUINO_RP2040
#define BOARD_SPI 0x4003C000u
#define BOARD_UART 0x40034000u
#else
#define BOARD_SPI 0x40008000u
#define BOARD_UART 0x4000C000u
#endif

enum {
    LOW,
    HIGH,
    INPUT = 0,
    OUTPUT = 1
};

void pinMode(int pin, int mode);
void digitalWrite(int pin, int level);
void delay(unsigned long ms);
void delayMicroseconds(unsigned us);

struct SerialPort {
    void begin(unsigned long)
    {
    }
    void println(const char *line);
};
extern SerialPort Serial;

void setup();
void loop();

#endif
