/*
 * core_raster.h - the core's set-up and edge stepping, for tests that hand it snapped corners.
 */
#ifndef CORE_RASTER_H
#define CORE_RASTER_H

#include "exact_cover.h"
#include "frame/frame.h"

/* Just enough of a frame for sheen_setup and sheen_spans: one draw, one triangle. */
struct core_raster {
    struct sheen_frame frame;
    struct sheen_target target; /* its size and order of bytes alone */
    struct sheen_mesh mesh;
    struct sheen_material material;
    struct draw_record draw;
    struct vertex vertex[3];
    struct entry entry[1];
    uint32_t cut[1];
};

/* A picture of width x height px. */
void core_raster_begin(struct core_raster *r, int width, int height);

/*
 * The spans of a triangle in the rectangle, corners in 1/64 px of the picture, within +-511 px of its centre;
 * either winding. Returns the number of rows; spans[0] is row *first.
 */
int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first);

#endif
