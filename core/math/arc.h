/*
 * arc.h - private: great arcs between unit vectors (lecture, "Spherical Linear Interpolation"), by a series, not sines.
 *
 * Between a and b, an angle p apart, the point at t is share(1 - t) a + share(t) b, where share(t) = sin(t p) / sin p.
 * Up to a right angle share(t) is t + t (1 - q)(c0 + c1 q + c2 q^2), q = t^2; c0, c1 and c2 follow from h = sin^2(p/2)
 * = |a - b|^2 / 4.
 */
#ifndef SHEEN_ARC_H
#define SHEEN_ARC_H

#include "fixed.h"

#define RIGHT_ANGLE (1 << 14) /* h of a right angle, UQ0.15 */

struct arc_series {
    uint16_t c0;    /* UQ.16 */
    int16_t c1, c2; /* Q.16 */
};

/* h: UQ0.15, at most RIGHT_ANGLE. Shares are off by at most 1.9 / 2^15. */
void sheen_arc_series(struct arc_series *s, int32_t h);

/*
 * floor(x / 2^15 + 1/2). The 1/2 is a register that a multiply-accumulate adds for free, or, without wide products, a 1
 * that need not be loaded.
 */
static inline int32_t round15(int32_t x)
{
#if WIDE_PRODUCTS
    int32_t half = 1 << 14;
    OPAQUE(half);
    return asr32(x + half, 15);
#else
    return asr32(asr32(x, 14) + 1, 1);
#endif
}

/*
 * share(t); t and the share are UQ0.15, t may be up to two steps beyond 0 or 1.0, where shares are exact. Range: t (1 -
 * q) is at most .385, c0 .571: 2^13.7 * 2^15.2.
 */
static inline int32_t arc_share(const struct arc_series *s, int32_t t)
{
    int32_t q = round15(t * t), terms = s->c0 + round15(q * (s->c1 + round15(q * s->c2)));

    return t + asr32(round15(t * (32768 - q)) * terms + (1 << 15), 16);
}

/* An arc of any width; one beyond a right angle is kept as two parts of equal width. */
struct arc {
    struct arc_series series;
    int16_t end[3][3]; /* 1.0 = 32767 */
    uint16_t h;        /* of a part, UQ0.15 */
    uint8_t parts;     /* 1 or 2; 0: the ends are opposite, so no arc is defined and the nearer end counts */
};

void sheen_arc_begin(struct arc *arc, const int16_t a[3], const int16_t b[3]);

/* The shares of an arc's ends at t, UQ0.15. */
static inline void arc_shares(const struct arc_series *s, int32_t t, int32_t share[2])
{
    share[0] = arc_share(s, (1 << 15) - t);
    OPAQUE_BOTH(t, share[0]); /* one after the other: both at once need more registers than there are */
    share[1] = arc_share(s, t);
}

/* Interpolates what is `first` and `second` at an arc's ends, Q0.15. */
static inline int32_t blended(const int32_t share[2], int32_t first, int32_t second)
{
    return round15(share[0] * first + share[1] * second);
}

/* A point of an arc: the shares of end[0] and end[1], the ends of the part that it lies on. */
struct arc_blend {
    const int16_t (*end)[3];
    int32_t share[2];
};

/* t: UQ0.15. */
static inline void arc_blend_at(const struct arc *arc, int32_t t, struct arc_blend *b)
{
    const int16_t(*end)[3] = arc->end;

    if (arc->parts == 0)
        t = t < 1 << 14 ? 0 : 1 << 15;
    if (arc->parts == 2) {
        t *= 2;
        if (t > 1 << 15) {
            t -= 1 << 15;
            end++;
        }
    }
    b->end = end;
    arc_shares(&arc->series, t, b->share);
    OPAQUE_BOTH(b->end, b->share[0]); /* so that the ends' components are loaded later, when registers are free */
}

/* Component i of the point, Q0.15. */
static inline int32_t blended_part(const struct arc_blend *b, int i)
{
    return blended(b->share, b->end[0][i], b->end[1][i]);
}

#endif
