/*
 * fixed.c - what of fixed.h need not stand in each caller.
 */
#include "fixed.h"

#if QUOTIENT_BY_BITS
/* A bit of the quotient a turn: what is left of a stands above those that are to come. */
uint32_t sheen_quotient(uint32_t a, uint32_t b)
{
    uint32_t left = 0;

    for (int bit = 0; bit < 32; bit++) {
        const uint32_t top = a >> 31;
        left = left << 1 | top;
        a <<= 1;
        if (left >= b) {
            left -= b;
            a++;
        }
    }
    return a;
}
#endif

/* By words: where the processor has none of 64 bits, their shifts by a variable are calls. */
int32_t sheen_mul_round(int32_t a, int32_t b, unsigned n)
{
    const uint64_t sum = (uint64_t)((int64_t)a * b) + (1u << (n - 1));

    return (int32_t)((uint32_t)(sum >> 32) << (32 - n) | (uint32_t)sum >> 1 >> (n - 1));
}
