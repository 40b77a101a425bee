/*
 * frame_sum_mesh.h - meshes from integers alone, so that every machine makes the same.
 */
#ifndef FRAME_SUM_MESH_H
#define FRAME_SUM_MESH_H

#include "sheen.h"

enum sum_mesh {
    SUM_BALL,
    SUM_TORUS,
    SUM_BOX,
    SUM_MESHES,            /* of which most scenes draw each */
    SUM_GLOBE = SUM_MESHES /* a part of one, of small plane quads whose normals are linear */
};

/* Lives until the next call. */
const struct sheen_mesh *sum_mesh(enum sum_mesh which);

#endif
