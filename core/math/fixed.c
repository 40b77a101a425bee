/*
 * fixed.c - what of fixed.h need not stand in each caller.
 */
#include "fixed.h"

int32_t sheen_mul_round(int32_t a, int32_t b, unsigned n)
{
    return mul_round(a, b, n);
}
