/*
 * mesh_assimp.c - reads mesh files with assimp's C interface. Runs in the confined child (mesh_file.c).
 */
#include "mesh_assimp.h"

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "mesh_assimp_io.h"
#include "mesh_dae_check.h"
#include "mesh_sink.h"
#include "utf8.h"

#define MAX_DEPTH 1000 /* nested nodes; more mean a broken file and would exhaust the stack */

/* The nodes are walked twice: first to count, then to fill the arrays. */
struct walk {
    const struct aiScene *scene;
    struct sheen_polygons *out; /* NULL while counting */
    size_t points, polygons, corners;
    int with_normals, with_colors, with_uvs;
    int has_pictures; /* 1: a mesh with uv has a material with a picture */
    int broken;       /* an index out of range, or too many of something */
};

/* 4 x 4, row by row, in double precision. */
static void multiply(const double a[16], const struct aiMatrix4x4 *b, double out[16])
{
    const float *r = &b->a1;

    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            out[4 * i + j] = 0;
            for (int k = 0; k < 4; k++)
                out[4 * i + j] += a[4 * i + k] * (double)r[4 * k + j];
        }
    }
}

static void transform_point(const double m[16], const struct aiVector3D *v, double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = m[4 * k] * (double)v->x + m[4 * k + 1] * (double)v->y + m[4 * k + 2] * (double)v->z + m[4 * k + 3];
    }
}

/*
 * Normals are transformed by the cofactors, which are the inverse's transpose times the
 * determinant and exist for flattening transforms too. Returns the determinant.
 */
static double cofactors(const double m[16], double out[9])
{
    for (int i = 0; i < 3; i++) {
        const double *a = m + 4 * ((i + 1) % 3), *b = m + 4 * ((i + 2) % 3);
        for (int j = 0; j < 3; j++) {
            int u = (j + 1) % 3, v = (j + 2) % 3;
            out[3 * i + j] = a[u] * b[v] - a[v] * b[u];
        }
    }
    return m[0] * out[0] + m[1] * out[1] + m[2] * out[2];
}

static void transform_normal(const double c[9], double sign, const struct aiVector3D *v, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = sign * (c[3 * k] * (double)v->x + c[3 * k + 1] * (double)v->y + c[3 * k + 2] * (double)v->z);
}

static int has_picture(const struct aiMaterial *material)
{
    return aiGetMaterialTextureCount(material, aiTextureType_DIFFUSE) > 0 ||
           aiGetMaterialTextureCount(material, aiTextureType_BASE_COLOR) > 0;
}

static void count_mesh(struct walk *walk, const struct aiMesh *mesh)
{
    walk->points += mesh->mNumVertices;
    walk->broken |= mesh->mMaterialIndex >= walk->scene->mNumMaterials || mesh->mMaterialIndex > UINT16_MAX;
    walk->with_normals |= mesh->mNormals != NULL;
    walk->with_colors |= mesh->mColors[0] != NULL;
    walk->with_uvs |= mesh->mTextureCoords[0] != NULL;
    walk->has_pictures |=
        !walk->broken && mesh->mTextureCoords[0] && has_picture(walk->scene->mMaterials[mesh->mMaterialIndex]);
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        for (unsigned c = 0; c < face->mNumIndices; c++)
            walk->broken |= face->mIndices[c] >= mesh->mNumVertices;
        if (face->mNumIndices < 3)
            continue;
        walk->polygons++;
        walk->corners += face->mNumIndices;
    }
}

static void get_color(const struct aiColor4D *from, uint8_t color[3])
{
    const float parts[3] = {from->r, from->g, from->b};

    for (int k = 0; k < 3; k++)
        color[k] = sheen_color_byte((double)parts[k], 1);
}

/* Turns v downwards. A NaN becomes infinite, because NaN stands for a missing uv (polygons.h). */
static void get_uv(const struct aiVector3D *from, double uv[2])
{
    const double v = 1 - (double)from->y;

    uv[0] = isnan(from->x) ? (double)INFINITY : (double)from->x;
    uv[1] = isnan(v) ? (double)INFINITY : v;
}

/* A mirroring transform turns faces inside out, so their corners are added in reverse order. */
static void fill_face(struct walk *walk, const struct aiMesh *mesh, const struct aiFace *face, const double c[9],
                      int mirrored)
{
    static const struct aiColor4D white = {1, 1, 1, 1};
    struct sheen_polygons *out = walk->out;

    for (unsigned i = 0; i < face->mNumIndices; i++) {
        unsigned index = face->mIndices[mirrored ? face->mNumIndices - 1 - i : i];
        out->corners[walk->corners] = (uint32_t)(walk->points + index);
        if (out->normals && mesh->mNormals)
            transform_normal(c, mirrored ? -1 : 1, &mesh->mNormals[index], out->normals[walk->corners]);
        if (out->colors)
            get_color(mesh->mColors[0] ? &mesh->mColors[0][index] : &white, out->colors[walk->corners]);
        if (out->uvs && mesh->mTextureCoords[0])
            get_uv(&mesh->mTextureCoords[0][index], out->uvs[walk->corners]);
        walk->corners++;
    }
    out->groups[walk->polygons] = (uint16_t)mesh->mMaterialIndex;
    out->first[++walk->polygons] = (uint32_t)walk->corners;
}

