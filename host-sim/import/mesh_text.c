/*
 * mesh_text.c - splits a text file into words and counts lines.
 */
#include "mesh_text.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "utf8.h"

static int is_end_of_line(char c)
{
    return c == '\n' || c == '\r';
}

static int is_blank(char c)
{
    return (unsigned char)c <= ' ' && !is_end_of_line(c);
}

/* Skips one line end; CR LF is one. */
static void next_line(struct sheen_text *text)
{
    text->at += text->at[0] == '\r' && text->at[1] == '\n' ? 2 : 1; /* *end is 0, so at[1] exists */
    text->line++;
}

static int is_joined(const struct sheen_text *text)
{
    return text->joins && *text->at == '\\' && is_end_of_line(text->at[1]);
}

/* Skips blanks and the ends of joined lines. */
static void skip_blanks(struct sheen_text *text)
{
    while (text->at < text->end) {
        if (is_blank(*text->at)) {
            text->at++;
        } else if (is_joined(text)) {
            text->at++;
            next_line(text);
        } else {
            return;
        }
    }
}

/* Skips to the end of the line and of the lines joined to it. */
static void to_end_of_line(struct sheen_text *text)
{
    while (text->at < text->end && !is_end_of_line(*text->at)) {
        if (is_joined(text)) {
            text->at++;
            next_line(text);
        } else {
            text->at++;
        }
    }
}

int sheen_text_begin(struct sheen_text *text, struct sheen_bytes *bytes)
{
    if (sheen_bytes_to_utf8(bytes) != 0)
        return sheen_problem(text->problem, SHEEN_ERR_MEMORY, "%s: not enough memory", text->path);
    const unsigned char *zero = memchr(bytes->bytes, 0, bytes->count);
    if (zero) /* a zero would separate digits */
        return sheen_problem(text->problem, SHEEN_ERR_ARGUMENT,
                             "%s: byte %td is 0, which no text has; UTF-16 without its mark?", text->path,
                             zero - bytes->bytes);
    text->at = (const char *)bytes->bytes;
    text->end = text->at + bytes->count;
    text->line = 1;
    return SHEEN_OK;
}

/* Whether mark is the end, from the # on, of Microsoft's 1.#IND, 1.#INF, 1.#QNAN or 1.#SNAN. */
static int is_no_number(const char *mark)
{
    return strncmp(mark, "#IN", 3) == 0 || strncmp(mark, "#QN", 3) == 0 || strncmp(mark, "#SN", 3) == 0;
}

/* Whether a comment begins directly after a digit; elsewhere in a word, a # may belong to a name. */
static int is_comment_of_number(const struct sheen_text *text, const char *begin)
{
    return text->comments && *text->at == '#' && text->at > begin && text->at[-1] >= '0' && text->at[-1] <= '9' &&
           !is_no_number(text->at);
}

int sheen_text_word(struct sheen_text *text, struct sheen_word *word)
{
    skip_blanks(text);
    if (text->comments && text->at < text->end && *text->at == '#') {
        while (text->at < text->end && !is_end_of_line(*text->at)) /* a final backslash belongs to a path */
            text->at++;
    }
    word->at = text->at;
    while (text->at < text->end && (unsigned char)*text->at > ' ' && !is_joined(text) &&
           !is_comment_of_number(text, word->at))
        text->at++;
    word->length = (size_t)(text->at - word->at);
    return word->length > 0;
}

int sheen_text_any_word(struct sheen_text *text, struct sheen_word *word)
{
    while (!sheen_text_word(text, word)) {
        if (text->at >= text->end) {
            text->ended = 1;
            return 0;
        }
        next_line(text);
    }
    return 1;
}

int sheen_text_line_rest(struct sheen_text *text, struct sheen_word *rest)
{
    skip_blanks(text);
    rest->at = text->at;
    to_end_of_line(text);
    const char *end = text->at;
    while (end > rest->at && is_blank(end[-1]))
        end--;
    rest->length = (size_t)(end - rest->at);
    return rest->length > 0;
}

void sheen_text_skip_line(struct sheen_text *text)
{
    to_end_of_line(text);
    if (text->at < text->end)
        next_line(text);
}

int sheen_word_is(const struct sheen_word *word, const char *expected)
{
    return word->length == strlen(expected) && strncasecmp(word->at, expected, word->length) == 0;
}

int sheen_word_is_of(const struct sheen_word *word, const char *expected)
{
    char padded[20];

    if (word->length > sizeof padded - 3)
        return 0;
    snprintf(padded, sizeof padded, " %.*s ", (int)word->length, word->at);
    return strcasestr(expected, padded) != NULL;
}

void sheen_word_unquote(struct sheen_word *word)
{
    if (word->length >= 2 && word->at[0] == '"' && word->at[word->length - 1] == '"')
        *word = (struct sheen_word){word->at + 1, word->length - 2};
}

int sheen_word_number(const struct sheen_word *word, double *value)
{
    const char *from = word->at, *mark = memchr(from, '#', word->length);
    char *end;

    *value = strtod(from, &end); /* stops at the blank or zero behind the word */
    if (word->length == 0 || end == from)
        return 0;
    if (mark && end == mark && is_no_number(mark)) {
        *value = NAN;
        return 1;
    }
    /* nan(ind) and the like: strtod need not accept what is in the brackets. */
    return end == from + word->length || (isnan(*value) && *end == '(');
}

int sheen_word_whole(const struct sheen_word *word, int64_t *value)
{
    char *end;

    *value = strtoll(word->at, &end, 10);
    return word->length > 0 && end == word->at + word->length;
}

int sheen_text_point(struct sheen_text *text, int across_lines, const char *what, double point[3])
{
    for (int k = 0; k < 3; k++) {
        struct sheen_word word;
        if (!(across_lines ? sheen_text_any_word(text, &word) : sheen_text_word(text, &word)))
            return sheen_text_problem(text, "%s of %d numbers, not 3", what, k);
        if (!sheen_word_number(&word, &point[k]))
            return sheen_text_problem(text, "'%.*s' is not a number", SHEEN_WORD(word));
        if (!(fabs(point[k]) <= FLT_MAX))
            return sheen_text_problem(text, "'%.*s' is not a finite number", SHEEN_WORD(word));
    }
    return SHEEN_OK;
}

int sheen_text_problem(const struct sheen_text *text, const char *format, ...)
{
    char what[256];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    return sheen_problem(text->problem, SHEEN_ERR_ARGUMENT, "%s:%lu: %s", text->path, text->line, what);
}

void sheen_group_name(struct sheen_group *group, const char *name, size_t length)
{
    char whole[2 * sizeof group->name];

    if (length > sizeof whole - 1)
        length = sizeof whole - 1;
    memcpy(whole, name, length);
    whole[length] = '\0';
    sheen_utf8_copy(group->name, sizeof group->name, whole);
}
