/*
 * no_letters.c - in place of view_letters.c where there is no cairo: the window's title says the first line.
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
