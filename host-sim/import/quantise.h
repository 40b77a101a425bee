/*
 * quantise.h - a host mesh in the core's integers. The command and the baker both come here,
 * so a baked mesh and the file that it came from are the same bits.
 *
 * Positions: round(32767 p), the mesh's scale being 32768/32767, offset 0; off by at most
 * 1/65534 of the fitted radius an axis. Normals: of the eight lattice points around 32767 n
 * the one nearest in direction: at most 2.1e-5 rad off, 0.8e-5 in the mean, over 10^5 directions.
 * Texture coordinates, of a part that shows a texture: the finest grid of 2^-15 to 1 that holds them all in 16 bits,
 * the offset on it; off by at most half a step. Where they repeat they are moved by whole numbers first.
 */
#ifndef SHEEN_QUANTISE_H
#define SHEEN_QUANTISE_H

#include "host_mesh.h"
#include "sheen.h"

struct sheen_quantised {
    struct sheen_mesh mesh; /* points into the arrays below */
    int16_t *positions, *normals, *polygon_normals;
    int16_t *uvs;       /* NULL: shows no texture. 2 a vertex, v downwards */
    uint8_t *colors;    /* NULL: the file has none, or they were not asked for. 3 a vertex */
    uint16_t *polygons; /* NULL where every polygon is a triangle */
    uint8_t *warp;
    struct sheen_triangle_edges *edges;
    void *indices;
    uint32_t polygon_count;
    struct sheen_mesh second; /* the other frame, on the same grid; its positions are NULL where there is none */
    int16_t *second_positions, *second_normals, *second_polygon_normals;
};

#define SHEEN_ALL_PARTS UINT32_MAX

/*
 * The polygons of one part of the host mesh or of all of them, then without texture, in its order. 0, or
 * SHEEN_ERR_MEMORY. On error nothing is left to free.
 */
int sheen_quantise(struct sheen_quantised *out, const struct sheen_host_mesh *host, uint32_t part);
void sheen_quantised_free(struct sheen_quantised *quantised);

/* A unit vector to int16, 1.0 = 32767. */
void sheen_quantise_unit(const double unit[3], int16_t out[3]);

#endif
