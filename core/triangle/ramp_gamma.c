/*
 * ramp_gamma.c - the ramp that puts light on a panel's own gamma curve.
 */
#include "triangle.h"

#define LIT_STEPS (SHEEN_RAMP_STEPS / 2) /* from L.N = 0 to 1 */
#define ROOT_OF_8 2763091829u            /* 8^(5/11), UQ2.30 */

/* x^(1/2.2) = (x^(1/11))^5, UQ2.30; x: UQ4.28, at most 8.0. */
static uint32_t on_curve(uint32_t x)
{
    uint32_t eleventh = 0, down = 0;

    if (x == 0)
        return 0;
    x = x < 1u << 31 ? x << 1 : UINT32_MAX; /* x / 8.0, UQ0.32 */
    for (; x < 1u << 21; down += 5)         /* times 2^11; the result is then 2^5 times as large */
        x <<= 11;
    for (uint32_t bit = 1u << 31; bit != 0; bit >>= 1)
        if (sheen_raised(eleventh | bit, 11) <= x)
            eleventh |= bit;
    return (uint32_t)((uint64_t)sheen_raised(eleventh, 5) * ROOT_OF_8 >> 32) >> down;
}

/* What D times diffuse adds to the ambient light at entry i of the lit half, Q.30: more than -4.0, less than 2.6. */
static int64_t rise_at(uint32_t i, sheen_q16_t ambient, sheen_q16_t diffuse)
{
    return (int64_t)on_curve(((uint32_t)ambient << 12) + (uint32_t)diffuse * 32 * i) - ((int64_t)ambient << 14);
}

/*
 * D times diffuse rises from `dark` to `bright`; if the ambient light is above 1.0, `dark` is negative. Range: both are
 * below 2^32, diffuse is at least 2^6.
 */
COLD int sheen_ramp_make_gamma(struct sheen_ramp *ramp, sheen_q16_t ambient, sheen_q16_t diffuse)
{
    if (ambient < 0 || ambient > 4 << 16 || diffuse < 64 || diffuse > 4 << 16)
        return SHEEN_ERR_ARGUMENT;
    const int64_t dark = rise_at(0, ambient, diffuse), bright = rise_at(LIT_STEPS, ambient, diffuse);
    const int64_t low = dark < 0 ? dark : 0, span = bright - low;
    const int64_t steepest = (rise_at(1, ambient, diffuse) - dark) * LIT_STEPS; /* per unit of L.N, times diffuse */

    for (uint32_t i = 0; i <= SHEEN_RAMP_STEPS; i++) {
        int64_t rise = i < LIT_STEPS ? dark : rise_at(i - LIT_STEPS, ambient, diffuse);
        ramp->value[i] = (uint16_t)(((rise - low) * 32768 + span / 2) / span);
    }
    ramp->low = (sheen_q16_t)(low * 4 / diffuse);
    ramp->span = (sheen_q16_t)((span * 4 + diffuse / 2) / diffuse);
    for (ramp->steep = 0; steepest > (int64_t)diffuse << (14 + ramp->steep);)
        ramp->steep++;
    ramp->reader = &sheen_ramp_reader;
    return SHEEN_OK;
}
