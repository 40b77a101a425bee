/*
 * both.c - what both boards do the same way.
 */
#include "both.h"

#include "board.h"
#include "ticks.h"

int both_delay(void *ctx, uint32_t us)
{
    (void)ctx;
    for (; us > 1000; us -= 1000) {
        ticks_delay_us(1000);
        board_feed();
    }
    ticks_delay_us(us);
    return SHEEN_OK;
}

int both_pressed(uint8_t down, const char *keys)
{
    static uint8_t before = 0xFF;
    uint8_t pressed = down & (uint8_t)~before;

    before = down;
    for (; pressed && *keys; pressed >>= 1, keys++)
        if (pressed & 1)
            return *keys;
    return -1;
}
