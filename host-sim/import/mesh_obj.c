/*
 * mesh_obj.c - Wavefront OBJ.
 *
 * OBJ has no counts: a file counts as complete if every index of a face names a vertex somewhere in the file
 * and the file does not end within a face, before its third corner.
 */
#include <stdlib.h>
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

/* Words of OBJ that do not change how faces look. */
static const char other_words[] = " vp g o mg p l lod bevel c_interp d_interp shadow_obj trace_obj maplib usemap "
                                  "cstype deg bmat step parm trim hole sp end con ctech stech bzp cdp res bsp ";
/* Words of surfaces, curves and other files, which are not read. */
static const char left_out_words[] = " surf curv curv2 scrv call csh cdc ";

/* Colours that reach this value are taken as 0..255: by the format they are 0..1, and no mesh in 0..255 is darker. */
#define BYTES 16

#define NOT_SAID (-1)

struct obj {
    struct sheen_bytes bytes;
    struct sheen_text text;
    struct sheen_polygons *out;
    size_t points, normals, uvs;    /* read so far */
    size_t total[3];                /* of points, normals, uvs; known after the first pass */
    struct sheen_color_range range; /* of vertices' colours, known after the first pass */
    uint16_t group;                 /* of faces */
    int64_t smoothing;              /* current smoothing group, set by s; 0: off; NOT_SAID */
    int64_t first_smoothing;        /* the first face's */
    int has_smoothing;              /* 1: faces are in several smoothing groups, or off */
    struct sheen_word *names;
    size_t names_count, names_room;
    struct sheen_word left_out;
};

/* v x y z, then nothing, a weight (for curves, ignored), or r g b and perhaps more. */
static int read_vertex(struct obj *obj, struct sheen_sink *sink)
{
    double point[3], more[5];
    struct sheen_word word;
    uint8_t color[3];
    int count = 0;
    int error = sheen_text_point(&obj->text, 0, "a vertex", point);

    while (!error && count < 5 && sheen_text_word(&obj->text, &word)) {
        if (!sheen_word_number(&word, &more[count++]))
            return sheen_text_problem(&obj->text, "'%.*s' is not a number", SHEEN_WORD(word));
    }
    if (error)
        return error;
    if (count >= 3 && !sink->keeping)
        sheen_color_range_add(&obj->range, more);
    for (int k = 0; count >= 3 && k < 3; k++)
        color[k] = sheen_color_byte(more[k], sheen_color_range_most(&obj->range, BYTES));
    sheen_sink_point(sink, point, count >= 3 ? color : NULL);
    obj->points++;
    return SHEEN_OK;
}

/* sheen_polygons_finish later treats a normal with a NaN as absent. */
static int read_normal(struct obj *obj, struct sheen_sink *sink)
{
    double normal[3];

    for (int k = 0; k < 3; k++) {
        struct sheen_word word;
        if (!sheen_text_word(&obj->text, &word))
            return sheen_text_problem(&obj->text, "a normal of %d numbers, not 3", k);
        if (!sheen_word_number(&word, &normal[k]))
            return sheen_text_problem(&obj->text, "'%.*s' is not a number", SHEEN_WORD(word));
    }
    sheen_sink_normal(sink, normal);
    obj->normals++;
    return SHEEN_OK;
}

/* vt u, then perhaps v and w; pictures have no w, so it is ignored. */
static int read_uv(struct obj *obj, struct sheen_sink *sink)
{
    double uv[2] = {0, 0};

    for (int k = 0; k < 2; k++) {
        struct sheen_word word;
        if (!sheen_text_word(&obj->text, &word)) {
            if (k == 1)
                break;
            return sheen_text_problem(&obj->text, "vt without a number");
        }
        if (!sheen_word_number(&word, &uv[k]))
            return sheen_text_problem(&obj->text, "'%.*s' is not a number", SHEEN_WORD(word));
    }
    sheen_sink_uv(sink, uv);
    obj->uvs++;
    return SHEEN_OK;
}

/* Splits v, v/vt, v//vn or v/vt/vn, which may also end with a slash; missing parts are ABSENT. */
#define ABSENT INT64_MIN
static int split_corner(const struct sheen_word *word, int64_t part[3])
{
    const char *at = word->at, *end = word->at + word->length;

    part[0] = part[1] = part[2] = ABSENT;
    for (int k = 0; k < 3 && at < end; k++) {
        struct sheen_word digits = {at, 0};
        while (at < end && *at != '/')
            at++;
        digits.length = (size_t)(at - digits.at);
        if (digits.length && !sheen_word_whole(&digits, &part[k]))
            return 0;
        at += at < end; /* the slash */
    }
    return at == end && part[0] != ABSENT;
}

/* Converts a face's index to one from 0: it counts from 1, also to later lines of the file, or backwards from -1. */
static int find(struct obj *obj, int64_t index, const char *what, size_t so_far, size_t total, size_t *found)
{
    if (index < 0 && index >= -(int64_t)so_far)
        *found = (size_t)((int64_t)so_far + index);
    else if (index > 0 && index <= (int64_t)total)
        *found = (size_t)index - 1;
    else
        return sheen_text_problem(&obj->text, "a face names %s %lld of %zu", what, (long long)index,
                                  index > 0 ? total : so_far);
    return SHEEN_OK;
}

