/*
 * quantise.h - a host mesh in the core's integers. The command and the baker both quantise with
 * this, so that a baked mesh has the same bits as the file that it was baked from.
 *
 * Positions are round(32767 p), with a mesh scale of 32768/32767 and offset 0: the error is at most
 * 1/65534 of the fitted radius per axis. A normal n is the one of the eight lattice points around 32767 n
 * that is nearest in direction: over 10^5 directions at most 2.1e-5 rad off, 0.8e-5 in the mean.
 * Texture coordinates, in a part that shows a texture, lie on the finest grid of steps 2^-15 to 1 that holds them all
 * in 16 bits; the offset lies on it too, and the error is at most half a step. Coordinates that repeat are first moved
 * by whole numbers.
 */
#ifndef SHEEN_QUANTISE_H
#define SHEEN_QUANTISE_H

#include "host_mesh.h"
#include "sheen.h"

struct sheen_quantised {
    struct sheen_mesh mesh; /* points into the arrays below */
    int16_t *positions, *normals, *polygon_normals;
    int16_t *uvs;       /* 2 per vertex, v downwards; NULL: shows no texture */
    uint8_t *colors;    /* 3 per vertex; NULL: the file has none, or they were not asked for */
    uint16_t *polygons; /* NULL if every polygon is a triangle */
    uint8_t *warp;
    struct sheen_triangle_edges *edges;
    void *indices;
    uint32_t polygon_count;
    struct sheen_mesh second; /* the other frame, on the same grid; its positions are NULL if there is none */
    int16_t *second_positions, *second_normals, *second_polygon_normals;
};

#define SHEEN_ALL_PARTS UINT32_MAX

/*
 * Quantises the polygons of one part of the host mesh, or with SHEEN_ALL_PARTS of all parts, then without a texture.
 * Keeps their order. Returns 0 or SHEEN_ERR_MEMORY; after an error there is nothing to free.
 */
int sheen_quantise(struct sheen_quantised *out, const struct sheen_host_mesh *host, uint32_t part);
void sheen_quantised_free(struct sheen_quantised *quantised);

/* Quantises a unit vector to int16, 1.0 = 32767. */
void sheen_quantise_unit(const double unit[3], int16_t out[3]);

#endif
