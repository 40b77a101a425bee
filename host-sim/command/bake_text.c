/*
 * bake_text.c - meshes, textures, power tables and ramps as a C header.
 */
#include "bake_text.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "utf8.h"

enum {
    COLUMNS = 116,
    STRUCT_BYTES = 72 /* struct sheen_mesh with 32-bit pointers */
};

size_t sheen_bake_bytes(const struct sheen_quantised *quantised, int flat, int edges)
{
    const struct sheen_mesh *mesh = &quantised->mesh;
    size_t bytes = STRUCT_BYTES + mesh->vertices * 12u + mesh->triangles * 3u * mesh->index_bytes;

    if (mesh->uvs)
        bytes += mesh->vertices * 4u;
    if (quantised->second.positions)
        bytes += STRUCT_BYTES + mesh->vertices * 12u + (flat ? quantised->polygon_count * 6u : 0);
    if (mesh->colors)
        bytes += mesh->vertices * 3u;
    if (flat)
        bytes += quantised->polygon_count * 7u + (quantised->polygons ? mesh->triangles * 2u : 0);
    return bytes + (edges ? mesh->triangles * sizeof *mesh->edges : 0);
}

/* Writes one word of an array, on a new line if the current one is full; *column is the current line's length. */
static void put_word(FILE *stream, const char *word, size_t *column)
{
    size_t length = strlen(word);

    if (*column == 0 || *column + 1 + length > COLUMNS) {
        fputs("\n   ", stream);
        *column = 3;
    }
    fprintf(stream, " %s", word);
    *column += 1 + length;
}

static void put(FILE *stream, int64_t number, size_t *column)
{
    char text[24];

    snprintf(text, sizeof text, "%" PRId64 ",", number);
    put_word(stream, text, column);
}

static void put_signed(FILE *stream, const char *name, const char *what, const int16_t *numbers, size_t count)
{
    size_t column = 0;

    fprintf(stream, "static const int16_t %s_%s[%zu] = {", name, what, count);
    for (size_t i = 0; i < count; i++)
        put(stream, numbers[i], &column);
    fputs("\n};\n", stream);
}

/* bytes: the size of a number, 1 or 2. */
static void put_unsigned(FILE *stream, const char *name, const char *what, const void *numbers, int bytes, size_t count)
{
    size_t column = 0;

    fprintf(stream, "static const uint%d_t %s_%s[%zu] = {", 8 * bytes, name, what, count);
    for (size_t i = 0; i < count; i++)
        put(stream, bytes == 1 ? ((const uint8_t *)numbers)[i] : ((const uint16_t *)numbers)[i], &column);
    fputs("\n};\n", stream);
}

/* Per triangle: the triangles across its edges, then the bits of sharp and of inner edges. */
static void put_edges(FILE *stream, const char *name, const struct sheen_mesh *mesh)
{
    size_t column = 0;

    fprintf(stream, "static const struct sheen_triangle_edges %s_edges[%u] = {", name, mesh->triangles);
    for (size_t t = 0; t < mesh->triangles; t++) {
        const struct sheen_triangle_edges *e = &mesh->edges[t];
        char text[48];
        snprintf(text, sizeof text, "{{%u, %u, %u}, %u, %u},", e->across[0], e->across[1], e->across[2], e->sharp,
                 e->inner);
        put_word(stream, text, &column);
    }
    fputs("\n};\n", stream);
}

