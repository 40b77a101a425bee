/*
 * Arduino.h - stands for an Arduino core on a computer: pins, time, a serial line. D/C is pin 9, reset pin 8.
 */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#include "wire.h"

enum {
    LOW,
    HIGH,
    INPUT = 0,
    OUTPUT = 1
};

inline void pinMode(int, int)
{
}

inline void digitalWrite(int pin, int level)
{
    if (pin == 9)
        wire_level = level;
    else if (pin == 8)
        wire_number('R', (uint32_t)level);
}

inline void delayMicroseconds(unsigned us)
{
    if (us)
        wire_number('T', us);
}

inline void delay(unsigned long ms)
{
    if (ms)
        wire_number('T', (uint32_t)ms * 1000u);
}

struct SerialPort {
    void begin(unsigned long)
    {
    }
    void println(const char *line)
    {
        fprintf(stderr, "%s\n", line);
    }
};
extern SerialPort Serial;

void setup();
void loop();

#endif
