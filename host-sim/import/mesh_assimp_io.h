/*
 * mesh_assimp_io.h - the files that Assimp opens, each read as a whole when it is opened. Private to mesh_assimp.c.
 */
#ifndef SHEEN_MESH_ASSIMP_IO_H
#define SHEEN_MESH_ASSIMP_IO_H

#include <assimp/cfileio.h>

extern struct aiFileIO sheen_assimp_io;

#endif