static int read_corner(struct obj *obj, struct sheen_sink *sink, const struct sheen_word *word)
{
    size_t point = 0, normal = SHEEN_NONE, uv = SHEEN_NONE;
    int64_t part[3];
    int error = SHEEN_OK;

    if (!split_corner(word, part))
        return sheen_text_problem(&obj->text, "'%.*s' is no corner of a face", SHEEN_WORD(*word));
    if (sink->keeping) {
        error = find(obj, part[0], "vertex", obj->points, obj->total[0], &point);
        /* A file may name normals or texture coordinates and have none at all. */
        if (!error && part[2] != ABSENT && obj->total[1] > 0)
            error = find(obj, part[2], "normal", obj->normals, obj->total[1], &normal);
        if (!error && part[1] != ABSENT && obj->total[2] > 0)
            error = find(obj, part[1], "texture coordinate", obj->uvs, obj->total[2], &uv);
    }
    if (!error)
        sheen_sink_corner(sink, point, normal, uv);
    return error;
}

static int read_face(struct obj *obj, struct sheen_sink *sink)
{
    struct sheen_word word;

    while (sheen_text_word(&obj->text, &word)) {
        int error = read_corner(obj, sink, &word);
        if (error)
            return error;
    }
    if (sink->corners - sink->begun >= 3) {
        if (sink->polygons == 0)
            obj->first_smoothing = obj->smoothing;
        obj->has_smoothing |= obj->smoothing != obj->first_smoothing || obj->smoothing == 0;
        sheen_sink_polygon(sink, obj->group, NULL);
        return SHEEN_OK;
    }
    size_t corners = sheen_sink_drop(sink);
    if (obj->text.at == obj->text.end)
        return sheen_text_problem(&obj->text, "the file ends within a face, after %zu of its corners", corners);
    sheen_note(&obj->out->notes, SHEEN_NOTE_WARNING, "%s:%lu: a face of %zu corners is left out", obj->text.path,
               obj->text.line, corners);
    return SHEEN_OK;
}

/* Groups are numbered in the order of their first use; 0 is for faces before any usemtl. */
static int use_material(struct obj *obj, const struct sheen_word *name)
{
    for (size_t i = 1; i < obj->names_count; i++) {
        if (obj->names[i].length == name->length && memcmp(obj->names[i].at, name->at, name->length) == 0) {
            obj->group = (uint16_t)i;
            return SHEEN_OK;
        }
    }
    if (obj->names_count == obj->names_room) {
        size_t room = obj->names_room ? 2 * obj->names_room : 16;
        struct sheen_word *names = realloc(obj->names, room * sizeof *names);
        if (!names)
            return SHEEN_ERR_MEMORY;
        obj->names = names;
        obj->names_room = room;
    }
    if (obj->names_count == 0)
        obj->names[obj->names_count++] = (struct sheen_word){"", 0};
    if (obj->names_count > UINT16_MAX)
        return sheen_text_problem(&obj->text, "more than %d materials", UINT16_MAX);
    obj->group = (uint16_t)obj->names_count;
    obj->names[obj->names_count++] = *name;
    return SHEEN_OK;
}

/* s N or s off; any other word means on. */
static void read_smoothing(struct obj *obj)
{
    struct sheen_word word;

    if (sheen_text_word(&obj->text, &word) && !sheen_word_whole(&word, &obj->smoothing))
        obj->smoothing = !sheen_word_is(&word, "off");
}

/* Notes a line that is not a vertex, normal, uv, face or material, if it matters. */
static void read_other(struct obj *obj, const struct sheen_word *word)
{
    int left_out = sheen_word_is_of(word, left_out_words);

    if (left_out && !obj->left_out.length)
        obj->left_out = *word;
    if (left_out || !sheen_word_is_of(word, other_words))
        sheen_note(&obj->out->notes, SHEEN_NOTE_WARNING, "%s:%lu: '%.*s' is not read, and left out", obj->text.path,
                   obj->text.line, SHEEN_WORD(*word));
}

static int read_line(struct obj *obj, struct sheen_sink *sink, const struct sheen_word *word)
{
    struct sheen_word name;

    if (sheen_word_is(word, "v"))
        return read_vertex(obj, sink);
    if (sheen_word_is(word, "vn"))
        return read_normal(obj, sink);
    if (sheen_word_is(word, "vt"))
        return read_uv(obj, sink);
    if (sheen_word_is(word, "f") || sheen_word_is(word, "fo"))
        return read_face(obj, sink);
    if (sheen_word_is(word, "s")) {
        read_smoothing(obj);
        return SHEEN_OK;
    }
    if (sheen_word_is(word, "usemtl")) {
        obj->group = 0; /* usemtl without a name: no material */
        return sheen_text_line_rest(&obj->text, &name) ? use_material(obj, &name) : SHEEN_OK;
    }
    if (!sheen_word_is(word, "mtllib"))
        read_other(obj, word);
    return SHEEN_OK;
}

