/*
 * test_gltf_picture.c - glTF files as they are imported and drawn, against the reference's own reading of the same
 * numbers.
 *
 * A wavy sheet with uvs and colours is written as three kinds of files: binary with the picture inside, floats and a
 * texture transform; as JSON with buffer and picture in files of their own, 16-bit numbers, a node that turns it, and a
 * base colour; binary without a texture. The functions read_* below derive from the specification, in double precision,
 * what these files mean. The import must agree with that corner by corner, and the picture that the core draws of it
 * must stay within its shading's limits of the reference's picture. Readings with a mistake in them must be refused.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "accuracy.h"
#include "png_file.h"
#include "quantise.h"
#include "texels.h"

#define ACROSS 12 /* quads */
#define DOWN 8
#define POINTS ((ACROSS + 1) * (DOWN + 1))
#define TRIANGLES (2 * ACROSS * DOWN)
#define SIDE 16 /* texels */

/* What a file holds, and how. */
enum kind {
    INSIDE, /* a GLB that contains everything, floats; nearest texels */
    BESIDE, /* separate files, a node's transform, unsigned shorts, clamped; bilinear texels */
    PLAIN,  /* a GLB without texture */
    KINDS
};
static const char *const kind_name[KINDS] = {"inside.glb", "beside.gltf", "plain.glb"};

/* Mistakes put into the reference's reading. */
enum mistake {
    NONE,
    LINEAR,    /* colours taken as if they were encoded already */
    CLOCKWISE, /* uv rotated in the wrong direction */
    WHITE,     /* without the base colour factor */
    MISTAKES
};
static const char *const mistake_name[MISTAKES] = {"", "linear colours", "uv turned clockwise", "no base colour"};

/* The transform of baseColorTexture, for each kind of file. */
static const double offset[KINDS][2] = {{0.1, 0.25}, {-0.15, -0.1}, {0, 0}};
static const double scale[KINDS][2] = {{2, 1.5}, {1.3, 1.2}, {1, 1}}, rotation[KINDS] = {0.4, 0, 0};
static const double factor[KINDS][3] = {{1, 1, 1}, {0.5, 0.8, 0.35}, {0.9, 0.3, 0.6}};

/* ---- what is written ---- */

struct numbers {
    float position[POINTS][3], uv[POINTS][2], color[POINTS][3];
    uint16_t short_uv[POINTS][2], short_color[POINTS][4], index[TRIANGLES][3];
    uint8_t rgba[SIDE * SIDE][4];
    unsigned char png[8192];
    size_t png_bytes;
};

static void make_points(struct numbers *n)
{
    for (int i = 0; i < POINTS; i++) {
        const double u = (double)(i % (ACROSS + 1)) / ACROSS, v = (double)(i / (ACROSS + 1)) / DOWN;
        n->position[i][0] = (float)(3 * u - 1.5);
        n->position[i][1] = (float)(0.25 * sin(7 * u) * cos(5 * v));
        n->position[i][2] = (float)(2 * v - 1);
        for (int k = 0; k < 2; k++) {
            n->uv[i][k] = (float)(k ? v : u);
            n->short_uv[i][k] = (uint16_t)lround(65535 * (k ? v : u));
        }
        for (int k = 0; k < 3; k++) {
            n->color[i][k] = (float)(0.5 + 0.45 * sin(4 * u + 6 * v + 2 * k));
            n->short_color[i][k] = (uint16_t)lround(65535 * (0.5 + 0.45 * cos(5 * u - 4 * v + 2 * k)));
        }
        n->short_color[i][3] = 65535;
    }
    for (int t = 0; t < TRIANGLES; t++) {
        const int quad = t / 2, at = quad / ACROSS * (ACROSS + 1) + quad % ACROSS;
        n->index[t][0] = (uint16_t)at;
        n->index[t][1] = (uint16_t)(t & 1 ? at + ACROSS + 2 : at + ACROSS + 1);
        n->index[t][2] = (uint16_t)(t & 1 ? at + 1 : at + ACROSS + 2);
    }
}

