/*
 * mesh_ply.c - Stanford PLY: the elements after the header.
 */
#include "mesh_ply.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

/* The meaning of a property; its names are in a table below. Parts of a vector are consecutive. */
enum role {
    X,
    Y,
    Z,
    NX,
    NY,
    NZ,
    RED,
    GREEN,
    BLUE,
    U,
    V,
    PICTURE,
    INDICES, /* from here on lists */
    UVS,
    ROLES
};

static const char *const role_names[ROLES] = {
    " x ",
    " y ",
    " z ",
    " nx ",
    " ny ",
    " nz ",
    " red r diffuse_red ",
    " green g diffuse_green ",
    " blue b diffuse_blue ",
    " u s texture_u ",
    " v t texture_v ",
    " texnumber ",
    " vertex_indices vertex_index ",
    " texcoord ",
};

enum element_kind {
    OTHER,
    VERTEX,
    FACE,
    STRIPS
};

static const char *const kind_words[] = {"elements that are no faces", "vertices", "faces", "tristrips"};

struct reading {
    struct sheen_ply ply;
    struct sheen_polygons *out;
    int has_uvs;        /* vertices have uv */
    int has_corner_uvs; /* faces have a list of u and v per corner; then the uv of vertices are not read */
};

/* The property of an element that has each role, and its value in the element just read. */
struct roles {
    int property[ROLES]; /* -1: none */
    double value[ROLES];
};

/* ---- faces ---- */

static int read_index(struct reading *reading, enum sheen_ply_type type, int restarts, double *index)
{
    int error = sheen_ply_whole(&reading->ply, type, "a vertex", index);

    if (!error && !(*index >= 0 && *index < (double)reading->ply.vertices) && !(restarts && *index == -1))
        return sheen_ply_problem(&reading->ply, "a face names vertex %.0f of %zu, which count from 0", *index,
                                 reading->ply.vertices);
    return error;
}

/* If vertices have normals or uv, every vertex has one, so these have the vertex's index too. */
static void put_corner(const struct reading *reading, struct sheen_sink *sink, double index)
{
    sheen_sink_corner(sink, (size_t)index, (size_t)index, reading->has_uvs ? (size_t)index : SHEEN_NONE);
}

/*
 * The first three indices of a strip make a triangle, each further index another, every second one turned around; -1
 * begins a new strip.
 */
static int read_strips(struct reading *reading, struct sheen_sink *sink, double count, enum sheen_ply_type type)
{
    double last[2] = {0, 0};
    unsigned run = 0; /* indices since the last -1 */

    for (double i = 0; i < count; i++) {
        double index;
        int error = read_index(reading, type, 1, &index);
        if (error)
            return error;
        if (index < 0) {
            run = 0;
            continue;
        }
        if (++run >= 3 && index != last[0] && index != last[1] && last[0] != last[1]) {
            put_corner(reading, sink, last[run % 2 ? 0 : 1]);
            put_corner(reading, sink, last[run % 2 ? 1 : 0]);
            put_corner(reading, sink, index);
            sheen_sink_polygon(sink, 0, NULL);
        }
        last[0] = last[1];
        last[1] = index;
    }
    return SHEEN_OK;
}

static int read_corners(struct reading *reading, struct sheen_sink *sink, double count, enum sheen_ply_type type)
{
    for (double i = 0; i < count; i++) {
        double index;
        int error = read_index(reading, type, 0, &index);
        if (error)
            return error;
        put_corner(reading, sink, index);
    }
    return SHEEN_OK;
}

static int skip_list(struct reading *reading, double count, enum sheen_ply_type type)
{
    int error = SHEEN_OK;

    for (double i = 0, value; !error && i < count; i++)
        error = sheen_ply_number(&reading->ply, type, &value);
    return error;
}

/* Reads u and v of each corner in turn; a u without a v at the end is ignored. */
static int read_corner_uvs(struct reading *reading, struct sheen_sink *sink, double count, enum sheen_ply_type type)
{
    double uv[2] = {0, 0};
    int error = SHEEN_OK;

    for (double i = 0, k = 0; !error && i < count; i++, k = 1 - k) {
        error = sheen_ply_number(&reading->ply, type, &uv[(int)k]);
        if (!error && k > 0)
            sheen_sink_uv(sink, uv);
    }
    return error;
}

/* role: the role of the list, or ROLES if it has none. */
static int read_list(struct reading *reading, struct sheen_sink *sink, const struct sheen_ply_property *property,
                     enum element_kind kind, int role)
{
    double count;
    int error = sheen_ply_whole(&reading->ply, property->count_type, "a list's count", &count);

