/*
 * shine.c - the table of s^n for one shininess.
 */
#include "pixel.h"

/* a * b for UQ0.32 factors, with 1.0 as 0xffffffff. */
static uint32_t multiply(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b + a + b) >> 32);
}

COLD uint32_t sheen_raised(uint32_t s, unsigned n)
{
    uint32_t result = UINT32_MAX;

    for (; n > 0; n >>= 1) {
        if ((n & 1u) != 0)
            result = multiply(result, s);
        s = multiply(s, s);
    }
    return result;
}

/* s^n at entry i of a table with that shift, UQ0.32. i <= SHEEN_POWER_ENTRIES. */
static uint32_t power_exact(unsigned i, unsigned shift, unsigned n)
{
    uint64_t u = (uint64_t)i << (24 - shift);

    return u < UINT32_MAX ? sheen_raised(UINT32_MAX - (uint32_t)u, n) : 0;
}

/*
 * The table spans u = 1 - s from 0 to 2^-shift, the smallest power of two from which on s^n stays under 2^-16. A line
 * between two points of a convex curve lies above it, on average by 1/12 of the second difference; the entries are
 * lowered by that, except the first, which is 1.0. The error left is at most n (n - 1) / 12 / (256 * 2^shift)^2 < 7e-4
 * of the highlight, to either side.
 */
COLD int sheen_shine_make(struct sheen_shine *shine, unsigned shininess)
{
    uint32_t before = UINT32_MAX, here = UINT32_MAX;
    unsigned shift = 0;

    if (shininess < 1 || shininess > 128)
        return SHEEN_ERR_ARGUMENT;
    while (shift < 3 && sheen_raised(UINT32_MAX - (UINT32_MAX >> (shift + 1)), shininess) < 1u << 16)
        shift++;
    shine->shininess = (uint8_t)shininess;
    shine->shift = (uint8_t)shift;
    shine->power[0] = 1u << 15;
    for (unsigned i = 0; i < SHEEN_POWER_ENTRIES; i++) {
        uint32_t after = power_exact(i + 1, shift, shininess);
        uint32_t bent = i > 0 ? (before - here - (here - after)) / 12 : 0; /* the table falls, ever more slowly */
        uint32_t power = here > bent ? here - bent : 0;
        power = (power >> 17) + (power >> 16 & 1u);
        shine->power[i] = shine->power[i] << 16 | (shine->power[i] - power); /* entry i with its decrease */
        shine->power[i + 1] = power;
        before = here;
        here = after;
    }
    shine->power[SHEEN_POWER_ENTRIES] = shine->power[SHEEN_POWER_ENTRIES] << 16 | shine->power[SHEEN_POWER_ENTRIES];
    return SHEEN_OK;
}
