/*
 * mesh_off.c - Geomview's OFF.
 *
 * OFF consists of words, and line ends matter only for colours: what follows a face's corners on their line is its
 * colour. A file is read as words alone if they come out even at its end, else with colours up to the ends of lines.
 */
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

enum {
    EXTRA = 12 /* how many numbers after a vertex or a face are kept */
};

struct off {
    struct sheen_bytes bytes;
    struct sheen_text text, body; /* body: where the vertices begin */
    struct sheen_polygons *out;
    int normals, colors, textures;  /* 1: vertices have them according to the first word */
    int by_lines;                   /* 1: numbers up to the end of a line belong to the vertex or face before them */
    int color_numbers;              /* per vertex: 3 or 4 */
    int64_t vertices, faces;        /* promised by the header */
    struct sheen_color_range range; /* of colours, known after the first pass */
};

/* Reads `want` numbers, or by lines the rest of the line, and keeps EXTRA. Returns their count, or -1 and an error. */
static int read_extra(struct off *off, int want, double numbers[EXTRA])
{
    struct sheen_word word;
    double number;
    int count = 0;

    while (off->by_lines ? sheen_text_word(&off->text, &word)
                         : count < want && sheen_text_any_word(&off->text, &word)) {
        if (!sheen_word_number(&word, &number)) {
            sheen_text_problem(&off->text, "'%.*s' is not a number", SHEEN_WORD(word));
            return -1;
        }
        if (count < EXTRA)
            numbers[count] = number;
        count++;
    }
    if (count < want) {
        sheen_text_problem(&off->text, "a vertex of %d numbers, not %d", count + 3, want + 3);
        return -1;
    }
    return count;
}

static const uint8_t *to_color(struct off *off, const struct sheen_sink *sink, const double *numbers, uint8_t color[3])
{
    if (!sink->keeping)
        sheen_color_range_add(&off->range, numbers);
    for (int k = 0; k < 3; k++)
        color[k] = sheen_color_byte(numbers[k], sheen_color_range_most(&off->range, 2));
    return color;
}

/* x y z, then a normal, a colour and texture coordinates, as far as vertices have them. */
static int read_vertex(struct off *off, struct sheen_sink *sink)
{
    int before_color = off->normals ? 3 : 0;
    int want = before_color + (off->colors ? off->color_numbers : 0) + (off->textures ? 2 : 0);
    double point[3], extra[EXTRA];
    uint8_t color[3];
    int error = sheen_text_point(&off->text, 1, "a vertex", point);
    int count = error ? -1 : read_extra(off, want, extra);

    if (count < 0)
        return SHEEN_ERR_ARGUMENT;
    if (count > want)
        sheen_note(&off->out->notes, SHEEN_NOTE_WARNING, "%s: numbers after vertices are left out", off->text.path);
    sheen_sink_point(sink, point, off->colors ? to_color(off, sink, extra + before_color, color) : NULL);
    if (off->normals)
        sheen_sink_normal(sink, extra);
    if (off->textures)
        sheen_sink_uv(sink, extra + want - 2);
    return SHEEN_OK;
}

static int read_whole(struct off *off, const char *what, int64_t *value)
{
    struct sheen_word word;

    if (!sheen_text_any_word(&off->text, &word))
        return sheen_text_problem(&off->text, "ends before %s", what);
    return sheen_word_whole(&word, value) ? SHEEN_OK
                                          : sheen_text_problem(&off->text, "'%.*s' is not %s", SHEEN_WORD(word), what);
}

static int read_corners(struct off *off, struct sheen_sink *sink)
{
    int64_t count = 0, index = 0;
    int error = read_whole(off, "a face's count of corners", &count);

    if (!error && count < 0)
        return sheen_text_problem(&off->text, "a face of %lld corners", (long long)count);
    for (int64_t i = 0; !error && i < count; i++) {
        error = read_whole(off, "a face's corner", &index);
        if (!error && (index < 0 || index >= off->vertices))
            error = sheen_text_problem(&off->text, "a face names vertex %lld of %lld, which count from 0",
                                       (long long)index, (long long)off->vertices);
        if (!error)
            sheen_sink_corner(sink, (size_t)index, off->normals ? (size_t)index : SHEEN_NONE,
                              off->textures ? (size_t)index : SHEEN_NONE);
    }
    return error;
}

/* n, n indices; by lines also a colour of 3 or 4 numbers, or an index into a colour table outside the file. */
static int read_face(struct off *off, struct sheen_sink *sink)
{
    double extra[EXTRA];
    uint8_t color[3];
    int error = read_corners(off, sink);
    int count = error ? -1 : read_extra(off, 0, extra);

    if (count < 0)
        return SHEEN_ERR_ARGUMENT;
    if (count == 2 || count > 4)
        return sheen_text_problem(&off->text, "%d numbers after a face's corners", count);
    if (sink->corners - sink->begun >= 3)
        sheen_sink_polygon(sink, 0, count >= 3 ? to_color(off, sink, extra, color) : NULL);
    else
        sheen_note(&off->out->notes, SHEEN_NOTE_WARNING, "%s: a face of %zu corners is left out", off->text.path,
                   sheen_sink_drop(sink));
    return SHEEN_OK;
}