static int pass(void *context, struct sheen_sink *sink)
{
    struct obj *obj = context;
    struct sheen_word word;
    int error = SHEEN_OK;

    obj->text.at = (const char *)obj->bytes.bytes;
    obj->text.line = 1;
    obj->group = 0;
    obj->smoothing = NOT_SAID;
    obj->points = obj->normals = obj->uvs = 0;
    while (!error && sheen_text_any_word(&obj->text, &word)) {
        error = read_line(obj, sink, &word);
        sheen_text_skip_line(&obj->text);
    }
    obj->total[0] = obj->points;
    obj->total[1] = obj->normals;
    obj->total[2] = obj->uvs;
    sink->groups = obj->names_count ? obj->names_count : 1;
    if (!error && sink->polygons == 0 && obj->left_out.length)
        return sheen_problem(obj->text.problem, SHEEN_ERR_ARGUMENT, "%s: no faces: '%.*s' is not read", obj->text.path,
                             SHEEN_WORD(obj->left_out));
    return error;
}

/* Returns 0 if there is no such file, else 1. */
static int read_file(struct obj *obj, const struct sheen_word *name)
{
    char path[4096];

    return sheen_beside(path, sizeof path, obj->text.path, name->at, name->length) == 0 &&
           sheen_mtl_read(obj->out, obj->names, path) == 0;
}

static void note_missing(struct obj *obj, const struct sheen_word *name)
{
    sheen_note(&obj->out->notes, SHEEN_NOTE_WARNING, "%s: there is no %.*s, so its materials have no colour",
               obj->text.path, (int)(name->length < 100 ? name->length : 100), name->at);
}

/* mtllib has one name, in quotes or not, maybe with blanks, or several names; if no file is found it may be either. */
static void read_library(struct obj *obj, struct sheen_word *rest)
{
    struct sheen_word word, missing[SHEEN_NOTES_MAX]; /* more are not noted */
    size_t words = 0, lacks = 0;

    sheen_word_unquote(rest);
    if (read_file(obj, rest))
        return;
    struct sheen_text text = {.at = rest->at, .end = rest->at + rest->length, .comments = 1};
    for (; sheen_text_word(&text, &word); words++) {
        if (read_file(obj, &word))
            continue;
        if (lacks < SHEEN_NOTES_MAX)
            missing[lacks] = word;
        lacks++;
    }
    if (words > 1 && lacks == words) {
        note_missing(obj, rest);
        return;
    }
    for (size_t i = 0; i < lacks && i < SHEEN_NOTES_MAX; i++)
        note_missing(obj, &missing[i]);
}

/* Called when the groups are known, because mtllib may follow the uses of its materials. */
static void read_materials(struct obj *obj)
{
    struct sheen_word word, rest, last = {"", 0};

    for (size_t g = 0; g < obj->names_count; g++)
        sheen_group_name(&obj->out->group[g], obj->names[g].at, obj->names[g].length);
    obj->text.at = (const char *)obj->bytes.bytes;
    while (sheen_text_any_word(&obj->text, &word)) {
        if (sheen_word_is(&word, "mtllib") && sheen_text_line_rest(&obj->text, &rest) &&
            (rest.length != last.length || memcmp(rest.at, last.at, rest.length) != 0)) {
            last = rest;
            read_library(obj, &rest);
        }
        sheen_text_skip_line(&obj->text);
    }
    for (size_t g = 1; g < obj->names_count; g++) {
        if (!obj->out->group[g].has_color && !obj->out->group[g].picture)
            sheen_note(&obj->out->notes, SHEEN_NOTE_ON_COLORS, "%s: material '%s' has no colour in any .mtl",
                       obj->text.path, obj->out->group[g].name);
    }
}

int sheen_mesh_obj_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    struct obj obj = {.text = {.path = path, .comments = 1, .joins = 1, .problem = problem}, .out = polygons};
    int error = sheen_bytes_load(&obj.bytes, path, problem);

    if (!error)
        error = sheen_text_begin(&obj.text, &obj.bytes);
    if (!error)
        error = sheen_sink_run(polygons, pass, &obj, path, problem);
    if (!error && sheen_color_range_most(&obj.range, BYTES) > 1)
        sheen_note(&polygons->notes, SHEEN_NOTE_WARNING,
                   "%s: its vertices' colours, up to %g, are taken as 0..255, though those of an OBJ are 0..1", path,
                   obj.range.largest);
    if (!error && obj.has_smoothing && obj.total[1] == 0)
        sheen_note(&polygons->notes, SHEEN_NOTE_WARNING,
                   "%s: its smoothing groups (s) are not read: --crease says which faces are smooth", path);
    if (!error)
        read_materials(&obj);
    free(obj.names);
    sheen_bytes_free(&obj.bytes);
    return error;
}
