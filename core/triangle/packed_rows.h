/*
 * packed_rows.h - private: a run of pixels along which the channels, packed in two words, are linear.
 */
#ifndef SHEEN_PACKED_ROWS_H
#define SHEEN_PACKED_ROWS_H

#include "triangle.h"

/* What is stepped along a run: its values at a pixel, or its steps per pixel. */
struct packed_at {
    uint32_t z;
    struct packed colour;
};

/* The same for pixels from shades; see linear_rows.c. */
struct shades_at {
    uint32_t z, f;
};

/* Without dither the rounding's 1/2 is in the packed words already. */
struct packed_way {
    intptr_t to_pixel;
    unsigned dither, swap;
};

/* late: the colour is not computed before the pixel has passed the depth test. */
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

/* thresholds: the row's, if the way dithers. */
SPECIALISED void packed_run(const struct tile *t, uint16_t *depth, int32_t count, struct packed_at at,
                            struct packed_at step, struct packed_way way, const threshold_t *thresholds)
{
    const uint16_t *end = depth + count;

    do
        packed_pixel(t, depth, &at, &step, &way, thresholds, 0);
    while (++depth != end);
}

#endif