static int read_all(struct off *off, struct sheen_sink *sink, int64_t count, const char *what,
                    int (*read)(struct off *off, struct sheen_sink *sink))
{
    struct sheen_word word;

    for (int64_t i = 0; i < count; i++) {
        struct sheen_text before = off->text;
        int more = sheen_text_any_word(&off->text, &word);
        off->text = before;
        int error = more ? read(off, sink) : SHEEN_ERR_ARGUMENT;
        if (error && (!more || off->text.ended))
            return sheen_text_problem(&off->text, "ends after %lld of %lld %s", (long long)i, (long long)count, what);
        if (error)
            return error;
    }
    return SHEEN_OK;
}

static int pass(void *context, struct sheen_sink *sink)
{
    struct off *off = context;
    struct sheen_word word;

    off->text = off->body;
    int error = read_all(off, sink, off->vertices, "vertices", read_vertex);
    if (!error)
        error = read_all(off, sink, off->faces, "faces", read_face);
    if (!error && sheen_text_any_word(&off->text, &word)) {
        if (!off->by_lines)
            return sheen_text_problem(&off->text, "'%.*s' follows the last face", SHEEN_WORD(word));
        sheen_note(&off->out->notes, SHEEN_NOTE_WARNING, "%s:%lu: what follows the last face is left out",
                   off->text.path, off->text.line);
    }
    return error;
}

/* Reads [ST][C][N][4][n]OFF; without such a word the kind is OFF. */
static int read_kind(struct off *off)
{
    struct sheen_text before = off->text;
    struct sheen_word word;
    int64_t number;

    if (!sheen_text_any_word(&off->text, &word) || sheen_word_whole(&word, &number)) {
        off->text = before;
        return SHEEN_OK;
    }
    struct sheen_word left = word;
    const struct {
        const char *prefix;
        int *set;
    } parts[] = {{"ST", &off->textures}, {"C", &off->colors}, {"N", &off->normals}};
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        size_t length = strlen(parts[i].prefix);
        *parts[i].set = left.length > 3 && memcmp(left.at, parts[i].prefix, length) == 0;
        left.at += *parts[i].set ? length : 0;
        left.length -= *parts[i].set ? length : 0;
    }
    if (sheen_word_is(&left, "4OFF") || sheen_word_is(&left, "nOFF") || sheen_word_is(&left, "4nOFF"))
        return sheen_text_problem(&off->text, "%.*s, points of other than three dimensions, is not read",
                                  SHEEN_WORD(word));
    struct sheen_word count = {left.at + 3, left.length - 3};
    if (left.length > 3 && memcmp(left.at, "OFF", 3) == 0 && sheen_word_whole(&count, &number)) {
        off->text.at = count.at; /* the counts follow without a blank: ModelNet40 has such files */
        return SHEEN_OK;
    }
    if (!sheen_word_is(&left, "OFF"))
        return sheen_text_problem(&off->text, "'%.*s' is not OFF", SHEEN_WORD(word));
    return SHEEN_OK;
}

/* The counts of vertices, faces and edges; some files leave out the edges. */
static int read_counts(struct off *off)
{
    struct sheen_word word;
    int error = read_whole(off, "a count of vertices", &off->vertices);
    unsigned long line = off->text.line;

    if (!error)
        error = read_whole(off, "a count of faces", &off->faces);
    if (!error && (off->vertices < 0 || off->faces < 0))
        error = sheen_text_problem(&off->text, "%lld vertices and %lld faces", (long long)off->vertices,
                                   (long long)off->faces);
    if (!error && !sheen_text_word(&off->text, &word) && line != off->text.line)
        sheen_text_any_word(&off->text, &word);
    return error;
}

/* Counts the colour's numbers on the first vertex's line, because COFF may or may not have alpha. */
static void count_color_numbers(struct off *off)
{
    struct sheen_text text = off->body;
    struct sheen_word word;
    int words = 0;

    if (sheen_text_any_word(&text, &word)) {
        for (words = 1; sheen_text_word(&text, &word);)
            words++;
    }
    off->color_numbers = words - 3 - (off->normals ? 3 : 0) - (off->textures ? 2 : 0) == 3 ? 3 : 4;
}

int sheen_mesh_off_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    struct off off = {.text = {.path = path, .line = 1, .comments = 1, .problem = problem}, .out = polygons};
    int error = sheen_bytes_load(&off.bytes, path, problem);

    const char *first = (const char *)off.bytes.bytes;
    if (!error && memmem(first, strcspn(first, "\r\n"), "BINARY", 6))
        error = sheen_text_problem(&off.text, "binary OFF is not read; save it as text");
    if (!error)
        error = sheen_text_begin(&off.text, &off.bytes);
    if (!error)
        error = read_kind(&off);
    if (!error)
        error = read_counts(&off);
    if (!error) {
        off.body = off.text;
        count_color_numbers(&off);
        error = sheen_sink_run(polygons, pass, &off, path, problem);
        if (error == SHEEN_ERR_ARGUMENT) {
            off.by_lines = 1;
            off.range = (struct sheen_color_range){0, 0};
            error = sheen_sink_run(polygons, pass, &off, path, problem);
        }
    }
    sheen_bytes_free(&off.bytes);
    return error;
}
