/*
 * mesh_format.c - chooses the reader of a mesh file from the table of formats.
 */
#include "mesh_format.h"

#include <stdio.h>
#include <string.h>

#include "mesh_assimp.h"
#include "mesh_bytes.h"
#include "mesh_file.h"
#include "mesh_gltf.h"
#include "mesh_readers.h"

static const struct format {
    const char *endings; /* each followed by a blank */
    const char *words;   /* first words of such files after comments, between blanks */
    sheen_mesh_reader *read;
} formats[] = {
    {".obj ", " v vn vt vp mtllib usemtl o g ", sheen_mesh_obj_read},
    {".ply ", " ply ", sheen_mesh_ply_read},
    {".off .coff .noff .cnoff ", " off coff noff cnoff stoff stcoff stnoff stcnoff ", sheen_mesh_off_read},
    {".stl .stlb .stla ", " solid ", sheen_mesh_stl_read},
    {".gltf .vrm ", " { ", sheen_mesh_gltf_read},
    {".glb ", " gltf ", sheen_mesh_gltf_read},
};

static sheen_mesh_reader *by_ending(const char *path)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name ? name : path, '.');
    char ending[16];

    if (!dot || snprintf(ending, sizeof ending, "%s ", dot) >= (int)sizeof ending)
        return NULL;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (strcasestr(formats[i].endings, ending))
            return formats[i].read;
    }
    return sheen_mesh_assimp_knows(dot) ? sheen_mesh_assimp_read : NULL;
}

/* Only its size tells a binary STL. */
static int is_binary_stl(const struct sheen_bytes *bytes)
{
    const unsigned char *count = bytes->bytes + 80;

    return bytes->count >= 84 && bytes->count == 84 + 50 * ((size_t)count[0] | (size_t)count[1] << 8 |
                                                            (size_t)count[2] << 16 | (size_t)count[3] << 24);
}

static sheen_mesh_reader *by_content(struct sheen_bytes *bytes)
{
    struct sheen_word first;

    if (is_binary_stl(bytes))
        return sheen_mesh_stl_read;
    if (sheen_bytes_to_utf8(bytes) != 0)
        return NULL;
    struct sheen_text text = {
        .at = (const char *)bytes->bytes, .end = (const char *)bytes->bytes + bytes->count, .comments = 1};
    if (!sheen_text_any_word(&text, &first))
        return NULL;
    if (first.at[0] == '{')
        first.length = 1; /* JSON: other characters may follow without a blank */
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (sheen_word_is_of(&first, formats[i].words))
            return formats[i].read;
    }
    return NULL;
}

int sheen_mesh_format_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    sheen_mesh_reader *reader = by_ending(path);
    struct sheen_bytes bytes;

    *polygons = (struct sheen_polygons){.target = polygons->target};
    if (!reader && sheen_bytes_load(&bytes, path, problem) == 0) {
        reader = by_content(&bytes);
        sheen_bytes_free(&bytes);
    }
    return (reader ? reader : sheen_mesh_assimp_read)(polygons, path, problem);
}
