/*
 * TFT_eSPI.h - stands for TFT_eSPI: pushImage() sends the bytes in the order of memory, unless setSwapBytes(true).
 */
#ifndef TFT_ESPI_H
#define TFT_ESPI_H

#include "standin_glass.h"

class TFT_eSPI
{
  public:
    void begin()
    {
    }
    void setRotation(uint8_t)
    {
    }
    int16_t width()
    {
        return 240;
    }
    int16_t height()
    {
        return 240;
    }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data)
    {
        standin_put(x, y, w, h, data, true);
    }
};

#endif