/* Fields are initialised in the struct's order, because C++ accepts no other. */
static void put_mesh(FILE *stream, const char *name, const struct sheen_quantised *quantised, int flat, int edges)
{
    const struct sheen_mesh *mesh = &quantised->mesh;

    put_signed(stream, name, "positions", mesh->positions, 3u * mesh->vertices);
    put_signed(stream, name, "normals", mesh->normals, 3u * mesh->vertices);
    if (flat)
        put_signed(stream, name, "polygon_normals", mesh->polygon_normals, 3u * quantised->polygon_count);
    if (flat && mesh->polygons)
        put_unsigned(stream, name, "polygons", mesh->polygons, 2, mesh->triangles);
    if (flat)
        put_unsigned(stream, name, "warp", mesh->warp, 1, quantised->polygon_count);
    put_unsigned(stream, name, "indices", mesh->indices, mesh->index_bytes, 3u * mesh->triangles);
    if (mesh->uvs)
        put_signed(stream, name, "uvs", mesh->uvs, 2u * mesh->vertices);
    if (edges)
        put_edges(stream, name, mesh);
    if (mesh->colors)
        put_unsigned(stream, name, "colors", mesh->colors, 1, 3u * mesh->vertices);

    fprintf(stream, "static const struct sheen_mesh %s = {\n", name);
    fprintf(stream, "    .positions = %s_positions,\n    .normals = %s_normals,\n", name, name);
    if (flat)
        fprintf(stream, "    .polygon_normals = %s_polygon_normals,\n", name);
    if (flat && mesh->polygons)
        fprintf(stream, "    .polygons = %s_polygons,\n", name);
    if (flat)
        fprintf(stream, "    .warp = %s_warp,\n", name);
    fprintf(stream, "    .indices = %s_indices,\n    .index_bytes = %u,\n", name, mesh->index_bytes);
    fprintf(stream, "    .vertices = %u,\n    .triangles = %u,\n", mesh->vertices, mesh->triangles);
    fprintf(stream, "    .scale = %" PRId32 ",\n    .offset = {%" PRId32 ", %" PRId32 ", %" PRId32 "},\n", mesh->scale,
            mesh->offset[0], mesh->offset[1], mesh->offset[2]);
    if (mesh->uvs)
        fprintf(stream, "    .uvs = %s_uvs,\n    .uv_bits = %u,\n    .uv_offset = {%" PRId32 ", %" PRId32 "},\n", name,
                mesh->uv_bits, mesh->uv_offset[0], mesh->uv_offset[1]);
    if (mesh->colors)
        fprintf(stream, "    .colors = %s_colors,\n", name);
    if (edges)
        fprintf(stream, "    .edges = %s_edges,\n", name);
    fputs("};\n\n", stream);
}

/* The mesh that a struct sheen_morph points to; it is called NAME_second. */
static void put_second(FILE *stream, const char *name, const struct sheen_quantised *quantised, int flat)
{
    const struct sheen_mesh *mesh = &quantised->second;

    put_signed(stream, name, "second_positions", mesh->positions, 3u * mesh->vertices);
    put_signed(stream, name, "second_normals", mesh->normals, 3u * mesh->vertices);
    if (flat)
        put_signed(stream, name, "second_polygon_normals", mesh->polygon_normals, 3u * quantised->polygon_count);
    fprintf(stream, "/* The other frame, for a struct sheen_morph of %s. */\n", name);
    fprintf(stream, "static const struct sheen_mesh %s_second = {\n    .positions = %s_second_positions,\n", name,
            name);
    fprintf(stream, "    .normals = %s_second_normals,\n", name);
    if (flat)
        fprintf(stream, "    .polygon_normals = %s_second_polygon_normals,\n", name);
    fprintf(stream, "    .vertices = %u,\n    .triangles = %u,\n    .scale = %" PRId32 ",\n};\n\n", mesh->vertices,
            mesh->triangles, mesh->scale);
}

/* NAME_texture, or if there are several, NAME_texture_0, NAME_texture_1 ... */
static void texture_name(const struct sheen_bake *bake, size_t number, char *name, size_t size)
{
    if (bake->texel_count > 1)
        snprintf(name, size, "%s_texture_%zu", bake->name, number);
    else
        snprintf(name, size, "%s_texture", bake->name);
}

static void put_texture(FILE *stream, const char *name, const struct sheen_texels *texels)
{
    const struct sheen_texture *texture = &texels->texture;
    size_t count = (size_t)1 << (texture->width_log2 + texture->height_log2);

    if (texels->indices) {
        put_unsigned(stream, name, "texels", texels->indices, 1, (count * texture->bits + 7) / 8);
        put_unsigned(stream, name, "palette", texels->palette, 2, texels->colors);
    } else {
        put_unsigned(stream, name, "texels", texels->values, 2, count);
    }
    fprintf(stream, "static const struct sheen_texture %s = {\n    .texels = %s_texels,\n", name, name);
    if (texels->indices)
        fprintf(stream, "    .palette = %s_palette,\n", name);
    fprintf(stream, "    .bits = %u,\n    .width_log2 = %u,\n    .height_log2 = %u,\n", texture->bits,
            texture->width_log2, texture->height_log2);
    fprintf(stream, "    .clamp_u = %u,\n    .clamp_v = %u,\n    .bilinear = %u,\n", texture->clamp_u, texture->clamp_v,
            texture->bilinear);
    fprintf(stream, "    .keyed = %u,\n    .key = %u,\n};\n\n", texture->keyed, texture->key);
}

