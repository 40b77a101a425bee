/*
 * mesh_gltf.h - glTF 2.0 files. For mesh_format.c, and for tests.
 */
#ifndef SHEEN_MESH_GLTF_H
#define SHEEN_MESH_GLTF_H

#ifdef __cplusplus
extern "C" {
#endif

#include "polygons.h"

/* As sheen_mesh_file_read, but in this process: .gltf with its buffers wherever its URIs say, or .glb. */
int sheen_mesh_gltf_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

#ifdef __cplusplus
}
#endif

#endif
