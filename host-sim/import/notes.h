/*
 * notes.h - what the user should know about a mesh that was read nevertheless.
 */
#ifndef SHEEN_NOTES_H
#define SHEEN_NOTES_H

#include <stdint.h>

#include "problem.h"

/* As a missing .mtl, or lines that were left out. Duplicates are dropped, and notes beyond the last place. */
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
    SHEEN_NOTE_ON_COLORS, /* a warning about the file's colours, which not every command uses */
    SHEEN_NOTE_DONE       /* no warning: reports what was asked for, or what may help */
};

/* Adds a line, without newline, that names the file. */
__attribute__((format(printf, 3, 4))) void sheen_note(struct sheen_notes *notes, enum sheen_note_kind kind,
                                                      const char *format, ...);

/* Prints them on standard error, one per line, warnings as `sheen: warning: ...`; those on colours only if used. */
void sheen_notes_print(const struct sheen_notes *notes, int uses_colors);

#endif
