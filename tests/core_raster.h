/*
 * core_raster.h - runs one triangle through the core's set-up and rows, without a frame.
 */
#ifndef CORE_RASTER_H
#define CORE_RASTER_H

#include "exact_cover.h"
#include "shading/shading.h"

/* What a shading's room needs: a draw record, a triangle, and the parts of the view that a set-up reads. */
struct core_raster {
    struct screen screen;
    struct pixel_format format; /* 565 in this machine's byte order */
    struct sheen_mesh mesh;
    struct sheen_material material;
    struct draw draw;
    struct vertex vertex[3];
};

/* A set-up with room for the shading's own part. */
struct core_setup {
    struct setup s;
    uint64_t room[(SETUP_BYTES - sizeof(struct setup) + 7) / 8];
};

/* A picture of width x height px, with flat shading and no lights. */
void core_raster_begin(struct core_raster *r, int width, int height);

/* Set up the triangle for a rectangle and fill the spans of its rows there; returns the number of these rows. */
unsigned core_raster_set_up(struct core_raster *r, struct sheen_rect rect, struct span *spans, struct core_setup *to);

/*
 * The spans of a triangle in the rectangle. Corners in 1/64 px of the picture, within +-511 px of its centre; either
 * winding. Returns the number of rows; spans[0] is row *first.
 */
int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first);

/* Draw the triangle with its shader. depth (z16) and pixels have the size given to core_raster_begin. */
void core_raster_draw(struct core_raster *r, uint16_t *depth, uint16_t *pixels);

/* Write the triangle's depths (z16) wherever they are nearer than what depth holds; size likewise. */
void core_raster_depths(struct core_raster *r, uint16_t *depth);

#endif