/* The picture's bytes, written to a file and read back: squares of 2 by 2 texels, bytes that 565 has to round. */
static int make_picture(struct numbers *n)
{
    struct sheen_problem problem;

    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE / 2, y = i / SIDE / 2;
        const uint8_t rgba[4] = {(uint8_t)(25 + 26 * x), (uint8_t)(250 - 29 * y), (uint8_t)(80 + 150 * ((x ^ y) & 1)),
                                 255};
        memcpy(n->rgba[i], rgba, sizeof rgba);
    }
    if (sheen_png_write_rgba("t.png", n->rgba[0], SIDE, SIDE, &problem) != 0)
        return -1;
    FILE *file = fopen("t.png", "rb");
    n->png_bytes = file ? fread(n->png, 1, sizeof n->png, file) : 0;
    return file && fclose(file) == 0 && n->png_bytes > 0 ? 0 : -1;
}

/* A buffer of views, one after another, each starting at a multiple of 4. */
struct buffer {
    unsigned char bytes[65536];
    size_t count, at[5], length[5];
    int views;
};

static void add_view(struct buffer *b, const void *bytes, size_t count)
{
    memcpy(b->bytes + b->count, bytes, count);
    b->at[b->views] = b->count;
    b->length[b->views++] = count;
    b->count += (count + 3) & ~(size_t)3;
}

static void fill_buffer(struct buffer *b, const struct numbers *n, enum kind kind)
{
    memset(b, 0, sizeof *b);
    add_view(b, n->position, sizeof n->position);
    add_view(b, kind == BESIDE ? (const void *)n->short_uv : n->uv, kind == BESIDE ? sizeof n->short_uv : sizeof n->uv);
    add_view(b, kind == BESIDE ? (const void *)n->short_color : n->color,
             kind == BESIDE ? sizeof n->short_color : sizeof n->color);
    add_view(b, n->index, sizeof n->index);
    if (kind == INSIDE)
        add_view(b, n->png, n->png_bytes);
}

static int write_json(char *to, size_t room, const struct buffer *b, enum kind kind)
{
    const char *const number = kind == BESIDE ? "5123,\"normalized\":true" : "5126";
    char views[600] = "", material[600], *end = views;

    for (int i = 0; i < b->views; i++)
        end += sprintf(end, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", i ? "," : "", b->at[i],
                       b->length[i]);
    int used = sprintf(material, "{\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":[%g,%g,%g,1]",
                       factor[kind][0], factor[kind][1], factor[kind][2]);
    if (kind != PLAIN)
        used +=
            sprintf(material + used,
                    ",\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"offset\":[%g,%g],"
                    "\"scale\":[%g,%g],\"rotation\":%g}}}",
                    offset[kind][0], offset[kind][1], scale[kind][0], scale[kind][1], rotation[kind]);
    sprintf(material + used, "}}");
    return snprintf(
        to, room,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0%s}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"COLOR_0\":2},\"indices\":3,"
        "\"material\":0}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\","
        "\"min\":[-2,-2,-2],\"max\":[2,2,2]},{\"bufferView\":1,\"componentType\":%s,\"count\":%d,\"type\":\"VEC2\"},"
        "{\"bufferView\":2,\"componentType\":%s,\"count\":%d,\"type\":\"%s\"},"
        "{\"bufferView\":3,\"componentType\":5123,\"count\":%d,\"type\":\"SCALAR\"}],\"bufferViews\":[%s],"
        "\"buffers\":[{\"byteLength\":%zu%s}],\"materials\":[%s]%s}",
        kind == BESIDE ? ",\"translation\":[3,-2,5],\"rotation\":[0.5,0,0,0.8660254037844386],\"scale\":[2,2,2]" : "",
        POINTS, number, POINTS, number, POINTS, kind == BESIDE ? "VEC4" : "VEC3", 3 * TRIANGLES, views, b->count,
        kind == BESIDE ? ",\"uri\":\"b.bin\"" : "", material,
        kind == PLAIN ? ""
        : kind == INSIDE
            ? ",\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":4,\"mimeType\":\"image/png\"}]"
            : ",\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":33071,\"wrapT\":33071}],"
              "\"images\":[{\"uri\":\"t.png\"}]");
}

