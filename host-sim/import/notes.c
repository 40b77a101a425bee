/*
 * notes.c - what the user should know about a mesh that was read nevertheless.
 */
#include "notes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void sheen_note(struct sheen_notes *notes, enum sheen_note_kind kind, const char *format, ...)
{
    struct sheen_note note = {.kind = (uint32_t)kind};
    char text[sizeof note.line.text];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    sheen_problem(&note.line, 0, "%s", text);
    for (uint32_t i = 0; i < notes->count; i++) {
        if (strcmp(notes->note[i].line.text, note.line.text) == 0)
            return;
    }
    if (notes->count < SHEEN_NOTES_MAX)
        notes->note[notes->count++] = note;
}

void sheen_notes_print(const struct sheen_notes *notes, int uses_colors)
{
    for (uint32_t i = 0; i < notes->count; i++) {
        uint32_t kind = notes->note[i].kind;
        if (uses_colors || kind != SHEEN_NOTE_ON_COLORS)
            fprintf(stderr, "sheen: %s%s\n", kind == SHEEN_NOTE_DONE ? "" : "warning: ", notes->note[i].line.text);
    }
}
