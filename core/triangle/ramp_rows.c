/*
 * ramp_rows.c - runs of pixels lit by a ramp, along which normals, or L.N and 1 - R.V, are stepped.
 */
#include "normal_rows.h"
#include "quadric_rows.h"

void sheen_normal_run_by_ramp(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                              const struct normal_run *run)
{
    normal_loop(t, d, x, x1, y, run, 1, 0);
}

void sheen_shaded_run_by_ramp(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                              struct shaded_run *run, unsigned second)
{
    general_loop(t, d, at, x, x1, y, run, (enum second)second, 1, 0);
}
