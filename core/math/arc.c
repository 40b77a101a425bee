/*
 * arc.c - great arcs between unit vectors (lecture, "Spherical Linear Interpolation").
 */
#include "arc.h"
#include "angle.h"
#include "newton.h"

/* sqrt of v in UQ4.60, at most 1.0: Q1.30. */
static int32_t root60(uint64_t v)
{
    if (v == 0)
        return 0;
    if (v >= (uint64_t)1 << 60)
        return 1 << 30;
    unsigned up = (clz64(v) - 4) & ~1u; /* to [2^58, 2^60): UQ4.60 in [1/4, 1) */
    uint32_t x = (uint32_t)(v << up >> 28);
    uint64_t root = (uint64_t)x * sheen_reciprocal_root(x); /* UQ1.63 in [1/2, 1) */

    return (int32_t)((root >> 33) >> (up / 2));
}

/* From half the chord h = |b - a| / 2 (or, beyond a right angle, |b + a| / 2) by the arc sine. a, b: Q1.30. */
struct arc sheen_arc_between(const int32_t a[3], const int32_t b[3])
{
    uint64_t chord = 0, sum = 0; /* squares of half lengths, UQ4.60 */

    for (int i = 0; i < 3; i++) {
        int64_t d = ((int64_t)b[i] - a[i]) / 2, m = ((int64_t)b[i] + a[i]) / 2;
        chord += (uint64_t)(d * d);
        sum += (uint64_t)(m * m);
    }
    const uint64_t one = (uint64_t)1 << 60;
    int wide = chord > sum;
    uint64_t smaller = wide ? sum : chord;
    if (smaller > one / 2) /* rounding, or normals longer than 1 */
        smaller = one / 2;
    int32_t h = root60(smaller), g = root60(one - smaller);
    uint32_t half = sheen_arc_sine(h);          /* half the angle, or a quarter turn less it; at most 1/8 turn */
    int32_t versine = (int32_t)(smaller >> 30); /* 2 h^2 = 1 - cos, Q2.29 */
    struct arc arc = {wide ? HALF_TURN - 2 * half : 2 * half, mul_round(h, g, 29),
                      wide ? (1 << 30) - versine : versine};

    return arc;
}

/* slerp of the normals of corners a and b, t in space. Q1.30. */
void sheen_arc_normal(const int16_t a[3], const int16_t b[3], uint32_t angle, uint32_t t, int32_t out[3])
{
    int32_t ka, kb; /* Q11.20: 1/sine reaches 1300 before the ends count as opposite */

    if (angle < TINY_ANGLE) {
        kb = (int32_t)(t >> 12);
        ka = (1 << 20) - kb;
    } else if (angle > HALF_TURN - TINY_ANGLE) {
        kb = t < HALF_TURN ? 0 : 1 << 20;
        ka = (1 << 20) - kb;
    } else {
        uint32_t part = mul_high(angle, t), sine = (uint32_t)sheen_sin(angle);
        unsigned zeros = clz32(sine);
        int64_t scale = sheen_reciprocal(sine << zeros); /* 1/sine = scale * 2^(zeros - 33) */
        ka = (int32_t)round_shift64(sheen_sin(angle - part) * scale, 43 - zeros);
        kb = (int32_t)round_shift64(sheen_sin(part) * scale, 43 - zeros);
    }
    ka += (int32_t)asr64((int64_t)ka * lacking(a), 31);
    kb += (int32_t)asr64((int64_t)kb * lacking(b), 31);
    for (int i = 0; i < 3; i++) /* Q0.15 times Q11.20; 1.0 of the normals is 32767 */
        out[i] = (int32_t)asr64(((int64_t)a[i] * ka + (int64_t)b[i] * kb) * 32769, 20);
}