static int write_file(const char *name, const void *bytes, size_t count)
{
    FILE *file = fopen(name, "wb");

    return file && fwrite(bytes, 1, count, file) == count && fclose(file) == 0 ? 0 : -1;
}

static unsigned char *put_word(unsigned char *to, size_t word)
{
    for (int i = 0; i < 4; i++)
        *to++ = (unsigned char)(word >> 8 * i & 0xff);
    return to;
}

static int write_mesh(const struct numbers *n, enum kind kind)
{
    static struct buffer b;
    static unsigned char glb[sizeof b.bytes + 8192];
    char json[4096];

    fill_buffer(&b, n, kind);
    size_t length = (size_t)write_json(json, sizeof json - 4, &b, kind);
    if (kind == BESIDE)
        return write_file("b.bin", b.bytes, b.count) | write_file(kind_name[kind], json, length);
    while (length % 4)
        json[length++] = ' ';
    unsigned char *end = put_word(put_word(put_word(glb, 0x46546c67), 2), 28 + length + b.count);
    end = put_word(put_word(end, length), 0x4e4f534a);
    memcpy(end, json, length);
    end = put_word(put_word(end + length, b.count), 0x004e4942);
    memcpy(end, b.bytes, b.count);
    return write_file(kind_name[kind], glb, 28 + length + b.count);
}

/* ---- what it says ---- */

static double encoded(double linear, enum mistake mistake)
{
    const double x = fmin(fmax(linear, 0), 1);

    return mistake == LINEAR ? x : x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
}

static double byte_of(double x)
{
    return floor(255 * x + 0.5) / 255;
}

static void read_position(const struct numbers *n, enum kind kind, int i, double to[3])
{
    const double x = (double)n->position[i][0], y = (double)n->position[i][1], z = (double)n->position[i][2];
    const double c = 0.5, s = sqrt(0.75); /* 60 degrees around x; the node's quaternion is (1/2, 0, 0, cos 30) */

    to[0] = kind == BESIDE ? 3 + 2 * x : x;
    to[1] = kind == BESIDE ? -2 + 2 * (c * y - s * z) : y;
    to[2] = kind == BESIDE ? 5 + 2 * (s * y + c * z) : z;
}

/* Scaled, rotated counter-clockwise as seen with v pointing down, then moved. */
static void read_uv(const struct numbers *n, enum kind kind, enum mistake mistake, int i, double to[2])
{
    const double u = kind == BESIDE ? n->short_uv[i][0] / 65535.0 : (double)n->uv[i][0];
    const double v = kind == BESIDE ? n->short_uv[i][1] / 65535.0 : (double)n->uv[i][1];
    const double angle = mistake == CLOCKWISE ? -rotation[kind] : rotation[kind], c = cos(angle), s = sin(angle);

    to[0] = c * scale[kind][0] * u + s * scale[kind][1] * v + offset[kind][0];
    to[1] = -s * scale[kind][0] * u + c * scale[kind][1] * v + offset[kind][1];
}

static void read_color(const struct numbers *n, enum kind kind, enum mistake mistake, int i, double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = byte_of(encoded(kind == BESIDE ? n->short_color[i][k] / 65535.0 : (double)n->color[i][k], mistake));
}

