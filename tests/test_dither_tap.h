/*
 * test_dither_tap.h - the core's unrounded colours, pixel by pixel.
 *
 * Included before the first line of every file of the library core_tapped, which is the
 * core and nothing else but this: pixel/pixel.h then hands over what it is about to round.
 */
#ifndef TEST_DITHER_TAP_H
#define TEST_DITHER_TAP_H

#include <stdint.h>

struct tile;

/* Channels of the target in levels, `fraction` bits below the point, before clamping; at: pixel of the tile. */
void tap_colour(const struct tile *tile, uint32_t at, uint32_t r, uint32_t g, uint32_t b, unsigned fraction);

#define SHEEN_TEST_TAP(tile, at, r, g, b, fraction) tap_colour(tile, at, r, g, b, fraction)

#define TAP_WIDTH 320 /* px: of the largest picture that is kept */
#define TAP_HEIGHT 240

struct tapped {
    double level[3]; /* of the pixel seen last: the nearest, as each one passed the depth test */
    int seen;        /* how often; 0: nothing was drawn here */
};
extern struct tapped tapped[TAP_HEIGHT][TAP_WIDTH];

/* Forget all pixels. */
void tap_begin(void);

#endif
