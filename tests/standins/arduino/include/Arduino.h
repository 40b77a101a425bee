/*
 * Arduino.h - stands for an Arduino core on a computer: pins, time, a serial line. D/C is pin 9, reset pin 8.
 * Levels and modes are enums, which refuse numbers, as in ArduinoCore-API without its Compat.h.
 */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#include "wire.h"

typedef enum {
    LOW,
    HIGH
} PinStatus;
typedef enum {
    INPUT,
    OUTPUT
} PinMode;
typedef enum {
    LSBFIRST,
    MSBFIRST
} BitOrder;
typedef uint8_t pin_size_t;

inline void pinMode(pin_size_t, PinMode)
{
}

inline void digitalWrite(pin_size_t pin, PinStatus level)
{
    if (pin == 9)
        wire_level = level;
    else if (pin == 8)
        wire_number('R', level);
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
