/*
 * mesh_ply_header.c - reads a PLY file's header: its elements, their counts and properties.
 */
#include <string.h>

#include "mesh_ply.h"

static const struct {
    const char *name, *other_name;
    size_t size;
} types[] = {
    [PLY_INT8] = {"char", "int8", 1},      [PLY_UINT8] = {"uchar", "uint8", 1},
    [PLY_INT16] = {"short", "int16", 2},   [PLY_UINT16] = {"ushort", "uint16", 2},
    [PLY_INT32] = {"int", "int32", 4},     [PLY_UINT32] = {"uint", "uint32", 4},
    [PLY_FLOAT] = {"float", "float32", 4}, [PLY_DOUBLE] = {"double", "float64", 8},
};

size_t sheen_ply_size(enum sheen_ply_type type)
{
    return types[type].size;
}

static int read_type(struct sheen_text *text, enum sheen_ply_type *type)
{
    struct sheen_word word;

    if (!sheen_text_word(text, &word))
        return sheen_text_problem(text, "a property without a type");
    for (int t = PLY_INT8; t <= PLY_DOUBLE; t++) {
        if (sheen_word_is(&word, types[t].name) || sheen_word_is(&word, types[t].other_name)) {
            *type = (enum sheen_ply_type)t;
            return SHEEN_OK;
        }
    }
    return sheen_text_problem(text, "'%.*s' is no type of PLY", SHEEN_WORD(word));
}

/* Reads what follows `property` in `property float x` or `property list uchar int vertex_indices`. */
static int read_property(struct sheen_ply *ply)
{
    struct sheen_text *text = &ply->text;
    struct sheen_ply_element *element = ply->elements ? &ply->element[ply->elements - 1] : NULL;
    struct sheen_text before = *text;
    struct sheen_word word;
    int error = SHEEN_OK;

    if (!element)
        return sheen_text_problem(text, "a property before any element");
    if (element->properties == PLY_PROPERTIES)
        return sheen_text_problem(text, "an element with more than %d properties", PLY_PROPERTIES);
    struct sheen_ply_property *property = &element->property[element->properties++];
    property->count_type = PLY_NONE;
    if (sheen_text_word(text, &word) && sheen_word_is(&word, "list"))
        error = read_type(text, &property->count_type);
    else
        *text = before;
    if (!error)
        error = read_type(text, &property->type);
    if (!error && property->count_type >= PLY_FLOAT)
        error = sheen_text_problem(text, "the count of a list is no whole number");
    if (!error && !sheen_text_word(text, &property->name))
        error = sheen_text_problem(text, "a property without a name");
    return error;
}

static int read_element(struct sheen_ply *ply)
{
    struct sheen_text *text = &ply->text;
    struct sheen_word word;

    if (ply->elements == PLY_ELEMENTS)
        return sheen_text_problem(text, "more than %d elements", PLY_ELEMENTS);
    struct sheen_ply_element *element = &ply->element[ply->elements];
    element->properties = 0;
    if (!sheen_text_word(text, &element->name) || !sheen_text_word(text, &word) ||
        !sheen_word_whole(&word, &element->count) || element->count < 0)
        return sheen_text_problem(text, "an element without a name or a count");
    for (int i = 0; i < ply->elements; i++) {
        if (ply->element[i].name.length == element->name.length &&
            memcmp(ply->element[i].name.at, element->name.at, element->name.length) == 0)
            return sheen_text_problem(text, "a second element '%.*s'", SHEEN_WORD(element->name));
    }
    if (sheen_word_is(&element->name, "vertex"))
        ply->vertices = (size_t)element->count;
    ply->elements++;
    return SHEEN_OK;
}

static int read_format(struct sheen_ply *ply)
{
    struct sheen_word word = {"", 0}, version = {"", 0};

    sheen_text_word(&ply->text, &word);
    sheen_text_word(&ply->text, &version);
    if (!sheen_word_is(&word, "ascii") && !sheen_word_is(&word, "binary_little_endian") &&
        !sheen_word_is(&word, "binary_big_endian"))
        return sheen_text_problem(&ply->text, "format '%.*s' is no PLY format", SHEEN_WORD(word));
    if (!sheen_word_is(&version, "1.0"))
        return sheen_text_problem(&ply->text, "version '%.*s' of PLY is not read, only 1.0", SHEEN_WORD(version));
    ply->format = sheen_word_is(&word, "ascii")                  ? PLY_ASCII
                  : sheen_word_is(&word, "binary_little_endian") ? PLY_LITTLE
                                                                 : PLY_BIG;
    return SHEEN_OK;
}

static void read_comment(struct sheen_ply *ply)
{
    struct sheen_word word, name;

    if (sheen_text_word(&ply->text, &word) && sheen_word_is(&word, "TextureFile") &&
        sheen_text_line_rest(&ply->text, &name) && !ply->picture.length)
        ply->picture = name;
}

static int read_line(struct sheen_ply *ply, const struct sheen_word *word)
{
    if (sheen_word_is(word, "format"))
        return read_format(ply);
    if (sheen_word_is(word, "element"))
        return read_element(ply);
    if (sheen_word_is(word, "property"))
        return read_property(ply);
    if (sheen_word_is(word, "comment"))
        read_comment(ply);
    /* An unknown line before the first element may be a comment without its first word; later, a broken property. */
    if (sheen_word_is(word, "comment") || sheen_word_is(word, "obj_info") || ply->elements == 0)
        return SHEEN_OK;
    return sheen_text_problem(&ply->text, "'%.*s' is no word of a PLY header", SHEEN_WORD(*word));
}

/*
 * The body follows the end of the line end_header. After it, LF behind CR may be a part of the line's end or the first
 * byte of the body; the end of the file's first line tells which.
 */
static void find_body(struct sheen_ply *ply)
{
    const char *first = (const char *)ply->bytes.bytes, *at = ply->text.at;

    first += strcspn(first, "\r\n");
    while (*at == ' ' || *at == '\t')
        at++;
    int only_cr = first[0] == '\r' && first[1] != '\n';
    if (*at == '\r')
        at += !only_cr && at[1] == '\n' ? 2 : 1;
    else if (*at == '\n')
        at++;
    ply->body = at;
    ply->body_line = ply->text.line + 1;
}

int sheen_ply_header(struct sheen_ply *ply)
{
    struct sheen_word word = {"", 0};
    int error = SHEEN_OK, formats = 0;

    if (!sheen_text_any_word(&ply->text, &word) || !sheen_word_is(&word, "ply"))
        return sheen_text_problem(&ply->text, "does not begin with 'ply'");
    for (;;) {
        sheen_text_skip_line(&ply->text);
        if (!sheen_text_any_word(&ply->text, &word))
            return sheen_text_problem(&ply->text, "the header has no end_header");
        if (sheen_word_is(&word, "end_header"))
            break;
        formats += sheen_word_is(&word, "format");
        error = read_line(ply, &word);
        if (error)
            return error;
    }
    if (formats != 1)
        return sheen_text_problem(&ply->text, "the header has %d lines 'format', not 1", formats);
    find_body(ply);
    return SHEEN_OK;
}
