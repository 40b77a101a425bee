/*
 * stdlib.h - stands for pico-sdk's pico/stdlib.h: GPIO and time. D/C is pin 16, chip select 17, reset 21.
 */
#ifndef PICO_STDLIB_H
#define PICO_STDLIB_H

#include <stdbool.h>
#include <stdint.h>

#include "wire.h"

typedef unsigned int uint;

enum {
    GPIO_IN = 0,
    GPIO_OUT = 1,
    GPIO_FUNC_SPI = 1
};

static inline void gpio_init(uint pin)
{
    (void)pin;
}

static inline void gpio_set_dir(uint pin, bool out)
{
    (void)pin;
    (void)out;
}

static inline void gpio_set_function(uint pin, int function)
{
    (void)pin;
    (void)function;
}

static inline void gpio_put(uint pin, bool value)
{
    if (pin == 16)
        wire_level = value;
    else if (pin == 21)
        wire_number('R', value);
}

static inline void sleep_us(uint64_t us)
{
    wire_number('T', (uint32_t)us);
}

static inline void tight_loop_contents(void)
{
}

#endif
