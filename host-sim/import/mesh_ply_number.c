/*
 * mesh_ply_number.c - reads the numbers of a PLY file's body: words, or binary in either byte order.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "mesh_ply.h"

int sheen_ply_problem(const struct sheen_ply *ply, const char *format, ...)
{
    char what[256];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    if (ply->format == PLY_ASCII)
        return sheen_text_problem(&ply->text, "%s", what);
    return sheen_problem(ply->text.problem, SHEEN_ERR_ARGUMENT, "%s: byte %td: %s", ply->text.path,
                         ply->text.at - (const char *)ply->bytes.bytes, what);
}

static double from_bits(enum sheen_ply_type type, uint64_t bits)
{
    uint32_t low = (uint32_t)bits;
    float single;
    double twice;

    switch (type) {
    case PLY_INT8:
        return (int8_t)bits;
    case PLY_INT16:
        return (int16_t)bits;
    case PLY_INT32:
        return (int32_t)low;
    case PLY_FLOAT:
        memcpy(&single, &low, sizeof single);
        return (double)single;
    case PLY_DOUBLE:
        memcpy(&twice, &bits, sizeof twice);
        return twice;
    default:
        return (double)bits;
    }
}

int sheen_ply_number(struct sheen_ply *ply, enum sheen_ply_type type, double *value)
{
    struct sheen_word word;
    size_t size = sheen_ply_size(type);

    if (ply->format == PLY_ASCII) {
        ply->ended = !sheen_text_any_word(&ply->text, &word);
        if (ply->ended)
            return SHEEN_ERR_ARGUMENT;
        return sheen_word_number(&word, value) ? SHEEN_OK
                                               : sheen_ply_problem(ply, "'%.*s' is not a number", SHEEN_WORD(word));
    }
    ply->ended = (size_t)(ply->text.end - ply->text.at) < size;
    if (ply->ended)
        return SHEEN_ERR_ARGUMENT;
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++) {
        size_t shift = 8 * (ply->format == PLY_LITTLE ? i : size - 1 - i);
        bits |= (uint64_t)(unsigned char)ply->text.at[i] << shift;
    }
    ply->text.at += size;
    *value = from_bits(type, bits);
    return SHEEN_OK;
}

int sheen_ply_whole(struct sheen_ply *ply, enum sheen_ply_type type, const char *what, double *value)
{
    int error = sheen_ply_number(ply, type, value);

    return !error && *value != floor(*value) ? sheen_ply_problem(ply, "%s %g is not whole", what, *value) : error;
}
