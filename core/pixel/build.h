/*
 * build.h - private: what a build of the core has: loops, counters, taps.
 */
#ifndef SHEEN_BUILD_H
#define SHEEN_BUILD_H

/* 1: count pixels, which costs time; pictures are the same. */
#ifndef SHEEN_STATS
#define SHEEN_STATS 0
#endif

/* 1: specialised loops for 565. Builds for size use only the general loops, which give the same pixels. */
#ifndef FAST_LOOPS
#ifdef __OPTIMIZE_SIZE__
#define FAST_LOOPS 0
#else
#define FAST_LOOPS 1
#endif
#endif

/*
 * Taps for a build that counts what its frames consist of: SHEEN_TAPS names the header that defines them
 * (host-sim/plan/taps.h). Without it SHEEN_TAP_ROWS just draws a set-up's rows in a tile, and the others do nothing.
 */
#ifdef SHEEN_TAPS
#include SHEEN_TAPS
#else
#define SHEEN_TAP(what, count) ((void)0)
#define SHEEN_TAP_SETUP(corners, gradients) ((void)0)
#define SHEEN_TAP_ROWS(tile, setup) (setup)->rows(tile, setup)
#endif

/* For loops that are written once and specialised by constant arguments. */
#if FAST_LOOPS
#define SPECIALISED static inline __attribute__((always_inline))
#else
#define SPECIALISED static inline
#endif

/* The same for specialisations of which a program may link one alone, without the others' code. */
#ifdef __GNUC__
#define SPLIT static inline __attribute__((always_inline))
#else
#define SPLIT static inline
#endif

/* Counts a pixel that passed the depth test, in builds that count. */
#if SHEEN_STATS
#define COUNT_SHADED(t) (++*(t)->shaded)
#else
#define COUNT_SHADED(t) ((void)0)
#endif

/* A test of dithering defines this to see each pixel's unrounded channels. */
#ifndef SHEEN_TEST_TAP
#define SHEEN_TEST_TAP(tile, at, r, g, b, fraction) ((void)0)
#endif

#endif
