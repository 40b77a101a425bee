/*
 * ramp_rows.c - pixels whose L.N and 1 - R.V are stepped, where the material has a ramp.
 */
#include "normal.h"
#include "quadric.h"

void sheen_run_by_ramp(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                       struct shaded_run *run, int has_highlight)
{
    const struct rounding rounding = rounding_of(t, &d->colour, y);

    for (uint32_t at = tile_offset(t, x, y); x < x1; x++, at++) {
        if (nearer(t, t->depth + at, run->z)) {
            int32_t ln = asr32((int32_t)run->f, 15);
            struct lit lit = {response_at(d->light.ramp, ln), 0};
            if (has_highlight && ln > 0 && run->u < d->loop.power_end)
                lit.specular = faded(power_entry(d->loop.power, run->u), (uint32_t)ln);
            put_any(t, d, rounding, at, x, &lit);
        }
        run->z += run->dz;
        run->f += run->df;
        run->df += run->ddf;
        run->u += run->du;
        run->du += run->ddu;
    }
}
