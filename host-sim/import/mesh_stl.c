/*
 * mesh_stl.c - STL, text and binary.
 *
 * A binary file has 80 arbitrary bytes, which may begin with "solid", a count, and 50 bytes per triangle. In a
 * text file the four bytes of the count are characters, which would promise more than 7 GB.
 */
#include <math.h>
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

enum {
    HEADER = 84,
    FACET = 50
};

struct stl {
    struct sheen_bytes bytes;
    struct sheen_text text;
};

static uint32_t little_32(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* ---- binary ---- */

/* Magics writes "COLOR=" and r g b a into the header: the colour of facets that have none of their own. */
static const unsigned char *find_magics(const unsigned char *header)
{
    for (int i = 0; i + 10 <= 80; i++) {
        if (memcmp(header + i, "COLOR=", 6) == 0)
            return header + i + 6;
    }
    return NULL;
}

static void facet_color(const unsigned char *facet, const unsigned char *whole, uint8_t color[3])
{
    unsigned bits = facet[48] | (unsigned)facet[49] << 8; /* 5 bits each, red lowest; bit 15: no colour of its own */

    for (unsigned k = 0; k < 3; k++) {
        unsigned part = bits >> 5 * k & 31;
        color[k] = bits & 0x8000 ? whole[k] : (uint8_t)(part << 3 | part >> 2);
    }
}

static int binary_pass(void *context, struct sheen_sink *sink)
{
    struct stl *stl = context;
    const unsigned char *bytes = stl->bytes.bytes, *whole = find_magics(bytes);
    uint32_t count = little_32(bytes + 80);

    for (uint32_t f = 0; f < count; f++) {
        const unsigned char *facet = bytes + HEADER + (size_t)FACET * f;
        uint8_t color[3];
        for (size_t k = 0; k < 9; k += 3) {
            double point[3];
            for (size_t i = 0; i < 3; i++) {
                uint32_t bits = little_32(facet + 12 + 4 * (k + i));
                float value;
                memcpy(&value, &bits, sizeof value);
                point[i] = (double)value;
                if (!isfinite(value))
                    return sheen_problem(stl->text.problem, SHEEN_ERR_ARGUMENT,
                                         "%s: byte %td: triangle %lu has a corner that is not a finite number",
                                         stl->text.path, facet - bytes, (unsigned long)f + 1);
            }
            sheen_sink_corner(sink, sink->points, SHEEN_NONE, SHEEN_NONE);
            sheen_sink_point(sink, point, NULL);
        }
        if (whole)
            facet_color(facet, whole, color);
        sheen_sink_polygon(sink, 0, whole ? color : NULL);
    }
    return SHEEN_OK;
}

/* ---- text ---- */

static int expect(struct stl *stl, const char *expected)
{
    struct sheen_word word;

    if (!sheen_text_any_word(&stl->text, &word))
        return sheen_text_problem(&stl->text, "ends where '%s' should be", expected);
    return sheen_word_is(&word, expected)
               ? SHEEN_OK
               : sheen_text_problem(&stl->text, "'%.*s' where '%s' should be", SHEEN_WORD(word), expected);
}

/* Skips the next word and returns 1 if it is `expected`, else returns 0. */
static int accept(struct stl *stl, const char *expected)
{
    struct sheen_text before = stl->text;
    struct sheen_word word;

    if (sheen_text_any_word(&stl->text, &word) && sheen_word_is(&word, expected))
        return 1;
    stl->text = before;
    return 0;
}

/*
 * Whether `facet` and what must follow it come later on this line, because a file may be a single line. Does not move
 * `text`.
 */
static int goes_on(struct sheen_text *text)
{
    struct sheen_text look = *text;
    struct sheen_word word, next;

    while (sheen_text_word(&look, &word)) {
        if (!sheen_word_is(&word, "facet"))
            continue;
        struct sheen_text before = look;
        if (sheen_text_word(&look, &next) && (sheen_word_is(&next, "normal") || sheen_word_is(&next, "outer")))
            return 1;
        look = before;
    }
    return 0;
}

/* Skips a solid's name: the rest of the line, or if facets follow on it, the words before `until`. */
static void skip_name(struct stl *stl, const char *until)
{
    struct sheen_text before = stl->text;
    struct sheen_word word;

    if (!goes_on(&stl->text)) {
        sheen_text_skip_line(&stl->text);
        return;
    }
    while (sheen_text_word(&stl->text, &word) && !sheen_word_is(&word, until))
        before = stl->text;
    stl->text = before;
}

/* Reads what follows `facet`. Its normal may be anything or missing: up to four words before `outer` are skipped. */
static int read_facet(struct stl *stl, struct sheen_sink *sink)
{
    struct sheen_word word;
    int found = accept(stl, "outer");
    int error = SHEEN_OK;

    for (int skipped = 0; !found && skipped < 4 && sheen_text_any_word(&stl->text, &word); skipped++)
        found = accept(stl, "outer");
    error = found ? expect(stl, "loop") : expect(stl, "outer");
    while (!error && accept(stl, "vertex")) {
        double point[3];
        error = sheen_text_point(&stl->text, 1, "a vertex", point);
        if (error)
            break;
        sheen_sink_corner(sink, sink->points, SHEEN_NONE, SHEEN_NONE);
        sheen_sink_point(sink, point, NULL);
    }
    if (!error && sink->corners - sink->begun < 3)
        error = expect(stl, "vertex");
    if (!error)
        error = expect(stl, "endloop");
    if (!error)
        error = expect(stl, "endfacet");
    if (!error)
        sheen_sink_polygon(sink, 0, NULL);
    return error;
}

/* Reads from behind `solid` to the end of the name behind `endsolid`. */
static int read_solid(struct stl *stl, struct sheen_sink *sink)
{
    int error = SHEEN_OK;

    skip_name(stl, "facet");
    while (!error && accept(stl, "facet"))
        error = read_facet(stl, sink);
    if (!error)
        error = expect(stl, "endsolid");
    if (!error)
        skip_name(stl, "solid");
    return error;
}

static int text_pass(void *context, struct sheen_sink *sink)
{
    struct stl *stl = context;
    int error;

    stl->text.at = (const char *)stl->bytes.bytes;
    stl->text.line = 1;
    do {
        struct sheen_text before;
        struct sheen_word word;
        error = expect(stl, "solid");
        if (!error)
            error = read_solid(stl, sink);
        before = stl->text;
        if (!error && !sheen_text_any_word(&stl->text, &word))
            return SHEEN_OK;
        stl->text = before;
    } while (!error);
    return error;
}

/* ---- binary or text ---- */

/* Looks at the first bytes, also of UTF-16. A binary file's count has zeros, its 80 arbitrary bytes may have none. */
static int begins_with_solid(const struct stl *stl)
{
    const unsigned char *bytes = stl->bytes.bytes;
    size_t count = stl->bytes.count < HEADER ? stl->bytes.count : HEADER;
    int is_utf16 = count >= 2 && (memcmp(bytes, "\xff\xfe", 2) == 0 || memcmp(bytes, "\xfe\xff", 2) == 0);

    if (is_utf16)
        return 1;
    if (memchr(bytes, 0, count))
        return 0;
    size_t mark = count >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    struct sheen_text text = {.at = (const char *)bytes + mark, .end = (const char *)bytes + stl->bytes.count};
    struct sheen_word word;
    return sheen_text_any_word(&text, &word) && sheen_word_is(&word, "solid");
}

static int read_bytes(struct sheen_polygons *polygons, struct stl *stl, const char *path, struct sheen_problem *problem)
{
    size_t count = stl->bytes.count;
    size_t facets = count > HEADER ? (count - HEADER) / FACET : 0;
    uint32_t promised = count >= HEADER ? little_32(stl->bytes.bytes + 80) : 0;

    if (count >= HEADER && promised <= facets)
        return sheen_sink_run(polygons, binary_pass, stl, path, problem);
    if (begins_with_solid(stl)) {
        int error = sheen_text_begin(&stl->text, &stl->bytes);
        return error ? error : sheen_sink_run(polygons, text_pass, stl, path, problem);
    }
    if (count < HEADER)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                             "%s: neither begins with 'solid' nor is long enough for a "
                             "binary STL",
                             path);
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT,
                         "%s: does not begin with 'solid', and as a binary STL it ends "
                         "after %zu of %lu triangles",
                         path, facets, (unsigned long)promised);
}

int sheen_mesh_stl_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    struct stl stl = {.text = {.path = path, .line = 1, .problem = problem}};
    int error = sheen_bytes_load(&stl.bytes, path, problem);

    if (!error)
        error = read_bytes(polygons, &stl, path, problem);
    polygons->z_up = 1;
    sheen_bytes_free(&stl.bytes);
    return error;
}
