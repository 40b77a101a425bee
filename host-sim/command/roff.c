/*
 * roff.c - text of the manual page, escaped for roff.
 */
#include "roff.h"

#include <stdio.h>

static void put_text(const char *text)
{
    for (int first = 1; *text; text++) {
        if (*text == '-')
            fputs("\\-", stdout);
        else if (*text == '\\')
            fputs("\\e", stdout);
        else if (first && (*text == '.' || *text == '\''))
            printf("\\&%c", *text);
        else
            putchar(*text);
        first = *text == '\n';
    }
}

void sheen_roff_line(const char *before, const char *text, const char *after)
{
    fputs(before, stdout);
    put_text(text);
    fputs(after, stdout);
}
