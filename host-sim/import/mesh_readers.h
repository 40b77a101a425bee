/*
 * mesh_readers.h - our own readers of mesh files, each in a file of its own. For mesh_format.c, which chooses one.
 *
 * As sheen_mesh_file_read, but in this process, into *polygons, which is zeroed except for `target`. They allocate no
 * memory on a file's word: counts in a file are checked against the data.
 */
#ifndef SHEEN_MESH_READERS_H
#define SHEEN_MESH_READERS_H

#include "mesh_text.h"
#include "polygons.h"

/*
 * Wavefront OBJ: v, vt, vn, f, usemtl, mtllib. An index of a missing vt counts as none. Smoothing groups are a note if
 * there are no normals.
 */
int sheen_mesh_obj_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/* Stanford PLY, text and binary in both byte orders: vertices, faces with texcoord, tristrips, in any order. */
int sheen_mesh_ply_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/* STL, text and binary. */
int sheen_mesh_stl_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/* Geomview's OFF, COFF, NOFF, STOFF and their unions, text. */
int sheen_mesh_off_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem);

/*
 * Reads the colours (Kd) and textures (map_Kd) of an OBJ's materials from its .mtl. names: each group's, from the OBJ.
 * Anything else in the .mtl is ignored; what cannot be read is a note, and so is transparency (d, map_d). 0, or -1 if
 * there is no such file.
 */
int sheen_mtl_read(struct sheen_polygons *polygons, const struct sheen_word *names, const char *path);

#endif
