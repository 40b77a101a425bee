/*
 * gpio.h - stands for ESP-IDF's GPIO. The level of the pin STANDIN_RESET goes to the wires.
 */
#ifndef GPIO_H
#define GPIO_H

#include <assert.h>
#include <stdint.h>

#include "wire.h"

typedef int gpio_num_t;
typedef enum {
    GPIO_MODE_OUTPUT = 2
} gpio_mode_t;
typedef struct {
    uint64_t pin_bit_mask;
    gpio_mode_t mode;
} gpio_config_t;

static uint64_t standin_outputs;

static inline int gpio_config(const gpio_config_t *config)
{
    standin_outputs |= config->pin_bit_mask;
    return 0;
}

static inline int gpio_set_level(gpio_num_t pin, uint32_t level)
{
    assert(standin_outputs >> pin & 1);
    if (pin == STANDIN_RESET)
        wire_number('R', level);
    return 0;
}

#endif
