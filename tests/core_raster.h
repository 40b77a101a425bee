/*
 * core_raster.h - one triangle through the core's set-up and rows, without a frame.
 */
#ifndef CORE_RASTER_H
#define CORE_RASTER_H

#include "exact_cover.h"
#include "shading/shading.h"

/* What a shading's room is given: a draw record, a triangle, and of the view what its set-up needs. */
struct core_raster {
    struct screen screen;
    struct pixel_format format; /* 565 in this machine's order */
    struct sheen_mesh mesh;
    struct sheen_material material;
    struct draw draw;
    struct vertex vertex[3];
};

/* A set-up's slot. */
struct core_setup {
    struct setup s;
    uint64_t room[(SETUP_BYTES - sizeof(struct setup) + 7) / 8];
};

/* A picture of width x height px, flat shading without lights. */
void core_raster_begin(struct core_raster *r, int width, int height);

/* Set the triangle up from the rectangle's rows on; the number of its rows there, whose spans are filled. */
unsigned core_raster_set_up(struct core_raster *r, struct sheen_rect rect, struct span *spans, struct core_setup *to);

/*
 * The spans of a triangle in the rectangle, corners in 1/64 px of the picture, within +-511 px of its centre;
 * either winding. Returns the number of rows; spans[0] is row *first.
 */
int core_raster_spans(struct core_raster *r, const struct cover_triangle *t, struct sheen_rect rect, struct span *spans,
                      int *first);

/* Draws the triangle, by its shader: depths, z16, and pixels, both of core_raster_begin's size. */
void core_raster_draw(struct core_raster *r, uint16_t *depth, uint16_t *pixels);

/* The triangle's depths, z16, where they are nearer than what is there: width x height of core_raster_begin. */
void core_raster_depths(struct core_raster *r, uint16_t *depth);

#endif
