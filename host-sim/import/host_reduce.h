/*
 * host_reduce.h - a host mesh of fewer triangles.
 */
#ifndef SHEEN_HOST_REDUCE_H
#define SHEEN_HOST_REDUCE_H

#include "host_mesh.h"

/*
 * The place of each vertex: vertices that stand at one point and differ in their normal alone have one number.
 * 0, or SHEEN_ERR_MEMORY.
 */
int sheen_host_places(const struct sheen_host_mesh *mesh, uint32_t *place, size_t *count);

/*
 * At most options->reduce triangles where the mesh has more, as near to its shape as can be. What is left are
 * corners of the mesh before, at the same places; each keeps that one of its vertex' normals that is nearest to its
 * new face, so that a smooth mesh stays as smooth and edges stay edges. With options->by_group the borders between
 * groups stay, and so do the seams of uv and of colours. A note tells how far off it is. Errors as
 * sheen_host_mesh_build; *mesh is freed then.
 */
int sheen_host_mesh_reduce(struct sheen_host_mesh *mesh, const struct sheen_host_options *options, const char *name,
                           struct sheen_problem *problem);

#endif
