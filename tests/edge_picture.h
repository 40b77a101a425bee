/*
 * edge_picture.h - draws meshes with their edges by the core.
 */
#ifndef EDGE_PICTURE_H
#define EDGE_PICTURE_H

#include "edge_meshes.h"

/* How a scene is drawn; all zero: no edges, RGB565 high byte first, bands of 16 rows, one buffer, one worker. */
struct edge_drawing {
    const struct sheen_edges *edges;
    enum sheen_pixel pixel;
    int band_rows;
    int buffers, workers;
    bool bottom_up; /* bands from the bottom to the top */
    bool second;    /* draw the mesh elsewhere in a frame before, so that only parts of the bands are drawn */
    uint8_t line[3];
};

/* values: 565 or grey levels, row by row. 0, or the error of the call that failed. */
int edge_picture(uint16_t *values, const struct ref_scene *scene, const struct sheen_mesh *mesh,
                 const struct edge_drawing *drawing);

/* The channels of a value, 0..1. */
void edge_channels(double out[3], const struct edge_drawing *drawing, unsigned value);

#endif