static void put_textures(FILE *stream, const struct sheen_bake *bake)
{
    char name[80];

    for (size_t i = 0; i < bake->texel_count; i++) {
        texture_name(bake, i, name, sizeof name);
        put_texture(stream, name, &bake->texels[i]);
    }
}

/* Writes a name from a file, clean UTF-8, as a C string. '?' is escaped because "??" may begin a trigraph. */
static void put_string(FILE *stream, const char *text)
{
    putc('"', stream);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\' || *text == '?')
            putc('\\', stream);
        putc(*text, stream);
    }
    putc('"', stream);
}

#define TEXTURE_FIELD "    const struct sheen_texture *texture; /* NULL: none */\n"

static void put_texture_field(FILE *stream, const struct sheen_bake *bake, size_t mesh)
{
    char name[80];

    if (!bake->texel_count)
        return;
    texture_name(bake, bake->pictures[mesh] - 1u, name, sizeof name);
    fprintf(stream, ", %s%s", bake->pictures[mesh] ? "&" : "NULL", bake->pictures[mesh] ? name : "");
}

static void put_groups(FILE *stream, const struct sheen_bake *bake)
{
    fprintf(stream, "/* The parts, each with its material's base colour: one sheen_draw() for each. */\n");
    fprintf(stream,
            "static const struct {\n    const struct sheen_mesh *mesh;\n    const char *material;\n"
            "    uint8_t base[3]; /* r, g, b */\n%s} %s_groups[%zu] = {\n",
            bake->texel_count ? TEXTURE_FIELD : "", bake->name, bake->count);
    for (size_t i = 0; i < bake->count; i++) {
        const uint8_t *color = bake->groups[i].color;
        fprintf(stream, "    {&%s_%zu, ", bake->name, i);
        put_string(stream, bake->groups[i].name);
        fprintf(stream, ", {%u, %u, %u}", color[0], color[1], color[2]);
        put_texture_field(stream, bake, i);
        fputs("},\n", stream);
    }
    fputs("};\n\n", stream);
}

static void put_parts(FILE *stream, const struct sheen_bake *bake)
{
    fprintf(stream, "/* The parts, each with its texture: one sheen_draw() for each. */\n");
    fprintf(stream, "static const struct {\n    const struct sheen_mesh *mesh;\n" TEXTURE_FIELD "} %s_parts[%zu] = {\n",
            bake->name, bake->count);
    for (size_t i = 0; i < bake->count; i++) {
        fprintf(stream, "    {&%s_%zu", bake->name, i);
        put_texture_field(stream, bake, i);
        fputs("},\n", stream);
    }
    fputs("};\n\n", stream);
}

/* Writes a comment's text, at most 950 bytes, altered where it would end the comment. */
static void put_comment(FILE *stream, const char *text)
{
    char clean[951];

    sheen_utf8_copy(clean, sizeof clean, text);
    for (const char *c = clean; *c; c++)
        putc(c[0] == '*' && c[1] == '/' ? '?' : *c, stream);
}

/* The text between the lines of the include guard. It is made in memory first: the guard's name contains its hash. */
struct body {
    FILE *stream;
    char *text;
    size_t size;
};

/* FNV-1a. */
static uint32_t hash_of(const char *text, size_t size)
{
    uint32_t hash = 2166136261u;

    for (size_t i = 0; i < size; i++)
        hash = (hash ^ (unsigned char)text[i]) * 16777619u;
    return hash;
}

/*
 * The guard's name depends on the header's content: a different mesh of the same name is not skipped silently, the
 * compiler reports what is defined twice; the same header may be included twice. The pragma makes it a system header,
 * in which GCC's C++ does not warn of fields by name: at -Wextra that some are left out, before C++20 at -Wpedantic.
 */
static void put_head(FILE *stream, const struct body *body, const char *name, const char *source)
{
    char guard[80];

    snprintf(guard, sizeof guard, "%s_MESH_H_%08" PRIx32, name, hash_of(body->text, body->size));
    fputs("/* Made by `", stream);
    put_comment(stream, source);
    fprintf(stream, "`. */\n/* clang-format off */\n#ifndef %s\n#define %s\n\n#include \"sheen.h\"\n\n", guard, guard);
    fputs("#if defined(__cplusplus) && defined(__GNUC__)\n#pragma GCC system_header /* fields by name */\n#endif\n\n",
          stream);
}

