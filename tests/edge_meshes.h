/*
 * edge_meshes.h - the meshes on which edges are tested, for the reference and for the core: a teapot, a gear, a rabbit
 * and a cube.
 */
#ifndef EDGE_MESHES_H
#define EDGE_MESHES_H

#include "core_picture.h"
#include "loaded_mesh.h"
#include "shapes.h"

enum edge_mesh_name {
    EDGE_TEAPOT,
    EDGE_GEAR,
    EDGE_RABBIT,
    EDGE_MESHES, /* smoothing is tested on those above */
    EDGE_CUBE = EDGE_MESHES,
    EDGE_ALL_MESHES
};

struct edge_mesh {
    const char *name;
    const struct ref_mesh *reference;
    struct sheen_mesh mesh; /* with its edges */
    struct loaded_mesh loaded;
    struct shape shape;
    struct ref_mesh own_reference;
    struct core_mesh own;
    struct sheen_triangle_edges *edges;
};

/* 0 or -1. Release with edge_mesh_free. */
int edge_mesh_make(struct edge_mesh *mesh, enum edge_mesh_name which);
void edge_mesh_free(struct edge_mesh *mesh);

#endif
