/*
 * SPI.h - stands for Arduino's SPI library: transfer() writes what it receives over what it sends.
 */
#ifndef SPI_H
#define SPI_H

#include <Arduino.h>

typedef enum {
    SPI_MODE0 = 0,
    SPI_MODE3 = 3
} SPIMode;

struct SPISettings {
    SPISettings(uint32_t, BitOrder, SPIMode)
    {
    }
    SPISettings(uint32_t, BitOrder, int)
    {
    }
};

struct SPIClass {
    void begin()
    {
    }
    void beginTransaction(SPISettings)
    {
    }
    void endTransaction()
    {
    }
    void transfer(void *bytes, size_t count)
    {
        wire_bytes(bytes, count);
        for (size_t i = 0; i < count; i++)
            static_cast<uint8_t *>(bytes)[i] = 0xFF;
    }
};
extern SPIClass SPI;

#endif
