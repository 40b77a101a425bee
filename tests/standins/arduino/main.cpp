/*
 * main.cpp - stands for the code that calls a sketch, which is included before it: setup(), and loop() three times.
 * With GLASS it prints what a display library drew; otherwise the wires' stand-in has printed what left on them.
 */
#include <Arduino.h>
#include <SPI.h>

#include "standin_glass.h"

SerialPort Serial;
SPIClass SPI;
uint16_t standin_glass[240 * 240];

int main()
{
    setup();
    for (int i = 0; i < 3; i++)
        loop();
#ifdef GLASS
    for (int i = 0; i < 240 * 240; i++) {
        putchar(standin_glass[i] & 255);
        putchar(standin_glass[i] >> 8);
    }
#else
    wire_number('F', 0);
#endif
    return fflush(stdout) != 0;
}
