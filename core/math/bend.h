/*
 * bend.h - private: how far apart the normals at the corners of a plane quad are, as its polygon's warp tells.
 */
#ifndef SHEEN_BEND_H
#define SHEEN_BEND_H

#include <stdint.h>

/*
 * Warp k + 1 says that the quad's normals are linear over it and that |a - b|^2 of any two of them is at most
 * sheen_bends[k], UQ0.16. The limits are a fifth (QUAD_APART) of |a - b|^2 at the angles that shadings distinguish: 13,
 * 14, 18, 20, 25.9, 30 and 34 degrees (reflection.c).
 */
#define BENDS 7
static const uint16_t sheen_bends[BENDS] = {671, 778, 1282, 1580, 2636, 3512, 4479};

#endif
