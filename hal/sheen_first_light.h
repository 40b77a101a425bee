/*
 * sheen_first_light.h - the picture to send to a panel before any other.
 *
 *   +-----------------------+     border of 1 px: a side missing or doubled means a wrong gap
 *   | ##                 [] |     corners: solid top left (red), hollow top right (green),
 *   |      R  R  G  G  B    |     triangle bottom left (blue), cross bottom right (white)
 *   |      . : + * # % @    |     show how the panel is turned or mirrored
 *   | \|                 >< |     bars red, green, blue: show colour order and inversion
 *   +-----------------------+     8 steps of grey, dark to light: show byte order and gamma
 */
#ifndef SHEEN_FIRST_LIGHT_H
#define SHEEN_FIRST_LIGHT_H

#include "sheen_target.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Draws the picture on any target, in bands that fit into the caller's buffer (at
 * least align_y rows; colour panels need 2 B per pixel), and waits until the last
 * band has been sent. Returns 0, SHEEN_ERR_ARGUMENT, SHEEN_ERR_MEMORY (the buffer
 * is too small), or the target's error.
 */
int sheen_first_light(const struct sheen_target *target, void *buffer, size_t bytes);

/* The picture's colour 0xRRGGBB at (x, y) if it is w x h px large. On grey targets the corner marks are white. */
uint32_t sheen_first_light_colour(unsigned x, unsigned y, unsigned w, unsigned h);

#ifdef __cplusplus
}
#endif
#endif
