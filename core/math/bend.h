/*
 * bend.h - private: how far apart normals are at the corners of a plane quad, told by its warp.
 */
#ifndef SHEEN_BEND_H
#define SHEEN_BEND_H

#include <stdint.h>

/*
 * Warp k + 1: linear normals, the most |a - b|^2 of any two up to sheen_bends[k], UQ0.16. A fifth (QUAD_APART) of what
 * shadings tell apart: 13, 14, 18, 20, 25.9, 30 and 34 degrees (reflection.c).
 */
#define BENDS 7
static const uint16_t sheen_bends[BENDS] = {671, 778, 1282, 1580, 2636, 3512, 4479};

#endif
