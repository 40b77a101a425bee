/*
 * angle.c - sine, cosine and arc sine. Sines: the nearest of 256 directions from a table, the
 * rest of the angle by the addition theorem.
 *
 * With |d| <= 2 pi / 512 = 0.0123 the series sin d = d - d^3/6 and cos d =
 * 1 - d^2/2 + d^4/24 are exact to 3e-12, far below a step of Q1.30 (9e-10).
 */
#include "angle.h"
#include "../sheen.h"
#include "fixed.h"

/* sin of i/256 turn, any i. Q1.30. */
static int32_t table_sine(uint32_t i)
{
    uint32_t quarter = (i >> 6) & 3u, at = i & 63u;
    int32_t value = sheen_sine_table[(quarter & 1u) != 0 ? 64u - at : at];

    return (quarter & 2u) != 0 ? -value : value;
}

sheen_q30_t sheen_sin(sheen_angle_t angle)
{
    uint32_t nearest = (angle + 0x00800000u) >> 24;    /* 0..256; 256 is 0 again */
    int32_t rest = (int32_t)(angle - (nearest << 24)); /* turns, Q0.32, |rest| <= 2^23 */
    int32_t d = sheen_mul_round(rest, 1686629713, 30); /* 2 pi in Q2.28: d in Q1.30, radians, |d| < 2^24 */
    int32_t square = sheen_mul_round(d, d, 30);        /* Q1.30 */
    int32_t sine = d - sheen_mul_round(sheen_mul_round(square, d, 30), 178956971, 30); /* 1/6 */
    int32_t versine = square / 2 - (sheen_mul_round(square, square, 30) * 2731 >> 16); /* 1 - cos d; 1/24 */
    int32_t table_cos = table_sine(nearest + 64u), table_sin = table_sine(nearest);

    return table_sin - sheen_mul_round(table_sin, versine, 30) + sheen_mul_round(table_cos, sine, 30);
}

sheen_q30_t sheen_cos(sheen_angle_t angle)
{
    return sheen_sin(angle + 0x40000000u);
}

/*
 * asin(x) / x is smooth in x^2: a polynomial through the Chebyshev nodes of
 * [0, 0.5005], in turns (UQ0.32), off by 2e-8 of itself.
 * Range: x^2 < 2^29.01, partial sums below 2^30.
 */
uint32_t sheen_arc_sine(int32_t x)
{
    static const int32_t term[8] = {683565268, 113929534, 51185443, 31782325, 11375414, 51836299, -61898811, 75167749};
    int32_t square = sheen_mul_round(x, x, 30), sum = term[7];

    for (int k = 6; k >= 0; k--)
        sum = term[k] + sheen_mul_round(sum, square, 30);
    return (uint32_t)sheen_mul_round(sum, x, 30);
}
