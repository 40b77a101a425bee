/*
 * angle.h - arc sine in binary angles (2^32 = one turn); sheen.h has sine and cosine.
 */
#ifndef SHEEN_ANGLE_H
#define SHEEN_ANGLE_H

#include <stdint.h>

/* asin(x) in turns (UQ0.32) for x in [0, 0.7072], Q1.30. The error is at most 3e-8 of the angle and 2 raw steps. */
uint32_t sheen_arc_sine(int32_t x);

#endif
