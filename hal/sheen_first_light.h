/*
 * sheen_first_light.h - the picture to send to a panel before any other.
 *
 *   +-----------------------+     a border of 1 px: a side missing or doubled is an offset
 *   | ##                 [] |     corners: solid top left (red), hollow top right (green),
 *   |      R  R  G  G  B    |     triangle bottom left (blue), cross bottom right (white):
 *   |      . : + * # % @    |     which way the panel is turned or mirrored
 *   | \|                 >< |     bars red, green, blue: colour order and inversion
 *   +-----------------------+     8 steps of grey, dark to light: byte order, gamma
 */
#ifndef SHEEN_FIRST_LIGHT_H
#define SHEEN_FIRST_LIGHT_H

#include "sheen_target.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Draws on any target, in bands that fit the caller's buffer (at least align_y
 * rows: 2 B a pixel on colour panels). Waits for the last band too. Returns 0,
 * SHEEN_ERR_ARGUMENT, SHEEN_ERR_MEMORY (the buffer is too small), or the
 * target's error.
 */
int sheen_first_light(const struct sheen_target *target, void *buffer, size_t bytes);

/* The pattern's colour 0xRRGGBB at (x, y) of a w x h picture; grey targets show the corners white. */
uint32_t sheen_first_light_colour(unsigned x, unsigned y, unsigned w, unsigned h);

#ifdef __cplusplus
}
#endif
#endif
