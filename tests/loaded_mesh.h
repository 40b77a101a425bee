/*
 * loaded_mesh.h - a mesh by name, built twice from what the command's reader reads: with the command's code for the
 * core, and with the reference's.
 */
#ifndef LOADED_MESH_H
#define LOADED_MESH_H

#include "quantise.h"
#include "reference/reference.h"

struct loaded_mesh {
    const char *name;
    struct ref_mesh reference;
    struct sheen_quantised quantised;
};

/* name: "builtin:..." or a file. 0, or -1 with a line on standard error. Release with loaded_mesh_free. */
int loaded_mesh_make(struct loaded_mesh *mesh, const char *name);
void loaded_mesh_free(struct loaded_mesh *mesh);

#endif
