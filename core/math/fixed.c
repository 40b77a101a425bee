/*
 * fixed.c - functions of fixed.h that need not be inlined.
 */
#include "fixed.h"

#if QUOTIENT_BY_BITS
/*
 * One bit of the quotient per iteration: `left` is the remainder; a's bits leave at the top, the quotient's enter
 * below.
 */
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

/* The shift is by words, because on 32-bit processors a 64-bit shift by a variable is a library call. */
int32_t sheen_mul_round(int32_t a, int32_t b, unsigned n)
{
    const uint64_t sum = (uint64_t)((int64_t)a * b) + (1u << (n - 1));

    return (int32_t)((uint32_t)(sum >> 32) << (32 - n) | (uint32_t)sum >> 1 >> (n - 1));
}