    if (error)
        return error;
    if (count < 0)
        return sheen_ply_problem(&reading->ply, "a list of %.0f", count);
    if (kind == FACE && role == INDICES)
        return read_corners(reading, sink, count, property->type);
    if (kind == STRIPS && role == INDICES)
        return read_strips(reading, sink, count, property->type);
    if (kind == FACE && role == UVS)
        return read_corner_uvs(reading, sink, count, property->type);
    return skip_list(reading, count, property->type);
}

/* ---- elements ---- */

static void find_roles(const struct sheen_ply_element *element, struct roles *roles)
{
    char padded[24];

    for (int r = 0; r < ROLES; r++) {
        roles->property[r] = -1;
        roles->value[r] = 0;
    }
    for (int i = 0; i < element->properties; i++) {
        const struct sheen_ply_property *property = &element->property[i];
        if (property->name.length > sizeof padded - 3)
            continue;
        snprintf(padded, sizeof padded, " %.*s ", (int)property->name.length, property->name.at);
        for (int r = 0; r < ROLES; r++) {
            if ((property->count_type != PLY_NONE) == (r >= INDICES) && strstr(role_names[r], padded))
                roles->property[r] = i;
        }
    }
}

static int has(const struct roles *roles, int first)
{
    int last = first + (first == U ? 1 : 2);

    while (first <= last && roles->property[first] >= 0)
        first++;
    return first > last;
}

/* Converts bytes, shorts or numbers from 0 to 1 to an sRGB colour. Returns NULL if the element has no colour. */
static const uint8_t *get_color(const struct sheen_ply_element *element, const struct roles *roles, uint8_t color[3])
{
    if (!has(roles, RED))
        return NULL;
    for (int k = 0; k < 3; k++) {
        enum sheen_ply_type type = element->property[roles->property[RED + k]].type;
        color[k] = sheen_color_byte(roles->value[RED + k], type >= PLY_FLOAT ? 1 : type == PLY_UINT16 ? 65535 : 255);
    }
    return color;
}

static int put_vertex(struct reading *reading, struct sheen_sink *sink, const struct roles *roles, const uint8_t *color)
{
    for (int k = 0; k < 3; k++) {
        if (!(fabs(roles->value[X + k]) <= FLT_MAX))
            return sheen_ply_problem(&reading->ply, "vertex %zu, which count from 0: not a finite number",
                                     sink->points);
    }
    sheen_sink_point(sink, roles->value + X, color);
    if (has(roles, NX))
        sheen_sink_normal(sink, roles->value + NX);
    if (has(roles, U) && !reading->has_corner_uvs)
        sheen_sink_uv(sink, roles->value + U);
    return SHEEN_OK;
}

/*
 * Uses the uv of the face's list, which are stored from `first` on, if there is one for each corner. MeshLab's
 * texnumber says to which picture they belong, where -1 is none; only the first picture is read.
 */
static void put_corner_uvs(struct reading *reading, struct sheen_sink *sink, const struct roles *roles, size_t first)
{
    const char *path = reading->ply.text.path;
    size_t corners = sink->corners - sink->begun, uvs = sink->uvs - first;

    if (uvs == corners && roles->value[PICTURE] == 0)
        sheen_sink_corner_uvs(sink, first);
    else if (uvs == corners && roles->value[PICTURE] > 0)
        sheen_note(&reading->out->notes, SHEEN_NOTE_WARNING, "%s: of its pictures only the first is read", path);
    else if (uvs > 0 && uvs != corners)
        sheen_note(&reading->out->notes, SHEEN_NOTE_WARNING,
                   "%s: the texcoord of a face of %zu corners are %zu pairs, and left out", path, corners, uvs);
}

static void put_face(struct reading *reading, struct sheen_sink *sink, const uint8_t *color)
{
    if (sink->corners - sink->begun >= 3)
        sheen_sink_polygon(sink, 0, color);
    else
        sheen_note(&reading->out->notes, SHEEN_NOTE_WARNING, "%s: a face of %zu corners is left out",
                   reading->ply.text.path, sheen_sink_drop(sink));
}

static int read_element(struct reading *reading, struct sheen_sink *sink, const struct sheen_ply_element *element,
                        enum element_kind kind, struct roles *roles)
{
    struct sheen_word word;
    uint8_t bytes[3];
    size_t uvs = sink->uvs;
    int error = SHEEN_OK;

