/*
 * host_reduce.h - a host mesh with fewer triangles.
 */
#ifndef SHEEN_HOST_REDUCE_H
#define SHEEN_HOST_REDUCE_H

#include "host_mesh.h"

/*
 * Numbers the places of vertices: vertices at the same point that differ only in their normal get the same number.
 * 0, or SHEEN_ERR_MEMORY.
 */
int sheen_host_places(const struct sheen_host_mesh *mesh, uint32_t *place, size_t *count);

/*
 * Reduces the mesh to at most options->reduce triangles if it has more, keeping its shape as well as possible. Vertices
 * that are left stay where they were; each corner keeps the one of its vertex's normals that is nearest to its new
 * face, so that a smooth mesh stays smooth and edges stay edges. With options->by_group the borders between groups
 * stay, and so do seams of uv and colours. A note says how large the error is. Errors as of sheen_host_mesh_build;
 * *mesh is freed then.
 */
int sheen_host_mesh_reduce(struct sheen_host_mesh *mesh, const struct sheen_host_options *options, const char *name,
                           struct sheen_problem *problem);

#endif
