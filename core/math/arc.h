/*
 * arc.h - private: great arcs between unit vectors.
 */
#ifndef SHEEN_ARC_H
#define SHEEN_ARC_H

#include "../sheen.h"
#include "fixed.h"

#define HALF_TURN 0x80000000u
/* Arcs under 2^-13 turn (8e-4 rad) are straight to 1e-10; arcs within it of half a turn have no direction. */
#define TINY_ANGLE (1u << 19)
/* What lies between two unit vectors. */
struct arc {
    uint32_t angle;        /* turns, 0..HALF_TURN */
    int32_t sine, versine; /* of it: Q1.30, and 1 - cos, Q2.29 */
};

/* a, b: unit vectors, Q1.30. */
struct arc sheen_arc_between(const int32_t a[3], const int32_t b[3]);

/* slerp from a to b (unit, 1.0 = 32767), `angle` apart in turns, at t (UQ0.32, in space). Q1.30. */
void sheen_arc_normal(const int16_t a[3], const int16_t b[3], uint32_t angle, uint32_t t, int32_t out[3]);

#endif
