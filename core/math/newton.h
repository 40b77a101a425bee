/*
 * newton.h - reciprocal and reciprocal square root: table seed + Newton step.
 *
 * Seeds are interpolated linearly between table entries and good to 2^-15 by themselves, which suffices at pixels
 * (*_rows.c). One Newton step makes them good to 2^-29, for vertices, triangles and frames.
 */
#ifndef SHEEN_NEWTON_H
#define SHEEN_NEWTON_H

#include "fixed.h"

/* 1/x at x = (128 + i) / 256, UQ1.15, i = 0..128. */
#define RECIPROCAL_ENTRIES 129
extern const uint16_t sheen_reciprocal_table[RECIPROCAL_ENTRIES];

/* 1/sqrt(x) at x = (128 + i) / 512, UQ1.15, i = 0..386: from 1/4 to 1 and two entries beyond. */
#define ROOT_ENTRIES 387
#define ROOT_FIRST 128
extern const uint16_t sheen_root_table[ROOT_ENTRIES];

/*
 * Seed of 1/x for x: UQ0.32 in [1/2, 1). UQ1.15, within 1.7 raw steps of exact (measured over all x).
 */
static inline uint32_t reciprocal_seed(uint32_t x)
{
    const uint16_t *entry = &sheen_reciprocal_table[(x >> 24) - 128u];
    uint32_t drop = (uint32_t)(entry[0] - entry[1]);

    return entry[0] - ((drop * ((x >> 8) & 0xffffu) + 0x8000u) >> 16);
}

/*
 * Seed of 1/sqrt(d) for d: UQ1.31 in [1/4, 1 + 1/512). UQ1.15, within 1.5 raw steps (measured over all d).
 * Range: drop <= 254 (at d = 1/4), so the product stays below 2^24.
 */
static inline uint32_t root_seed(uint32_t d)
{
    const uint16_t *entry = &sheen_root_table[(d >> 22) - ROOT_FIRST];
    uint32_t drop = (uint32_t)(entry[0] - entry[1]);

    return entry[0] - ((drop * ((d >> 6) & 0xffffu) + 0x8000u) >> 16);
}

/* 1/x for x: UQ0.32 in [1/2, 1). UQ1.31, within 2^-29 relative; 2.0 is returned as 0xffffffff. */
uint32_t sheen_reciprocal(uint32_t x);

/* a / b for 0 <= a <= b, b > 0, any common scale: UQ0.32, within 2^-28; 1.0 is returned as 0xffffffff. */
uint32_t sheen_ratio(uint32_t a, uint32_t b);

/*
 * A Newton step towards 1/sqrt(x) for x: UQ0.32 in [1/4, 1); root and result UQ1.31, 2.0 is returned as 0xffffffff.
 * From root = root_seed(x >> 1) << 16 the result is within 2^-29 relative.
 */
uint32_t sheen_root_step(uint32_t x, uint32_t root);

/* 1/sqrt(x) to the same precision without the table; slower, for what is done once per draw or when a mesh is made. */
uint32_t sheen_reciprocal_root(uint32_t x);

#endif
