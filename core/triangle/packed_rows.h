/*
 * packed_rows.h - private: a run of pixels whose channels, in two words, are linear along it.
 */
#ifndef SHEEN_PACKED_ROWS_H
#define SHEEN_PACKED_ROWS_H

#include "triangle.h"

/* What changes along a run, and its steps. */
struct packed_at {
    uint32_t z;
    struct packed colour;
};

/* The same of shades: see linear_rows.c. */
struct shades_at {
    uint32_t z, f;
};

/* Without dither rounding is in the words. */
struct packed_way {
    intptr_t to_pixel;
    unsigned dither, swap;
};

/* late: nothing is made of the colour before the pixel is seen. */
SPECIALISED void packed_pixel(const struct tile *t, uint16_t *depth, struct packed_at *at, const struct packed_at *step,
                              const struct packed_way *way, const threshold_t *thresholds, unsigned late)
{
    if (nearer(t, depth, at->z)) {
        if (late)
            OPAQUE(at->colour.red_blue);
        *pixel_at(depth, way->to_pixel) =
            way->dither ? dithered_565(t, depth, at->colour, threshold_pair(thresholds, depth), way->swap)
                        : packed_565(at->colour, way->swap);
    }
    at->z += step->z;
    at->colour.red_blue += step->colour.red_blue;
    at->colour.green += step->colour.green;
}

/* thresholds: of the row, where the way dithers. */
SPECIALISED void packed_run(const struct tile *t, uint16_t *depth, int32_t count, struct packed_at at,
                            struct packed_at step, struct packed_way way, const threshold_t *thresholds)
{
    const uint16_t *end = depth + count;

    do
        packed_pixel(t, depth, &at, &step, &way, thresholds, 0);
    while (++depth != end);
}

#endif
