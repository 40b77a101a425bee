/*
 * normal_rows.c - pixels lit from their normals by any number of lights: 1/sqrt(N.N), and a dot product per light.
 */
#include "normal_rows.h"

#if !FAST_LOOPS
void put_any(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
             const struct lit *lit)
{
    put_general(t, &d->colour, rounding, at, x, colour_channel(&d->colour, 0, lit), colour_channel(&d->colour, 1, lit),
                colour_channel(&d->colour, 2, lit));
}
#endif

HOT void sheen_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                          const struct normal_run *run)
{
    normal_loop(t, d, x, x1, y, run, 0, 0);
}
