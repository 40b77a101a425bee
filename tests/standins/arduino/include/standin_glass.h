/*
 * standin_glass.h - what the display libraries' stand-ins draw on: 240 x 240 values of 565.
 */
#ifndef STANDIN_GLASS_H
#define STANDIN_GLASS_H

#include <stdint.h>

extern uint16_t standin_glass[240 * 240];

/* swap: the values are stored high byte first, so their bytes are swapped. */
inline void standin_put(int x, int y, int w, int h, const uint16_t *values, bool swap)
{
    for (int row = 0; row < h; row++)
        for (int column = 0; column < w; column++) {
            uint16_t value = values[row * w + column];
            standin_glass[(y + row) * 240 + x + column] = swap ? (uint16_t)(value << 8 | value >> 8) : value;
        }
}

#endif