    for (int i = 0; !error && i < element->properties; i++) {
        const struct sheen_ply_property *property = &element->property[i];
        double value = 0;
        if (property->count_type != PLY_NONE)
            error = read_list(reading, sink, property, kind,
                              roles->property[INDICES] == i ? INDICES
                              : roles->property[UVS] == i   ? UVS
                                                            : ROLES);
        else
            error = sheen_ply_number(&reading->ply, property->type, &value);
        for (int r = 0; !error && r < INDICES; r++) {
            if (roles->property[r] == i)
                roles->value[r] = value;
        }
    }
    if (!error && reading->ply.format == PLY_ASCII && sheen_text_word(&reading->ply.text, &word))
        error = sheen_ply_problem(&reading->ply, "'%.*s' is one value more than the header says", SHEEN_WORD(word));
    if (error)
        return error;
    const uint8_t *color = get_color(element, roles, bytes);
    if (kind == FACE) {
        put_corner_uvs(reading, sink, roles, uvs);
        put_face(reading, sink, color);
    }
    return kind == VERTEX ? put_vertex(reading, sink, roles, color) : SHEEN_OK;
}

static enum element_kind kind_of(const struct sheen_ply_element *element)
{
    return sheen_word_is(&element->name, "vertex")      ? VERTEX
           : sheen_word_is(&element->name, "face")      ? FACE
           : sheen_word_is(&element->name, "tristrips") ? STRIPS
                                                        : OTHER;
}

static int read_elements(struct reading *reading, struct sheen_sink *sink, const struct sheen_ply_element *element)
{
    enum element_kind kind = kind_of(element);
    struct roles roles;

    find_roles(element, &roles);
    if (element->count > 0 && element->properties == 0)
        return sheen_ply_problem(&reading->ply, "element '%.*s' has no properties", SHEEN_WORD(element->name));
    if (kind == VERTEX && !has(&roles, X))
        return sheen_ply_problem(&reading->ply, "vertices without x, y and z");
    if ((kind == FACE || kind == STRIPS) && element->count > 0 && roles.property[INDICES] < 0)
        return sheen_ply_problem(&reading->ply, "faces without a list vertex_indices");
    reading->has_uvs |= kind == VERTEX && has(&roles, U) && !reading->has_corner_uvs;
    for (int64_t i = 0; i < element->count; i++) {
        int error = read_element(reading, sink, element, kind, &roles);
        if (error && reading->ply.ended)
            return sheen_ply_problem(&reading->ply, "ends after %lld of %lld %s", (long long)i,
                                     (long long)element->count, kind_words[kind]);
        if (error)
            return error;
    }
    return SHEEN_OK;
}

/* Called before elements are read, because vertices may precede the faces whose lists replace their uv. */
static void find_corner_uvs(struct reading *reading)
{
    struct roles roles;

    for (int e = 0; e < reading->ply.elements; e++) {
        find_roles(&reading->ply.element[e], &roles);
        reading->has_corner_uvs |= kind_of(&reading->ply.element[e]) == FACE && roles.property[UVS] >= 0;
    }
}

/* Warns of what follows the last element, except for the end of a line. */
static void look_behind(struct reading *reading)
{
    struct sheen_ply *ply = &reading->ply;
    struct sheen_word word;

    if (ply->format == PLY_ASCII ? sheen_text_any_word(&ply->text, &word) : ply->text.end - ply->text.at > 2)
        sheen_note(&reading->out->notes, SHEEN_NOTE_WARNING, "%s: what follows the last element is left out",
                   ply->text.path);
}

static int pass(void *context, struct sheen_sink *sink)
{
    struct reading *reading = context;
    int error = SHEEN_OK;

    reading->ply.text.at = reading->ply.body;
    reading->ply.text.line = reading->ply.body_line;
    for (int e = 0; !error && e < reading->ply.elements; e++)
        error = read_elements(reading, sink, &reading->ply.element[e]);
    if (!error)
        look_behind(reading);
    return error;
}

/* `comment TextureFile NAME` is not in the standard, but all programs write it. */
static void add_picture(struct sheen_polygons *polygons, const char *path, const struct sheen_word *name)
{
    struct sheen_picture picture = {.name = sheen_picture_beside(path, name->at, name->length), .cutoff = .5};

    polygons->group[0].picture = sheen_polygons_picture(polygons, &picture);
}

int sheen_mesh_ply_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    static struct reading reading; /* 40 KB: not on the stack */

    memset(&reading, 0, sizeof reading);
    reading.out = polygons;
    reading.ply.text = (struct sheen_text){.path = path, .line = 1, .problem = problem};
    int error = sheen_bytes_load(&reading.ply.bytes, path, problem);
    if (!error && sheen_bytes_to_utf8(&reading.ply.bytes) != 0)
        error = sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    if (!error) {
        reading.ply.text.at = (const char *)reading.ply.bytes.bytes;
        reading.ply.text.end = reading.ply.text.at + reading.ply.bytes.count;
        error = sheen_ply_header(&reading.ply);
    }
    if (!error) {
        find_corner_uvs(&reading);
        error = sheen_sink_run(polygons, pass, &reading, path, problem);
    }
    if (!error && reading.ply.picture.length)
        add_picture(polygons, path, &reading.ply.picture);
    sheen_bytes_free(&reading.ply.bytes);
    return error;
}
