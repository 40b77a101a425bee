/*
 * quadric_rows.h - private: a pixel of quadric_rows.c, and its general loop for light with and without a ramp.
 */
#ifndef SHEEN_QUADRIC_ROWS_H
#define SHEEN_QUADRIC_ROWS_H

#include "fog.h"
#include "normal.h"
#include "quadric.h"

/* The intensities at a pixel from its quadrics' values. */
SPECIALISED struct lit lit_of(const struct loop_terms *q, uint32_t f, uint32_t u, enum second second)
{
    struct lit lit = {(uint32_t)max32(min32(asr32((int32_t)f, 15), 65535), 0), 0};

    if (second == SECOND_SPECULAR)
        lit.specular = not_negative(u) >> 15;
    else if (second == SECOND_POWER && u < q->power_end)
        lit.specular = faded(power_entry(q->power, u), lit.diffuse);
    SHEEN_TAP(HIGHLIGHT, second == SECOND_POWER && u < q->power_end);
    return lit;
}

/* The loop for any format, with clamp and dither. */
SPLIT void general_loop(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                        struct shaded_run *run, enum second second, int by_ramp, int is_fogged)
{
    struct rounding rounding = rounding_of(t, &d->colour, y);

    for (; x < x1; x++, at++) {
        if (nearer(t, t->depth + at, run->z)) {
            struct lit lit = lit_of(&d->loop, run->f, run->u, second);
            if (by_ramp)
                lit.diffuse = response_at(d->light.ramp, asr32((int32_t)run->f, 15));
            if (is_fogged)
                put_fogged_lit(t, d, rounding, at, x, run->z, &lit);
            else
                put_any(t, d, rounding, at, x, &lit);
        }
        run->z += run->dz;
        run->f += run->df;
        run->df += run->ddf;
        run->u += run->du;
        run->du += run->ddu;
    }
}

#endif
