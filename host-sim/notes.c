/*
 * notes.c - what a person should know of a mesh that was read all the same.
 */
#include "notes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void sheen_note(struct sheen_notes *notes, int on_colors, const char *format, ...)
{
    struct sheen_note note = {.on_colors = on_colors != 0};
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
        if (uses_colors || !notes->note[i].on_colors)
            fprintf(stderr, "sheen: warning: %s\n", notes->note[i].line.text);
    }
}