static int read_mesh(struct ref_mesh *mesh, const struct numbers *n, enum kind kind, enum mistake mistake)
{
    static const struct ref_mesh_options fit = {.fit = true, .crease = -1};
    static double point[POINTS][3], uv[3 * TRIANGLES][2], color[3 * TRIANGLES][3];
    static uint32_t first[TRIANGLES + 1], corner[3 * TRIANGLES];
    const struct ref_polygons polygons = {.points = (const double(*)[3])point,
                                          .point_count = POINTS,
                                          .first = first,
                                          .polygon_count = TRIANGLES,
                                          .corners = corner,
                                          .uv = kind == PLAIN ? NULL : (const double(*)[2])uv,
                                          .color = (const double(*)[3])color};

    for (int i = 0; i < POINTS; i++)
        read_position(n, kind, i, point[i]);
    for (uint32_t c = 0; c < 3 * TRIANGLES; c++) {
        const int i = n->index[c / 3][c % 3];
        corner[c] = (uint32_t)i;
        first[c / 3 + 1] = c / 3 * 3 + 3;
        read_uv(n, kind, mistake, i, uv[c]);
        read_color(n, kind, mistake, i, color[c]);
    }
    return ref_mesh_build(mesh, &polygons, &fit);
}

static struct ref_texture read_texture(const struct numbers *n, enum kind kind)
{
    static uint16_t texels[SIDE * SIDE];
    const bool clamp = kind == BESIDE;

    for (int i = 0; i < SIDE * SIDE; i++) {
        const double color[3] = {n->rgba[i][0] / 255.0, n->rgba[i][1] / 255.0, n->rgba[i][2] / 255.0};
        texels[i] = ref_565(color);
    }
    return (struct ref_texture){
        .width = SIDE, .height = SIDE, .texels = texels, .bits = 16, .clamp = {clamp, clamp}, .bilinear = clamp};
}

static void set_scene(struct ref_scene *scene, const struct ref_mesh *mesh, enum kind kind, enum mistake mistake)
{
    accuracy_view(scene, mesh, 1);
    ref_scene_orbit(scene, 25, kind == BESIDE ? -10 : 50, 5, 2.4);
    scene->width = scene->height = 240;
    scene->shading = REF_GOURAUD;
    scene->two_sided = scene->colored = true;
    for (int k = 0; k < 3; k++)
        scene->base[k] = mistake == WHITE ? 1 : byte_of(encoded(factor[kind][k], mistake));
}

/* ---- what was imported ---- */

static int import(struct sheen_host_mesh *host, enum kind kind)
{
    static const struct sheen_texture_options textures = {.most = 512, .cutoff = -1};
    const struct sheen_host_options options = {.colors = 1, .textures = &textures};
    struct sheen_problem problem;

    if (sheen_host_mesh_load(host, kind_name[kind], &options, &problem) == 0)
        return 0;
    printf("  FAILED %s\n", problem.text);
    return -1;
}

/* The number of corners whose uv or colour differs from the reference's. */
static long differing_corners(const struct sheen_host_mesh *host, const struct ref_mesh *mesh)
{
    long differ = host->triangle_count != mesh->triangle_count;

    for (size_t t = 0; t < mesh->triangle_count && differ == 0; t++) {
        for (int k = 0; k < 3; k++) {
            const struct sheen_host_vertex *v = &host->vertices[host->triangles[t].vertex[k]];
            const uint32_t c = mesh->triangles[t].corner[k];
            double off = 0;
            for (int i = 0; i < 3; i++)
                off = fmax(off, fabs(v->color[i] - 255 * mesh->color[c][i]));
            for (int i = 0; i < 2 && mesh->uv; i++)
                off = fmax(off, fabs(v->uv[i] - mesh->uv[c][i]));
            differ += off > 1e-6;
        }
    }
    return differ;
}

