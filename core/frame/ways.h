/*
 * ways.h - private, for tests and measurements: which ways triangles took, and a way that they are to take.
 */
#ifndef SHEEN_FRAME_WAYS_H
#define SHEEN_FRAME_WAYS_H

#include "../sheen.h"
#include "../triangle/ways.h"

/* Set-ups since sheen_begin, by way. */
void sheen_frame_ways(const struct sheen_frame *frame, uint32_t by_way[SHEEN_WAYS]);

/* For draws from now on. way: 0: chosen for each triangle; 1 + enum sheen_way: that one wherever it is good enough. */
void sheen_frame_force(struct sheen_frame *frame, unsigned way);

#endif
