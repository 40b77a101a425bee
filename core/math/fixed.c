/*
 * fixed.c - what of fixed.h need not stand in each caller.
 */
#include "fixed.h"

/* By words: where the processor has none of 64 bits, their shifts by a variable are calls. */
int32_t sheen_mul_round(int32_t a, int32_t b, unsigned n)
{
    const uint64_t sum = (uint64_t)((int64_t)a * b) + (1u << (n - 1));

    return (int32_t)((uint32_t)(sum >> 32) << (32 - n) | (uint32_t)sum >> 1 >> (n - 1));
}
