/*
 * test_dither_tap.h - the core's unrounded colours, pixel by pixel.
 *
 * The library core_tapped is the core with this header included before the first line of every file, and is otherwise
 * unchanged. With it, pixel/rounding.h hands over each colour that it is about to round.
 */
#ifndef TEST_DITHER_TAP_H
#define TEST_DITHER_TAP_H

#include <stdint.h>

struct tile;

/* r, g, b: channels of the target in levels, with `fraction` fraction bits, not clamped; at: the pixel in the tile. */
void tap_colour(const struct tile *tile, uint32_t at, uint32_t r, uint32_t g, uint32_t b, unsigned fraction);

#define SHEEN_TEST_TAP(tile, at, r, g, b, fraction) tap_colour(tile, at, r, g, b, fraction)

#define TAP_WIDTH 320 /* px, the size of the largest picture that can be stored */
#define TAP_HEIGHT 240

struct tapped {
    double level[3]; /* of the pixel seen last, which is the nearest because each one passed the depth test */
    int seen;        /* how often the pixel was drawn; 0: never */
};
extern struct tapped tapped[TAP_HEIGHT][TAP_WIDTH];

/* Forget all pixels. */
void tap_begin(void);

#endif
