/*
 * notes.h - what a person should know of a mesh that was read all the same.
 */
#ifndef SHEEN_NOTES_H
#define SHEEN_NOTES_H

#include <stdint.h>

#include "problem.h"

/* A missing .mtl, lines that were left out. One past the last is dropped, as is one that is there already. */
#define SHEEN_NOTES_MAX 4
struct sheen_notes {
    uint32_t count;
    struct sheen_note {
        struct sheen_problem line;
        uint32_t kind; /* enum sheen_note_kind */
    } note[SHEEN_NOTES_MAX];
};

enum sheen_note_kind {
    SHEEN_NOTE_WARNING,
    SHEEN_NOTE_ON_COLORS, /* a warning of the file's colours, which not every command uses */
    SHEEN_NOTE_DONE       /* no warning: what was asked for is done */
};

/* Adds a line, without newline, that names the file. */
__attribute__((format(printf, 3, 4))) void sheen_note(struct sheen_notes *notes, enum sheen_note_kind kind,
                                                      const char *format, ...);

/* On standard error, a line each, warnings as `sheen: warning: ...`; those on colours only where they are used. */
void sheen_notes_print(const struct sheen_notes *notes, int uses_colors);

#endif