static void fill_mesh(struct walk *walk, const struct aiMesh *mesh, const double transform[16])
{
    double c[9];
    int mirrored = cofactors(transform, c) < 0;

    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        if (mesh->mFaces[f].mNumIndices >= 3)
            fill_face(walk, mesh, &mesh->mFaces[f], c, mirrored);
    }
    for (unsigned v = 0; v < mesh->mNumVertices; v++)
        transform_point(transform, &mesh->mVertices[v], walk->out->points[walk->points + v]);
    walk->points += mesh->mNumVertices;
}

static void walk_node(struct walk *walk, const struct aiNode *node, const double parent[16], int depth)
{
    double transform[16];

    if (depth > MAX_DEPTH)
        walk->broken = 1;
    if (walk->broken)
        return;
    multiply(parent, &node->mTransformation, transform);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *mesh = walk->scene->mMeshes[node->mMeshes[i]];
        if (walk->out)
            fill_mesh(walk, mesh, transform);
        else
            count_mesh(walk, mesh);
        walk->broken |= walk->corners > UINT32_MAX / 8 || walk->points > UINT32_MAX / 8;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        walk_node(walk, node->mChildren[i], transform, depth + 1);
}

static void walk_scene(struct walk *walk, const struct aiScene *scene, struct sheen_polygons *out)
{
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    *walk = (struct walk){.scene = scene, .out = out};
    walk_node(walk, scene->mRootNode, identity, 0);
}

static void read_material(const struct aiMaterial *material, struct sheen_group *group)
{
    struct aiString name;
    struct aiColor4D color;

    if (aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS)
        sheen_utf8_copy(group->name, sizeof group->name, name.data);
    if (aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &color) != aiReturn_SUCCESS &&
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &color) != aiReturn_SUCCESS)
        return;
    get_color(&color, group->color);
    group->has_color = 1;
}

static int convert(struct sheen_polygons *polygons, const struct aiScene *scene, const char *path,
                   struct sheen_problem *problem)
{
    struct walk walk;

    walk_scene(&walk, scene, NULL);
    if (walk.broken)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                             "%s: a face names a vertex or material that is not there, "
                             "or there are too many",
                             path);
    if (walk.polygons == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: no faces", path);
    int with = (walk.with_normals ? SHEEN_WITH_NORMALS : 0) | (walk.with_colors ? SHEEN_WITH_COLORS : 0) |
               (walk.with_uvs ? SHEEN_WITH_UVS : 0);
    int error =
        sheen_polygons_alloc(polygons, walk.points, walk.polygons, walk.corners, scene->mNumMaterials + 1u, with);
    if (error)
        return sheen_problem(problem, error, "%s: not enough memory", path);
    if (walk.has_pictures)
        sheen_note(&polygons->notes, SHEEN_NOTE_WARNING,
                   "%s: its own textures are not read, as Assimp reads it; --texture FILE shows one", path);
    walk_scene(&walk, scene, polygons);
    for (unsigned i = 0; i < scene->mNumMaterials; i++)
        read_material(scene->mMaterials[i], &polygons->group[i]);
    return SHEEN_OK;
}

int sheen_mesh_assimp_knows(const char *ending)
{
    return aiIsExtensionSupported(ending) == AI_TRUE;
}

/* Disables the shapes that assimp makes up for bones if a file has no faces. */
static const struct aiScene *import(const char *path)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();

    aiSetImportPropertyInteger(settings, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
    const struct aiScene *scene = aiImportFileExWithProperties(path, 0, &sheen_assimp_io, settings);
    aiReleasePropertyStore(settings);
    return scene;
}

/* Reports why assimp has no scene, in better words than assimp's if possible. */
static int explain(const char *said, const char *path, struct sheen_problem *problem)
{
    if (strstr(said, "bad_alloc") || strstr(said, "length_error"))
        return SHEEN_ERR_MEMORY; /* mesh_file.c makes the message */
    const char *ending = strrchr(path, '.');
    if (strstr(said, "No suitable reader") || !ending || !sheen_mesh_assimp_knows(ending))
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: its format is not known, by its name nor by its content",
                             path);
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, said);
}

int sheen_mesh_assimp_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    const char *ending = strrchr(path, '.');
    int checked = ending && strcasecmp(ending, ".dae") == 0, error = SHEEN_OK;

    memset(polygons, 0, sizeof *polygons);
    if (checked)
        error = sheen_dae_check(path, problem);
    if (error)
        return error;
    const struct aiScene *scene = import(path);
    if (!scene)
        return explain(aiGetErrorString(), path, problem);
    error = convert(polygons, scene, path, problem);
    aiReleaseImport(scene);
    if (!error && !checked) /* assimp silently leaves out or clamps what is broken in such a file */
        sheen_note(&polygons->notes, SHEEN_NOTE_WARNING,
                   "%s: read by Assimp, which may leave out what is broken: look at the picture", path);
    return error;
}
