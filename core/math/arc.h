/*
 * arc.h - private: great arcs between unit vectors (lecture, "Spherical Linear Interpolation") by a series: no sine.
 *
 * From a to b an angle p apart, t of the way is share(1 - t) a + share(t) b, share(t) = sin(t p) / sin p. Up to a right
 * angle that is t + t (1 - q)(c0 + c1 q + c2 q^2), q = t^2, with c from h = sin^2(p/2) = |a - b|^2 / 4.
 */
#ifndef SHEEN_ARC_H
#define SHEEN_ARC_H

#include "fixed.h"

#define RIGHT_ANGLE (1 << 14) /* h of it, UQ0.15 */

struct arc_series {
    uint16_t c0;    /* UQ.16 */
    int16_t c1, c2; /* Q.16 */
};

/* h: UQ0.15, at most RIGHT_ANGLE. Shares are off by at most 1.8 / 2^15. */
void sheen_arc_series(struct arc_series *s, int32_t h);

/* floor(x / 2^15 + 1/2) */
static inline int32_t round15(int32_t x)
{
    return asr32(x + (1 << 14), 15);
}

/* share(t), t and it UQ0.15. Range: t (1 - q) is at most .385, c0 .571: 2^13.7 * 2^15.2. */
static inline int32_t arc_share(const struct arc_series *s, int32_t t)
{
    int32_t q = round15(t * t), terms = s->c0 + round15(q * (s->c1 + round15(q * s->c2)));

    return t + asr32(round15(t * (32768 - q)) * terms + (1 << 15), 16);
}

/* An arc of any width: beyond a right angle it is two, as wide as each other. */
struct arc {
    struct arc_series series;
    int16_t end[3][3]; /* 1.0 = 32767 */
    uint16_t h;        /* of a part, UQ0.15 */
    uint8_t parts;     /* 1 or 2; 0: opposite ends, between which there is no way: the nearer one */
};

void sheen_arc_begin(struct arc *arc, const int16_t a[3], const int16_t b[3]);
/* t: UQ0.15; n: Q1.30. */
void sheen_arc_at(const struct arc *arc, int32_t t, int32_t n[3]);

#endif
