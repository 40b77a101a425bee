/*
 * progress.c - one line that shows how far long work has got, on a terminal only.
 */
#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#define WIDTH 60 /* columns for the text: a line that wraps could not be erased */

void sheen_progress(const char *what, int done, int whole)
{
    if (!isatty(STDERR_FILENO))
        return;
    fprintf(stderr, "\r\x1b[K%.*s", WIDTH, what);
    if (whole > 0)
        fprintf(stderr, " %d/%d", done, whole);
    fflush(stderr);
}

void sheen_progress_end(void)
{
    if (!isatty(STDERR_FILENO))
        return;
    fputs("\r\x1b[K", stderr);
    fflush(stderr);
}
