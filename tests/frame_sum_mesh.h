/*
 * frame_sum_mesh.h - meshes computed with integers only, so that every machine makes the same ones.
 */
#ifndef FRAME_SUM_MESH_H
#define FRAME_SUM_MESH_H

#include "sheen.h"

enum sum_mesh {
    SUM_BALL,
    SUM_TORUS,
    SUM_BOX,
    SUM_MESHES,            /* most loops draw each of those above */
    SUM_GLOBE = SUM_MESHES /* part of a globe: small plane quads whose normals are linear */
};

/* The mesh is valid until the next call. */
const struct sheen_mesh *sum_mesh(enum sum_mesh which);

#endif
