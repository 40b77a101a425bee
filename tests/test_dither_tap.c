/*
 * test_dither_tap.c - stores the colours that the core is about to round.
 */
#include <math.h>
#include <string.h>

#include "frame/frame.h"
#include "test_dither_tap.h"

struct tapped tapped[TAP_HEIGHT][TAP_WIDTH];

void tap_begin(void)
{
    memset(tapped, 0, sizeof tapped);
}

void tap_colour(const struct tile *tile, uint32_t at, uint32_t r, uint32_t g, uint32_t b, unsigned fraction)
{
    unsigned x = (unsigned)tile->rect.x0 + at % tile->pitch, y = (unsigned)tile->rect.y0 + at / tile->pitch;

    if (x >= TAP_WIDTH || y >= TAP_HEIGHT)
        return;
    struct tapped *pixel = &tapped[y][x];
    pixel->level[0] = ldexp(r, -(int)fraction); /* exact, because the values have 32 bits */
    pixel->level[1] = ldexp(g, -(int)fraction);
    pixel->level[2] = ldexp(b, -(int)fraction);
    pixel->seen++;
}