static int open_body(struct body *body)
{
    body->text = NULL;
    body->stream = open_memstream(&body->text, &body->size);
    return body->stream ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

/* Writes the whole header and frees the body. */
static int close_body(struct body *body, FILE *stream, const char *name, const char *source)
{
    int failed = ferror(body->stream);

    if (fclose(body->stream) != 0 || failed) {
        free(body->text);
        return SHEEN_ERR_MEMORY;
    }
    put_head(stream, body, name, source);
    fwrite(body->text, 1, body->size, stream);
    fputs("#endif\n", stream);
    free(body->text);
    return ferror(stream) ? SHEEN_ERR_ARGUMENT : SHEEN_OK;
}

/*
 * What a program needs to know when it is compiled, for SHEEN_ARENA_DEFAULT_BYTES(): all parts together. Not enums,
 * which C++ does not like to be added if they are of different headers.
 */
static void put_counts(FILE *stream, const struct sheen_bake *bake)
{
    uint32_t vertices = 0, triangles = 0;

    for (size_t i = 0; i < bake->count; i++) {
        vertices += bake->meshes[i].mesh.vertices;
        triangles += bake->meshes[i].mesh.triangles;
    }
    fprintf(stream, "#define %s_vertices %" PRIu32 "\n#define %s_triangles %" PRIu32 "\n\n", bake->name, vertices,
            bake->name, triangles);
}

static void put_bake(FILE *stream, const struct sheen_bake *bake)
{
    for (size_t i = 0; i < bake->count; i++) {
        char name[80];
        if (bake->groups || bake->count > 1)
            snprintf(name, sizeof name, "%s_%zu", bake->name, i);
        else
            snprintf(name, sizeof name, "%s", bake->name);
        put_mesh(stream, name, &bake->meshes[i], bake->flat, bake->edges);
        if (bake->meshes[i].second.positions)
            put_second(stream, name, &bake->meshes[i], bake->flat);
    }
    put_textures(stream, bake);
    if (bake->groups)
        put_groups(stream, bake);
    else if (bake->count > 1)
        put_parts(stream, bake);
    put_counts(stream, bake);
}

int sheen_bake_text(FILE *stream, const struct sheen_bake *bake)
{
    struct body body;

    if (open_body(&body) != 0)
        return SHEEN_ERR_MEMORY;
    put_bake(body.stream, bake);
    return close_body(&body, stream, bake->name, bake->source);
}

int sheen_bake_shine_text(FILE *stream, const struct sheen_shine *shine, const char *name, const char *source)
{
    struct body body;
    size_t column = 0;

    if (open_body(&body) != 0)
        return SHEEN_ERR_MEMORY;
    fprintf(body.stream, "static const struct sheen_shine %s = {\n    .power = {", name);
    for (size_t i = 0; i < sizeof shine->power / sizeof shine->power[0]; i++)
        put(body.stream, shine->power[i], &column);
    fprintf(body.stream, "\n    },\n    .shininess = %u,\n    .shift = %u,\n};\n\n", shine->shininess, shine->shift);
    return close_body(&body, stream, name, source);
}

int sheen_bake_texture_text(FILE *stream, const struct sheen_texels *texels, const char *name, const char *source)
{
    struct body body;

    if (open_body(&body) != 0)
        return SHEEN_ERR_MEMORY;
    put_texture(body.stream, name, texels);
    return close_body(&body, stream, name, source);
}

int sheen_bake_ramp_text(FILE *stream, const struct sheen_ramp *ramp, const char *name, const char *source)
{
    struct body body;
    size_t column = 0;

    if (open_body(&body) != 0)
        return SHEEN_ERR_MEMORY;
    fprintf(body.stream,
            "static const struct sheen_ramp %s = {\n    .reader = &sheen_ramp_reader,\n    .low = %" PRId32
            ",\n    .span = %" PRId32 ",\n    .value = {",
            name, ramp->low, ramp->span);
    for (size_t i = 0; i <= SHEEN_RAMP_STEPS; i++)
        put(body.stream, ramp->value[i], &column);
    fprintf(body.stream, "\n    },\n    .steep = %u,\n};\n\n", ramp->steep);
    return close_body(&body, stream, name, source);
}
