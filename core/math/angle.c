/*
 * angle.c - sine and arc sine, odd functions and so x times a polynomial in x^2; a cosine is a shifted sine.
 */
#include "angle.h"
#include "../sheen.h"
#include "fixed.h"

/* The sum of term[k] * square^k, k = 0..last; square Q1.30, terms of any format. Range: partial sums below 2^31. */
static APART int32_t polynomial(const int32_t *term, int last, int32_t square)
{
    int32_t sum = term[last];

    while (last-- > 0)
        sum = term[last] + sheen_mul_round(sum, square, 30);
    return sum;
}

/*
 * x = 1.0 is a quarter of a turn, and sin(x * pi / 2) is x + x * polynomial, with an error of at most 1.4e-11, which
 * rounding raises to 1.9 raw steps. Terms in Q0.31; quarter turns are exact, because at x = 1.0 the terms' sum is 0
 * within a step of Q0.31.
 */
sheen_q30_t sheen_sin(sheen_angle_t angle)
{
    static const int32_t term[6] = {1225775778, -1387197326, 171138528, -10053703, 344064, -7341};
    const uint32_t half = angle & 0x7fffffffu;
    const int32_t x = (int32_t)(half <= 0x40000000u ? half : 0x80000000u - half);
    const int32_t sine = x + sheen_mul_round(polynomial(term, 5, sheen_mul_round(x, x, 30)), x, 31);

    return angle == half ? sine : -sine;
}

sheen_q30_t sheen_cos(sheen_angle_t angle)
{
    return sheen_sin(angle + 0x40000000u);
}

/*
 * asin(x) / x is smooth in x^2: a polynomial through the Chebyshev nodes of [0, 0.5005], in turns (UQ0.32), with a
 * relative error of 2e-8. Range: x^2 < 2^29.01, partial sums below 2^30.
 */
uint32_t sheen_arc_sine(int32_t x)
{
    static const int32_t term[8] = {683565268, 113929534, 51185443, 31782325, 11375414, 51836299, -61898811, 75167749};

    return (uint32_t)sheen_mul_round(polynomial(term, 7, sheen_mul_round(x, x, 30)), x, 30);
}
