/*
 * mesh_text.h - words of a text file with their lines, for the readers of mesh files.
 *
 * Lines end with LF, CR or CR LF; words are separated by blanks, tabs and other control characters.
 */
#ifndef SHEEN_MESH_TEXT_H
#define SHEEN_MESH_TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "mesh_bytes.h"
#include "polygons.h"

struct sheen_text {
    const char *path;
    const char *at, *end; /* *end is 0 */
    unsigned long line;   /* of `at`, from 1 */
    int comments;         /* 1: a # at the beginning of a word or after a digit begins a comment */
    int ended;            /* 1: sheen_text_any_word has found no more */
    int joins;            /* 1: a backslash at the end of a line joins it with the next */
    struct sheen_problem *problem;
};

struct sheen_word {
    const char *at;
    size_t length;
};

/* Begins at the start of a file's text, converted to UTF-8. 0, or an error if it is no text. */
int sheen_text_begin(struct sheen_text *text, struct sheen_bytes *bytes);

/* The next word of this line; 0: there is none, nor will the next call find one. */
int sheen_text_word(struct sheen_text *text, struct sheen_word *word);

/* The next word of this line or a later one; 0 at the end of the file. */
int sheen_text_any_word(struct sheen_text *text, struct sheen_word *word);

/* The rest of the line, without blanks around it, with joined lines and comments as they are; 0: nothing. */
int sheen_text_line_rest(struct sheen_text *text, struct sheen_word *rest);

/* Goes to the beginning of the next line. */
void sheen_text_skip_line(struct sheen_text *text);

/* Whether a word is this one, in upper or lower case. */
int sheen_word_is(const struct sheen_word *word, const char *expected);

/* Whether it is one of these words, which are separated by blanks and at most 16 bytes long. */
int sheen_word_is_of(const struct sheen_word *word, const char *expected);

/* Removes quotes around a word. */
void sheen_word_unquote(struct sheen_word *word);

/*
 * The whole word as a number. 1, also for a number that is not finite (Microsoft's 1.#IND becomes NaN); 0: it is no
 * number.
 */
int sheen_word_number(const struct sheen_word *word, double *value);

/* The whole word as a decimal whole number; saturates. */
int sheen_word_whole(const struct sheen_word *word, int64_t *value);

/* Three coordinates, finite as 32-bit floats; messages call the point `what`. 0, or an error with the line. */
int sheen_text_point(struct sheen_text *text, int across_lines, const char *what, double point[3]);

/* "PATH:LINE: ..." */
__attribute__((format(printf, 2, 3))) int sheen_text_problem(const struct sheen_text *text, const char *format, ...);

/* For messages: arguments of "%.*s", a word's length (at most this) and its bytes. */
#define SHEEN_WORD(word) (int)((word).length < 40 ? (word).length : 40), (word).at

/* A material's name, cut between characters. */
void sheen_group_name(struct sheen_group *group, const char *name, size_t length);

#endif
