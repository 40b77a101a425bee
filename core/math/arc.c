/*
 * arc.c - great arcs between unit vectors, in 32-bit products except for the middle of wide arcs.
 */
#include "arc.h"
#include "newton.h"

/* Ends whose sum is no longer than this (1.0 = 32767) are opposite. */
#define OPPOSITE 4
#define ANGLE_ROUNDED (1 << 16) /* tolerance of a right angle, as -cosine in Q.30: 90.003 degrees */

/*
 * The terms are a least-squares fit over h and t that weights the largest errors most, because 1 / sin p and the like
 * have no short series of their own up to 90 degrees. Range: h * 115164 < 2^31.
 */
HOT void sheen_arc_series(struct arc_series *s, int32_t h)
{
    static const int32_t first[5] = {115164, -34433, 46635, 32890, 43797};
    int32_t square = round15(h * h), sum = 0;

    for (int k = 0; k < 5; k++)
        sum = first[k] + round15(h * sum);
    s->c0 = (uint16_t)round15(h * sum);
    s->c1 = (int16_t)round15(square * (-10284 + round15(h * (931 + round15(h * -38834)))));
    s->c2 = (int16_t)round15(square * round15(h * 1978));
}

/* |v|^2 of a sum or difference of unit vectors, UQ2.30: below 2^32. */
static uint32_t square_of(const int32_t v[3])
{
    const uint32_t x = (uint32_t)v[0], y = (uint32_t)v[1], z = (uint32_t)v[2];

    return x * x + y * y + z * z;
}

/* v / |v|, Q0.15, where 1 / |v| = root * 2^(up/2 - 47). Range: v 2^(up/2) is at most 2^16, its products below 2^31. */
static int32_t unit_part(int32_t v, unsigned up, uint32_t root)
{
    const int32_t part = v * (1 << up / 2), high = (int32_t)(root >> 17), low = (int32_t)(root >> 2 & 0x7fffu);

    return min32(round15(part * high + asr32(part * low, 15)), 32767);
}

/* Splits an obtuse arc into two equal parts, or none if its ends are opposite. Returns |a - b|^2 of a part's ends. */
static APART uint32_t bisect(struct arc *arc)
{
    int32_t v[3];

    for (int i = 0; i < 3; i++)
        v[i] = arc->end[0][i] + arc->end[1][i];
    const uint32_t square = square_of(v);
    arc->parts = 0;
    if (square <= OPPOSITE * OPPOSITE)
        return 0;
    arc->parts = 2;
    const unsigned up = clz32(square) & ~1u;
    const uint32_t root = sheen_reciprocal_root(square << up);
    for (int i = 0; i < 3; i++) {
        const int32_t middle = unit_part(v[i], up, root);
        v[i] = arc->end[0][i] - middle;
        arc->end[2][i] = arc->end[1][i];
        arc->end[1][i] = (int16_t)middle;
    }
    return square_of(v);
}

COLD void sheen_arc_begin(struct arc *arc, const int16_t a[3], const int16_t b[3])
{
    uint32_t square = 0;
    int32_t dot = 0;

    for (int i = 0; i < 3; i++) {
        const uint32_t apart = (uint32_t)(a[i] - b[i]);
        square += apart * apart;
        dot += a[i] * b[i];
        arc->end[0][i] = a[i];
        arc->end[1][i] = b[i];
    }
    arc->parts = 1;
    if (dot < -ANGLE_ROUNDED)
        square = bisect(arc);
    arc->h = (uint16_t)min32((int32_t)(square >> 17), RIGHT_ANGLE);
    sheen_arc_series(&arc->series, arc->h);
}
