/*
 * mesh_format.c - which reader a mesh file gets: the table of formats.
 */
#include "mesh_format.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "mesh_assimp.h"
#include "mesh_file.h"
#include "mesh_gltf.h"
#include "mesh_readers.h"

static const struct format {
    const char *endings; /* each followed by a blank */
    const char *magics;  /* first bytes that tell, each followed by a newline; "" where none do */
    sheen_mesh_reader *read;
} formats[] = {
    {".obj ", "", sheen_mesh_obj_read},
    {".ply ", "ply\n", sheen_mesh_ply_read},
    {".off .coff .noff .cnoff ", "OFF\nCOFF\nNOFF\nCNOFF\nSTOFF\n", sheen_mesh_off_read},
    {".stl .stlb .stla ", "solid \n", sheen_mesh_stl_read},
    {".gltf .vrm ", "{\n", sheen_mesh_gltf_read},
    {".glb ", "glTF\n", sheen_mesh_gltf_read},
};

/* The ending with its dot and a blank, or "". */
static void get_ending(const char *path, char ending[16])
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name ? name : path, '.');

    ending[0] = '\0';
    if (dot && strlen(dot) < 14)
        snprintf(ending, 16, "%s ", dot);
}

static size_t read_magic(const char *path, char *magic, size_t room)
{
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* confine.h allows no other way */
    ssize_t count = file < 0 ? 0 : read(file, magic, room);

    if (file >= 0)
        close(file);
    return count < 0 ? 0 : (size_t)count;
}

static sheen_mesh_reader *choose(const char *path)
{
    char ending[16], magic[8];

    get_ending(path, ending);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (ending[0] && strcasestr(formats[i].endings, ending))
            return formats[i].read;
    }
    size_t count = read_magic(path, magic, sizeof magic);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        for (const char *m = formats[i].magics; *m; m += strcspn(m, "\n") + 1) {
            size_t length = strcspn(m, "\n");
            if (count >= length && memcmp(magic, m, length) == 0)
                return formats[i].read;
        }
    }
    return sheen_mesh_assimp_read;
}

int sheen_mesh_format_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    return choose(path)(polygons, path, problem);
}
