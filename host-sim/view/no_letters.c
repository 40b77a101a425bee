/*
 * no_letters.c - replaces view_letters.c if there is no cairo; the window's title still shows the first line.
 */
#include "view_letters.h"

void sheen_letters(const struct sheen_letters *letters, int x, int y, int grey, const char *line)
{
    (void)letters;
    (void)x;
    (void)y;
    (void)grey;
    (void)line;
}

void sheen_letters_end(void)
{
}
