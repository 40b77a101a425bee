/*
 * nearest.c - finds the nearest word by Levenshtein distance.
 */
#include "nearest.h"

#include <ctype.h>
#include <string.h>

#include "sheen_panel.h"

#define LETTERS 48 /* letters that are compared: more than any name has */

static size_t least(size_t a, size_t b, size_t c)
{
    size_t ab = a < b ? a : b;

    return ab < c ? ab : c;
}

/* Computes the table row by row: entry j of row i is the distance between the first i letters of a and j of b. */
static size_t distance(const char *a, const char *b, size_t length)
{
    size_t row[LETTERS + 1];

    length = length < LETTERS ? length : LETTERS;
    for (size_t j = 0; j <= length; j++)
        row[j] = j;
    for (size_t i = 0; a[i] && i < LETTERS; i++) {
        size_t before = row[0]; /* the entry one to the left in the row before */
        row[0] = i + 1;
        for (size_t j = 1; j <= length; j++) {
            size_t above = row[j];
            int differ = tolower((unsigned char)a[i]) != tolower((unsigned char)b[j - 1]);
            row[j] = least(above + 1, row[j - 1] + 1, before + (size_t)differ);
            before = above;
        }
    }
    return row[length];
}

void sheen_nearest_try(struct sheen_nearest *nearest, const char *name, size_t length)
{
    size_t far = distance(nearest->word, name, length);

    if (nearest->name && nearest->distance <= far)
        return;
    nearest->name = name;
    nearest->length = (int)length;
    nearest->distance = far;
}

void sheen_nearest_panel(struct sheen_nearest *nearest)
{
    for (size_t i = 0; sheen_panel_at(i); i++) {
        const char *name = sheen_panel_at(i)->name;
        sheen_nearest_try(nearest, name, strcspn(name, "-"));
        sheen_nearest_try(nearest, name, strlen(name));
    }
}
