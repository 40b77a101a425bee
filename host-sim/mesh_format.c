/*
 * mesh_format.c - which reader a mesh file gets: the table of formats.
 */
#include "mesh_format.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "mesh_assimp.h"
#include "mesh_file.h"
#include "mesh_gltf.h"

static const struct format {
    const char *endings; /* each followed by a blank */
    const char *magic;   /* the file's first bytes, or NULL where they tell nothing */
    sheen_mesh_reader *read;
} formats[] = {
    {".obj ", NULL, sheen_mesh_assimp_read},     {".ply ", "ply", sheen_mesh_assimp_read},
    {".off ", "OFF", sheen_mesh_assimp_read},    {".stl .stlb .stla ", "solid ", sheen_mesh_assimp_read},
    {".gltf .vrm ", NULL, sheen_mesh_gltf_read}, {".glb ", "glTF", sheen_mesh_gltf_read},
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
    FILE *file = fopen(path, "rb");
    size_t count = file ? fread(magic, 1, room, file) : 0;

    if (file)
        fclose(file);
    return count;
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
        const char *expect = formats[i].magic;
        if (expect && count >= strlen(expect) && memcmp(magic, expect, strlen(expect)) == 0)
            return formats[i].read;
    }
    return sheen_mesh_assimp_read;
}

int sheen_mesh_format_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    return choose(path)(polygons, path, problem);
}
