/*
 * host_border.h - whether an eye sees the inside of a mesh that is not closed.
 */
#ifndef SHEEN_HOST_BORDER_H
#define SHEEN_HOST_BORDER_H

#include "host_mesh.h"

/*
 * 1 if triangles at the mesh's border, which is where an edge belongs to one triangle only, are seen from behind by an
 * eye at that place (in the mesh's fitted coordinates) and not hidden by what it sees from the front, in more than a
 * few pixels. Only one place near the border in some of these triangles is looked at: 0 does not mean that there is no
 * hole. SHEEN_ERR_MEMORY on failure.
 */
int sheen_host_border_is_seen(const struct sheen_host_mesh *mesh, const double eye[3]);

#endif
