/*
 * esp_rom_sys.h - stands for ESP-IDF's short delays.
 */
#ifndef ESP_ROM_SYS_H
#define ESP_ROM_SYS_H

#include "wire.h"

static inline void esp_rom_delay_us(uint32_t us)
{
    wire_number('T', us);
}

#endif
