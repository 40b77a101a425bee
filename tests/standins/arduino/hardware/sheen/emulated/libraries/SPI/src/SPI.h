/*
 * SPI.h - stands for Arduino's SPI library: drives the PL022 that both emulated boards have, one byte at a time.
 */
#ifndef SPI_H
#define SPI_H

#include <Arduino.h>

enum {
    MSBFIRST = 1,
    SPI_MODE0 = 0,
    SPI_MODE3 = 3
};

struct SPISettings {
    SPISettings(uint32_t, int, int)
    {
    }
};

struct SPIClass {
    void begin()
    {
        REGISTER(BOARD_SPI + 0x10) = 2; /* prescaler, 8 bits, on */
        REGISTER(BOARD_SPI) = 7;
        REGISTER(BOARD_SPI + 4) = 2;
    }
    void beginTransaction(SPISettings)
    {
    }
    void endTransaction()
    {
    }
    void transfer(void *bytes, size_t count)
    {
        uint8_t *at = static_cast<uint8_t *>(bytes);

        for (size_t i = 0; i < count; i++) {
            REGISTER(BOARD_SPI + 8) = at[i];
            while (!(REGISTER(BOARD_SPI + 0xC) & 4)) /* nothing received yet */
                ;
            at[i] = (uint8_t)REGISTER(BOARD_SPI + 8);
        }
    }
};
extern SPIClass SPI;

#endif