/* Compares the picture that the core draws of the import with the reference's; true if it is within the limits. */
static bool is_kept(struct accuracy_shot *shot, struct ref_scene *scene, const struct ref_picture *picture,
                    const struct sheen_host_mesh *host)
{
    struct ref_texture imported = {.width = SIDE, .height = SIDE, .bits = 16};
    struct sheen_texels texels = {.values = NULL};
    struct sheen_quantised quantised;
    bool made = sheen_quantise(&quantised, host, 0) == 0, kept = false;

    if (!made)
        return false;
    if (scene->texture) {
        imported.bilinear = scene->texture->bilinear;
        made = host->picture_count == 1 && host->picture[0].size[0] == SIDE && host->picture[0].size[1] == SIDE &&
               sheen_texels_make(&texels, &host->picture[0], 0, imported.bilinear) == 0;
        imported.texels = texels.values;
        imported.clamp[0] = texels.texture.clamp_u;
        imported.clamp[1] = texels.texture.clamp_v;
        scene->texture = &imported;
    }
    for (int k = 0; k < 3; k++)
        scene->base[k] = host->group[0].has_color ? host->group[0].color[k] / 255.0 : 1;
    if (made && accuracy_shoot(shot, scene, picture, &quantised.mesh, 0) == SHEEN_OK) {
        const struct ref_score *s = &shot->score;
        kept = imported.bilinear ? (double)s->calm_equal >= ACCURACY_BILINEAR * (double)s->calm && s->beyond == 0 &&
                                       (double)s->compared >= ACCURACY_COMPARED * (double)s->covered
                                 : accuracy_kept(s, REF_GOURAUD, ACCURACY_COMPARED);
    }
    sheen_texels_free(&texels);
    sheen_quantised_free(&quantised);
    return kept;
}

static int judge(const struct numbers *n, enum kind kind, enum mistake mistake)
{
    static struct accuracy_shot shot;
    struct ref_texture texture = read_texture(n, kind);
    struct sheen_host_mesh host;
    struct ref_mesh mesh;
    struct ref_scene scene;
    struct ref_picture picture;

    if (import(&host, kind) != 0 || read_mesh(&mesh, n, kind, mistake) != 0)
        return 1;
    set_scene(&scene, &mesh, kind, mistake);
    scene.texture = kind == PLAIN ? NULL : &texture;
    if (ref_render(&picture, &scene) != 0)
        return 1;
    const bool kept = is_kept(&shot, &scene, &picture, &host);
    const long corners = differing_corners(&host, &mesh);
    const bool wrong = mistake == NONE ? !kept || corners > 0 : kept;
    printf("%-12s %-20s %5.1f %% compared, %6.2f %% equal, worst %d, %ld corners differ: %s%s\n", kind_name[kind],
           mistake_name[mistake],
           100.0 * (double)shot.score.compared / (double)(shot.score.covered + !shot.score.covered),
           100.0 * (double)shot.score.calm_equal / (double)(shot.score.calm + !shot.score.calm), shot.score.worst,
           corners, kept ? "kept" : "refused", wrong ? "  FAILED" : "");
    ref_picture_free(&picture);
    ref_mesh_free(&mesh);
    sheen_host_mesh_free(&host);
    return wrong;
}

int main(void)
{
    static const struct {
        enum kind kind;
        enum mistake mistake;
    } mistaken[] = {{INSIDE, LINEAR}, {INSIDE, CLOCKWISE}, {BESIDE, LINEAR}, {BESIDE, WHITE}, {PLAIN, WHITE}};
    static struct numbers numbers;
    char place[] = "/tmp/gltf_picture.XXXXXX";
    int failed = 0;

    if (!mkdtemp(place) || chdir(place) != 0)
        return 2;
    make_points(&numbers);
    failed += make_picture(&numbers) != 0;
    for (int kind = 0; kind < KINDS; kind++)
        failed += write_mesh(&numbers, (enum kind)kind) != 0 || judge(&numbers, (enum kind)kind, NONE);
    for (size_t i = 0; i < sizeof mistaken / sizeof *mistaken; i++)
        failed += judge(&numbers, mistaken[i].kind, mistaken[i].mistake);
    for (int kind = 0; kind < KINDS; kind++)
        remove(kind_name[kind]);
    remove("t.png");
    remove("b.bin");
    failed += chdir("/") != 0 || rmdir(place) != 0;
    printf("%d failed\n", failed);
    return failed != 0;
}
