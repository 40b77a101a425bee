/*
 * LovyanGFX.hpp - stands for LovyanGFX: pushImage() expects each uint16_t high byte first, unless setSwapBytes(true).
 */
#ifndef LOVYANGFX_HPP
#define LOVYANGFX_HPP

#include "standin_glass.h"

class LGFX {
  public:
    bool init() { return true; }
    void setRotation(uint_fast8_t) {}
    int32_t width() const { return 240; }
    int32_t height() const { return 240; }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data) { standin_put(x, y, w, h, data, true); }
};

#endif
