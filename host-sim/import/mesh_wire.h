/*
 * mesh_wire.h - sends polygons through a pipe, from the process that read a file to the one that asked.
 */
#ifndef SHEEN_MESH_WIRE_H
#define SHEEN_MESH_WIRE_H

#include "polygons.h"

/* error: the reader's; the polygons count only if it is 0, *problem only if it is not. 0, or -1 and errno. */
int sheen_mesh_send(int pipe, int error, const struct sheen_polygons *polygons, const struct sheen_problem *problem);

/*
 * 1: the other end's answer, with its code in *error and what belongs to it; 0: the
 * answer broke off or is invalid. The polygons' sizes are within bounds and their arrays
 * exist; their contents must be checked (sheen_polygons_check). Release with
 * sheen_polygons_free in any case.
 */
int sheen_mesh_receive(int pipe, int *error, struct sheen_polygons *polygons, struct sheen_problem *problem);

#endif
