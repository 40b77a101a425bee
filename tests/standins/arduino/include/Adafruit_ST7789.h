/*
 * Adafruit_ST7789.h - stands for Adafruit's ST7789 on Adafruit GFX: drawRGBBitmap() expects values in machine order.
 */
#ifndef ADAFRUIT_ST7789_H
#define ADAFRUIT_ST7789_H

#include "standin_glass.h"

class Adafruit_ST7789
{
  public:
    Adafruit_ST7789(int8_t, int8_t, int8_t)
    {
    }
    void init(uint16_t, uint16_t)
    {
    }
    int16_t width() const
    {
        return 240;
    }
    int16_t height() const
    {
        return 240;
    }
    void drawRGBBitmap(int16_t x, int16_t y, uint16_t *values, int16_t w, int16_t h)
    {
        standin_put(x, y, w, h, values, false);
    }
};

#endif
